//! The electromechanical drive as a text model: step sizes for which Euler's method is stable for its circuit and
//! gains, and its margins.

use crate::stabilisation::bearable::bearable_steps;
use crate::stabilisation::drive_law::{Nine, Seven, violation};
use crate::stabilisation::regions::decays;
use crate::stabilisation::schemes::Scheme;
use reader::{Allowed, Quantity};
use simulation::events::Margins;
use simulation::knowledge::{Diagnosis, Ended, Knowledge, submit};
use simulation::models::Modelled;
use simulation::{Choice, Margin};
use std::convert::Infallible;
use systems::crank_drive::{Circuit, CrankDrive};
use systems::crank_slider::CrankSlider;

/// The name in the key `known_as` of scene files.
pub const NAME: &str = "crank_drive";

/// The fraction of the squared rod length up to which the rod's constraint may be violated.
const LOST: f64 = 0.1;

submit! { Knowledge {
    name: NAME,
    summary: "source, transformer, rectifier, motor, crank and slider; the rod's constraint is led to zero by gains",
    parameters: &[
        "amplitude", "frequency", "l1", "l2", "mutual", "r1", "r2", "forward", "reverse", "knee", "c3", "l4", "r4", "l5", "r5", "motor",
        "b6", "b7", "inertia", "mass", "crank", "rod", "weight", "damping", "stiffness",
    ],
    columns: &["q1", "q2", "q4", "q5", "q6", "q7", "q1'", "q2'", "q4'", "q5'", "q6'", "q7'"],
    equations: &[include_str!("../../../../scenes/drive/stiff_diode.toml")],
    theory,
    diagnosis,
    margins,
    ..Knowledge::EMPTY
} }

/// The data of the drive by name.
fn data(scene: &dyn Modelled) -> Nine {
    let value = |name: &str| scene.value(name).unwrap_or(f64::NAN);
    let read = |quantity: &'static Quantity| Ok::<_, Infallible>(value(&quantity.name));
    let (Ok(circuit), Ok(mechanism)) = (Circuit::read(read), CrankSlider::read(read));
    Nine { drive: CrankDrive { circuit, mechanism }, damping: value("damping"), stiffness: value("stiffness") }
}

/// The initial state of the seven equations.
fn start(scene: &dyn Modelled) -> [f64; 7] {
    let [f1, f2, q4, q5, f4, f5, q6, f6] =
        ["q1'", "q2'", "q4", "q5", "q4'", "q5'", "q6", "q6'"].map(|name| scene.value(name).unwrap_or(f64::NAN));
    [f1, f2, q4 - q5, f4, f5, q6, f6]
}

/// The margin of the run: it ends where the rod's constraint is violated by more than `LOST`.
fn margins(scene: &dyn Modelled, names: &[String]) -> Option<Box<Margins>> {
    let drive = data(scene).drive;
    let place = |name: &str| names.iter().position(|known| known == name);
    let (angle, speed, slider, velocity) = (place("q6")?, place("q6'")?, place("q7")?, place("q7'")?);
    Some(Box::new(move |_, y, _| {
        let nine = [0.0, 0.0, 0.0, 0.0, 0.0, y[angle], y[speed], y[slider], y[velocity]];
        let (violated, rate) = violation(&drive, &nine);
        let what = "the rod's constraint is lost: it is violated by more than a tenth of the rod's length squared";
        let value = LOST * drive.mechanism.rod.powi(2) - violated.abs();
        vec![Margin { value, rate: -violated.signum() * rate, what, ..Margin::default() }]
    }))
}

fn diagnosis(ended: &Ended<'_>) -> Option<Diagnosis> {
    let Nine { damping, stiffness, .. } = data(ended.scene);
    let what = match foreseen(ended.scene, ended.choice) {
        _ if damping < 0.0 || stiffness < 0.0 => "the violation of the constraint grows: both gains must be positive",
        Foreseen { gains: Some(false), .. } => {
            "the violation of the constraint grows: the gains are outside the stability region of the method at its step"
        }
        Foreseen { circuit: Some((Bears::Nowhere | Bears::Somewhere, _)), .. } => {
            "the currents grow: the step is longer than the stability limit of the method for the circuit"
        }
        _ => return None,
    };
    Some(Diagnosis { what: what.to_owned(), at: None })
}

fn theory(scene: &dyn Modelled, choice: &Choice) -> Vec<String> {
    let Foreseen { step, gains, circuit } = foreseen(scene, choice);
    let gains = gains.map(|decay| {
        let (beta, kappa) = in_steps(&data(scene), step);
        let what = if decay { "decays" } else { "does not decay" };
        format!("with h b = {beta:.6} and h^2 k = {kappa:.6} a violation of the constraint {what}")
    });
    let circuit = circuit.map(|(bears, [least, most])| {
        let bears = match bears {
            Bears::Everywhere => "is stable for the circuit at every instant",
            Bears::Somewhere => "is stable for the circuit only at some instants",
            Bears::Nowhere => "is stable for the circuit at no instant",
        };
        format!(
            "Euler {bears} with h = {step} s: its longest steps along the motion are {least:.6} s to {most:.6} s, \
             as found by search"
        )
    });
    unusual(scene).into_iter().chain(gains).chain(circuit).collect()
}

/// Descriptions of data that the equations admit, but no real drive has.
fn unusual(scene: &dyn Modelled) -> Vec<String> {
    let CrankDrive { circuit, mechanism } = data(scene).drive;
    let quantities = Circuit::<f64>::QUANTITIES.iter().chain(CrankSlider::<f64>::QUANTITIES);
    let beyond = quantities.filter_map(|quantity| {
        let value = scene.value(&quantity.name)?;
        let holds = quantity.bound.holds(value, Allowed::default());
        (!holds).then(|| format!("`{}` {}: it is {value} {}", quantity.name, quantity.bound.broken(), quantity.unit))
    });
    let diode = (circuit.reverse < circuit.forward).then_some("the diodes conduct better backwards than forwards");
    let short = "the rod is no longer than the crank: the crank cannot turn round";
    let rod = (mechanism.rod <= mechanism.crank).then_some(short);
    beyond.chain(diode.into_iter().chain(rod).map(str::to_owned)).collect()
}

/// Theoretical results for a constant step.
struct Foreseen {
    /// The step size h, s; zero for variable steps.
    step: f64,
    /// Whether a violation of the constraint decays; `None` without gains.
    gains: Option<bool>,
    /// The stability of Euler's method for the circuit, with the smallest and largest stable step size along the
    /// motion, s; `None` for other methods.
    circuit: Option<(Bears, [f64; 2])>,
}

/// The part of the motion during which Euler's method is stable for the circuit.
#[derive(Clone, Copy)]
enum Bears {
    Everywhere,
    Somewhere,
    Nowhere,
}

/// The dimensionless gains h b and h^2 k.
fn in_steps(law: &Nine, step: f64) -> (f64, f64) {
    (step * law.damping, step * step * law.stiffness)
}

fn foreseen(scene: &dyn Modelled, choice: &Choice) -> Foreseen {
    let (law, span) = (data(scene), scene.run().span);
    let Some((scheme, step)) = Scheme::of(choice.method, span) else {
        return Foreseen { step: 0.0, gains: None, circuit: None };
    };
    let (beta, kappa) = in_steps(&law, step);
    let gains = (beta != 0.0 || kappa != 0.0).then(|| decays(scheme, beta, kappa));
    let seven = Seven { drive: law.drive };
    let bearable = (scheme == Scheme::Euler).then(|| bearable_steps(&seven, &start(scene), span).ok()).flatten();
    let circuit = bearable.map(|[least, most]| match step {
        step if step < least => (Bears::Everywhere, [least, most]),
        step if step > most => (Bears::Nowhere, [least, most]),
        _ => (Bears::Somewhere, [least, most]),
    });
    Foreseen { step, gains, circuit }
}
