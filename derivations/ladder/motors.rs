//! The ladder of a scene with a motor: its own model, its windings lumped, currents at their quasi-steady values, none, and
//! the smaller machines that the scene's data make.

use super::currents::Current;
use super::lumping::{Lumped, Lumping};
use super::rung::{Fill, Lower, Written};
use super::{Ladder, Loss, Rung, Whole, resting};
use crate::machines::{AnyMachine, Bench, Catalogued, ForMachine, Machine, RotorState, is_fed};
use crate::scene::{Axes, Scene, System};
use crate::stationary::motor::Decimals;
use crate::systems::gyrostat::driven::Driven;
use field::{Analytic, Over, Rational};
use std::sync::Arc;
use std::time::{Duration, Instant};
use symbolic::Sym;

/// That bars at any angles close in the sums of their currents.
const CLOSURE: &str = "konosevich2022/beyond-damper/closure";

impl Ladder {
    /// Of a scene in the axes of a form.
    pub fn of_scene(scene: &Scene, axes: Axes) -> Self {
        let begin = Instant::now();
        let own = scene.problem(axes);
        let under = scene.machine.clone().apply(Under { scene, axes, start: &own.state });
        let Within { written, start, whole, lumping, rungs } = under;
        let law = match (&lumping, rungs.first()) {
            (Some(_), Some(lumped)) => Arc::clone(&lumped.law),
            _ => Arc::clone(&own.law),
        };
        let (model, made) = (scene.machine.name(), Duration::ZERO);
        let mut ladder = Ladder { model, own, written, law, start, whole, rungs, lumping, made };
        let smaller = AnyMachine::LIST.iter().map(|(name, _)| *name).take_while(|name| *name != scene.machine.name());
        // the equivalent windings are what lumping finds
        let smaller = smaller.filter(|name| *name != "equivalent_windings").collect::<Vec<_>>();
        for model in smaller.into_iter().rev() {
            ladder.rungs.extend(machine_rung(scene, axes, &ladder, model));
        }
        ladder.made = begin.elapsed();
        ladder
    }
}

/// What is derived from the scene's own machine.
struct Within {
    written: Arc<dyn Written>,
    start: Vec<f64>,
    whole: Box<Whole>,
    lumping: Option<Lumping>,
    rungs: Vec<Rung>,
}

struct Under<'a> {
    scene: &'a Scene,
    axes: Axes,
    start: &'a [f64],
}

impl ForMachine for Under<'_> {
    type Output = Within;

    fn apply<M: Catalogued + Clone + Send + Sync + 'static>(self, machine: M) -> Within {
        let Under { scene, axes, start } = self;
        let name = scene.machine.name();
        let exact = M::read::<Sym, _>(&mut Decimals(&scene.machine_data, name)).ok();
        let windings = machine.windings();
        let mechanical = start.len() - windings;
        let Some(lumping) = exact.and_then(|exact| Lumping::of(&exact)) else {
            return unlumped(scene, axes, machine, start);
        };
        let lumped = Lumped { machine, windings: lumping.over(Rational::to_f64) };
        let written = written(&scene.system, axes, lumped.clone());
        let (mechanics, currents) = start.split_at(mechanical);
        let inner = [mechanics, &lumping.lumped(currents)].concat();
        let dropped = format!(
            "of {windings} currents those {} combinations that feel no field and do no work",
            windings - lumping.windings.len()
        );
        let loss = Loss::Nothing { claim: Some(CLOSURE) };
        let Some(exact) = Rung::new("lumped windings", &dropped, loss, Lower::other(&written), inner.clone()) else {
            return unlumped(scene, axes, lumped.machine, start);
        };
        let rungs = std::iter::once(exact).chain(followed(&lumped, &written, &inner)).collect();
        let recovery = lumping.recovery(currents);
        let whole = move |time: f64, y: &[f64]| {
            let (mechanics, lumped) = y.split_at(mechanical);
            mechanics.iter().copied().chain(recovery.currents(time, lumped)).collect()
        };
        Within { written, start: inner, whole: Box::new(whole), lumping: Some(lumping), rungs }
    }
}

/// What is derived from a machine as it is.
fn unlumped<M>(scene: &Scene, axes: Axes, machine: M, start: &[f64]) -> Within
where
    M: Machine<f64> + Clone + Send + Sync + 'static,
{
    let written = written(&scene.system, axes, machine.clone());
    let rungs = followed(&machine, &written, start);
    Within { written, start: start.to_vec(), whole: Box::new(|_, y| y.to_vec()), lumping: None, rungs }
}

/// A system with a machine over expressions.
fn written<M: Machine<f64> + Send + Sync + 'static>(system: &System, axes: Axes, machine: M) -> Arc<dyn Written> {
    match (system, axes) {
        (System::Gyrostat(bodies), Axes::First) => Arc::new(Driven::new(bodies.first_form().0, machine)),
        (System::Gyrostat(bodies), Axes::Second) => Arc::new(Driven::new(bodies.second_form().0, machine)),
        (System::Bench { axial }, _) => Arc::new(Bench { machine, axial: *axial }),
    }
}

/// The rungs whose law is the richer one at currents that are not followed, the fastest windings first.
fn followed<M>(machine: &M, written: &Arc<dyn Written>, start: &[f64]) -> Vec<Rung>
where
    M: Machine<f64> + Clone + Send + Sync + 'static,
{
    let windings = machine.windings();
    if is_fed(machine) {
        return resting::rung(machine, written, start).into_iter().collect();
    }
    if windings == 0 || M::ROTOR != RotorState::AngleAndSpeed {
        return Vec::new();
    }
    let time_constant = |k: usize| machine.inductance(k) / machine.resistance(k);
    let mut order: Vec<usize> = (0..windings).collect();
    order.sort_by(|&a, &b| time_constant(a).total_cmp(&time_constant(b)));
    // of one time constant up to rounding: one class
    let ends = (1..=windings)
        .filter(|&end| end == windings || time_constant(order[end]) > (1.0 + 1e-9) * time_constant(order[end - 1]));
    let mut rungs = Vec::new();
    for end in ends {
        let mut slaved = order[..end].to_vec();
        slaved.sort_unstable();
        let all = end == windings;
        let kinds = if all {
            &[Current::AtPresentSlip, Current::Resistive, Current::Absent][..]
        } else {
            &[Current::AtPresentSlip, Current::Resistive]
        };
        let suitable = kinds.iter().filter(|kind| slaved.iter().all(|&k| kind.suits(machine, k)));
        rungs.extend(suitable.filter_map(|&kind| without(machine, written, start, &slaved, kind)));
    }
    rungs
}

/// The rung on which these windings have currents of a kind.
fn without<M>(machine: &M, written: &Arc<dyn Written>, start: &[f64], slaved: &[usize], kind: Current) -> Option<Rung>
where
    M: Machine<f64> + Clone + Send + Sync + 'static,
{
    let mechanical = start.len() - machine.windings();
    let rotor = mechanical - M::ROTOR.dimension();
    let followed: Vec<usize> = (0..machine.windings()).filter(|k| !slaved.contains(k)).collect();
    let kept: Vec<usize> = (0..mechanical).chain(followed.iter().map(|k| mechanical + k)).collect();
    let z0: Vec<f64> = kept.iter().map(|&place| start[place]).collect();
    let slowest = slaved.iter().map(|&k| machine.inductance(k) / machine.resistance(k)).fold(0.0, f64::max);
    let name = match (followed.is_empty(), kind) {
        (true, Current::AtPresentSlip) => "currents at the present slip",
        (true, Current::Resistive) => "resistive currents",
        (true, Current::Absent) => "no currents",
        (false, Current::Resistive) => "fast windings resistive",
        (false, _) => "fast windings at the present slip",
    };
    let dropped = format!("of {}: {}", counted(slaved.len(), "current"), kind.dropped());
    let fill = Slaved { machine: machine.clone(), rotor, currents: mechanical, slaved: slaved.to_vec(), kind };
    let loss = Loss::Small { parameter: kind.parameter() };
    let mut rung = Rung::new(name, &dropped, loss, Lower::keeping(written, kept, fill), z0)?;
    rung.small = Some(Box::new(move |z, dz| kind.value(slowest, z[rotor + 1], dz[rotor + 1])));
    Some(rung)
}

/// Currents as functions of angle and slip.
struct Slaved<M> {
    machine: M,
    /// Where the rotor's state and the currents begin.
    rotor: usize,
    currents: usize,
    slaved: Vec<usize>,
    kind: Current,
}

impl<M: Machine<f64> + Send + Sync + 'static> Fill for Slaved<M> {
    fn fill<S: Over<f64> + Analytic>(&self, y: &mut [S]) {
        let (angle, slip) = M::ROTOR.angle_and_slip(&y[self.rotor..self.currents]);
        for &k in &self.slaved {
            y[self.currents + k] = self.kind.of(&self.machine, k, angle, slip);
        }
    }
}

pub(super) fn counted(count: usize, what: &str) -> String {
    match count {
        1 => format!("1 {what}"),
        _ => format!("{count} {what}s"),
    }
}

/// A smaller machine of the scene's data, lifted by the names of the states: an angle that it does not know turns with its
/// slip, currents that it does not have are absent.
fn machine_rung(scene: &Scene, axes: Axes, ladder: &Ladder, model: &'static str) -> Option<Rung> {
    let smaller = scene.with_model(model).ok()?;
    let names = smaller.names();
    if names.is_empty() {
        return None; // on a bench a rotor of constant speed has no state at all
    }
    let (law, speed) = smaller.machine.clone().apply(Alone { system: &scene.system, axes });
    let (_, own_speed) = scene.machine.clone().apply(Alone { system: &scene.system, axes });
    let lag = speed - own_speed;
    let running = Arc::clone(&law);
    let own = scene.names();
    let states = ladder.start.len();
    let count = names.len();
    let turning = own.iter().any(|name| name == "angle") && !names.iter().any(|name| name == "angle");
    let slip = names.iter().position(|name| name == "slip");
    let from: Vec<(usize, Option<usize>, String)> = own
        .iter()
        .take(states)
        .enumerate()
        .filter(|(_, name)| ["w", "v", "a", "s"].iter().any(|first| name.starts_with(first)))
        .map(|(place, name)| (place, names.iter().position(|known| known == name), name.clone()))
        .collect();
    let slipping = move |z: &[Sym]| slip.map_or(Sym::ZERO, |slip| z[slip]) + Sym::lift(lag);
    let lift = move |_: Sym, z: &[Sym]| {
        let mut y = vec![Sym::ZERO; states];
        for (place, known, name) in &from {
            y[*place] = match (name.as_str(), known) {
                ("slip", _) => slipping(z),
                ("angle", None) => z[count],
                (_, known) => known.map_or(Sym::ZERO, |known| z[known]),
            };
        }
        y
    };
    let rates = move |time: Sym, z: &[Sym]| {
        let mut dz = vec![Sym::ZERO; count];
        law.rates(time, &z[..count], &mut dz);
        dz.extend(turning.then(|| slipping(z)));
        dz
    };
    let mut start = smaller.state(axes);
    start.extend(turning.then_some(scene.start.rotor_angle));
    let plain = move |time: f64, z: &[f64], dz: &mut [f64]| {
        running.rates(time, &z[..count], &mut dz[..count]);
        if turning {
            dz[count] = slip.map_or(0.0, |slip| z[slip]) + lag;
        }
    };
    let lower = Lower {
        dimension: start.len(),
        lift: Arc::new(lift),
        rates: Arc::new(rates),
        plain: Some(Arc::new(plain)),
        kept: None,
    };
    let (dropped, parameter) = dropped(model);
    Rung::new(model, dropped, Loss::Small { parameter }, lower, start)
}

/// What a smaller machine leaves out, and what must be small for that.
fn dropped(model: &str) -> (&'static str, &'static str) {
    match model {
        "synchronous" => ("all currents and the damping by slip", "damping of the swing over one swing"),
        "kloss" | "asynchronous" => {
            ("the angle to the field: the moment is one of slip alone", "b0 over the moment of slip")
        }
        "free_rotor" => ("the motor's moment", "M t over the rotor's momentum"),
        _ => (
            "the rotor's own motion: its speed is kept by whatever moment that takes",
            "change of speed over the speed",
        ),
    }
}

/// A machine's law with its system, and its W.
struct Alone<'a> {
    system: &'a System,
    axes: Axes,
}

impl ForMachine for Alone<'_> {
    type Output = (Arc<dyn Written>, f64);

    fn apply<M: Catalogued + Clone + Send + Sync + 'static>(self, machine: M) -> Self::Output {
        let speed = machine.frame_speed();
        (written(self.system, self.axes, machine), speed)
    }
}
