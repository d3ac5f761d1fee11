//! What a machine does to its rotor while the angle rests.
//!
//! In the fluxes c_k = L_k i_k + psi_k(g) of the circuits the energy is U(g) + sum (c_k - psi_k(g))^2 / (2 L_k). With
//! the angle at rest the currents fade, i_k = i_k(0) exp(-r_k t) with r_k = R_k/L_k, and the slip s = g' obeys
//!
//!   s' = K (-U'(g) + sum_k psi_k'(g) i_k(t) + m(s)) + pull ,
//!
//! K the slip that a unit of impulse gives and `pull` what else moves it. Where m is linear, m(s) = m(0) - b s, the rest is
//! exponentials; elsewhere Gauss' collocation of order 8 solves it. When the angle moves, the fluxes rest.
//!
//! A supply or conductors that slide break this: c_k phi' ties the currents to the slip at a resting angle too, and the
//! flow is none of these. Such machines are refused ([`has_known_flow`]).

use super::{Machine, RotorState, is_fed};
use field::{Analytic, Base, Circle, Over, Scalar, Tangent};
use integrators::{Collocation, Family, Real};
use symbolic::{Hypotheses, Sym, decide};

/// Stages of the collocation: its order, 8, is not below that of any composition.
const STAGES: usize = 4;
/// Of Newton's iteration, whose error is squared each time.
const ITERATIONS: usize = 4;

/// The rotor in the coordinates in which pieces flow.
#[derive(Clone, Debug, PartialEq)]
pub struct Point<S> {
    /// g; means nothing where the laws do not know it
    pub angle: S,
    /// p, the rotor's spin
    pub momentum: S,
    /// c_k
    pub fluxes: Vec<S>,
}

/// Whether the moment m is linear in the slip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    Linear,
    Curved,
}

/// A length of time, prepared.
#[derive(Clone, Debug)]
pub struct Kick<S> {
    pub length: S,
    /// K
    compliance: S,
    /// 1 - exp(-r_k h)
    losses: Vec<S>,
    moment: Moment<S>,
}

#[derive(Clone, Debug)]
enum Moment<S> {
    /// m(0); K b; the integral of exp(-K b t) over h; what a unit of each psi_k' i_k(0) adds to the slip.
    Linear { at_zero: S, rate: S, lasting: S, pushes: Vec<S> },
    /// exp(-r_k c_i h) at each node.
    Curved { rule: Rule<S>, left: Vec<[S; STAGES]> },
}

/// Nodes, weights and matrix of a collocation.
#[derive(Clone, Copy, Debug)]
pub struct Rule<S> {
    pub nodes: [S; STAGES],
    pub weights: [S; STAGES],
    pub matrix: [[S; STAGES]; STAGES],
}

impl Law {
    /// By the second derivative, decided exactly.
    pub fn of(machine: &impl Machine<f64>) -> Self {
        let slip = Sym::symbol("slip");
        let moment = machine.moment_law(slip, slip + Sym::lift(machine.frame_speed()));
        let bend = moment.diff(slip).diff(slip);
        if decide(bend, &Hypotheses::none()).is_zero() { Law::Linear } else { Law::Curved }
    }
}

impl<S: Real> Rule<S> {
    /// Gauss' collocation.
    pub fn gauss() -> Self {
        let table = Collocation::<S>::new(Family::Gauss, STAGES);
        Rule {
            nodes: std::array::from_fn(|i| table.nodes[i]),
            weights: std::array::from_fn(|i| table.weights[i]),
            matrix: std::array::from_fn(|i| std::array::from_fn(|j| table.matrix[i][j])),
        }
    }
}

impl<S: Scalar> Kick<S> {
    /// Of a machine for a length of time. `quotient(a, b)` is (exp(-a) - exp(-b)) / (b - a).
    pub fn new<P: Base, M: Machine<P>>(
        machine: &M,
        law: Law,
        length: S,
        compliance: S,
        quotient: impl Fn(S, S) -> S,
        rule: Rule<S>,
    ) -> Self
    where
        S: Over<P>,
    {
        let ratio = |k| S::lift(machine.resistance(k)) / S::lift(machine.inductance(k));
        let loss = |exponent: S| exponent * quotient(S::zero(), exponent);
        let windings = 0..machine.windings();
        let moment = match law {
            Law::Linear => {
                let frame_speed = Tangent::fixed(S::lift(machine.frame_speed()));
                let slip = Tangent::variable(S::zero());
                let Tangent { value, slope, .. } = machine.moment_law(slip, slip + frame_speed);
                let rate = -compliance * slope;
                let pushed = |k| compliance * length * quotient(ratio(k) * length, rate * length);
                let lasting = length * quotient(S::zero(), rate * length);
                Moment::Linear { at_zero: value, rate, lasting, pushes: windings.clone().map(pushed).collect() }
            }
            Law::Curved => {
                let left = |k| rule.nodes.map(|node| S::one() - loss(ratio(k) * node * length));
                Moment::Curved { rule, left: windings.clone().map(left).collect() }
            }
        };
        Kick { length, compliance, losses: windings.map(|k| loss(ratio(k) * length)).collect(), moment }
    }
}

/// Whether the flow is known: of windings with an angle that the laws know, without supply, without sliding.
pub fn has_known_flow<P: Base, M: Machine<P>>(machine: &M) -> bool {
    machine.windings() == 0 || M::ROTOR == RotorState::AngleAndSpeed && !is_fed(machine)
}

/// The flow: moves the rotor's momentum and the fluxes. Gives what is left of the equation that is solved by iteration.
#[inline]
pub fn kick<P: Base, S: Over<P> + Analytic, M: Machine<P>>(
    machine: &M,
    by: &Kick<S>,
    slip: S,
    pull: S,
    rotor: &mut Point<S>,
) -> S {
    let angle = if M::ROTOR == RotorState::AngleAndSpeed { rotor.angle.circle() } else { Circle::zero() };
    let varied = angle.moving(S::one());
    let force = -machine.field_energy(varied).slope;
    let windings = rotor.fluxes.iter_mut().zip(&by.losses).enumerate();
    // psi_k' i_k(0), and the fluxes after
    let couplings = windings.map(|(k, (flux, loss))| {
        let Tangent { value, slope, .. } = machine.linkage(k, varied);
        let own = *flux - value;
        *flux -= own * *loss;
        slope * own / S::lift(machine.inductance(k))
    });
    let steady = |force: S| by.compliance * force + pull;
    let (gain, left) = match &by.moment {
        Moment::Linear { at_zero, rate, lasting, pushes } => {
            let start = *lasting * (steady(force + *at_zero) - *rate * slip);
            (couplings.zip(pushes).fold(start, |gain, (coupling, push)| gain + coupling * *push), S::zero())
        }
        Moment::Curved { rule, left } => {
            let mut forces = [force; STAGES];
            for (coupling, left) in couplings.zip(left) {
                forces.iter_mut().zip(left).for_each(|(force, left)| *force += coupling * *left);
            }
            let rate = |i: usize, slip: Tangent<S>| {
                let speed = slip + Tangent::fixed(S::lift(machine.frame_speed()));
                let moment = machine.moment_law(slip, speed);
                Tangent::moving(steady(forces[i] + moment.value), by.compliance * moment.slope)
            };
            rule.solve(by.length, slip, rate)
        }
    };
    rotor.momentum += (gain - by.length * pull) / by.compliance;
    left
}

impl<S: Scalar> Rule<S> {
    /// What s' = f_i(s) adds to s over a length of time, f_i the rate at node i with its slope; and the last correction
    /// of Newton's iteration, squared.
    fn solve(&self, length: S, start: S, rate: impl Fn(usize, Tangent<S>) -> Tangent<S>) -> (S, S) {
        let mut stages = [start; STAGES];
        let mut left = S::zero();
        for _ in 0..ITERATIONS {
            let rates: [Tangent<S>; STAGES] = std::array::from_fn(|i| rate(i, Tangent::variable(stages[i])));
            let mut rows: [[S; STAGES]; STAGES] = std::array::from_fn(|i| {
                std::array::from_fn(|j| {
                    let unit = if i == j { S::one() } else { S::zero() };
                    unit - length * self.matrix[i][j] * rates[j].slope
                })
            });
            let mut residuals: [S; STAGES] = std::array::from_fn(|i| {
                let slopes = self.matrix[i].iter().zip(&rates);
                slopes.fold(start - stages[i], |sum, (a, rate)| sum + length * *a * rate.value)
            });
            eliminate(&mut rows, &mut residuals);
            stages.iter_mut().zip(residuals).for_each(|(stage, correction)| *stage += correction);
            left = residuals.iter().fold(S::zero(), |sum, correction| sum + *correction * *correction);
        }
        let gain = (0..STAGES)
            .fold(S::zero(), |sum, i| sum + length * self.weights[i] * rate(i, Tangent::variable(stages[i])).value);
        (gain, left)
    }
}

/// Solves in place; without a choice of pivots, which laws over any field cannot make: the matrix is near one.
fn eliminate<S: Scalar>(rows: &mut [[S; STAGES]; STAGES], right: &mut [S; STAGES]) {
    for k in 0..STAGES {
        for i in (0..STAGES).filter(|i| *i != k) {
            let factor = rows[i][k] / rows[k][k];
            let above = rows[k];
            rows[i].iter_mut().zip(above).for_each(|(entry, above)| *entry -= factor * above);
            let above = right[k];
            right[i] -= factor * above;
        }
    }
    (0..STAGES).for_each(|k| right[k] /= rows[k][k]);
}

impl<S: Analytic> Point<S> {
    /// From the rotor's part of a law's state with its momentum, and the currents.
    pub fn enter<P: Base, M: Machine<P>>(machine: &M, rotor: &[S], momentum: S, currents: &[S]) -> Self
    where
        S: Over<P>,
    {
        let angle = match (M::ROTOR, rotor) {
            (RotorState::AngleAndSpeed, [angle, ..]) => *angle,
            _ => S::zero(),
        };
        let point = angle.circle();
        let flux = |(k, &i): (usize, &S)| S::lift(machine.inductance(k)) * i + machine.linkage(k, point);
        Point { angle, momentum, fluxes: currents.iter().enumerate().map(flux).collect() }
    }

    /// To the rotor's part of a law's state, and the currents.
    #[inline]
    pub fn leave<P: Base, M: Machine<P>>(&self, machine: &M, slip: S, y: &mut [S])
    where
        S: Over<P>,
    {
        let (rotor, currents) = y.split_at_mut(M::ROTOR.dimension());
        M::ROTOR.write(self.angle, slip, rotor);
        if !currents.is_empty() {
            let point = self.angle.circle();
            for (k, (i, flux)) in currents.iter_mut().zip(&self.fluxes).enumerate() {
                *i = (*flux - machine.linkage(k, point)) / S::lift(machine.inductance(k));
            }
        }
    }
}

/// The fastest rate at which a current fades: the largest r_k.
pub fn fastest_current<S: Real>(machine: &impl Machine<f64>) -> S {
    let rates = (0..machine.windings()).map(|k| S::lift(machine.resistance(k)) / S::lift(machine.inductance(k)));
    rates.fold(S::zero(), |fastest, rate| if rate > fastest { rate } else { fastest })
}

/// The rate at which a slip fades by the moment m alone: -K dm/ds.
pub fn fading_slip<S: Real>(machine: &impl Machine<f64>, compliance: S, slip: S) -> S {
    let slip = Tangent::variable(slip);
    -compliance * machine.moment_law(slip, slip + Tangent::fixed(S::lift(machine.frame_speed()))).slope
}

/// Whether Newton's iteration came close enough for its next step to end in rounding, slips being of any size.
pub fn solved<S: Real>(left: S) -> bool {
    left <= S::lift(S::EPSILON)
}

/// (exp(-a) - exp(-b)) / (b - a), also where a and b are near each other, or far apart.
pub fn decay_quotient<S: Real>(a: S, b: S) -> S {
    let (low, gap) = if a < b { (a, b - a) } else { (b, a - b) };
    // (1 - exp(-gap)) / gap
    let mut share = S::zero();
    if gap < S::ratio(1, 2) {
        let mut term = S::one();
        let mut k = 1;
        while term.magnitude() > S::lift(S::EPSILON * 1e-2) {
            share += term;
            k += 1;
            term *= -gap / S::int(k);
        }
    } else {
        share = (S::one() - (-gap).exp()) / gap;
    }
    (-low).exp() * share
}
