//! The electromechanical drive in its nine equations, the rod's constraint stabilised by gains of the scene.

use super::rewritten::{Rewritten, ready, redundant};
use super::{Amiss, Diagnosis, Ended, Mechanism};
use crate::stabilisation::bearable::bearable_steps;
use crate::stabilisation::drive_law::{Nine, Seven, instant, violation};
use crate::stabilisation::regions::decays;
use crate::stabilisation::schemes::Scheme;
use field::{Analytic, Over};
use integrators::{Method, Ode};
use mechanics::constrained::energies;
use reader::Quantity;
use simulation::Margin;
use simulation::work_precision::{Formulation, Treated};
use systems::crank_drive::{Circuit, CrankDrive};
use systems::crank_slider::CrankSlider;

/// The nine equations with the data of a scene.
#[derive(Clone, Copy, Debug)]
pub struct Drive(Nine);

reader::quantities! {
    /// Of the law that leads a violation f of the rod's constraint: f'' = -b f' - k f.
    pub struct Gains {
        /// b, damping of the constraint's violation; zero for Lagrange's equations alone
        damping: "1/s",
        /// k, stiffness of the constraint's violation
        stiffness: "1/s^2",
    }
}

/// The share of the square of the rod's length beyond which a violation is no constraint any more.
const LOST: f64 = 0.1;

impl Mechanism for Drive {
    const NAME: &'static str = "crank_drive";
    const SUMMARY: &'static str = "source, transformer, rectifier, motor, crank and slider: nine equations";
    const STATE: &'static [Quantity] = &[
        Quantity::any("f1", "A", "current of the primary winding"),
        Quantity::any("f2", "A", "current of the secondary winding"),
        Quantity::any("q3", "A s", "charge of the capacitor"),
        Quantity::any("f4", "A", "current of the choke"),
        Quantity::any("f5", "A", "current of the armature"),
        Quantity::any("q6", "rad", "angle of the crank"),
        Quantity::any("f6", "rad/s", "speed of the crank"),
        Quantity::any("q7", "m", "place of the slider"),
        Quantity::any("f7", "m/s", "velocity of the slider"),
    ];
    /// The slider's place and velocity are those that the rod allows.
    const START: &'static [Quantity] = Self::STATE.split_at(7).0;
    const SHOWN: &'static [Quantity] = &[
        Quantity::any("violation", "m^2", "f = (q7 - r cos q6)^2 + (r sin q6)^2 - l^2"),
        Quantity::any("violation_rate", "m^2/s", "rate of the violation"),
    ];

    const FORMULATION: Formulation = Formulation::Given;

    fn read<E>(source: &mut impl FnMut(&'static Quantity) -> Result<f64, E>) -> Result<Self, E> {
        let drive = CrankDrive { circuit: Circuit::read(&mut *source)?, mechanism: CrankSlider::read(&mut *source)? };
        let Gains { damping, stiffness } = Gains::read(source)?;
        Ok(Drive(Nine { drive, damping, stiffness }))
    }

    fn rates<S: Over<f64> + Analytic>(&self, time: S, y: &[S], dy: &mut [S]) {
        self.0.rates(time, y, dy);
    }

    fn energy<S: Over<f64> + Analytic>(&self, time: S, y: &[S]) -> S {
        energies::energy(&self.0.drive, &instant(time, y))
    }

    fn power<S: Over<f64> + Analytic>(&self, time: S, y: &[S]) -> S {
        energies::power(&self.0.drive, &instant(time, y))
    }

    fn state(&self, start: &[f64]) -> Vec<f64> {
        Seven { drive: self.0.drive }.whole(start).to_vec()
    }

    fn shown(&self, _time: f64, y: &[f64]) -> Vec<f64> {
        let (value, rate) = violation(&self.0.drive, y);
        vec![value, rate]
    }

    fn amiss(&self, _start: &[f64]) -> Vec<Amiss> {
        let Circuit { l1, l2, mutual, forward, reverse, .. } = self.0.drive.circuit;
        let coupled = (mutual * mutual >= l1 * l2).then(|| Amiss {
            name: "mutual",
            what: "M^2 < L1 L2 is broken: the windings would have energy below zero",
            accepted: format!("less than {} H is accepted", (l1 * l2).sqrt()),
        });
        let diode = (reverse < forward).then(|| Amiss {
            name: "reverse",
            what: "the diode conducts better backwards than forwards",
            accepted: format!("at least {forward} ohm is accepted"),
        });
        coupled.into_iter().chain(diode).chain(rod_too_short(&self.0.drive.mechanism)).collect()
    }

    fn margins(&self, _start: &[f64], y: &[f64], _dy: &[f64]) -> Vec<Margin> {
        let (violated, rate) = violation(&self.0.drive, y);
        let what = "the rod's constraint is lost: it is violated by more than a tenth of the rod's length squared";
        let value = LOST * self.0.drive.mechanism.rod.powi(2) - violated.abs();
        vec![Margin { value, rate: -violated.signum() * rate, what, ..Margin::default() }]
    }

    fn diagnosis(&self, run: &Ended<'_>) -> Option<Diagnosis> {
        let what = match self.foreseen(run.start, run.method, run.span) {
            Foreseen { gains: Some(false), .. } => {
                "the violation of the constraint grows: the gains are outside what the method bears at its step"
            }
            Foreseen { circuit: Some((Bears::Nowhere | Bears::Somewhere, _)), .. } => {
                "the currents grow: the step is longer than what the method bears of the circuit"
            }
            _ => return None,
        };
        Some(Diagnosis { what, at: None })
    }

    /// In its seven equations without the slider; and by all charges and their currents, q4 in the place of q4 - q5 = q3.
    fn rewritten(&self, start: &[f64]) -> Vec<Rewritten> {
        let seven = Seven { drive: self.0.drive };
        let whole = Box::new(move |y: &[f64]| seven.whole(y).to_vec());
        let law = Treated::Free(ready(seven));
        let minimal = Rewritten { formulation: Formulation::Minimal, law, state: start.to_vec(), whole };
        let [f1, f2, q3, f4, f5, q6, f6, q7, f7] = seven.whole(start);
        let state = [0.0, 0.0, q3, 0.0, q6, q7, f1, f2, f4, f5, f6, f7];
        let nine = |y: &[f64]| vec![y[6], y[7], y[2] - y[3], y[8], y[9], y[4], y[10], y[5], y[11]];
        std::iter::once(minimal).chain(redundant::<_, 6, 1>(&self.0.drive, &state, nine)).collect()
    }

    fn theory(&self, start: &[f64], method: Method, span: f64) -> Vec<String> {
        let Foreseen { step, gains, circuit } = self.foreseen(start, method, span);
        let gains = gains.map(|decay| {
            let (beta, kappa) = self.in_steps(step);
            let what = if decay { "decays" } else { "does not decay" };
            format!("with h b = {beta:.6} and h^2 k = {kappa:.6} a violation of the constraint {what}")
        });
        let circuit = circuit.map(|(bears, [least, most])| {
            let bears = match bears {
                Bears::Everywhere => "bears the circuit at every instant",
                Bears::Somewhere => "does not bear the circuit at every instant",
                Bears::Nowhere => "bears the circuit at no instant",
            };
            format!(
                "Euler {bears} with h = {step} s: its longest steps along the motion are {least:.6} s to {most:.6} s, \
                 as found by search"
            )
        });
        gains.into_iter().chain(circuit).collect()
    }
}

/// What theory says of a constant step.
struct Foreseen {
    /// h, s; zero where it varies.
    step: f64,
    /// Whether a violation decays, where it is led.
    gains: Option<bool>,
    /// Of Euler: where it bears the circuit, and the least and greatest of the steps that it bears, s.
    circuit: Option<(Bears, [f64; 2])>,
}

/// At which instants of the motion.
#[derive(Clone, Copy)]
enum Bears {
    Everywhere,
    Somewhere,
    Nowhere,
}

impl Drive {
    /// h b and h^2 k.
    fn in_steps(&self, step: f64) -> (f64, f64) {
        (step * self.0.damping, step * step * self.0.stiffness)
    }

    fn foreseen(&self, start: &[f64], method: Method, span: f64) -> Foreseen {
        let Some((scheme, step)) = Scheme::of(method, span) else {
            return Foreseen { step: 0.0, gains: None, circuit: None };
        };
        let (beta, kappa) = self.in_steps(step);
        let gains = (beta != 0.0 || kappa != 0.0).then(|| decays(scheme, beta, kappa));
        let bearable = (scheme == Scheme::Euler)
            .then(|| bearable_steps(&Seven { drive: self.0.drive }, start, span).ok())
            .flatten();
        let circuit = bearable.map(|[least, most]| match step {
            step if step < least => (Bears::Everywhere, [least, most]),
            step if step > most => (Bears::Nowhere, [least, most]),
            _ => (Bears::Somewhere, [least, most]),
        });
        Foreseen { step, gains, circuit }
    }
}

/// The crank turns all the way round only with a rod that is longer.
fn rod_too_short(mechanism: &CrankSlider<f64>) -> Option<Amiss> {
    let accepted = format!("a rod longer than the crank, {} m, is accepted", mechanism.crank);
    let what = "the rod is no longer than the crank: the crank cannot turn round";
    (mechanism.rod <= mechanism.crank).then_some(Amiss { name: "rod", what, accepted })
}
