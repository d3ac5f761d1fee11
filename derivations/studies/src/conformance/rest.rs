//! Steady currents, steady states of the motor on a bench, their stability, and the stiffness of the equations there.

use super::instant::{Instant, vanish};
use super::verdict_of;
use crate::stationary::motor::{MotorStates, NoMotor};
use claims::finding::PropertyVerdict;
use integrators::{Jacobian, Method, Ode, Span, Tolerance, integrate, spectrum};
use motor::{Bench, Machine, Motor, RotorState, is_fed, steady_currents, torque_and_current_rates};
use nalgebra::Complex;
use simulation::CompiledLaw;
use symbolic::Sym;

/// The moment of inertia A', kg m^2, of the bench on which runs confirm the exact results.
const AXIAL: f64 = 0.01;
/// The initial deviation from the steady state, the length of a run in slowest time constants (long enough for
/// transient growth to decay), and its budget of evaluations. An oscillation that hardly decays remains undecided.
const OFF: f64 = 1e-4;
const LONG: f64 = 12.0;
const MOST: u64 = 2_000_000;
/// The largest rate at a steady state, relative to the terms of which it is the sum.
const ROUNDING: f64 = 1e-9;
/// Eigenvalues with a larger ratio cannot both be resolved in double precision.
const APART: f64 = 1e12;

/// Proves that every rate vanishes at the steady currents, for any inductances: they are also the currents in the limit
/// L -> 0. At synchronism without a supply they vanish, and the motor without currents remains.
pub(super) fn currents(machine: &impl Machine<Sym>, at: &Instant) -> PropertyVerdict {
    if at.currents.is_empty() {
        return PropertyVerdict::DoesNotApply("it has no windings".to_owned());
    }
    let Some(resting) = steady_currents(machine, at.angle, at.slip) else {
        return PropertyVerdict::Fails(
            "no currents rest: the smaller model without their transients does not exist".to_owned(),
        );
    };
    let mut rates = vec![Sym::ZERO; resting.len()];
    torque_and_current_rates(machine, at.angle, at.slip, &resting, &mut rates);
    let rates = rates.into_iter().enumerate().map(|(k, rate)| (format!("the rate of resting current {k}"), rate));
    if is_fed(machine) || machine.rotor() != RotorState::AngleAndSpeed {
        return verdict_of(vanish(rates), "L -> 0: there are currents at which every rate vanishes");
    }
    let still = vec![Sym::ZERO; resting.len()];
    let in_step = torque_and_current_rates(machine, at.angle, Sym::ZERO, &still, &mut still.clone());
    let bare =
        machine.torque_law(Sym::ZERO, machine.frame_speed()) - machine.field_energy(at.angle.moving(Sym::ONE)).slope;
    let step = std::iter::once(("the torque in step".to_owned(), in_step - bare));
    verdict_of(
        vanish(rates.chain(step)),
        "L -> 0: every rate vanishes at some currents; in step it is the motor without",
    )
}

/// The steady states as numbers, each with its spectrum and the growth of a deviation in a run.
pub(super) struct Rest {
    known: Result<Known, PropertyVerdict>,
}

struct Known {
    states: Vec<State>,
    /// Whether every speed is a steady state, as for a free rotor; one of them is examined.
    every: bool,
}

struct State {
    /// The largest rate at the steady state, relative to its largest term.
    residual: f64,
    spectrum: Option<Vec<Complex<f64>>>,
    /// The ratio of the deviations at the end and at the start of a run; `None` where the largest real part is zero
    /// within rounding.
    grows: Option<f64>,
}

impl Rest {
    /// The steady states of a motor, checked with its law.
    pub fn of(machine: &Motor) -> Self {
        Self::beside(MotorStates::of(machine), machine)
    }

    /// Exact steady states, checked with the law of a machine.
    pub fn beside<M>(motor: Result<MotorStates, NoMotor>, machine: &M) -> Self
    where
        M: Machine<f64> + Clone + Send + Sync + 'static,
    {
        let unknown = |reason: NoMotor| match reason {
            NoMotor::NotAlgebraic(_) => PropertyVerdict::Undecided(reason.to_string()),
            NoMotor::Data(_) | NoMotor::NoRest | NoMotor::AnyAngle => PropertyVerdict::Fails(reason.to_string()),
        };
        let known = motor.map_err(unknown).and_then(|motor| {
            let bench = Bench { machine: machine.clone(), axial: AXIAL };
            let starts = states(&motor, machine);
            if bench.dimension() == 0 {
                return Err(PropertyVerdict::DoesNotApply(
                    "a kept rotor without windings has no state of its own".to_owned(),
                ));
            }
            let system = CompiledLaw::new(bench);
            let states = starts.iter().map(|start| State::at(&system, start)).collect();
            Ok(Known { states, every: matches!(motor, MotorStates::Free) })
        });
        Rest { known }
    }

    /// Checks that the rates of the integrated law vanish at the exact steady states.
    pub fn stationary(&self) -> PropertyVerdict {
        self.judged(|known| {
            let count = known.states.len();
            if count == 0 {
                return PropertyVerdict::Proved("it has no stationary state".to_owned());
            }
            match known.states.iter().position(|state| state.residual > ROUNDING) {
                Some(place) => {
                    PropertyVerdict::Fails(format!("the law that runs does not rest at stationary state {}", place + 1))
                }
                None if known.every => PropertyVerdict::Tested("every speed is stationary, and rests".to_owned()),
                None if count == 1 => {
                    PropertyVerdict::Tested("one state, found exactly; the law that runs rests there".to_owned())
                }
                None => PropertyVerdict::Tested(format!(
                    "{count} states, all found exactly; the law that runs rests at each"
                )),
            }
        })
    }

    /// Checks that runs from nearby states converge or diverge in agreement with the eigenvalues.
    pub fn stability(&self) -> PropertyVerdict {
        self.judged(|known| {
            let told: Vec<(bool, f64)> = known.states.iter().filter_map(State::told).collect();
            let wrong = told.iter().find(|(decays, grows)| *decays != (*grows < 1.0));
            match wrong {
                Some((true, _)) => {
                    PropertyVerdict::Fails("a run leaves a state to which its eigenvalues draw it".to_owned())
                }
                Some((false, _)) => {
                    PropertyVerdict::Fails("a run comes to a state from which its eigenvalues drive it".to_owned())
                }
                None if told.is_empty() => {
                    PropertyVerdict::DoesNotApply("eigenvalues decide the stability of no state".to_owned())
                }
                None => {
                    let stable = told.iter().filter(|(decays, _)| *decays).count();
                    let left = told.len() - stable;
                    PropertyVerdict::Tested(format!("as the eigenvalues say, runs come to {stable} and leave {left}"))
                }
            }
        })
    }

    /// Computes the stiffness ratio: the largest modulus of an eigenvalue divided by the smallest nonzero one.
    pub fn stiffness(&self) -> PropertyVerdict {
        self.judged(|known| {
            let mut widest = 1.0_f64;
            for state in &known.states {
                let Some(spectrum) = &state.spectrum else {
                    return PropertyVerdict::Fails("the eigenvalues at a stationary state are not finite".to_owned());
                };
                let sizes = || spectrum.iter().map(|root| root.norm()).filter(|size| *size > 1e-12);
                let (least, most) = (sizes().fold(f64::INFINITY, f64::min), sizes().fold(0.0, f64::max));
                widest = widest.max(if least.is_finite() { most / least } else { 1.0 });
            }
            match widest {
                _ if known.states.is_empty() => PropertyVerdict::DoesNotApply("it has no stationary state".to_owned()),
                apart if apart > APART => {
                    PropertyVerdict::Fails("the fastest motion hides the slowest in rounding".to_owned())
                }
                apart => PropertyVerdict::Tested(format!("eigenvalues within 10^{}", apart.log10().ceil() as i32)),
            }
        })
    }

    fn judged(&self, judge: impl FnOnce(&Known) -> PropertyVerdict) -> PropertyVerdict {
        self.known.as_ref().map_or_else(Clone::clone, judge)
    }
}

impl State {
    fn at(system: &CompiledLaw, start: &[f64]) -> Self {
        let n = start.len();
        let mut rates = vec![0.0; n];
        Ode::<f64>::rates(system, 0.0, start, &mut rates);
        let mut matrix = vec![0.0; n * n];
        Jacobian::of(system).matrix(0.0, start, &mut matrix);
        let size =
            matrix.iter().zip(start.iter().cycle()).fold(1.0, |most: f64, (entry, y)| most.max((entry * y).abs()));
        let residual = rates.iter().fold(0.0, |most: f64, rate| most.max(rate.abs())) / size;
        let spectrum = spectrum(n, &matrix);
        let grows = spectrum.as_ref().and_then(|spectrum| ratio(system, start, spectrum));
        State { residual, spectrum, grows }
    }

    /// Whether all eigenvalues have negative real parts, and the growth in a run; `None` where the eigenvalues do not
    /// decide.
    fn told(&self) -> Option<(bool, f64)> {
        let real = |root: &Complex<f64>| root.re;
        let spectrum = self.spectrum.as_ref()?;
        Some((spectrum.iter().map(real).fold(f64::NEG_INFINITY, f64::max) < 0.0, self.grows?))
    }
}

/// The ratio of the deviations from a steady state at the end and at the start of a run; `None` where the eigenvalues
/// do not decide.
fn ratio(system: &CompiledLaw, start: &[f64], spectrum: &[Complex<f64>]) -> Option<f64> {
    let size = spectrum.iter().fold(0.0, |most: f64, root| most.max(root.norm()));
    let greatest = spectrum.iter().fold(f64::NEG_INFINITY, |most, root| most.max(root.re));
    if greatest.abs() <= 1e-9 * size {
        return None;
    }
    let slowest = match greatest < 0.0 {
        true => spectrum.iter().fold(f64::INFINITY, |least, root| least.min(-root.re)),
        false => greatest,
    };
    let off = |k: usize| OFF * (1.0 + 0.3 * (k as f64).sin());
    let from: Vec<f64> = start.iter().enumerate().map(|(k, y)| y + off(k)).collect();
    let mut span = Span::new(0.0, LONG / slowest, &from);
    span.budget.evaluations = MOST;
    let outcome = integrate(system, Method::RadauIIA { stages: 3 }, &Tolerance::both(1e-9), &span, &mut ());
    let away = |y: &[f64]| y.iter().zip(start).map(|(y, rest)| (y - rest).abs()).fold(0.0, f64::max);
    outcome.reached().then(|| away(&outcome.state) / away(&from))
}

/// The states on a bench: those of the rotor, then the currents.
fn states(motor: &MotorStates, machine: &impl Machine<f64>) -> Vec<Vec<f64>> {
    let with = |rotor: &[f64], currents: &[f64]| {
        let mut state = [rotor, currents].concat();
        state.resize(machine.rotor().dimension() + machine.windings(), 0.0);
        state
    };
    match motor {
        MotorStates::Kept { .. } => vec![with(&[], &[])],
        MotorStates::Free => vec![with(&[1.0], &[])],
        MotorStates::InStep { angles, .. } => {
            angles.iter().map(|angle| with(&[angle.radians(), 0.0], &angle.currents)).collect()
        }
        MotorStates::Slipping { speeds, .. } => {
            let frame_speed = machine.frame_speed();
            speeds.iter().map(|slip| with(&[slip.speed.to_f64() - frame_speed], &slip.currents)).collect()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Known, Rest, State};
    use claims::finding::PropertyVerdict;
    use integrators::Ode;
    use simulation::CompiledLaw;
    use symbolic::Sym;

    /// y' = (t - 1) y, or its negative: the eigenvalue at the start determines the growth during the first second only.
    struct Fickle {
        decays: bool,
    }

    impl Ode<Sym> for Fickle {
        fn dimension(&self) -> usize {
            1
        }

        fn rates(&self, t: Sym, y: &[Sym], dy: &mut [Sym]) {
            let rate = (t - Sym::ONE) * y[0];
            dy[0] = if self.decays { rate } else { -rate };
        }
    }

    #[test]
    fn a_run_that_does_not_do_what_the_eigenvalues_say_is_found_out() {
        for decays in [true, false] {
            let state = State::at(&CompiledLaw::new(Fickle { decays }), &[0.0]);
            let rest = Rest { known: Ok(Known { states: vec![state], every: false }) };
            assert!(matches!(rest.stability(), PropertyVerdict::Fails(_)), "{:?}", rest.stability());
        }
    }
}
