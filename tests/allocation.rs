//! The right-hand side does not allocate memory: for every machine, with one bar or with forty, and for every scalar
//! type used in integrations.

use dalembert_derivations::machines::synchronous::Synchronous;
use dalembert_derivations::papers::konosevich2022::gyrostats;
use dalembert_derivations::studies::AnyScene;
use dalembert_derivations::studies::ensemble::kind::{Kind, form_parameters};
use dalembert_derivations::studies::scene::Scene;
use dalembert_derivations::systems::disc::Disc;
use dalembert_derivations::systems::gyrostat::driven::Driven;
use dalembert_derivations::systems::gyrostat::forms::{Form, SecondForm};
use dalembert_derivations::systems::ladder::Ladder;
use field::{Analytic, Batch, DoubleDouble, Over};
use integrators::{BatchRungeKutta4, Dual8, Ensemble, Failure, Members, Ode, Real, Splitting, batch_order, compose};
use mechanics::constrained::PointSystem as _;
use mechanics::constrained::State;
use mechanics::constrained::programmed::{Linear, programmed};
use mechanics::regimes::{Consistency, Dry, Sizes, Touch, touches, verdict};
use motor::{Motor, Separable, WithSuppliedWork, catalogue, has_known_flow};
use physical::machines::with_bars;
use physical::rounded;
use reader::Family;
use simulation::{Axes, CompiledLaw, Problem, Running};
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

mod physical;

/// The system's allocator with a count of allocations per thread.
struct Counting;

thread_local! {
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

// SAFETY: every call is passed unchanged to the system's allocator.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.set(ALLOCATIONS.get() + 1);
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

/// The number of allocations of a piece of work.
fn allocations(work: impl FnOnce()) -> usize {
    let before = ALLOCATIONS.get();
    work();
    ALLOCATIONS.get() - before
}

/// The allocations of a right-hand side for every scalar type used in integrations.
fn by_rates(form: impl Form<f64>, machine: Motor) -> usize {
    fn over<S: Over<f64> + Analytic>(law: &impl Ode<S>) -> usize {
        let y: Vec<S> = (0..law.dimension()).map(|i| S::lift(0.1 + i as f64)).collect();
        let mut dy = vec![S::zero(); y.len()];
        let count = allocations(|| law.rates(S::zero(), &y, &mut dy));
        assert!(dy.iter().any(|rate| !rate.is_zero()));
        count
    }
    // with the supplied work as an additional state
    let law = WithSuppliedWork(Driven::new(form, machine));
    over::<f64>(&law) + over::<Dual8>(&law) + over::<DoubleDouble>(&law)
}

#[test]
fn the_count_sees_an_allocation() {
    assert_eq!(allocations(|| drop(std::hint::black_box(vec![1.0]))), 1);
}

#[test]
fn the_right_hand_side_allocates_nothing() {
    let g = rounded(&gyrostats::opposite_sign().gyrostat);
    for name in catalogue::entries().into_iter().map(|entry| entry.name) {
        for bars in [1, 6, 40] {
            let machine = with_bars(name, bars);
            assert_eq!(by_rates(g.first_form().0, machine.clone()), 0, "{name} with {bars} bars, first form");
            assert_eq!(by_rates(g.second_form().0, machine), 0, "{name} with {bars} bars, second form");
        }
    }
}

#[test]
fn the_right_hand_side_of_a_written_motor_allocates_nothing() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/machines/reluctance.toml");
    let machine = Scene::open(&path).expect("it is in order").machine;
    let g = rounded(&gyrostats::opposite_sign().gyrostat);
    assert_eq!(by_rates(g.first_form().0, machine.clone()), 0, "first form");
    assert_eq!(by_rates(g.second_form().0, machine), 0, "second form");
}

#[test]
fn a_series_allocates_nothing_once_there_is_room_for_it() {
    let g = rounded(&gyrostats::opposite_sign().gyrostat);
    let system = CompiledLaw::new(Driven::new(g.second_form().0, with_bars("multi_current", 40)));
    let mut series = integrators::System::taylor(&system).expect("it has a series");
    let mut y = vec![0.1; Ode::<f64>::dimension(&system)];
    series.expand(0.0, &y, 20);
    let count = allocations(|| {
        for _ in 0..3 {
            series.expand(0.0, &y, 20);
            series.sum(1e-3, &mut y);
        }
    });
    assert_eq!(count, 0);
    assert!(y.iter().all(|y| y.is_finite()));
    drop(series);
    let next = allocations(|| {
        let mut series = integrators::System::taylor(&system).expect("it has a series");
        series.expand(0.0, &y, 20);
    });
    assert_eq!(next, 1, "the next run finds the room of the last one");
}

/// The allocations of twenty steps of a composition, after its preparation.
fn by_steps(form: impl Form<f64>, machine: Motor) -> usize {
    fn over<S: Real + Running>(driven: &Driven<f64, impl Form<f64>, Motor>) -> usize {
        let mut y: Vec<S> = (0..driven.dimension()).map(|i| S::lift(0.1 + 0.05 * i as f64)).collect();
        let programs = driven.programs();
        let Some(pieces) = driven.pieces_by::<S>(Some(&programs)) else {
            assert!(!has_known_flow(&driven.machine), "a known flow makes pieces");
            return 0;
        };
        let mut composed = compose(pieces, Splitting::BlanesMoan4);
        composed.prepare(S::lift(1e-3));
        composed.enter(&y);
        allocations(|| {
            for _ in 0..20 {
                assert!(composed.advance());
                composed.leave(&mut y);
            }
        })
    }
    let driven = Driven::new(form, machine);
    over::<f64>(&driven) + over::<DoubleDouble>(&driven)
}

#[test]
fn a_step_of_a_composition_allocates_nothing() {
    let g = rounded(&gyrostats::opposite_sign().gyrostat);
    for name in catalogue::entries().into_iter().map(|entry| entry.name) {
        for bars in [1, 40] {
            let machine = with_bars(name, bars);
            assert_eq!(by_steps(g.first_form().0, machine.clone()), 0, "{name} with {bars} bars, first form");
            assert_eq!(by_steps(g.second_form().0, machine), 0, "{name} with {bars} bars, second form");
        }
    }
}

#[test]
fn a_step_by_the_programs_of_a_written_motor_allocates_nothing() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/machines/reluctance.toml");
    let machine = Scene::open(&path).expect("it is in order").machine;
    let g = rounded(&gyrostats::opposite_sign().gyrostat);
    assert_eq!(by_steps(g.first_form().0, machine), 0);
}

/// The uniform ladder on wall and floor, with a state at rest.
fn ladder() -> (Ladder<f64>, State<f64, 4>) {
    let ladder = Ladder { mass: 1.0, inertia: 1.0 / 3.0, half_length: 1.0, gravity: 9.81, friction: [0.3; 2] };
    (ladder, State { time: 0.0, place: [0.6, 0.8, 0.8, 0.6], velocity: [0.0; 4] })
}

#[test]
fn a_verdict_allocates_nothing_be_it_moving_at_rest_or_undetermined() {
    let (ladder, rest) = ladder();
    let moving = State { velocity: [0.8, -0.6, -0.6, 0.8], ..rest };
    for at in [rest, moving] {
        let count = allocations(|| {
            let dry = Dry::<f64, 2>::of(&ladder, &at, ladder.force(&at)).expect("one constraint");
            let touch: [Touch; 2] = touches(&ladder, &at, Sizes::of(&at)).expect("on wall and floor");
            assert!(matches!(verdict(&dry, &touch), Consistency::Unique(_)));
        });
        assert_eq!(count, 0);
    }
}

#[test]
fn leading_violated_constraints_allocates_nothing() {
    let disc = Disc { mass: 3.0, second_moment: 1.0, radius: 2.0, gravity: 9.8 };
    let law: Linear<f64, 6> = Linear::baumgarte(5.0, 5.0);
    let place = [0.1, 0.2, 1.5, 0.9, 0.1, 0.4, -0.2, 0.8, 0.5];
    let at = State { time: 0.0, place, velocity: place.map(|x| 1.0 - x) };
    let count = allocations(|| {
        let led = programmed(&disc, &law, &at, disc.force(&at)).expect("the rows are independent there");
        assert!(led.acceleration.iter().all(|a| a.is_finite()));
    });
    assert_eq!(count, 0);
}

#[test]
fn the_equations_of_mechanisms_and_their_power_allocate_nothing() {
    fn over<S: Over<f64> + Analytic>(law: &dyn Ode<S>, state: &[f64]) -> usize {
        let y: Vec<S> = state.iter().map(|y| S::lift(*y)).collect();
        let mut dy = vec![S::zero(); y.len()];
        // the program is compiled at the first call
        law.rates(S::lift(0.0), &y, &mut dy);
        allocations(|| law.rates(S::lift(0.1), &y, &mut dy))
    }
    for name in
        ["governors/drum_programme", "governors/between_discs", "governors/released", "governors/elastic_stable"]
            .into_iter()
            .chain(["drive/stiff_diode", "bodies/coin", "bodies/sleigh", "bodies/crank_slider"])
    {
        scenes::register(|_| ());
        let path = std::path::Path::new("scenes").join(name).with_extension("toml");
        let scene = AnyScene::open(&path).expect("it is sound");
        let Problem { law, state, .. } = scene.smooth().problem(Axes::First);
        let count = over::<f64>(&*law, &state) + over::<Dual8>(&*law, &state) + over::<DoubleDouble>(&*law, &state);
        assert_eq!(count, 0, "{name}");
    }
}

/// Ensemble members whose data differ by a tenth of a percent.
struct Crowd<'a> {
    left: u64,
    parameters: &'a [f64],
    state: &'a [f64],
    steps: u64,
}

impl Members for Crowd<'_> {
    fn next(&mut self, parameters: &mut [f64], state: &mut [f64]) -> Option<u64> {
        self.left = self.left.checked_sub(1)?;
        let near = |to: &mut [f64], from: &[f64]| {
            to.iter_mut().zip(from).for_each(|(to, from)| *to = from * (1.0 + 1e-3 * self.left as f64));
        };
        near(parameters, self.parameters);
        near(state, self.state);
        Some(self.left)
    }

    fn ended(&mut self, _: u64, _: &[f64], steps: u64, _: f64, failure: Option<Failure>) {
        assert_eq!(failure, None);
        self.steps += steps;
    }
}

#[test]
fn an_ensemble_allocates_nothing_from_its_first_member_to_its_last() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/ensembles/spread.toml");
    let scene = Scene::open(&path).expect("it is in order");
    let kind = Kind::record(&scene.system, &scene.machine, Axes::Second).expect("it has a law");
    let (_, mut parameters) = form_parameters(&scene.system, Axes::Second);
    parameters.extend(scene.machine.values());
    let state = scene.state(Axes::Second);
    let series = kind.series(batch_order(1e-9)).expect("it is small");
    let mut ensemble = Ensemble::new(series, 1e-9, 0.05, kind.states(), kind.parameters());
    let mut crowd = Crowd { left: 20, parameters: &parameters, state: &state, steps: 0 };
    assert_eq!(allocations(|| ensemble.run(&mut crowd)), 0);
    assert!(crowd.steps > 60, "{}", crowd.steps);
}

#[test]
fn steps_side_by_side_allocate_nothing() {
    let (form, motor) = (
        SecondForm::new(
            [1.0, 2.0, 2.5].map(Batch::all).into(),
            [0.6, 0.0, 0.8].map(Batch::all).into(),
            Batch::all(0.1),
            [0.5, 0.8, 0.2].map(Batch::all).into(),
        ),
        Synchronous { field_speed: 30.0, b0: 0.5, f: 0.1 },
    );
    let law = Driven::new(form, motor.map(Batch::<16, true>::all));
    let mut state: Vec<_> = (0..8).map(|i| Batch::all(0.1 * f64::from(i))).collect();
    let mut room = BatchRungeKutta4::new(8);
    assert_eq!(allocations(|| room.steps(&law, 0.0, 1e-3, 5, &mut state)), 0);
    assert!(state[0].0[15].is_finite());
}
