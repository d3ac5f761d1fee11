//! A motor that is written in a scene beside the compiled one, in turns: right-hand sides of the gyrostat in the second form
//! over `f64`, by the laws' own programs and by the tape of the whole law; then whole runs of both as scenes
//! of a bench. Ratios of medians.
//!
//! `cargo bench --bench text_motors`

use derivations::machines::multi_current::MultiCurrent;
use derivations::machines::synchronous::Synchronous;
use derivations::machines::{AnyMachine, Catalogued, ForMachine, Machine};
use derivations::scene::{Axes, Family, Scene};
use derivations::systems::gyrostat::driven::Driven;
use derivations::systems::gyrostat::forms::{Form, SecondForm};
use derivations::taped::Taped;
use integrators::{Method, Ode, Span, Tolerance, integrate};
use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;

mod gyrostat;

const TURNS: usize = 41;
const CALLS: u32 = 20_000;

fn main() {
    let (gyrostat, windings) = (gyrostat::gyrostat(), gyrostat::windings());
    let form = gyrostat.second_form().0;
    let single = Synchronous { field_speed: windings.field_speed, b0: windings.b0, f: windings.f };
    println!(
        "motor         written over compiled   its tape over compiled   a run by Dormand-Prince 8   one by Taylor"
    );
    for (name, compiled, bars) in [
        ("no currents", AnyMachine::Synchronous(single), 0),
        ("six bars", AnyMachine::MultiCurrent(MultiCurrent::evenly(windings, 6)), 6),
    ] {
        let scene = written(&windings, bars);
        let text = scene.machine.clone();
        let times = [compiled.clone().apply(Law(form)), text.clone().apply(Law(form)), text.apply(OnTape(form))];
        let Some([own, interpreted, taped]) = in_turns(&times) else { return println!("nothing was measured") };
        let runs = [Method::DormandPrince8, Method::Taylor].map(|method| {
            let sides = [compiled.clone(), scene.machine.clone()].map(|machine| run(&scene, machine, method));
            in_turns(&sides).map_or(f64::NAN, |[own, text]| text / own)
        });
        let [explicit, taylor] = runs;
        println!("{name:<12} {:>21.2} {:>24.2} {explicit:>26.2} {taylor:>15.2}", interpreted / own, taped / own);
    }
}

/// A scene of a bench with this table `[machine]`.
fn scene(machine: &str) -> Scene {
    let text = format!(
        "title = \"t\"\nsystem = \"bench\"\n[rotor]\naxial = \"1 kg m^2\"\n[start]\nrotor_speed = \"0 rad/s\"\n[run]\n\
         span = \"1 s\"\n[machine]\n{machine}"
    );
    Scene::parse("bench", &text).unwrap_or_else(|error| panic!("{error}"))
}

/// The same motor as text.
fn written(windings: &derivations::machines::multi_current::Windings<f64>, bars: usize) -> Scene {
    let w = windings;
    let mut text = format!(
        "model = \"text\"\nfield_speed = \"{} rad/s\"\nfield_energy = \"-b0*cos(g)\"\n\
         moment_law = \"{}\"\n[machine.parameters]\nb0 = \"{} N m\"\nf = \"{} N m s\"\nmu = \"{} N m s\"\na1 = \"{} Wb\"\n\
         l1 = \"{} H\"\nr1 = \"{} ohm\"\na2 = \"{} Wb\"\nl2 = \"{} H\"\nr2 = \"{} ohm\"\n",
        w.field_speed,
        if bars == 0 { "-f*phi'" } else { "-(mu*g' + f*phi')" },
        w.b0,
        w.f,
        w.mu,
        w.a1,
        w.l1,
        w.r1,
        w.a2,
        w.l2,
        w.r2
    );
    for n in 1..=bars {
        text += &format!("t{n} = \"{} deg\"\n", 360.0 * n as f64 / bars as f64 - 45.0);
    }
    if bars > 0 {
        text += "[[machine.winding]]\nflux = \"a1*cos(g)\"\ninductance = \"l1\"\nresistance = \"r1\"\n";
    }
    for n in 1..=bars {
        text +=
            &format!("[[machine.winding]]\nflux = \"-a2*sin(g + t{n})\"\ninductance = \"l2\"\nresistance = \"r2\"\n");
    }
    scene(&text)
}

/// A run of a scene by a method.
fn run(scene: &Scene, machine: AnyMachine, method: Method) -> std::cell::RefCell<Call> {
    let problem = Scene { machine, ..scene.clone() }.problem(Axes::First);
    let call: Call = Box::new(move || {
        let span = Span::new(0.0, problem.span, &problem.state);
        black_box(integrate(&*problem.law, method, &Tolerance::both(1e-9), &span, &mut ()));
    });
    call.into()
}

type Call = Box<dyn FnMut()>;

/// A right-hand side, each call after the one before.
fn call(law: impl Ode<f64> + 'static) -> Call {
    let mut state: Vec<f64> = (0..law.dimension()).map(|i| 0.1 + 0.05 * i as f64).collect();
    let mut rates = state.clone();
    Box::new(move || {
        for _ in 0..CALLS {
            law.rates(0.0, black_box(&state), &mut rates);
            state[0] += rates[0] * 1e-15;
        }
    })
}

struct Law(SecondForm<f64>);

impl ForMachine for Law {
    type Output = std::cell::RefCell<Call>;

    fn apply<M: Catalogued + Clone + Send + Sync + 'static>(self, machine: M) -> Self::Output {
        call(driven(self.0, machine)).into()
    }
}

struct OnTape(SecondForm<f64>);

impl ForMachine for OnTape {
    type Output = std::cell::RefCell<Call>;

    fn apply<M: Catalogued + Clone + Send + Sync + 'static>(self, machine: M) -> Self::Output {
        call(Taped::new(Arc::new(driven(self.0, machine)))).into()
    }
}

fn driven<F: Form<f64>, M: Machine<f64>>(form: F, machine: M) -> Driven<f64, F, M> {
    Driven::new(form, machine)
}

/// The median time of each, s, all taken in turns.
fn in_turns<const N: usize>(calls: &[std::cell::RefCell<Call>; N]) -> Option<[f64; N]> {
    let mut times = [const { Vec::new() }; N];
    for _ in 0..TURNS {
        for (call, times) in calls.iter().zip(&mut times) {
            let start = Instant::now();
            (call.borrow_mut())();
            times.push(start.elapsed().as_secs_f64());
        }
    }
    times.iter_mut().for_each(|times| times.sort_by(f64::total_cmp));
    let medians: Vec<f64> = times.iter().filter_map(|times| times.get(TURNS / 2).copied()).collect();
    medians.try_into().ok()
}
