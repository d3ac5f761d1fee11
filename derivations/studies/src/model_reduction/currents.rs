//! Quasi-steady values of currents: algebraic functions of angle and slip that replace their equations.
//!
//! L i' + R i = -psi'(g) s with the slip s = g'. Three approximations, from the richest:
//!
//! | value of i | exact where | small parameter |
//! |---|---|---|
//! | the current at the present slip, -s (R psi' - L s psi'')/(R^2 + L^2 s^2) | the slip is constant | (L/R)^2 \|s'\| |
//! | the resistive current, -psi' s/R | nothing induces: L = 0 | (L/R) \|s\| |
//! | none, 0 | the rotor is synchronous | psi'^2 \|s\|/R relative to the other torques |
//!
//! The first is a solution for fluxes with one harmonic, psi'' + psi constant, and is used for these only. Windings
//! with a supply, or with sliding conductors, have currents at synchronism too: all their currents take the steady
//! values at the present angle and speed ([`motor::steady_currents`]).

use field::{Circle, Over, Tangent};
use motor::Machine;
use symbolic::{Hypotheses, Sym, decide};

/// The algebraic value that replaces a current.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Current {
    /// The periodic current for the present slip, taken as constant.
    AtPresentSlip,
    /// The current of a circuit without inductance.
    Resistive,
    /// Zero.
    Absent,
}

impl Current {
    /// The current of a winding at an angle and slip (rad/s), A.
    pub fn of<S, M>(self, machine: &M, winding: usize, angle: Circle<S>, slip: S) -> S
    where
        S: Over<f64>,
        M: Machine<f64>,
    {
        let [_, first, second] = flux(machine, winding, angle);
        let (l, r) = (S::lift(machine.inductance(winding)), S::lift(machine.resistance(winding)));
        match self {
            Current::AtPresentSlip => {
                -(slip * (r * first - l * slip * second)) / (r.squared() + l.squared() * slip.squared())
            }
            Current::Resistive => -(first * slip) / r,
            Current::Absent => S::zero(),
        }
    }

    /// Whether this value is available for a winding.
    pub fn suits<M: Machine<f64>>(self, machine: &M, winding: usize) -> bool {
        match self {
            Current::AtPresentSlip => machine.resistance(winding) > 0.0 && has_one_harmonic(machine, winding),
            Current::Resistive => machine.resistance(winding) > 0.0,
            Current::Absent => true,
        }
    }

    /// The neglected part of the currents, in words.
    pub fn dropped(self) -> &'static str {
        match self {
            Current::AtPresentSlip => "their transients; each current is that of the present slip",
            Current::Resistive => "their induction; each current is -psi' g'/R",
            Current::Absent => "these currents",
        }
    }

    /// The small parameter as a formula.
    pub fn parameter(self) -> &'static str {
        match self {
            Current::AtPresentSlip => "(L/R)^2 |slip'|",
            Current::Resistive => "(L/R) |slip|",
            Current::Absent => "psi'^2 |slip|/R over b0",
        }
    }

    /// The small parameter for a time constant (s), a slip (rad/s) and its rate; `None` where it depends on other
    /// quantities.
    pub fn value(self, time_constant: f64, slip: f64, rate: f64) -> Option<f64> {
        match self {
            Current::AtPresentSlip => Some(time_constant * time_constant * rate.abs()),
            Current::Resistive => Some(time_constant * slip.abs()),
            Current::Absent => None,
        }
    }
}

/// The flux linkage and its derivatives psi, psi', psi''.
fn flux<S: Over<f64>, M: Machine<f64>>(machine: &M, winding: usize, angle: Circle<S>) -> [S; 3] {
    let twice = angle.moving(S::one()).moving(Tangent::fixed(S::one()));
    let flux: Tangent<Tangent<S>> = machine.linkage(winding, twice);
    [flux.value.value, flux.value.slope, flux.slope.slope]
}

/// Whether psi'' + psi is constant, decided for all angles.
pub(super) fn has_one_harmonic<M: Machine<f64>>(machine: &M, winding: usize) -> bool {
    let point = Circle { cos: Sym::symbol("c"), sin: Sym::symbol("s") };
    let sum = |angle: Circle<Sym>| {
        let [value, _, second] = flux(machine, winding, angle);
        value + second
    };
    decide(sum(point) - sum(Circle::zero()), &Hypotheses::none().on_circle(point)).is_zero()
}
