//! A motor written as text equals that of the catalogue: the programs are equal, and so are the values of the compiled
//! law.

use crate::physical::rounded;
use dalembert_derivations::machines::asynchronous::Asynchronous;
use dalembert_derivations::machines::brushed::Brushed;
use dalembert_derivations::machines::crossed_windings::CrossedWindings;
use dalembert_derivations::machines::equivalent_windings::EquivalentWindings;
use dalembert_derivations::machines::kloss::Kloss;
use dalembert_derivations::machines::multi_current::{MultiCurrent, Windings};
use dalembert_derivations::machines::permanent_magnet::{Magnets, PermanentMagnet};
use dalembert_derivations::machines::synchronous::Synchronous;
use dalembert_derivations::papers::konosevich2022::gyrostats;
use dalembert_derivations::studies::scene::Scene;
use dalembert_derivations::studies::scene::state::names;
use dalembert_derivations::systems::gyrostat::driven::Driven;
use field::{Analytic, Circle, DoubleDouble};
use integrators::{Ode, Real, Splitting, compose};
use motor::ConstantSpeed;
use motor::FreeRotor;
use motor::{Bench, Machine, Motor, Programs, Separable, catalogue};
use reader::{Family, Quantity};
use series::{Equations, Recurrence};
use simulation::Running;
use std::convert::Infallible;
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

/// The parameters of a motor of the catalogue.
const DATA: &str = "field_speed = \"9 rad/s\"\n";
const WINDINGS: &str = "b0 = \"0.8 N m\"\na1 = \"0.5 Wb\"\nl1 = \"0.3 H\"\nr1 = \"0.7 ohm\"\na2 = \"0.4 Wb\"\n\
                        l2 = \"0.2 H\"\nr2 = \"0.9 ohm\"\nmu = \"0.02 N m s\"\nf = \"0.05 N m s\"\n";

/// The motor with a given name and data.
fn named(model: &str, data: &str) -> Motor {
    scene(&format!("[machine]\nmodel = \"{model}\"\n{data}")).machine
}

/// A motor as text.
fn written(data: &str, laws: &str, parameters: &str, windings: &str) -> Motor {
    scene(&format!("[machine]\nmodel = \"text\"\n{data}{laws}[machine.parameters]\n{parameters}{windings}")).machine
}

fn winding(flux: &str, of: u8) -> String {
    format!("[[machine.winding]]\nflux = \"{flux}\"\ninductance = \"l{of}\"\nresistance = \"r{of}\"\n")
}

const FIELD_AND_FRICTION: &str = "field_energy = \"-b0*cos(g)\"\ntorque_law = \"-(mu*g' + f*phi')\"\n";

/// The motor with bars at some angles, compiled and as text; the data of the bars are bitwise equal.
fn with_bars(degrees: &[f64]) -> (MultiCurrent<f64>, Motor) {
    let windings =
        Windings { field_speed: 9.0, b0: 0.8, a1: 0.5, l1: 0.3, r1: 0.7, a2: 0.4, l2: 0.2, r2: 0.9, mu: 0.02, f: 0.05 };
    let bars = degrees.iter().map(|angle| (angle * PI / 180.0).circle()).collect();
    let angles: String = degrees.iter().enumerate().map(|(n, angle)| format!("t{n} = \"{angle} deg\"\n")).collect();
    let each: String = (0..degrees.len()).map(|n| winding(&format!("-a2*sin(g + t{n})"), 2)).collect();
    let text = written(DATA, FIELD_AND_FRICTION, &format!("{WINDINGS}{angles}"), &(winding("a1*cos(g)", 1) + &each));
    (MultiCurrent { windings, bars }, text)
}

/// Motors of the catalogue, each with its text.
fn twins() -> Vec<(Motor, Motor)> {
    let slip = "k = \"0.02 N m s\"\nf = \"0.05 N m s\"\n";
    let kloss = "pull_out = \"0.8 N m\"\npull_out_slip = \"0.2\"\nf = \"0.05 N m s\"\n";
    let kloss_law = "torque_law = \"2*pull_out*(-g'/field_speed)*pull_out_slip/((-g'/field_speed)*(-g'/field_speed) \
                     + pull_out_slip*pull_out_slip) - f*phi'\"\n";
    let field = "b0 = \"0.8 N m\"\nf = \"0.05 N m s\"\n";
    let field_law = "field_energy = \"-b0*cos(g)\"\ntorque_law = \"-f*phi'\"\n";
    let two =
        winding("a1*cos(g)", 1) + &winding("-a2*sqrt(5/2)*sin(g + t)", 2) + &winding("-a2*sqrt(5/2)*cos(g + t)", 2);
    let lumped = format!("{WINDINGS}t = \"-45 deg\"\n");
    let plain =
        |model: &str, data: &str, laws: &str| (named(model, &format!("{DATA}{data}")), written(DATA, laws, data, ""));
    vec![
        (named("free_rotor", ""), written("field_speed = \"0 rad/s\"\n", "torque_law = \"0\"\n", "", "")),
        plain("asynchronous", slip, "torque_law = \"-(k*g' + f*phi')\"\n"),
        plain("kloss", kloss, kloss_law),
        plain("synchronous", field, field_law),
        (
            named("equivalent_windings", &format!("{DATA}{WINDINGS}bars = 5\n")),
            written(DATA, FIELD_AND_FRICTION, &lumped, &two),
        ),
        (
            named("crossed_windings", &format!("{DATA}{CROSSED}")),
            written(
                DATA,
                "torque_law = \"-f*phi'\"\n",
                CROSSED,
                "[[machine.winding]]\ncurrent = \"i1\"\nflux = \"flux*cos(g)\"\ninductance = \"inductance\"\n\
                 resistance = \"resistance\"\n[[machine.winding]]\ncurrent = \"i2\"\nflux = \"flux*sin(g)\"\n\
                 inductance = \"inductance\"\nresistance = \"resistance\"\n",
            ),
        ),
        (
            named("permanent_magnet", &format!("{DATA}{MAGNETS}pole_pairs = 3\n")),
            written(
                DATA,
                "torque_law = \"-f*phi'\"\n",
                MAGNETS,
                "[[machine.winding]]\ncurrent = \"id\"\nflux = \"0\"\ninductance = \"along\"\n\
                 resistance = \"resistance\"\nsupply = \"voltage*sin(3*g)\"\nmotional = \"-across*iq*3\"\n\
                 [[machine.winding]]\ncurrent = \"iq\"\nflux = \"0\"\ninductance = \"across\"\n\
                 resistance = \"resistance\"\nsupply = \"voltage*cos(3*g)\"\nmotional = \"(flux + along*id)*3\"\n",
            ),
        ),
        (
            named("brushed", BRUSHED),
            written(
                "field_speed = \"0 rad/s\"\n",
                "torque_law = \"-f*phi'\"\n",
                BRUSHED,
                "[[machine.winding]]\ncurrent = \"i\"\nflux = \"0\"\ninductance = \"inductance\"\n\
                 resistance = \"resistance\"\nsupply = \"voltage\"\nmotional = \"flux\"\n",
            ),
        ),
    ]
}

/// The size of a law: the columns of its Taylor recurrence, and the operations of its straight-line code.
fn counts(law: &impl Ode<Sym>) -> (usize, usize) {
    let state: Vec<Sym> = (0..law.dimension()).map(|i| Sym::symbol(&format!("y{i}"))).collect();
    let mut rates = vec![Sym::ZERO; state.len()];
    law.rates(Sym::ZERO, &state, &mut rates);
    let equations = Equations { state: &state, time: None, parameters: &[], rates: &rates, solve: None };
    let recurrence = Recurrence::record(&equations).expect("it is a law");
    (recurrence.columns::<8>(), Tape::record(&state, &rates).expect("it is a program").operations())
}

/// The sizes on a bench and in a gyrostat, in both forms.
fn all_counts(machine: &(impl Machine<f64> + Clone)) -> [(usize, usize); 3] {
    let g = rounded(&gyrostats::opposite_sign().gyrostat);
    [
        counts(&Bench { machine: machine.clone(), axial: 0.3 }),
        counts(&Driven::new(g.first_form().0, machine.clone())),
        counts(&Driven::new(g.second_form().0, machine.clone())),
    ]
}

#[test]
fn every_motor_written_as_text_comes_to_programs_of_the_same_length() {
    for (own, text) in twins() {
        let name = own.name();
        assert_eq!(names(true, &own), names(true, &text), "{name}");
        assert_eq!(all_counts(&own), all_counts(&text), "{name}");
    }
    for degrees in [&[75.0][..], &[-45.0, 75.0, 195.0], &[0.0, 45.0, 90.0, 135.0, 180.0, 225.0, 270.0, 315.0]] {
        let (compiled, text) = with_bars(degrees);
        assert_eq!(all_counts(&compiled), all_counts(&text), "{degrees:?}");
    }
}

/// The value of a datum, different for different names.
fn datum(quantity: &Quantity) -> f64 {
    0.3 + 0.01 * quantity.name.bytes().map(f64::from).sum::<f64>() % 1.0
}

fn given(quantity: &'static Quantity) -> Result<f64, Infallible> {
    Ok(datum(quantity))
}

/// Asserts that the motor of a name agrees with the compiled law: names, sizes, rates.
fn is_compiled(name: &str, law: &(impl Machine<f64> + Clone)) {
    let motor = catalogue::sampled(name, datum, 5).expect("it is in the catalogue");
    assert_eq!(motor.rotor(), law.rotor(), "{name}");
    assert_eq!((motor.frame_speed(), motor.windings()), (law.frame_speed(), law.windings()), "{name}");
    for k in 0..law.windings() {
        assert_eq!(motor.current_name(k), law.current_name(k), "{name}");
        assert_eq!((motor.inductance(k), motor.resistance(k)), (law.inductance(k), law.resistance(k)), "{name}");
        let angle = Circle::<f64>::zero();
        assert_eq!(motor.supply(k, angle).is_some(), law.supply(k, angle).is_some(), "{name}");
    }
    assert_eq!(all_counts(&motor), all_counts(law), "{name}");
    same_rates(name, &motor, law);
}

/// Asserts that the rates in a gyrostat agree up to rounding.
fn same_rates(name: &str, ours: &(impl Machine<f64> + Clone), theirs: &(impl Machine<f64> + Clone)) {
    for turn in 0..20 {
        let y: Vec<f64> = (0..17).map(|i| 2.0 * f64::from(7 * turn + 3 * i).sin()).collect();
        for (ours, theirs) in rates(ours, &y).iter().zip(&rates(theirs, &y)) {
            assert!((ours - theirs).abs() <= 1e-13 * theirs.abs().max(1.0), "{name}: {ours} for {theirs}");
        }
    }
}

fn rates(machine: &(impl Machine<f64> + Clone), y: &[f64]) -> Vec<f64> {
    let g = rounded(&gyrostats::opposite_sign().gyrostat);
    let driven = Driven::new(g.second_form().0, machine.clone());
    let y: Vec<f64> = y.iter().copied().cycle().take(driven.dimension()).collect();
    let mut dy = vec![0.0; y.len()];
    driven.rates(&y, &mut dy);
    dy
}

#[test]
fn the_programs_of_every_motor_do_what_its_law_does_as_it_is_compiled() {
    let Ok(windings) = Windings::read(given);
    let Ok(magnets) = Magnets::read(given);
    let (Ok(constant), Ok(asynchronous), Ok(kloss)) =
        (ConstantSpeed::read(given), Asynchronous::read(given), Kloss::read(given));
    let (Ok(synchronous), Ok(crossed), Ok(brushed)) =
        (Synchronous::read(given), CrossedWindings::read(given), Brushed::read(given));
    is_compiled("constant_speed", &constant);
    is_compiled("free_rotor", &FreeRotor::default());
    is_compiled("asynchronous", &asynchronous);
    is_compiled("kloss", &kloss);
    is_compiled("synchronous", &synchronous);
    is_compiled("equivalent_windings", &EquivalentWindings::new(windings, 5, -Circle::turn(1, 8)));
    is_compiled("multi_current", &MultiCurrent::evenly(windings, 5));
    is_compiled("crossed_windings", &crossed);
    is_compiled("permanent_magnet", &PermanentMagnet { magnets, pole_pairs: 5 });
    is_compiled("brushed", &brushed);
}

#[test]
fn the_rates_of_a_text_are_those_of_the_catalogue_to_rounding() {
    for (own, text) in twins() {
        same_rates(own.name(), &text, &own);
    }
}

/// The law over expressions, with the data as exact constants.
fn expressed(machine: impl Machine<f64>) -> Vec<Sym> {
    let g = rounded(&gyrostats::opposite_sign().gyrostat);
    let driven = Driven::new(g.first_form().0, machine);
    let state: Vec<Sym> = (0..driven.dimension()).map(|i| Sym::symbol(&format!("y{i}"))).collect();
    let mut rates = vec![Sym::ZERO; state.len()];
    driven.rates(&state, &mut rates);
    rates
}

/// The code of a law, recorded in a separate thread with an empty expression graph.
fn code(machine: impl Machine<f64> + Send + 'static) -> Vec<String> {
    let tape = std::thread::spawn(move || {
        let rates = expressed(machine);
        let state: Vec<Sym> = (0..rates.len()).map(|i| Sym::symbol(&format!("y{i}"))).collect();
        Tape::record(&state, &rates).expect("it is a program")
    });
    let tape = tape.join().expect("it is recorded");
    tape.source(Language::C, "rates").to_string().lines().map(str::to_owned).collect()
}

#[test]
fn with_the_same_bits_for_the_bars_the_recorded_law_is_the_same_expression() {
    let (compiled, text) = with_bars(&[-45.0, 75.0, 195.0]);
    assert_eq!(code(text), code(compiled));
    let Ok(windings) = Windings::read(given);
    for bars in [1, 2] {
        let of_catalogue = |name| catalogue::sampled(name, datum, bars).expect("it is in the catalogue");
        assert_eq!(code(of_catalogue("multi_current")), code(MultiCurrent::evenly(windings, bars)), "{bars}");
        let lumped = EquivalentWindings::new(windings, bars, -Circle::turn(1, 8));
        assert_eq!(code(of_catalogue("equivalent_windings")), code(lumped), "{bars}");
    }
}

fn by_both(law: &impl Separable, state: &[f64]) {
    let programs = law.programs();
    let plain = off_by::<f64>(law, &programs, state);
    let exact = off_by::<DoubleDouble>(law, &programs, state);
    assert!(plain < 1e-13 && exact < 1e-28, "{plain:e} {exact:e}");
}

/// The largest difference after a few steps, relative to the number or to one; `None` for a law without sub-flows.
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
    // a nonlinear torque, with windings
    let bent = "field_energy = \"-b0*cos(g)\"\ntorque_law = \"-mu*g'/(1 + g'*g'*s*s) - f*phi'\"\n";
    let with_time = format!("{WINDINGS}s = \"0.3 s\"\nt = \"20 deg\"\n");
    let bent = written(DATA, bent, &with_time, &(winding("a1*cos(g)", 1) + &winding("-a2*sin(2*g + t)", 2)));
    let g = rounded(&gyrostats::opposite_sign().gyrostat);
    // the first one is omitted, since it does not move on a bench
    for text in twins().into_iter().skip(1).map(|(_, text)| text).chain([bent, with_bars(&[-45.0, 75.0]).1]) {
        let driven = Driven::new(g.second_form().0, text.clone());
        by_both(&driven, &y[..driven.dimension()]);
        let bench = Bench { machine: text, axial: 0.3 };
        by_both(&bench, &y[6..6 + bench.dimension()]);
    }
}
