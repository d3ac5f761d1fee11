//! The linearisation of a scene's gyrostat with its motor: symbolic, evaluated over fractions and enclosures.

use super::linear::{Integral, Linear};
use super::state::{Layout, StationaryState};
use crate::stationary::energies::Energies;
use crate::stationary::motor::NoMotor;
use algebra::real::Ordered;
use field::{Circle, Rational, Tangent};
use motor::{Machine, Motor, RotorState, is_fed, steady_currents};
use nalgebra::Vector3;
use std::sync::Arc;
use symbolic::{Formulas, Hypotheses, Sym, decide, symbols};

/// The matrices of [`Linear`] as formulas of the state, with the decimals of the file as data.
#[derive(Clone, Debug)]
pub struct Approximation {
    pub layout: Layout,
    /// The integrals, which give the structural zero eigenvalues.
    pub integrals: Vec<Integral>,
    /// Whether G is conserved: no dissipation at any slip.
    pub conservative: bool,
    /// Whether the motor's own torque does not depend on the slip: it neither damps nor drives.
    pub steady: bool,
    /// Whether a supply or sliding conductors change G, which then decides nothing.
    pub fed: bool,
    /// Whether there is no weight: the angular momentum is constant in space, with eigenvalues +-i w0.
    pub balanced: bool,
    formulas: Arc<Formulas>,
    /// The values of the symbols in the formulas: of the bodies, the load, a datum of the machine.
    letters: Vec<Rational>,
}

impl Approximation {
    /// The linearisation of bodies, given by their energies, with a machine.
    ///
    /// # Errors
    /// [`NoMotor`] where the machine's laws are not algebraic.
    pub fn of(energies: &Energies<Rational>, motor: &Motor) -> Result<Self, NoMotor> {
        Self::with(energies, &motor.decimals())
    }

    /// The linearisation with a machine whose data are constants.
    ///
    /// # Errors
    /// [`NoMotor::NotAlgebraic`] where the machine's laws are not algebraic.
    pub fn with(energies: &Energies<Rational>, machine: &impl Machine<Sym>) -> Result<Self, NoMotor> {
        Self::lettered(&energies.written(), machine, &[])
    }

    /// The linearisation with symbols among the data of bodies and machine, whose values are given later.
    pub(super) fn lettered(
        energies: &Energies<Sym>,
        machine: &impl Machine<Sym>,
        letters: &[Sym],
    ) -> Result<Self, NoMotor> {
        let unknowns = symbols(["w0", "v1", "v2", "v3", "W", "c", "s"]);
        let [speed, v1, v2, v3, rotor_speed, cos, sin] = unknowns;
        let place =
            StationaryState { speed, vertical: Vector3::new(v1, v2, v3), rotor_speed, angle: Circle { cos, sin } };
        let (fed, slip) = (is_fed(machine), rotor_speed - machine.frame_speed());
        if steady_currents(machine, place.angle, slip).is_none() {
            return Err(NoMotor::NoRest);
        }
        let linear = Linear::at(energies, machine, &place, is_free(machine));
        let all = linear.rates.iter().chain(&linear.energy).chain(&linear.integrals).chain(&linear.turning).flatten();
        let all: Vec<Sym> =
            all.chain(&linear.missing).chain(&linear.momentum).chain(&linear.damping).copied().collect();
        let unknowns = [&unknowns[..], letters].concat();
        let formulas = Formulas::of(&all, &unknowns).map_err(|reason| NoMotor::NotAlgebraic(reason.to_string()))?;
        let integrals = [Integral::Vertical, Integral::Momentum, Integral::RotorMomentum];
        let steady = is_steady(machine);
        Ok(Approximation {
            layout: Layout::of(machine),
            integrals: integrals[..linear.integrals.len()].to_vec(),
            conservative: steady && !fed && linear.damping.iter().all(|&one| vanishes(one)),
            steady,
            fed,
            formulas: Arc::new(formulas),
            letters: Vec::new(),
            balanced: energies.weight.iter().all(|&one| vanishes(one)),
        })
    }

    /// The linearisation with values for its symbols, including those of the bodies.
    pub(super) fn given(&self, letters: Vec<Rational>, energies: &Energies<Rational>) -> Self {
        let balanced = energies.weight.iter().all(|one| one.sign() == Some(0));
        Approximation { letters, balanced, ..self.clone() }
    }

    /// The matrices at a state; `None` where a number may be undefined, or is not in the number field.
    pub fn at<R: Ordered>(&self, place: &[R; 7], one: &R) -> Option<Linear<R>> {
        let letters: Vec<R> = self.letters.iter().map(|value| one.fraction(*value)).collect::<Option<_>>()?;
        let values = self.formulas.values(&[&place[..], &letters].concat(), one)?;
        let size = self.layout.size();
        let square = size * size;
        let rows = |from: usize, count: usize| -> Vec<Vec<R>> {
            values[from..from + count * size].chunks(size).map(<[R]>::to_vec).collect()
        };
        let integrals = self.integrals.len();
        let single = 2 * square + (integrals + 3) * size;
        Some(Linear {
            rates: rows(0, size),
            energy: rows(square, size),
            integrals: rows(2 * square, integrals),
            turning: rows(2 * square + integrals * size, 3),
            missing: rows(single, 1).concat(),
            momentum: values[single + size..single + size + 3].to_vec(),
            damping: values[single + size + 3..].to_vec(),
        })
    }
}

fn vanishes(expression: Sym) -> bool {
    decide(expression, &Hypotheses::none()).is_zero()
}

/// Whether the torque law never depends on the slip.
fn is_steady(machine: &impl Machine<Sym>) -> bool {
    let [slip, speed] = symbols(["slip", "speed"]);
    vanishes(machine.torque_law(Tangent::variable(slip), Tangent::variable(speed)).slope)
}

/// Whether no torque ever acts: no windings, no angle, and a vanishing torque law.
fn is_free(machine: &impl Machine<Sym>) -> bool {
    let [slip, speed] = symbols(["slip", "speed"]);
    machine.rotor() == RotorState::Speed && machine.windings() == 0 && vanishes(machine.torque_law(slip, speed))
}
