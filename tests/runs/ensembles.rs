//! Ensembles: each member's run equals its run alone, independently of the other members of its batch.

use dalembert_derivations::machines::multi_current::{MultiCurrent, Windings};
use dalembert_derivations::studies::scene::Scene;
use dalembert_derivations::systems::gyrostat::admissible::Inadmissible;
use dalembert_derivations::systems::gyrostat::driven::Driven;
use dalembert_derivations::systems::gyrostat::forms::SecondForm;
use field::Batch;
use integrators::{
    BatchRungeKutta4, BatchSeries, Ensemble, Failure, Members, Ode, Taylor, Tolerance, batch_order, runge_kutta_4_step,
};
use nalgebra::Vector3;
use reader::Family;
use simulation::Axes;
use simulation::ensemble::draw::Draw;
use simulation::ensemble::{EnsembleScene, Row, Stopped};
use std::ops::ControlFlow;

/// The text of the scene file, with other machines too.
fn text() -> String {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/ensembles/spread.toml");
    std::fs::read_to_string(path).expect("it is there")
}

fn ensemble(text: &str) -> EnsembleScene {
    dalembert_derivations::studies::ensemble::parse("ensemble.toml", text).unwrap_or_else(|error| panic!("{error}"))
}

fn rows(scene: &EnsembleScene, threads: usize) -> Vec<Row> {
    let mut rows = Vec::new();
    scene.run(1..=scene.members, threads, |row| {
        rows.push(row);
        ControlFlow::Continue(())
    });
    rows
}

fn short(members: u64) -> String {
    text().replace("members = 10000", &format!("members = {members}")).replace("span = \"0.5 s\"", "span = \"0.1 s\"")
}

/// The scene of a member, as its own file would describe it.
fn single(text: &str, row: &Row) -> Scene {
    let mut one = Scene::parse("ensemble.toml", text).unwrap_or_else(|error| panic!("{error}"));
    let dalembert_derivations::studies::scene::Setup::Gyrostat(bodies) = &mut one.system else {
        panic!("it has a carrier")
    };
    let [cx, cy, cz, axial, b0, r2, angle, wx, wy, wz, vx, vy, vz] = row.drawn[..] else { panic!("13 numbers vary") };
    bodies.rotor.axial = axial;
    bodies.carrier.centre = [cx, cy, cz].into();
    one.given = one.given.with("b0", b0).and_then(|given| given.with("r2", r2)).expect("the data are its own");
    one.machine = one.given.model(one.machine.name()).expect("the data are its own");
    one.start.rotor_angle = angle;
    one.start.vertical = [vx, vy, vz].into();
    one.start.angular_velocity = [wx, wy, wz].into();
    one
}

#[test]
fn every_member_is_the_single_run_of_its_scene() {
    let text = short(19);
    for row in rows(&ensemble(&text), 2) {
        let last = row.last.as_ref().unwrap_or_else(|| panic!("{row:?}"));
        let one = single(&text, &row);
        let mut problem = one.problem(Axes::Second);
        let series = problem.law.taylor().expect("its law is recorded");
        let mut taylor =
            Taylor::new(series, &Tolerance::both(one.run.tolerance)).with_order(batch_order(one.run.tolerance));
        let steps = taylor.propagate(0.0, one.run.span, &mut problem.state).expect("it arrives");
        assert_eq!((steps, &row.stopped), (row.steps, &None));
        one.back(Axes::Second)(&mut problem.state);
        // the slip starts at -150 rad/s: rounding errors have this scale, and grow by a factor of a thousand
        for (a, b) in problem.state.iter().zip(&last.state) {
            assert!((a - b).abs() < 1e-12 * 150.0, "member {}: {a} {b}", row.number);
        }
        assert!(last.derived[..2].iter().all(|change| change.is_some_and(|change| change.abs() < 1e-8)), "{last:?}");
        assert_eq!((last.derived[2], last.derived[3]), (None, None), "this motor dissipates");
    }
}

/// The relation phi' = g' + W with the member's own W.
#[test]
fn the_speed_of_the_rotor_is_its_slip_and_the_speed_of_the_members_own_field() {
    let field = "machine.field_speed = { from = \"100 rad/s\", to = \"150 rad/s\" }";
    let scene = ensemble(&short(5).replace("machine.b0 = { mean = \"0.15 N m\", deviation = \"0.01 N m\" }", field));
    let columns = scene.columns();
    let of = |name: &str| columns.iter().position(|known| known == name).expect("it is a column");
    for row in rows(&scene, 1) {
        let last = row.last.as_ref().unwrap_or_else(|| panic!("{row:?}"));
        let (drawn, state) = (row.drawn[of("machine.field_speed") - 1], |name| last.state[of(name) - of("steps") - 1]);
        assert!((100.0..150.0).contains(&drawn));
        assert!((state("rotor_speed") - state("slip") - drawn).abs() < 1e-12, "{drawn}: {row:?}");
    }
}

#[test]
fn numbers_have_the_moments_of_their_distribution() {
    let count = 40_000;
    let moments = |number: &dyn Fn(u64) -> f64| {
        let powers = |power: i32| (0..count).map(|n| number(n).powi(power)).sum::<f64>() / count as f64;
        [powers(1), powers(2), powers(4)]
    };
    let near = |found: [f64; 3], known: [f64; 3]| found.iter().zip(known).all(|(a, b)| (a - b).abs() < 0.05);
    let [even, normal] = [moments(&|n| Draw::new(1, n, "x").even(0)), moments(&|n| Draw::new(1, n, "x").normal(2))];
    assert!(near(even, [1.0 / 2.0, 1.0 / 3.0, 1.0 / 5.0]) && near(normal, [0.0, 1.0, 3.0]), "{even:?} {normal:?}");
}

#[test]
fn seed_member_datum_and_place_each_change_the_number() {
    let of = |seed, member, datum, i| Draw::new(seed, member, datum).even(i);
    let one = of(1, 1, "a", 0);
    assert!([of(2, 1, "a", 0), of(1, 2, "a", 0), of(1, 1, "b", 0), of(1, 1, "a", 1)].iter().all(|x| *x != one));
    assert_eq!(of(1, 1, "a", 0), one);
}

#[test]
fn results_are_the_same_to_the_last_bit_with_any_number_of_threads() {
    let scene = ensemble(&short(40));
    let one = rows(&scene, 1);
    assert_eq!(one, rows(&scene, 3));
    assert!(one.iter().zip(1..).all(|(row, number)| row.number == number) && one.len() == 40);
    // a run that starts at a later member gives equal results
    let mut tail = Vec::new();
    scene.run(30..=40, 2, |row| {
        tail.push(row);
        ControlFlow::Continue(())
    });
    assert_eq!(tail[..], one[29..]);
}

#[test]
fn every_machine_and_both_systems_have_ensembles_that_agree_with_single_runs() {
    let data = "k = \"1e-3 N m s\"\npull_out = \"0.1 N m\"\npull_out_slip = 0.2\nspeed = \"150 rad/s\"\n\
                voltage = \"14 V\"\nflux = \"30 mWb\"\nresistance = \"0.6 ohm\"\ninductance = \"2 mH\"\n\
                along = \"1.2 mH\"\nacross = \"2 mH\"\npole_pairs = 3\n";
    let counts = ["bars", "pole_pairs", "pull_out_slip"];
    for name in motor::catalogue::entries().into_iter().map(|entry| entry.name) {
        let all = short(9).replace("[start]", &format!("{data}\n[start]"));
        // each machine uses the data that it has
        let known = |line: &str| {
            let key = line.split(" =").next().unwrap_or_default();
            !line.contains(" = \"") && !counts.contains(&key) || keys(name).contains(&key)
        };
        let (before, rest) = all.split_once("[machine]").expect("it has one");
        let (machine, after) = rest.split_once("[start]").expect("it follows");
        let machine: String = machine.lines().filter(|line| known(line)).map(|line| format!("{line}\n")).collect();
        let machine = machine.replace("multi_current", name) + &format!("model = \"{name}\"\n");
        let after: String = after
            .lines()
            .filter(|line| !line.starts_with("machine.") && !line.starts_with("outputs"))
            .filter(|line| name != "constant_speed" || !line.starts_with("rotor_speed"))
            .map(|line| format!("{line}\n"))
            .collect();
        let scene = ensemble(&format!("{before}[machine]\n{machine}\n[start]\n{after}"));
        for row in rows(&scene, 1) {
            let last = row.last.as_ref().unwrap_or_else(|| panic!("{name}: {row:?}"));
            assert!(row.stopped.is_none(), "{name}: {row:?}");
            for change in last.derived.iter().copied().flatten() {
                assert!(change.abs() < 1e-6, "{name}: {change:e}");
            }
        }
    }
}

/// The data of a machine, by name.
fn keys(name: &str) -> Vec<&'static str> {
    let windings = ["field_speed", "b0", "a1", "l1", "r1", "a2", "l2", "r2", "mu", "f", "bars"];
    match name {
        "constant_speed" => vec!["speed"],
        "free_rotor" => vec![],
        "asynchronous" => vec!["field_speed", "k", "f"],
        "kloss" => vec!["field_speed", "pull_out", "pull_out_slip", "f"],
        "synchronous" => vec!["field_speed", "b0", "f"],
        "crossed_windings" => vec!["field_speed", "flux", "inductance", "resistance", "f"],
        "permanent_magnet" => {
            vec!["field_speed", "voltage", "flux", "along", "across", "resistance", "f", "pole_pairs"]
        }
        "brushed" => vec!["voltage", "flux", "inductance", "resistance", "f"],
        _ => windings.to_vec(),
    }
}

#[test]
fn members_that_cannot_exist_or_do_not_arrive_are_rows_with_a_reason() {
    let text = short(30).replace("deviation = \"0.2e-4 kg m^2\"", "deviation = \"3e-4 kg m^2\"");
    let rows = rows(&ensemble(&text), 2);
    let impossible = rows.iter().filter(|row| row.last.is_none()).count();
    assert!(impossible > 3 && impossible < 27 && rows.len() == 30, "{impossible}");
    assert!(rows.iter().all(|row| row.last.is_some() || row.stopped.as_ref().is_some_and(|why| why.contains("A'"))));
    // a field that rotates so fast that no step above the rounding limit is short enough
    let text = short(8).replace(
        "machine.b0 = { mean = \"0.15 N m\", deviation = \"0.01 N m\" }",
        "machine.field_speed = { from = \"1e200 rad/s\", to = \"1e300 rad/s\" }",
    );
    for row in self::rows(&ensemble(&text), 1) {
        let last = row.last.as_ref().expect("its bodies exist");
        assert!(row.stopped.is_some() && last.time < 0.1, "{row:?}");
        assert!(last.state.iter().all(|x| x.is_finite()));
    }
}

#[test]
fn what_is_wrong_with_an_ensemble_is_told_at_its_place() {
    let wrong = [
        ("rotor.axial = {", "rotor.axiel = {", "unknown key `axiel`", "is `axial` meant?"),
        ("\"0.01 N m\"", "\"0.01 A\"", "`deviation`", "units of the dimension"),
        ("to = \"180 deg\"", "to = \"-190 deg\"", "`to` is less than `from`", "a number that is not less"),
        ("mean = \"0.15 N m\", ", "", "how `b0` varies is not said", "{ from, to }"),
        ("members = 10000", "members = 0", "`members` is out of range", "from 1 to"),
        ("[ensemble.vary]", "[ensemble.very]", "unknown key `very`", "is `vary` meant?"),
    ];
    for (from, to, title, help) in wrong {
        let text = text();
        assert!(text.contains(from), "{from}");
        let message = dalembert_derivations::studies::ensemble::parse("wrong.toml", &text.replacen(from, to, 1))
            .expect_err(to)
            .to_string();
        assert!(message.contains(title) && message.contains(help) && message.contains("^"), "{message}");
    }
}

/// The law y' = p y; it is infinite where y overflows.
struct Growth {
    rates: Batch<4>,
    series: Vec<[Batch<4>; 1]>,
}

impl BatchSeries<4> for Growth {
    fn set(&mut self, lane: usize, parameters: &[f64]) {
        self.rates.0[lane] = parameters[0];
    }

    fn order(&self) -> usize {
        self.series.len() - 1
    }

    fn expand(&mut self, _: Batch<4>, states: &[Batch<4>]) {
        let mut term = states[0];
        for (k, row) in self.series.iter_mut().enumerate() {
            row[0] = term;
            term = term * self.rates / Batch::all((k + 1) as f64);
        }
    }

    fn coefficients(&self, k: usize) -> &[Batch<4>] {
        &self.series[k]
    }

    fn sum(&self, h: Batch<4>, out: &mut [Batch<4>]) {
        out[0] = self.series.iter().rev().fold(Batch::all(0.0), |sum, row| sum * h + row[0]);
    }
}

/// The initial values (p, y) of each member.
struct Starts<'a> {
    starts: &'a [(f64, f64)],
    next: usize,
    ended: Vec<(u64, f64, f64, Option<Failure>)>,
}

impl Members for Starts<'_> {
    fn next(&mut self, parameters: &mut [f64], state: &mut [f64]) -> Option<u64> {
        (parameters[0], state[0]) = *self.starts.get(self.next)?;
        self.next += 1;
        Some(self.next as u64)
    }

    fn ended(&mut self, number: u64, state: &[f64], _: u64, at: f64, failure: Option<Failure>) {
        self.ended.push((number, state[0], at, failure));
    }
}

#[test]
fn a_member_that_fails_disturbs_no_other_and_nobody_waits_for_the_slowest() {
    let rates = [1.0, -2.0, f64::NAN, 300.0, 0.0, 5e5, -1.0, 2.0, 3.0, -1e6];
    // the last one would be infinite after the single step that reaches the end
    let starts: Vec<(f64, f64)> = rates.iter().map(|rate| (*rate, 1.0)).chain([(1.0, 1e308)]).collect();
    let series = vec![[Batch::all(0.0)]; batch_order(1e-12) + 1];
    let mut members = Starts { starts: &starts, next: 0, ended: Vec::new() };
    let source = Growth { rates: Batch::all(0.0), series };
    Ensemble::new(source, 1e-12, 1.0, 1, 1).with_most_steps(10_000).run(&mut members);
    assert_eq!(members.ended.len(), starts.len());
    for (number, state, at, failure) in members.ended.iter().copied() {
        let (rate, start) = starts[number as usize - 1];
        match rate {
            _ if rate.is_nan() || start > 1.0 => {
                assert_eq!((state, at, failure), (start, 0.0, Some(Failure::LeftTheNumbers { at: 0.0 })));
            }
            5e5 => assert!(failure.is_some() && state.is_finite() && at < 1.0, "{failure:?}"),
            -1e6 => assert!(matches!(failure, Some(Failure::TooManyEvaluations { .. })), "{failure:?}"),
            _ => assert!(failure.is_none() && (state / rate.exp() - 1.0).abs() < 1e-9, "{rate}: {state}"),
        }
    }
    // the member with the fastest growth was the fourth to enter, and is not among the first to leave
    assert!(members.ended.iter().position(|end| end.0 == 4) > members.ended.iter().position(|end| end.0 == 5));
}

/// The states after fifty steps of a batch of gyrostats with bars, one in each lane, all slightly different, with
/// numbers starting at `first`.
fn side_by_side<const L: usize, const FUSED: bool>(first: usize) -> Vec<Batch<L, FUSED>> {
    let lanes = |value: f64| Batch(std::array::from_fn(|lane| value * (1.0 + 1e-2 * (first + lane) as f64)));
    let form = SecondForm::new(
        Vector3::new(0.02, 0.026, 0.031).map(lanes),
        Vector3::new(0.6, 0.0, 0.8).map(Batch::all),
        lanes(3e-4),
        Vector3::new(0.5, 0.8, 0.2).map(lanes),
    );
    let Ok(windings) = Windings::read(|quantity| {
        Ok::<_, std::convert::Infallible>(lanes(if quantity.name == "field_speed" { 30.0 } else { 0.01 }))
    });
    let law = Driven::new(form, MultiCurrent::evenly(windings, 3));
    let mut state: Vec<Batch<L, FUSED>> = (0..law.dimension()).map(|i| lanes(0.3 + 0.1 * i as f64)).collect();
    BatchRungeKutta4::new(state.len()).steps(&law, 0.0, 1e-4, 50, &mut state);
    state
}

#[test]
fn steps_side_by_side_are_the_same_to_the_last_bit_in_any_company() {
    fn in_company<const FUSED: bool>() {
        let sixteen = side_by_side::<16, FUSED>(0);
        let (five, one) = (side_by_side::<5, FUSED>(4), side_by_side::<1, FUSED>(6));
        for ((many, few), single) in sixteen.iter().zip(&five).zip(&one) {
            assert!(many.0[4..9] == few.0 && many.0[6] == single.0[0] && many.0[6].is_finite());
        }
    }
    in_company::<true>();
    in_company::<false>();
    let (once, twice) = (side_by_side::<16, true>(0), side_by_side::<16, false>(0));
    for (a, b) in once.iter().zip(&twice).flat_map(|(a, b)| a.0.into_iter().zip(b.0)) {
        assert!((a - b).abs() <= 1e-12 * a.abs().max(1.0), "{a} and {b}");
    }
}

#[test]
fn steps_side_by_side_are_the_classical_ones_with_the_time_in_the_law() {
    struct Forced;
    impl<S: field::Scalar> Ode<S> for Forced {
        fn dimension(&self) -> usize {
            2
        }
        fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
            (dy[0], dy[1]) = (y[1] * t, -y[0] + t * t);
        }
    }
    let mut state = [Batch::<3, false>([1.0, 2.0, 3.0]), Batch::all(0.5)];
    BatchRungeKutta4::new(2).steps(&Forced, 0.25, 0.125, 8, &mut state);
    for lane in 0..3 {
        let (mut y, mut after) = ([[1.0, 2.0, 3.0][lane], 0.5], [0.0; 2]);
        let (mut slopes, mut stage) = (std::array::from_fn(|_| vec![0.0; 2]), [0.0; 2]);
        for n in 0..8 {
            let rates = |t: f64, y: &[f64], dy: &mut [f64]| Forced.rates(t, y, dy);
            runge_kutta_4_step(rates, 0.25 + 0.125 * f64::from(n), &y, 0.125, &mut slopes, &mut stage, &mut after);
            y = after;
        }
        for i in 0..2 {
            assert!((state[i].0[lane] - y[i]).abs() < 1e-13, "{} and {}", state[i].0[lane], y[i]);
        }
    }
}

#[test]
fn members_are_counted_by_their_kind_whatever_stands_in_the_reason() {
    let triangle =
        |axial| Stopped::Impossible(Inadmissible::RotorTriangle { axial, twice_transverse: 1.0 }.to_string());
    for stopped in [
        triangle(2.0),
        triangle(3.0),
        Stopped::Machine("R > 0 is broken".to_owned()),
        Stopped::NotFinite { datum: "rotor.axis".into() },
        Stopped::Run(Failure::StepCollapsed { at: 0.5, step: 1e-20 }),
        Stopped::Run(Failure::LeftTheNumbers { at: 0.5 }),
        Stopped::Run(Failure::Stiff { at: 0.5 }),
    ] {
        let text = stopped.to_string();
        assert_eq!(Stopped::kind_in(&text), stopped.kind(), "{text}");
        assert!(text.len() > stopped.kind().len() + 2, "{text}");
    }
}
