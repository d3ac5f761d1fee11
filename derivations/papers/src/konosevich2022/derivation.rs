//! Equations of motion of the paper's gyrostat and of its motor, as text: derived by a selected principle, in normal
//! form, not solved for the accelerations.

use super::alphabet::letter;
use super::letters::Letters;
use claims::derivation::{Derivation, Equation, NotDerived, Principle};
use claims::submit;
use mechanics::rotation::{euler, vertical};
use symbolic::{Hypotheses, Sym, coefficients, normal};
use systems::gyrostat::MotionInstant;

const GYROSTAT: Derivation = Derivation {
    name: "gyrostat",
    summary: "carrier and rotor in the principal axes of A, under the moment M on the rotor",
    principles: &[Principle::Momentum, Principle::Appell, Principle::Hamel, Principle::Lagrange],
    equations: gyrostat,
};

const MOTOR: Derivation = Derivation {
    name: "motor",
    summary: "the synchronous motor with three damper bars, alone: moment and currents",
    principles: &[Principle::Maxwell],
    equations: |_| {
        let (s, bars) = (Letters::default(), 3);
        motor::reading::equations(&s.motor(bars), &s.currents(bars))
    },
};

submit! { GYROSTAT }
submit! { MOTOR }

fn gyrostat(principle: Principle) -> Result<Vec<Equation>, NotDerived> {
    let s = &Letters::default();
    let g = s.in_axes_of_a();
    let angles = ["ψ", "θ", "φ", "φ′"].map(letter);
    let mut accelerations = vec![s.dw.x, s.dw.y, s.dw.z, s.ddphi];
    let residuals = match principle {
        Principle::Momentum => g.by_momentum(&s.motion()),
        Principle::Appell => g.by_appell(&s.motion()),
        Principle::Hamel => {
            let at = vertical(&euler([angles[0], angles[1], angles[2]]));
            g.by_hamel(angles, &MotionInstant { vertical: at, ..s.motion() })
        }
        Principle::Lagrange => {
            let rates = ["ψ̇", "θ̇", "φ̇", "φ̇′"].map(letter);
            let second = ["ψ̈", "θ̈", "φ̈", "φ̈′"].map(letter);
            accelerations = second.to_vec();
            g.by_lagrange(angles, rates, second, s.torque)
        }
        Principle::Maxwell | Principle::VirtualPower | Principle::Gauss => {
            return Err(NotDerived::Inapplicable { system: GYROSTAT.name, accepted: GYROSTAT.principles });
        }
    };
    residuals.into_iter().map(|residual| split(residual, &accelerations, &s.unit_axis)).collect()
}

fn simplified(expression: Sym, rules: &Hypotheses) -> Result<Sym, NotDerived> {
    normal(expression, rules).map(|form| form.to_sym()).map_err(|reason| NotDerived::TooLarge(reason.to_string()))
}

/// The equation residual = 0 with the accelerations on the left-hand side, multiplied by the common denominator.
fn split(residual: Sym, accelerations: &[Sym], rules: &Hypotheses) -> Result<Equation, NotDerived> {
    let form = normal(residual, rules).map_err(|reason| NotDerived::TooLarge(reason.to_string()))?;
    let terms =
        coefficients(form.numerator(), accelerations).map_err(|reason| NotDerived::TooLarge(reason.to_string()))?;
    let (mut left, mut right) = (Sym::ZERO, Sym::ZERO);
    for (exponents, coefficient) in terms {
        let mut term = simplified(coefficient, rules)?;
        if exponents.iter().all(|&e| e == 0) {
            right -= term;
            continue;
        }
        for (acceleration, exponent) in accelerations.iter().zip(exponents) {
            if exponent > 0 {
                term *= acceleration.powi(exponent as i32);
            }
        }
        left += term;
    }
    Ok(Equation { left, right: simplified(right, rules)? })
}
