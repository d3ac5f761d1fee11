//! The flow of the currents and the rotor momentum at a constant angle, for splitting methods.
//!
//! With the flux linkages c_k = L_k i_k + psi_k(g) the energy of the circuits is U(g) + sum (c_k - psi_k(g))^2 / (2
//! L_k). At a constant angle the currents decay, i_k = i_k(0) exp(-r_k t) with r_k = R_k/L_k, and the slip s = g'
//! satisfies
//!
//!   s' = K (-U'(g) + sum_k psi_k'(g) i_k(t) + m(s)) + pull ,
//!
//! K is the slip per unit of angular impulse, and `pull` the rate of the slip due to other causes. If m is linear,
//! m(s) = m(0) - b s, the solution consists of exponentials; otherwise Gauss collocation of order 8 is used. When the
//! angle moves, the c_k are constant.
//!
//! With a supply or with sliding conductors, c_k phi' couples the currents to the slip also at a constant angle, and
//! the flow has no such form. Such machines are rejected ([`has_known_flow`]).

use super::fixed_angle_laws::FixedAngleMachine;
use super::gauss4_scalar::{Rule, STAGES};
use super::{Machine, RotorState, is_fed};
use field::{Analytic, Base, Circle, Over, Scalar, Tangent};
use integrators::Real;
use symbolic::{Hypotheses, Sym, decide};

/// The state of the rotor, in the coordinates of the pieces.
#[derive(Clone, Debug, PartialEq)]
pub struct Point<S> {
    /// The angle g, rad; unused where the laws do not depend on it.
    pub angle: S,
    /// The rotor's angular momentum p, N m s.
    pub momentum: S,
    /// The flux linkages c_k, Wb.
    pub fluxes: Vec<S>,
}

/// Whether the torque m is linear in the slip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    Linear,
    Curved,
}

/// The flow over one time length, with precomputed coefficients.
#[derive(Clone, Debug)]
pub struct Kick<S> {
    pub length: S,
    /// K, 1/(kg m^2).
    compliance: S,
    /// 1 - exp(-r_k h).
    losses: Vec<S>,
    torque: TorqueLaw<S>,
}

#[derive(Clone, Debug)]
enum TorqueLaw<S> {
    /// m(0); K b; the integral of exp(-K b t) over h; the change of slip per unit of each psi_k' L_k i_k(0).
    Linear { at_zero: S, rate: S, lasting: S, pushes: Vec<S> },
    /// exp(-r_k c_i h) / L_k at each node c_i.
    Curved { rule: Rule<S>, left: Vec<[S; STAGES]> },
}

impl Law {
    /// Decides by the second derivative of the torque, exactly.
    pub fn of(machine: &impl Machine<f64>) -> Self {
        let slip = Sym::symbol("slip");
        let torque = machine.torque_law(slip, slip + Sym::lift(machine.frame_speed()));
        let bend = torque.diff(slip).diff(slip);
        if decide(bend, &Hypotheses::none()).is_zero() { Law::Linear } else { Law::Curved }
    }
}

impl<S: Scalar> Kick<S> {
    /// Prepares the flow of a machine over a time length (s). `quotient(a, b)` is (exp(-a) - exp(-b)) / (b - a).
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
        let inductance = |k| S::lift(machine.inductance(k));
        let ratio = |k| S::lift(machine.resistance(k)) / inductance(k);
        let loss = |exponent: S| exponent * quotient(S::zero(), exponent);
        let windings = 0..machine.windings();
        let torque = match law {
            Law::Linear => {
                let Tangent { value, slope, .. } = torque_at(machine, S::zero());
                let rate = -compliance * slope;
                let pushed = |k| compliance * length * quotient(ratio(k) * length, rate * length) / inductance(k);
                let lasting = length * quotient(S::zero(), rate * length);
                TorqueLaw::Linear { at_zero: value, rate, lasting, pushes: windings.clone().map(pushed).collect() }
            }
            Law::Curved => {
                let left = |k| rule.nodes.map(|node| (S::one() - loss(ratio(k) * node * length)) / inductance(k));
                TorqueLaw::Curved { rule, left: windings.clone().map(left).collect() }
            }
        };
        Kick { length, compliance, losses: windings.map(|k| loss(ratio(k) * length)).collect(), torque }
    }
}

/// Whether the flow is available: the laws depend on the angle, and there is neither a supply nor a sliding conductor.
pub fn has_known_flow<P: Base, M: Machine<P>>(machine: &M) -> bool {
    machine.windings() == 0 || machine.rotor() == RotorState::AngleAndSpeed && !is_fed(machine)
}

/// Passes psi_k(g) with its derivative to `each`, for each winding k. Returns -U'(g).
#[inline(always)]
pub fn laws_at<P: Base, S: Over<P>, M: Machine<P>>(
    machine: &M,
    angle: Circle<S>,
    mut each: impl FnMut(usize, Tangent<S>),
) -> S {
    let varied = angle.moving(S::one());
    let force = -machine.field_energy(varied).slope;
    (0..machine.windings()).for_each(|k| each(k, machine.linkage(k, varied)));
    force
}

/// The torque m at a slip, with its derivative.
#[inline(always)]
pub fn torque_at<P: Base, S: Over<P>>(machine: &impl Machine<P>, slip: S) -> Tangent<S> {
    let slip = Tangent::variable(slip);
    machine.torque_law(slip, slip + Tangent::fixed(S::lift(machine.frame_speed())))
}

/// Applies the flow to the rotor's momentum and the fluxes. Returns the residual of the equation that is solved by
/// iteration.
#[inline]
pub fn kick<P: Base, S: Over<P> + Analytic, A: FixedAngleMachine<P, S>>(
    machine: &A,
    by: &Kick<S>,
    slip: S,
    pull: S,
    rotor: &mut Point<S>,
) -> S {
    let fluxes = &mut rotor.fluxes;
    // psi_k' L_k i_k(0), and the new flux
    let mut fade = |k: usize, Tangent { value, slope, .. }: Tangent<S>| {
        let (flux, loss) = (&mut fluxes[k], &by.losses[k]);
        let own = *flux - value;
        *flux -= own * *loss;
        slope * own
    };
    let steady = |force: S| by.compliance * force + pull;
    let (gain, left) = match &by.torque {
        TorqueLaw::Linear { at_zero, rate, lasting, pushes } => {
            let mut pushed = S::zero();
            let force = force(machine, rotor.angle, |k, linkage| pushed += fade(k, linkage) * pushes[k]);
            (pushed + *lasting * (steady(force + *at_zero) - *rate * slip), S::zero())
        }
        TorqueLaw::Curved { rule, left } => {
            let mut forces = [S::zero(); STAGES];
            let force = force(machine, rotor.angle, |k, linkage| {
                let coupling = fade(k, linkage);
                forces.iter_mut().zip(&left[k]).for_each(|(force, left)| *force += coupling * *left);
            });
            let rates = |slips: &[S; STAGES]| {
                let torques = machine.torques(slips);
                std::array::from_fn(|i| {
                    let Tangent { value, slope, .. } = torques[i];
                    Tangent::moving(steady(force + forces[i] + value), by.compliance * slope)
                })
            };
            rule.solve(by.length, slip, rates)
        }
    };
    rotor.momentum += (gain - by.length * pull) / by.compliance;
    left
}

/// [`FixedAngleMachine::at_angle`] for a machine whose laws depend on the angle; zero for others, which have no
/// windings.
#[inline(always)]
fn force<P: Base, S: Over<P> + Analytic, A: FixedAngleMachine<P, S>>(
    machine: &A,
    angle: S,
    each: impl FnMut(usize, Tangent<S>),
) -> S {
    if machine.machine().rotor() == RotorState::AngleAndSpeed {
        machine.at_angle(angle.circle(), each)
    } else {
        S::zero()
    }
}

impl<S: Analytic> Point<S> {
    /// The point of the rotor's part of a state, its momentum, and the currents.
    pub fn enter<P: Base, M: Machine<P>>(machine: &M, rotor: &[S], momentum: S, currents: &[S]) -> Self
    where
        S: Over<P>,
    {
        let angle = match (machine.rotor(), rotor) {
            (RotorState::AngleAndSpeed, [angle, ..]) => *angle,
            _ => S::zero(),
        };
        let point = angle.circle();
        let flux = |(k, &i): (usize, &S)| S::lift(machine.inductance(k)) * i + machine.linkage(k, point);
        Point { angle, momentum, fluxes: currents.iter().enumerate().map(flux).collect() }
    }

    /// Writes the rotor's part of a state, and the currents.
    #[inline]
    pub fn leave<P: Base, A: FixedAngleMachine<P, S>>(&self, acting: &A, slip: S, y: &mut [S])
    where
        S: Over<P>,
    {
        let machine = acting.machine();
        let state = machine.rotor();
        let (rotor, currents) = y.split_at_mut(state.dimension());
        state.write(self.angle, slip, rotor);
        if !currents.is_empty() {
            acting.linkages(self.angle.circle(), |k, linkage| {
                currents[k] = (self.fluxes[k] - linkage) / S::lift(machine.inductance(k));
            });
        }
    }
}

/// The decay rates of the currents and of the slip in a kick, 1/s.
#[derive(Clone, Copy, Debug)]
pub struct DecayRates<S> {
    /// The largest r_k, 1/s.
    current: S,
    /// K, 1/(kg m^2).
    compliance: S,
    /// -K dm/ds for a torque that is linear in the slip, 1/s.
    slip: Option<S>,
}

impl<S: Real> DecayRates<S> {
    /// The rates of a machine with the given change of slip per unit of angular impulse.
    pub fn of(machine: &impl Machine<f64>, law: Law, compliance: S) -> Self {
        let rates = (0..machine.windings()).map(|k| S::lift(machine.resistance(k)) / S::lift(machine.inductance(k)));
        let current = rates.fold(S::zero(), |fastest, rate| if rate > fastest { rate } else { fastest });
        let unknown = DecayRates { current, compliance, slip: None };
        DecayRates { slip: (law == Law::Linear).then(|| unknown.of_slip(machine, S::zero())), ..unknown }
    }

    /// The fastest decay rate of a current or of the slip, at a slip (rad/s), in 1/s.
    pub fn fastest(&self, machine: &impl Machine<f64>, slip: S) -> f64 {
        let of_slip = self.slip.unwrap_or_else(|| self.of_slip(machine, slip));
        self.current.approx().max(of_slip.approx())
    }

    /// The decay rate of the slip due to the torque m, 1/s.
    fn of_slip(&self, machine: &impl Machine<f64>, slip: S) -> S {
        -self.compliance * torque_at(machine, slip).slope
    }
}

/// Whether Newton's iteration has converged such that its next correction would be rounding.
pub fn solved<S: Real>(left: S) -> bool {
    left <= S::lift(S::EPSILON)
}

/// The quotient (exp(-a) - exp(-b)) / (b - a), accurate also for equal and for very different arguments.
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
