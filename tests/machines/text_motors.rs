//! A motor whose laws stand in a scene is the compiled one: the same programs, and the same messages for what is wrong.

use crate::physical::rounded;
use dalembert_derivations::machines::multi_current::{MultiCurrent, Windings};
use dalembert_derivations::machines::{AnyMachine, Bench, Catalogued, ForMachine, Programs};
use dalembert_derivations::papers::konosevich2022::gyrostats;
use dalembert_derivations::scene::problem::Law;
use dalembert_derivations::scene::state::names;
use dalembert_derivations::scene::{Axes, Family, Scene, System};
use dalembert_derivations::separated::Separable;
use dalembert_derivations::systems::gyrostat::driven::Driven;
use dalembert_derivations::taped::Running;
use field::{Analytic, DoubleDouble, Over};
use integrators::{Directions, Ode, Real, Splitting, compose};
use series::{Equations, Recurrence};
use std::f64::consts::PI;
use symbolic::{Language, Sym, Tape};

const CROSSED: &str = "flux = \"0.3 Wb\"\ninductance = \"0.2 H\"\nresistance = \"0.7 ohm\"\nf = \"0.05 N m s\"\n";
const MAGNETS: &str = "voltage = \"12 V\"\nflux = \"0.3 Wb\"\nalong = \"0.2 H\"\nacross = \"0.3 H\"\n\
                       resistance = \"0.7 ohm\"\nf = \"0.05 N m s\"\n";
const BRUSHED: &str = "voltage = \"12 V\"\nflux = \"0.3 Wb\"\ninductance = \"0.2 H\"\nresistance = \"0.7 ohm\"\n\
                       f = \"0.05 N m s\"\n";

/// A bench with this table `[machine]`.
fn scene(machine: &str) -> Scene {
    let text = format!(
        "title = \"t\"\nsystem = \"bench\"\n[rotor]\naxial = \"0.3 kg m^2\"\n{machine}\n\
         [start]\nrotor_speed = \"1 rad/s\"\n[run]\nspan = \"1 s\"\n"
    );
    Scene::parse("scene.toml", &text).unwrap_or_else(|error| panic!("{error}"))
}

/// The parameters of a compiled motor.
const DATA: &str = "field_speed = \"9 rad/s\"\n";
const WINDINGS: &str = "b0 = \"0.8 N m\"\na1 = \"0.5 Wb\"\nl1 = \"0.3 H\"\nr1 = \"0.7 ohm\"\na2 = \"0.4 Wb\"\n\
                        l2 = \"0.2 H\"\nr2 = \"0.9 ohm\"\nmu = \"0.02 N m s\"\nf = \"0.05 N m s\"\n";

/// The compiled motor of a name and data.
fn compiled(model: &str, data: &str) -> AnyMachine {
    scene(&format!("[machine]\nmodel = \"{model}\"\n{data}")).machine
}

/// A motor as text.
fn written(data: &str, laws: &str, parameters: &str, windings: &str) -> AnyMachine {
    scene(&format!("[machine]\nmodel = \"text\"\n{data}{laws}[machine.parameters]\n{parameters}{windings}")).machine
}

fn winding(flux: &str, of: u8) -> String {
    format!("[[machine.winding]]\nflux = \"{flux}\"\ninductance = \"l{of}\"\nresistance = \"r{of}\"\n")
}

const FIELD_AND_FRICTION: &str = "field_energy = \"-b0*cos(g)\"\nmoment_law = \"-(mu*g' + f*phi')\"\n";

/// The motor with bars at some angles, compiled and as text; the bars of both have the same bits.
fn with_bars(degrees: &[f64]) -> (AnyMachine, AnyMachine) {
    let windings =
        Windings { field_speed: 9.0, b0: 0.8, a1: 0.5, l1: 0.3, r1: 0.7, a2: 0.4, l2: 0.2, r2: 0.9, mu: 0.02, f: 0.05 };
    let bars = degrees.iter().map(|angle| (angle * PI / 180.0).circle()).collect();
    let angles: String = degrees.iter().enumerate().map(|(n, angle)| format!("t{n} = \"{angle} deg\"\n")).collect();
    let each: String = (0..degrees.len()).map(|n| winding(&format!("-a2*sin(g + t{n})"), 2)).collect();
    let text = written(DATA, FIELD_AND_FRICTION, &format!("{WINDINGS}{angles}"), &(winding("a1*cos(g)", 1) + &each));
    (AnyMachine::MultiCurrent(MultiCurrent { windings, bars }), text)
}

/// Every catalogued machine that has a law of its own, and what is written for it.
fn twins() -> Vec<(AnyMachine, AnyMachine)> {
    let slip = "k = \"0.02 N m s\"\nf = \"0.05 N m s\"\n";
    let kloss = "pull_out = \"0.8 N m\"\npull_out_slip = \"0.2\"\nf = \"0.05 N m s\"\n";
    let kloss_law = "moment_law = \"2*pull_out*(-g'/field_speed)*pull_out_slip/((-g'/field_speed)*(-g'/field_speed) \
                     + pull_out_slip*pull_out_slip) - f*phi'\"\n";
    let field = "b0 = \"0.8 N m\"\nf = \"0.05 N m s\"\n";
    let field_law = "field_energy = \"-b0*cos(g)\"\nmoment_law = \"-f*phi'\"\n";
    let two =
        winding("a1*cos(g)", 1) + &winding("-a2*sqrt(5/2)*sin(g + t)", 2) + &winding("-a2*sqrt(5/2)*cos(g + t)", 2);
    let lumped = format!("{WINDINGS}t = \"-45 deg\"\n");
    let plain = |model: &str, data: &str, laws: &str| {
        (compiled(model, &format!("{DATA}{data}")), written(DATA, laws, data, ""))
    };
    vec![
        (compiled("free_rotor", ""), written("field_speed = \"0 rad/s\"\n", "moment_law = \"0\"\n", "", "")),
        plain("asynchronous", slip, "moment_law = \"-(k*g' + f*phi')\"\n"),
        plain("kloss", kloss, kloss_law),
        plain("synchronous", field, field_law),
        (
            compiled("equivalent_windings", &format!("{DATA}{WINDINGS}bars = 5\n")),
            written(DATA, FIELD_AND_FRICTION, &lumped, &two),
        ),
        (
            compiled("crossed_windings", &format!("{DATA}{CROSSED}")),
            written(
                DATA,
                "moment_law = \"-f*phi'\"\n",
                CROSSED,
                "[[machine.winding]]\ncurrent = \"i1\"\nflux = \"flux*cos(g)\"\ninductance = \"inductance\"\n\
                 resistance = \"resistance\"\n[[machine.winding]]\ncurrent = \"i2\"\nflux = \"flux*sin(g)\"\n\
                 inductance = \"inductance\"\nresistance = \"resistance\"\n",
            ),
        ),
        (
            compiled("permanent_magnet", &format!("{DATA}{MAGNETS}pole_pairs = 3\n")),
            written(
                DATA,
                "moment_law = \"-f*phi'\"\n",
                MAGNETS,
                "[[machine.winding]]\ncurrent = \"id\"\nflux = \"0\"\ninductance = \"along\"\n\
                 resistance = \"resistance\"\nsupply = \"voltage*sin(3*g)\"\nmotional = \"-across*iq*3\"\n\
                 [[machine.winding]]\ncurrent = \"iq\"\nflux = \"0\"\ninductance = \"across\"\n\
                 resistance = \"resistance\"\nsupply = \"voltage*cos(3*g)\"\nmotional = \"(flux + along*id)*3\"\n",
            ),
        ),
        (
            compiled("brushed", BRUSHED),
            written(
                "field_speed = \"0 rad/s\"\n",
                "moment_law = \"-f*phi'\"\n",
                BRUSHED,
                "[[machine.winding]]\ncurrent = \"i\"\nflux = \"0\"\ninductance = \"inductance\"\n\
                 resistance = \"resistance\"\nsupply = \"voltage\"\nmotional = \"flux\"\n",
            ),
        ),
        with_bars(&[75.0]),
        with_bars(&[-45.0, 75.0, 195.0]),
        with_bars(&[0.0, 45.0, 90.0, 135.0, 180.0, 225.0, 270.0, 315.0]),
    ]
}

/// What a law comes to: columns of its Taylor recurrence, operations of its straight-line code.
fn counts(law: &impl Ode<Sym>) -> (usize, usize) {
    let state: Vec<Sym> = (0..law.dimension()).map(|i| Sym::symbol(&format!("y{i}"))).collect();
    let mut rates = vec![Sym::ZERO; state.len()];
    law.rates(Sym::ZERO, &state, &mut rates);
    let equations = Equations { state: &state, time: None, parameters: &[], rates: &rates, solve: None };
    let recurrence = Recurrence::record(&equations).expect("it is a law");
    (recurrence.columns::<8>(), Tape::record(&state, &rates).expect("it is a program").operations())
}

/// On a bench and in a gyrostat, in both forms.
struct Counts;

impl ForMachine for Counts {
    type Output = [(usize, usize); 3];

    fn apply<M: Catalogued + Clone + Send + Sync + 'static>(self, machine: M) -> Self::Output {
        let g = rounded(&gyrostats::opposite_sign().gyrostat);
        [
            counts(&Bench { machine: machine.clone(), axial: 0.3 }),
            counts(&Driven::new(g.first_form().0, machine.clone())),
            counts(&Driven::new(g.second_form().0, machine)),
        ]
    }
}

#[test]
fn every_machine_written_as_text_comes_to_programs_of_the_same_length() {
    for (compiled, text) in twins() {
        let name = compiled.name();
        assert_eq!(names(true, &compiled), names(true, &text), "{name}");
        assert_eq!(compiled.apply(Counts), text.apply(Counts), "{name}");
    }
}

/// The rates on a bench and in a gyrostat, over numbers.
struct Rates<'a>(&'a [f64]);

impl ForMachine for Rates<'_> {
    type Output = Vec<f64>;

    fn apply<M: Catalogued + Clone + Send + Sync + 'static>(self, machine: M) -> Vec<f64> {
        let g = rounded(&gyrostats::opposite_sign().gyrostat);
        let driven = Driven::new(g.second_form().0, machine);
        let y: Vec<f64> = self.0.iter().copied().cycle().take(driven.dimension()).collect();
        let mut dy = vec![0.0; y.len()];
        driven.rates(&y, &mut dy);
        dy
    }
}

#[test]
fn its_rates_are_those_of_the_compiled_machine_to_rounding() {
    for (compiled, text) in twins() {
        let name = compiled.name();
        for turn in 0..20 {
            let y: Vec<f64> = (0..17).map(|i| 2.0 * f64::from(7 * turn + 3 * i).sin()).collect();
            let (ours, theirs) = (text.clone().apply(Rates(&y)), compiled.clone().apply(Rates(&y)));
            for (ours, theirs) in ours.iter().zip(&theirs) {
                assert!((ours - theirs).abs() <= 1e-13 * theirs.abs().max(1.0), "{name}: {ours} for {theirs}");
            }
        }
    }
}

/// The rates of a scene as it runs, over a field, by their approximations.
fn run_rates<S: Over<f64>>(scene: &Scene, y: &[f64], approximate: impl Fn(S) -> Vec<f64>) -> Vec<Vec<f64>>
where
    dyn Law: Ode<S>,
{
    let state: Vec<S> = y.iter().map(|y| S::lift(*y)).collect();
    let mut rates = vec![S::zero(); y.len()];
    scene.problem(Axes::Second).law.rates(S::zero(), &state, &mut rates);
    rates.into_iter().map(approximate).collect()
}

#[test]
fn as_a_scene_it_runs_by_one_program_to_the_same_rates_over_every_field() {
    let gyrostat = System::Gyrostat(Box::new(rounded(&gyrostats::opposite_sign().gyrostat)));
    for (compiled, text) in twins() {
        for system in [System::Bench { axial: 0.3 }, gyrostat.clone()] {
            let name = compiled.name();
            let scenes = [text.clone(), compiled.clone()].map(|machine| Scene {
                machine,
                system: system.clone(),
                ..scene("[machine]\nmodel = \"free_rotor\"\n")
            });
            let y: Vec<f64> = (0..names(matches!(system, System::Bench { .. }), &compiled).len())
                .map(|i| 2.0 * (1.0 + 3.0 * i as f64).sin())
                .collect();
            let [ours, theirs] = scenes.each_ref().map(|scene| {
                [
                    run_rates::<f64>(scene, &y, |rate| vec![rate]),
                    run_rates::<DoubleDouble>(scene, &y, |rate| vec![rate.hi(), rate.lo()]),
                    run_rates::<Directions>(scene, &y, |rate| vec![rate.re]),
                ]
            });
            for (ours, theirs) in ours.iter().flatten().zip(theirs.iter().flatten()) {
                let off = (ours[0] - theirs[0]).abs();
                assert!(off <= 1e-13 * theirs[0].abs().max(1.0), "{name}: {ours:?} for {theirs:?}");
            }
        }
    }
}

/// The law over expressions, with the data as exact constants.
struct Written;

impl ForMachine for Written {
    type Output = Vec<Sym>;

    fn apply<M: Catalogued + Clone + Send + Sync + 'static>(self, machine: M) -> Vec<Sym> {
        let g = rounded(&gyrostats::opposite_sign().gyrostat);
        let driven = Driven::new(g.first_form().0, machine);
        let state: Vec<Sym> = (0..driven.dimension()).map(|i| Sym::symbol(&format!("y{i}"))).collect();
        let mut rates = vec![Sym::ZERO; state.len()];
        driven.rates(&state, &mut rates);
        rates
    }
}

#[test]
fn with_the_same_bits_for_the_bars_the_recorded_law_is_the_same_expression() {
    let (compiled, text) = with_bars(&[-45.0, 75.0, 195.0]);
    let tapes = [text, compiled].map(|machine| {
        // in a thread of its own, so that neither finds the other's expressions
        let tape = std::thread::spawn(move || {
            let rates = machine.apply(Written);
            let state: Vec<Sym> = (0..rates.len()).map(|i| Sym::symbol(&format!("y{i}"))).collect();
            Tape::record(&state, &rates).expect("it is a program")
        });
        tape.join().expect("it is recorded")
    });
    let code = |tape: &Tape| -> Vec<String> {
        tape.source(Language::C, "rates").to_string().lines().map(str::to_owned).collect()
    };
    let [ours, theirs] = tapes.each_ref().map(code);
    assert_eq!(ours, theirs);
}

/// Steps by the programs of a written motor and by its laws one by one.
struct Kicked<'a>(&'a [f64]);

impl ForMachine for Kicked<'_> {
    type Output = ();

    fn apply<M: Catalogued + Clone + Send + Sync + 'static>(self, machine: M) {
        let g = rounded(&gyrostats::opposite_sign().gyrostat);
        let driven = Driven::new(g.second_form().0, machine.clone());
        by_both(&driven, &self.0[..driven.dimension()]);
        let bench = Bench { machine, axial: 0.3 };
        by_both(&bench, &self.0[6..6 + bench.dimension()]);
    }
}

fn by_both(law: &impl Separable, state: &[f64]) {
    let programs = law.programs().expect("its laws are recorded");
    let plain = off_by::<f64>(law, &programs, state);
    let exact = off_by::<DoubleDouble>(law, &programs, state);
    assert!(plain < 1e-13 && exact < 1e-28, "{plain:e} {exact:e}");
}

/// The largest difference after a few steps, relative to a number or to one; none of a law without pieces.
fn off_by<S: Real + Running>(law: &impl Separable, programs: &Programs, state: &[f64]) -> f64 {
    let start: Vec<S> = state.iter().map(|y| S::lift(*y)).collect();
    let after = |programs: Option<&Programs>| {
        let mut composed = compose(law.pieces_by::<S>(programs)?, Splitting::KahanLi8);
        composed.prepare(S::ratio(1, 100));
        composed.enter(&start);
        let mut end = start.clone();
        assert!((0..3).all(|_| composed.advance()), "it goes on");
        composed.leave(&mut end);
        Some(end)
    };
    let (Some(ours), Some(theirs)) = (after(Some(programs)), after(None)) else { return 0.0 };
    assert_ne!(theirs, start, "it moves");
    let off = |(a, b): (&S, &S)| ((*a - *b).magnitude() / (S::one() + b.magnitude())).approx();
    ours.iter().zip(&theirs).map(off).fold(0.0, f64::max)
}

#[test]
fn its_kicks_by_programs_are_those_of_its_laws_one_by_one() {
    let y: Vec<f64> = (0..20).map(|i| (1.0 + 3.0 * f64::from(i)).sin()).collect();
    // a moment that bends, with windings
    let bent = "field_energy = \"-b0*cos(g)\"\nmoment_law = \"-mu*g'/(1 + g'*g'*s*s) - f*phi'\"\n";
    let with_time = format!("{WINDINGS}s = \"0.3 s\"\nt = \"20 deg\"\n");
    let bent = written(DATA, bent, &with_time, &(winding("a1*cos(g)", 1) + &winding("-a2*sin(2*g + t)", 2)));
    // the first is left alone: on a bench it does not move
    for text in twins().into_iter().skip(1).map(|(_, text)| text).chain([bent]) {
        text.apply(Kicked(&y));
    }
}
