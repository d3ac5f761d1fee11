//! What a splitting does near a gyrostat's stationary motion at every step between two, proved: rests and rotations alike.
//!
//! Where the carrier turns the pieces do not rest, and the splitting has a stationary motion of its own, another one for each step h:
//! a fixed point of its step in the body's axes, in which turning about the vertical changes nothing. Krawczyk's operator encloses
//! it over an interval of steps as Taylor models in h ([`FixedPoint`]), with the derivative of the step there. Where the carrier
//! rests with its rotor in balance every piece does: no square of the energy turns anything, and weight and motor push nothing. Then
//! the fixed point is the law's, whatever the step. It is enclosed once, and the derivative of a step is the product of those of its
//! flows at this one point. What grows is decided by `grows`; where it stays open or nothing is enclosed, it is said to be tested.
//!
//! A step is taken over `Surface`, which leaves the multipliers out that are one by structure. The step is that which runs, its
//! laws over models: of the bodies and the integrals it has the floats that run, of the motor the decimals, with windings lumped.

use super::motions::Stationed;
use super::multipliers::grows;
use super::stepped::{Both, Enclosed, OnSurface, Steps};
use super::stretches::{Found, Limits, Proved};
use super::surface::{Step, Surface};
use super::written::keeps_energy;
use crate::ladder::{Lumped, Lumping};
use crate::machines::{Catalogued, ForMachine, Law, has_known_flow};
use crate::scene::{Axes, MachineData, Scene, System};
use crate::stationary::motor::Decimals;
use crate::systems::gyrostat::Gyrostat;
use crate::systems::gyrostat::forms::SecondForm;
use field::{Rational, Scalar, Tangent};
use integrators::Splitting;
use nalgebra::{DMatrix, DVector};
use std::fmt;
use symbolic::Sym;
use symbolic::real::{FixedPoint, Mapped, Ordered, TaylorModel};

/// A gyrostat near a stationary motion, its motor forgotten.
pub struct Turning {
    steps: Box<dyn Steps>,
    /// The law's motion.
    start: Vec<f64>,
    /// The same, enclosed, where the carrier rests.
    rest: Option<Vec<TaylorModel>>,
    /// Nothing takes energy: every piece is Hamilton's, and with a multiplier z there is 1/z.
    symmetric: bool,
}

/// Why nothing is proved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unproved {
    /// On a bench, for a motor without an angle that it keeps, or one whose flow is not written down.
    Bench,
    /// A member of a family: others are its neighbours, and no operator contracts.
    Family,
    /// The flow of the push is found by collocation.
    Curved,
    /// The flow of the push is not known.
    Fed,
    /// A datum of the motor is missing, or is no number.
    Data,
    /// The law's rest is not enclosed: it is degenerate.
    Rest,
    /// More unknowns than are enclosed.
    Many(usize),
}

impl fmt::Display for Unproved {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Bench => write!(f, "the motor keeps no angle, or its flow is not written down"),
            Self::Family => write!(f, "the motion is one of a family"),
            Self::Curved => write!(f, "the moment is not linear in the slip"),
            Self::Fed => write!(f, "the flow of the motor's piece is not known"),
            Self::Data => write!(f, "a datum of the motor is missing"),
            Self::Rest => write!(f, "the rest is not enclosed"),
            Self::Many(unknowns) => write!(f, "{unknowns} unknowns are more than {MOST_UNKNOWNS}"),
        }
    }
}

const MOST_UNKNOWNS: usize = 12;
/// A place without an enclosed motion is not searched to the last digit, nor is an edge.
const LIMITS: Limits = Limits { sign: 1e-5, motion: 1e-2, most: 200 };
/// Of Newton's iteration in floats towards the own motion, and when the next correction is rounding.
const ITERATIONS: usize = 12;
const CONVERGED: f64 = 1e-9;
/// s, and how far about the floats of a rest it is looked for; they are off by their rounding.
const SHORT: f64 = 0.01;
const REST: f64 = 1e-9;

impl Turning {
    /// Of a gyrostat at a stationary motion.
    ///
    /// # Errors
    /// [`Unproved`].
    pub fn of(scene: &Scene, motion: &Stationed) -> Result<Self, Unproved> {
        let System::Gyrostat(bodies) = &scene.system else { return Err(Unproved::Bench) };
        if motion.member.is_some() {
            return Err(Unproved::Family);
        }
        let state = Scene { start: motion.start.clone(), ..scene.clone() }.state(Axes::Second);
        let near = Near { bodies, data: &scene.machine_data, name: scene.machine.name(), state: &state };
        let mut turning = scene.machine.clone().apply(near)?;
        if motion.rests {
            // whatever the step, so by a short one; no other fixed point is near
            let step = TaylorModel::constant(SHORT);
            turning.rest = Some(turning.own(Splitting::Strang, &step, REST).ok_or(Unproved::Rest)?.place);
        }
        Ok(turning)
    }

    /// Whether the map grows, for every step between two, s.
    pub fn course(&self, splitting: Splitting, ends: [f64; 2]) -> Proved {
        let look = |[low, high]: [f64; 2]| {
            let step = TaylorModel::over_range(low, high);
            let slopes = match &self.rest {
                Some(rest) => derivative(&*self.steps.at_rest(splitting, &step), rest).map(|(_, slopes)| slopes),
                None => self.own(splitting, &step, 0.0).map(|own| own.slopes),
            };
            let Some(slopes) = slopes else { return Found::Lost };
            grows(&slopes, &step, self.symmetric).map_or(Found::Open, Found::Grows)
        };
        Proved::by(look, ends, LIMITS)
    }

    /// The splitting's own motion for every step of a range; `None` where it is not enclosed.
    fn own(&self, splitting: Splitting, step: &TaylorModel, least: f64) -> Option<FixedPoint> {
        let mut near = self.start.clone();
        let (mut places, mut inverses) = (Vec::new(), Vec::new());
        for node in TaylorModel::nodes() {
            let at_node = self.steps.over_floats(splitting, step.at(node));
            let (place, inverse) = approached(&*at_node, near)?;
            near = place.clone();
            places.push(place);
            inverses.push(inverse);
        }
        let n = near.len();
        let centre: Vec<TaylorModel> =
            (0..n).map(|i| TaylorModel::through(std::array::from_fn(|k| places[k][i]))).collect();
        let entry = |i: usize, j: usize| TaylorModel::through(std::array::from_fn(|k| inverses[k][(i, j)]));
        let inverse: Vec<Vec<TaylorModel>> = (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect();
        let over = self.steps.over_models(splitting, step);
        let value = |at: &[TaylorModel]| {
            let fixed: Vec<Tangent<TaylorModel>> = at.iter().copied().map(Tangent::fixed).collect();
            Some(over(&fixed)?.into_iter().map(|end| end.value).collect())
        };
        FixedPoint::near(&centre, &inverse, least, value, |at| derivative(&*over, at))
    }
}

/// The values of a step and its derivative, a column after the other.
fn derivative<S: Scalar>(step: &Step<'_, Tangent<S>>, at: &[S]) -> Option<Mapped<S>> {
    let column = |moved: usize| {
        let moving = |(k, y): (usize, &S)| if k == moved { Tangent::variable(*y) } else { Tangent::fixed(*y) };
        step(&at.iter().enumerate().map(moving).collect::<Vec<_>>())
    };
    let columns: Vec<Vec<Tangent<S>>> = (0..at.len()).map(column).collect::<Option<_>>()?;
    let slopes = (0..at.len()).map(|i| columns.iter().map(|column| column[i].slope).collect()).collect();
    Some((columns.first()?.iter().map(|end| end.value).collect(), slopes))
}

/// A fixed point by Newton's iteration, and (1 - DR)^-1 there.
fn approached(step: &Step<'_, Tangent<f64>>, near: Vec<f64>) -> Option<(Vec<f64>, DMatrix<f64>)> {
    let n = near.len();
    let mut place = DVector::from_vec(near);
    for _ in 0..ITERATIONS {
        let (end, slopes) = derivative(step, place.as_slice())?;
        let left = DMatrix::from_fn(n, n, |i, j| f64::from(u8::from(i == j)) - slopes[i][j]);
        let inverse = left.try_inverse()?;
        let correction = &inverse * (DVector::from_vec(end) - &place);
        place += &correction;
        if correction.norm() < CONVERGED * place.norm() {
            return Some((place.as_slice().to_vec(), inverse));
        }
    }
    None
}

/// Puts the motor into it.
struct Near<'a> {
    bodies: &'a Gyrostat<f64>,
    data: &'a MachineData,
    name: &'static str,
    /// As the law has it, in the axes of the second form.
    state: &'a [f64],
}

impl ForMachine for Near<'_> {
    type Output = Result<Turning, Unproved>;

    fn apply<M: Catalogued + Clone + Send + Sync + 'static>(self, machine: M) -> Self::Output {
        if !has_known_flow(&machine) {
            return Err(Unproved::Fed);
        }
        if Law::of(&machine) == Law::Curved {
            return Err(Unproved::Curved);
        }
        let exact = M::read::<Sym, _>(&mut Decimals(self.data, self.name)).map_err(|_| Unproved::Data)?;
        let enclosed = M::read::<TaylorModel, _>(&mut Enclosed(self.data, self.name)).map_err(|_| Unproved::Data)?;
        let lumping = Lumping::of(&exact);
        let near_zero = TaylorModel::constant(0.0);
        let fraction = |value: Rational| near_zero.fraction(value).unwrap_or(TaylorModel::constant(f64::NAN));
        let (floats, models) = match &lumping {
            Some(lumping) => (
                Lumped { machine, windings: lumping.over(Rational::to_f64) },
                Lumped { machine: enclosed, windings: lumping.over(fraction) },
            ),
            None => (Lumped::unchanged(machine), Lumped::unchanged(enclosed)),
        };
        let full = self.bodies.derived().full;
        let (moments, axis, axial, weight) = self.bodies.form_data(&full);
        let form = SecondForm::new(moments, axis, axial, weight);
        let number = TaylorModel::constant;
        let form_of_models = SecondForm::new(moments.map(number), axis.map(number), number(axial), weight.map(number));
        let surface = Surface::at(&form, &floats, self.state);
        let start = surface.start(&form, &floats, self.state);
        if start.len() > MOST_UNKNOWNS {
            return Err(Unproved::Many(start.len()));
        }
        let models = OnSurface { form: form_of_models, machine: models, surface: surface.map(number) };
        let floats = OnSurface { form, machine: floats, surface };
        let symmetric = keeps_energy(&exact, M::ROTOR);
        Ok(Turning { steps: Box::new(Both { floats, models }), start, rest: None, symmetric })
    }
}
