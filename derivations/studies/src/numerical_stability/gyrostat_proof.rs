//! Proved stability of a splitting near a gyrostat's steady motion for all step sizes of an interval: equilibria and
//! rotations.
//!
//! If the carrier rotates, the sub-flows have no common equilibrium, and the splitting has a fixed point that depends
//! on the step size h, in the body's axes, where a rotation about the vertical changes nothing. Krawczyk's operator
//! encloses it over an interval of step sizes as Taylor models in h ([`FixedPoint`]), with the derivative of the step
//! there. If the carrier is at rest and its rotor balanced, the state is an equilibrium of every sub-flow, since weight
//! and torque vanish. The fixed point is then that of the law for every h: it is enclosed once, and the derivative of a
//! step is the product of those of its flows at this point. Instability is decided by `grows`. Where this is undecided
//! or nothing is enclosed, only the numerical test is reported.
//!
//! A single step size needs no interval: with numbers enclosed to thirty digits the rounding of long compositions stays
//! small where Taylor models over floats have become too wide. The tested step sizes are proved in this way, one by
//! one.
//!
//! A step is taken on `Surface`, without the multipliers that are one by structure. It is the step of the integrator,
//! with its laws over Taylor models: bodies, integrals and collocation have the floats of the run, the motor the
//! decimals of the file, with lumped windings. A torque that is nonlinear in the slip takes as many Newton steps as in
//! a run.

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

/// A gyrostat with its motor near a steady motion.
pub struct Turning {
    floats: OnSurface<f64>,
    ranges: Over<TaylorModel>,
    points: Over<Ball>,
    /// The steady motion of the law, in floats.
    start: Vec<f64>,
    /// Whether there is no dissipation: every sub-flow is then Hamiltonian, and multipliers come in pairs z, 1/z.
    symmetric: bool,
}

/// The steps over enclosures.
struct Over<F: Base> {
    steps: OnSurface<F>,
    /// The enclosed equilibrium of the law, if the carrier is at rest.
    rest: Option<Vec<F>>,
}

/// Intervals without an enclosed fixed point, and those with a threshold, are not bisected to the last digit.
const LIMITS: Limits = Limits { sign: 1e-5, motion: 1e-2, most: 200 };
/// The largest number of Newton iterations in floats for the fixed point, and the relative correction at which they
/// end.
const ITERATIONS: usize = 12;
const CONVERGED: f64 = 1e-9;
/// The step size (s) with which an equilibrium is enclosed, and the radius around its floats, which have rounding
/// errors.
const SHORT: f64 = 0.01;
const REST: f64 = 1e-9;

impl Turning {
    /// The proofs for a gyrostat at a steady motion.
    ///
    /// # Errors
    /// [`Unproved`] with the reason why nothing can be proved.
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

    /// Whether the state is an equilibrium of every sub-flow.
    pub fn rests(&self) -> bool {
        self.points.rest.is_some()
    }

    /// Decides whether the map is unstable, for all step sizes in an interval, s; where this is undecided at one of the
    /// ascending `steps`, it is decided for this step size alone.
    pub fn course(&self, splitting: Splitting, ends: [f64; 2], steps: &[f64]) -> Proved {
        // fixed points in floats, from which the proof starts; an equilibrium is that of the law
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

    /// The derivative of a step at its fixed point; `None` where that is not enclosed.
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

    /// The equilibrium of the law, a fixed point for every step size, enclosed with a short step, for which there is no
    /// other fixed point nearby.
    fn resting<C: Rounded, const N: usize>(&self, over: &Over<Model<C, N>>) -> Option<Vec<Model<C, N>>> {
        Some(self.own(over, Splitting::Strang, Model::constant(SHORT), &self.start, REST)?.place)
    }

    /// The fixed point for all step sizes of a model; `None` where it is not enclosed.
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

/// The values of a step and its derivative, column by column.
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

/// A gyrostat and its motor.
struct Near<'a> {
    bodies: &'a Gyrostat<f64>,
    motor: &'a Motor,
}

impl Near<'_> {
    /// The proofs near a state of the law in the axes of the second form.
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

    /// The steps over models.
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
