//! A motor that is written in a scene beside the compiled one, in turns: one right-hand side over `f64`, over a value with its
//! slopes in eight directions and over double-double, and whole runs by one method of each kind. Ratios of medians.
//!
//! `cargo bench --bench text_motors`

use dalembert_derivations::machines::AnyMachine;
use dalembert_derivations::machines::kloss::Kloss;
use dalembert_derivations::machines::multi_current::{MultiCurrent, Windings};
use dalembert_derivations::machines::synchronous::Synchronous;
use dalembert_derivations::scene::{Axes, Family, Problem, Scene, System};
use field::{DoubleDouble, Over};
use integrators::{Directions, Method, Ode, Span, Splitting, Tolerance, integrate};
use std::cell::RefCell;
use std::hint::black_box;
use std::time::Instant;

mod gyrostat;

const TURNS: usize = 41;
const CALLS: u32 = 5_000;
const METHODS: [Method; 5] = [
    Method::DormandPrince8,
    Method::GraggBulirschStoer,
    Method::RadauIIA { stages: 5 },
    Method::Split { splitting: Splitting::Strang, steps: 500 },
    Method::Taylor,
];

fn main() {
    println!("written over compiled");
    println!("system    motor          value  slopes   exact  Dormand-Prince 8     GBS   Radau  splitting  Taylor");
    let windings = gyrostat::windings();
    let Windings { field_speed, b0, f, .. } = windings;
    for (name, compiled, scene) in [
        ("no currents", AnyMachine::Synchronous(Synchronous { field_speed, b0, f }), written(&windings, 0)),
        ("six bars", AnyMachine::MultiCurrent(MultiCurrent::evenly(windings, 6)), written(&windings, 6)),
        ("twelve bars", AnyMachine::MultiCurrent(MultiCurrent::evenly(windings, 12)), written(&windings, 12)),
        ("Kloss", AnyMachine::Kloss(kloss()), kloss_written()),
    ] {
        for (system, place) in
            [("bench", scene.system.clone()), ("gyrostat", System::Gyrostat(Box::new(gyrostat::gyrostat())))]
        {
            let problem = |machine: &AnyMachine| {
                Scene { machine: machine.clone(), system: place.clone(), ..scene.clone() }.problem(Axes::Second)
            };
            let each =
                |call: fn(Problem) -> Call| [&compiled, &scene.machine].map(|machine| call(problem(machine)).into());
            let mut cells =
                [value::<f64>, value::<Directions>, value::<DoubleDouble>].map(|call| ratio(&each(call))).to_vec();
            for method in METHODS {
                cells.push(ratio(&[&compiled, &scene.machine].map(|machine| run(problem(machine), method).into())));
            }
            let [value, slopes, exact, explicit, extrapolated, implicit, split, taylor] = cells[..] else { return };
            println!(
                "{system:<9} {name:<12} {value:>7.2} {slopes:>7.2} {exact:>7.2} {explicit:>17.2} {extrapolated:>7.2} \
                 {implicit:>7.2} {split:>10.2} {taylor:>7.2}"
            );
        }
    }
}

const KLOSS: [f64; 4] = [30.0, 0.05, 0.2, 1e-4];

fn kloss() -> Kloss<f64> {
    let [field_speed, pull_out, pull_out_slip, f] = KLOSS;
    Kloss { field_speed, pull_out, pull_out_slip, f }
}

fn kloss_written() -> Scene {
    let [field_speed, pull_out, pull_out_slip, f] = KLOSS;
    scene(&format!(
        "model = \"text\"\nfield_speed = \"{field_speed} rad/s\"\n\
         moment_law = \"2*pull_out*(-g'/field_speed)*pull_out_slip/((-g'/field_speed)*(-g'/field_speed) \
         + pull_out_slip*pull_out_slip) - f*phi'\"\n[machine.parameters]\npull_out = \"{pull_out} N m\"\n\
         pull_out_slip = \"{pull_out_slip}\"\nf = \"{f} N m s\"\n"
    ))
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
fn written(windings: &Windings<f64>, bars: usize) -> Scene {
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

type Call = Box<dyn FnMut()>;

/// A run by a method.
fn run(problem: Problem, method: Method) -> Call {
    Box::new(move || {
        let span = Span::new(0.0, problem.span, &problem.state);
        black_box(integrate(&*problem.law, method, &Tolerance::both(1e-9), &span, &mut ()));
    })
}

/// A right-hand side, each call after the one before.
fn value<S: Over<f64>>(problem: Problem) -> Call
where
    dyn dalembert_derivations::scene::problem::Law: Ode<S>,
{
    let n = problem.state.len();
    let mut state: Vec<S> = (0..n).map(|i| S::lift(0.1 + 0.05 * i as f64)).collect();
    let (mut rates, little) = (state.clone(), S::lift(1e-15));
    Box::new(move || {
        for _ in 0..CALLS {
            problem.law.rates(S::zero(), black_box(&state), &mut rates);
            for (state, rate) in state.iter_mut().zip(&rates) {
                *state += *rate * little;
            }
        }
    })
}

/// The median time of the second over that of the first, taken in turns.
fn ratio(calls: &[RefCell<Call>; 2]) -> f64 {
    let mut times = [const { Vec::new() }; 2];
    for _ in 0..TURNS {
        for (call, times) in calls.iter().zip(&mut times) {
            let start = Instant::now();
            (call.borrow_mut())();
            times.push(start.elapsed().as_secs_f64());
        }
    }
    let [compiled, written] = times.map(|mut times: Vec<f64>| {
        times.sort_by(f64::total_cmp);
        times[TURNS / 2]
    });
    written / compiled
}
