//! What a splitting does near a gyrostat's stationary motion at every step between two, proved: rests and rotations alike.
//!
//! Where the carrier turns the pieces do not rest, and the splitting has a stationary motion of its own, another one for each step h:
//! a fixed point of its step in the body's axes, in which turning about the vertical changes nothing. Krawczyk's operator encloses
//! it over an interval of steps as Taylor models in h ([`FixedPoint`]), with the derivative of the step there. Where the carrier
//! rests with its rotor in balance every piece does: no square of the energy turns anything, and weight and motor push nothing. Then
//! the fixed point is the law's, whatever the step. It is enclosed once, and the derivative of a step is the product of those of its
//! flows at this one point. What grows is decided by `grows`; where it stays open or nothing is enclosed, it is said to be tested.
//!
//! A single step needs no range: over numbers that are enclosed to thirty digits what long compositions make of rounding lasts where
//! models over floats have become too wide, and the steps that are tested are proved so, one by one.
//!
//! A step is taken over `Surface`, which leaves the multipliers out that are one by structure. The step is that which runs, its
//! laws over models: of the bodies, the integrals and the collocation it has the floats that run, of the motor the decimals, with
//! windings lumped. A moment that is not linear in the slip takes as many of Newton's steps as it takes when it runs.

use super::casimir_leaf::{Step, Surface};
use super::continuation::{before, followed};
use super::gyrostat_step::{OnSurface, enclosed};
use super::motions::Stationed;
use super::multipliers::{Matrix, grows};
use super::reasons::{MOST_UNKNOWNS, Unproved};
use super::step_intervals::{Found, Limits, Proved};
use super::symbolic_linearisation::keeps_energy;
use crate::model_reduction::{Lumped, Lumping};
use crate::scene::{Scene, Setup};
use algebra::real::{Ball, FixedPoint, Mapped, Model, Rounded, TaylorModel};
use field::{Base, Rational, Scalar, Tangent};
use integrators::Splitting;
use motor::{Law, Motor, Rule, has_known_flow};
use nalgebra::{DMatrix, DVector};
use simulation::Axes;
use systems::gyrostat::Gyrostat;
use systems::gyrostat::forms::SecondForm;

/// A gyrostat with its motor near a stationary motion.
pub struct Turning {
    floats: OnSurface<f64>,
    ranges: Over<TaylorModel>,
    points: Over<Ball>,
    /// The law's motion.
    start: Vec<f64>,
    /// Nothing takes energy: every piece is Hamilton's, and with a multiplier z there is 1/z.
    symmetric: bool,
}

/// Its steps over enclosures.
struct Over<F: Base> {
    steps: OnSurface<F>,
    /// The law's motion where the carrier rests.
    rest: Option<Vec<F>>,
}

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
        let Setup::Gyrostat(bodies) = &scene.system else { return Err(Unproved::Bench) };
        if motion.member.is_some() {
            return Err(Unproved::Family);
        }
        let state = Scene { start: motion.start.clone(), ..scene.clone() }.state(Axes::Second);
        let mut turning = Near { bodies, motor: &scene.machine }.turning(&state)?;
        if motion.rests {
            turning.ranges.rest = Some(turning.resting(&turning.ranges).ok_or(Unproved::Rest)?);
            turning.points.rest = Some(turning.resting(&turning.points).ok_or(Unproved::Rest)?);
        }
        Ok(turning)
    }

    /// Whether every piece rests.
    pub fn rests(&self) -> bool {
        self.points.rest.is_some()
    }

    /// Whether the map grows, for every step between two, s; what stays open at one of `steps`, in ascending order, is looked at there
    /// alone.
    pub fn course(&self, splitting: Splitting, ends: [f64; 2], steps: &[f64]) -> Proved {
        // in floats, for the proof to begin with; a rest is the law's
        let moving = if self.rests() { &[] } else { steps };
        let followed = followed(moving, |step, near: Option<&Vec<f64>>| {
            approached(&*self.floats.step(splitting, step, false), near.unwrap_or(&self.start).clone())
                .map(|(place, _)| place)
        });
        let look = |[low, high]: [f64; 2]| {
            let step = TaylorModel::over_range(low, high);
            let Some(slopes) = self.slopes(&self.ranges, splitting, step, &followed) else { return Found::Lost };
            grows(&slopes, &step, self.symmetric).map_or(Found::Open, Found::Grows)
        };
        let mut proved = Proved::by(look, ends, LIMITS);
        let alone = |step: &f64| {
            let at = Ball::constant(*step);
            Some((*step, grows(&self.slopes(&self.points, splitting, at, &followed)?, &at, self.symmetric)?))
        };
        proved.alone = steps.iter().filter(|step| proved.at(**step).is_none()).filter_map(alone).collect();
        proved
    }

    /// The derivative of a step at its own motion; `None` where that is not enclosed.
    fn slopes<C: Rounded, const N: usize>(
        &self,
        over: &Over<Model<C, N>>,
        splitting: Splitting,
        step: Model<C, N>,
        followed: &[(f64, Vec<f64>)],
    ) -> Option<Matrix<Model<C, N>>> {
        match &over.rest {
            Some(rest) => derivative(&*over.steps.step(splitting, step, true), rest).map(|(_, slopes)| slopes),
            None => {
                let near = before(followed, step.at(Model::<C, N>::nodes()[0])).unwrap_or(&self.start);
                self.own(over, splitting, step, near, 0.0).map(|own| own.slopes)
            }
        }
    }

    /// The law's rest, a fixed point whatever the step: so by a short one; no other fixed point is near.
    fn resting<C: Rounded, const N: usize>(&self, over: &Over<Model<C, N>>) -> Option<Vec<Model<C, N>>> {
        Some(self.own(over, Splitting::Strang, Model::constant(SHORT), &self.start, REST)?.place)
    }

    /// The splitting's own motion for every step of a model; `None` where it is not enclosed.
    fn own<C: Rounded, const N: usize>(
        &self,
        over: &Over<Model<C, N>>,
        splitting: Splitting,
        step: Model<C, N>,
        start: &[f64],
        least: f64,
    ) -> Option<FixedPoint<Model<C, N>>> {
        let mut near = start.to_vec();
        let (mut places, mut inverses) = (Vec::new(), Vec::new());
        for node in Model::<C, N>::nodes() {
            let at_node = self.floats.step(splitting, step.at(node), false);
            let (place, inverse) = approached(&*at_node, near)?;
            near = place.clone();
            places.push(place);
            inverses.push(inverse);
        }
        let n = near.len();
        let centre: Vec<Model<C, N>> = (0..n).map(|i| Model::through(std::array::from_fn(|k| places[k][i]))).collect();
        let entry = |i: usize, j: usize| Model::through(std::array::from_fn(|k| inverses[k][(i, j)]));
        let inverse: Matrix<Model<C, N>> = (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect();
        let over = over.steps.step(splitting, step, false);
        let value = |at: &[Model<C, N>]| {
            let fixed: Vec<Tangent<Model<C, N>>> = at.iter().copied().map(Tangent::fixed).collect();
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
    motor: &'a Motor,
}

impl Near<'_> {
    /// Near a state of the law in the axes of the second form.
    fn turning(&self, state: &[f64]) -> Result<Turning, Unproved> {
        let machine = self.motor.clone();
        if !has_known_flow(&machine) {
            return Err(Unproved::Fed);
        }
        let (law, rule) = (Law::of(&machine), Rule::gauss());
        let exact = machine.decimals();
        let lumping = Lumping::of(&exact);
        let floats = match &lumping {
            Some(lumping) => Lumped { machine, windings: lumping.over(Rational::to_f64) },
            None => Lumped::unchanged(machine),
        };
        let (moments, axis, axial, weight) = self.bodies.form_data(&self.bodies.derived().full);
        let form = SecondForm::new(moments, axis, axial, weight);
        let surface = Surface::at(&form, &floats, state);
        let start = surface.start(&form, &floats, state);
        if start.len() > MOST_UNKNOWNS {
            return Err(Unproved::Many(start.len()));
        }
        let ranges = self.over(lumping.as_ref(), &surface, (law, rule));
        let points = self.over(lumping.as_ref(), &surface, (law, rule));
        let floats = OnSurface { form, machine: floats, surface, law, rule };
        let symmetric = keeps_energy(&exact);
        Ok(Turning { floats, ranges, points, start, symmetric })
    }

    /// Its steps over models.
    fn over<C: Rounded, const N: usize>(
        &self,
        lumping: Option<&Lumping>,
        surface: &Surface<f64>,
        (law, rule): (Law, Rule<f64>),
    ) -> Over<Model<C, N>> {
        let machine = self.motor.over(|_, value| enclosed(Rational::decimal(value)));
        let machine = match lumping {
            Some(lumping) => Lumped { machine, windings: lumping.over(enclosed) },
            None => Lumped::unchanged(machine),
        };
        let number = Model::constant;
        let (moments, axis, axial, weight) = self.bodies.form_data(&self.bodies.derived().full);
        let form = SecondForm::new(moments.map(number), axis.map(number), number(axial), weight.map(number));
        let surface = surface.map(number);
        Over { steps: OnSurface { form, machine, surface, law, rule }, rest: None }
    }
}
