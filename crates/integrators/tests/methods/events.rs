//! Events: a signal decreases through zero, or only touches zero.

use dalembert_integrators::{
    Event, Happening, Method, Ode, Outcome, Pace, Record, Signal, Span, Switches, System, TaylorSeries, Tolerance,
    integrate, integrate_to_event,
};
use field::{Analytic, Over};

/// q'' = -q
struct Oscillator;

impl<S: Over<f64> + Analytic> Ode<S> for Oscillator {
    fn dimension(&self) -> usize {
        2
    }

    fn rates(&self, _t: S, y: &[S], dy: &mut [S]) {
        (dy[0], dy[1]) = (y[1], -y[0]);
    }
}

impl System for Oscillator {
    fn taylor(&self) -> Option<Box<dyn TaylorSeries<f64> + '_>> {
        Some(Box::new(Turning(Vec::new())))
    }
}

/// The series of a rotation: a_(k+1) is a_k rotated by -90 degrees, divided by k + 1.
struct Turning(Vec<[f64; 2]>);

impl TaylorSeries<f64> for Turning {
    fn expand(&mut self, _t: f64, y: &[f64], order: usize) {
        self.0.clear();
        let mut term = [y[0], y[1]];
        for k in 0..=order {
            self.0.push(term);
            term = [term[1] / (k as f64 + 1.0), -term[0] / (k as f64 + 1.0)];
        }
    }

    fn coefficients(&self, k: usize) -> &[f64] {
        &self.0[k]
    }

    fn sum(&self, h: f64, out: &mut [f64]) {
        let sum = self.0.iter().rev().fold([0.0; 2], |[a, b], [p, q]| [a * h + p, b * h + q]);
        out.copy_from_slice(&sum);
    }
}

/// The signal q - level.
struct Above(f64);

impl Switches for Above {
    fn count(&self) -> usize {
        1
    }

    fn signals(&self, _time: f64, y: &[f64], out: &mut [Signal]) {
        out[0] = Signal { value: y[0] - self.0, rate: y[1], noise: 1e-11, ..Signal::default() };
    }
}

const ADAPTIVE: [Method; 6] = [
    Method::DormandPrince5,
    Method::DormandPrince8,
    Method::Verner9,
    Method::GraggBulirschStoer,
    Method::Radau5,
    Method::Taylor,
];

fn run(method: Method, level: f64, start: [f64; 2], outputs: &[f64]) -> (Outcome<f64>, Option<Event>, Record<f64>) {
    let tolerance = Tolerance::both(if method == Method::Radau5 { 1e-11 } else { 1e-13 });
    let mut record = Record::new();
    let span = Span::new(0.0, 10.0, &start).with_outputs(outputs);
    let (outcome, event) = integrate_to_event(&Oscillator, method, &tolerance, &span, &Above(level), &mut record);
    (outcome, event, record)
}

#[test]
fn a_fall_through_zero_is_located_as_well_as_the_motion_is_known() {
    for method in ADAPTIVE {
        let (outcome, event, _) = run(method, 0.5, [1.0, 0.0], &[10.0]);
        let event = event.unwrap_or_else(|| panic!("{method:?} saw nothing"));
        assert_eq!((event.signal, event.what), (0, Happening::Falls));
        let exact = std::f64::consts::FRAC_PI_3;
        let bound = if method == Method::Radau5 { 1e-8 } else { 1e-12 };
        assert!((event.time - exact).abs() < bound, "{method:?}: {:e}", event.time - exact);
        assert_eq!(outcome.time, event.time);
        assert!((outcome.state[0] - 0.5).abs() < 1e-13, "{method:?}");
    }
}

#[test]
fn a_touch_is_seen_and_a_dip_that_stays_above_is_not() {
    for method in [Method::DormandPrince8, Method::GraggBulirschStoer] {
        let (_, event, _) = run(method, -1.0, [1.0, 0.0], &[10.0]);
        let event = event.unwrap_or_else(|| panic!("{method:?} saw no touch"));
        assert_eq!(event.what, Happening::Touches);
        assert!((event.time - std::f64::consts::PI).abs() < 1e-10, "{method:?}: {:e}", event.time);
        let (outcome, event, _) = run(method, -1.001, [1.0, 0.0], &[10.0]);
        assert!(event.is_none() && outcome.reached(), "{method:?}");
    }
}

#[test]
fn a_short_dip_within_one_step_is_found() {
    for level in [-0.999, -0.9999, -0.99999999] {
        let (_, event, _) = run(Method::GraggBulirschStoer, level, [1.0, 0.0], &[10.0]);
        let event = event.unwrap_or_else(|| panic!("the dip below {level} was not seen"));
        assert_eq!(event.what, Happening::Falls);
        assert!((event.time - f64::acos(level)).abs() < 1e-9, "{level}: {}", event.time);
    }
}

/// A signal equal to one whose rates are only rounding errors.
struct Rest;

impl Switches for Rest {
    fn count(&self) -> usize {
        1
    }

    fn signals(&self, time: f64, _: &[f64], out: &mut [Signal]) {
        out[0] = Signal { value: 1.0, rate: 1e-17 * (1e3 * time).cos(), noise: 1e-11, ..Signal::default() };
    }
}

#[test]
fn a_signal_at_rest_is_not_searched_for_a_least_value() {
    let (start, tolerance) = ([1.0, 0.0], Tolerance::both(1e-9));
    let span = Span::new(0.0, 100.0, &start);
    for method in [Method::DormandPrince8, Method::GraggBulirschStoer] {
        let (watched, event) = integrate_to_event(&Oscillator, method, &tolerance, &span, &Rest, &mut ());
        assert_eq!(event, None);
        let alone = integrate(&Oscillator, method, &tolerance, &span, &mut ());
        assert_eq!(watched.work.rates, alone.work.rates, "{method:?}");
    }
}

#[test]
fn a_signal_that_starts_at_zero_counts_once_it_was_positive() {
    let (_, event, _) = run(Method::DormandPrince8, 0.0, [0.0, 1.0], &[10.0]);
    let event = event.expect("it falls after half a turn");
    assert_eq!(event.what, Happening::Falls);
    assert!((event.time - std::f64::consts::PI).abs() < 1e-12);
    let (outcome, event, _) = run(Method::DormandPrince8, 0.0, [0.0, -1.0], &[10.0]);
    assert_eq!(event.map(|e| (e.what, e.time)), Some((Happening::StartsBelow, 0.0)));
    assert_eq!(outcome.time, 0.0);
}

#[test]
fn the_observer_sees_nothing_beyond_the_event() {
    for method in ADAPTIVE {
        let (_, _, record) = run(method, 0.5, [1.0, 0.0], &[0.0, 0.5, 1.0, 1.5, 10.0]);
        assert_eq!(record.times, [0.0, 0.5, 1.0], "{method:?}");
    }
}

#[test]
fn an_event_on_a_polynomial_costs_one_more_expansion() {
    let span = Span::new(0.0, 10.0, &[1.0, 0.0]);
    let tolerance = Tolerance::both(1e-13);
    let (outcome, event) = integrate_to_event(&Oscillator, Method::Taylor, &tolerance, &span, &Above(0.5), &mut ());
    assert!(event.is_some());
    assert_eq!(outcome.work.rates % (outcome.work.steps + 1), 0, "{}", outcome.work);
}

/// The signal cos 5t for q = cos t: 16 q^5 - 20 q^3 + 5 q.
struct Fifth;

impl Switches for Fifth {
    fn count(&self) -> usize {
        1
    }

    fn signals(&self, _time: f64, y: &[f64], out: &mut [Signal]) {
        let square = y[0] * y[0];
        let value = ((16.0 * square - 20.0) * square + 5.0) * y[0];
        let rate = ((80.0 * square - 60.0) * square + 5.0) * y[1];
        out[0] = Signal { value, rate, noise: 1e-11, ..Signal::default() };
    }
}

#[test]
fn of_several_falls_within_one_long_polynomial_step_the_first_is_found() {
    let span = Span::new(0.0, 10.0, &[1.0, 0.0]);
    let (method, tolerance) = (Method::Taylor, Tolerance::both(1e-12));
    // cos 5t decreases through zero eight times
    assert!(integrate(&Oscillator, method, &tolerance, &span, &mut ()).work.steps <= 4);
    let (_, event) = integrate_to_event(&Oscillator, method, &tolerance, &span, &Fifth, &mut ());
    let exact = std::f64::consts::PI / 10.0;
    assert!(event.is_some_and(|event| (event.time - exact).abs() < 1e-12), "{event:?}");
}

/// The step that contains the event is repeated to each trial time as a single step, not with all steps of the span.
#[test]
fn a_constant_step_is_computed_again_as_one_step() {
    let span = Span::new(0.0, 2.0, &[1.0, 0.0]);
    let method = Method::RungeKutta4 { steps: 2_000 };
    let (outcome, event) = integrate_to_event(&Oscillator, method, &Tolerance::both(1e-9), &span, &Above(0.5), &mut ());
    let time = event.expect("cos t falls below 1/2").time;
    assert!((time - std::f64::consts::FRAC_PI_3).abs() < 1e-12, "{time}");
    assert!(outcome.work.rates < 5_000, "{}", outcome.work);
}

/// A point that rotates at the rate one, and as signal the square of its distance from a line through the centre, minus
/// a small constant.
struct Even;

impl<S: Over<f64> + Analytic> Ode<S> for Even {
    fn dimension(&self) -> usize {
        1
    }

    fn rates(&self, _time: S, _y: &[S], dy: &mut [S]) {
        dy[0] = S::one();
    }
}

impl System for Even {}

/// The constant subtracted from the square.
const LESS: f64 = 1e-8;

impl Switches for Even {
    fn count(&self) -> usize {
        1
    }

    fn signals(&self, _time: f64, y: &[f64], out: &mut [Signal]) {
        let (sin, cos) = y[0].sin_cos();
        out[0] =
            Signal { value: sin * sin - LESS, rate: 2.0 * sin * cos, noise: 0.0, pace: Pace { near: 1.0, own: 1.0 } };
    }

    fn ends_above(&self, _signal: usize) -> bool {
        true
    }
}

#[test]
fn a_distance_that_comes_to_zero_within_one_long_step_is_found() {
    // the law of the point has no series
    for method in ADAPTIVE.into_iter().filter(|method| *method != Method::Taylor) {
        let span = Span::new(0.0, 100.0, &[0.5]);
        let (outcome, event) = integrate_to_event(&Even, method, &Tolerance::both(1e-9), &span, &Even, &mut ());
        let exact = std::f64::consts::PI - LESS.sqrt().asin() - 0.5;
        assert!(event.is_some_and(|event| (event.time - exact).abs() < 1e-9), "{method:?}: {event:?}");
        assert!(outcome.state[0].sin().powi(2) > LESS, "{method:?}: {outcome:?}");
    }
}

/// The square of a distance that hardly changes in the motion of [`Even`], although motions in other directions would
/// change it.
struct Steady {
    own: f64,
}

impl Switches for Steady {
    fn count(&self) -> usize {
        1
    }

    fn signals(&self, _time: f64, _y: &[f64], out: &mut [Signal]) {
        out[0] = Signal { value: 0.04, rate: 0.0, noise: 0.0, pace: Pace { near: 1.0, own: self.own } };
    }
}

#[test]
fn a_distance_that_the_motion_itself_does_not_change_is_not_looked_for_within_a_step() {
    let span = Span::new(0.0, 2.0, &[0.5]);
    let work = |own: f64| {
        let steady = Steady { own };
        let found = integrate_to_event(&Even, Method::DormandPrince8, &Tolerance::both(1e-9), &span, &steady, &mut ());
        assert_eq!(found.1, None);
        found.0.work
    };
    let alone = integrate(&Even, Method::DormandPrince8, &Tolerance::both(1e-9), &span, &mut ()).work;
    assert_eq!(work(0.1), alone);
    assert!(work(1.0).rates > alone.rates);
}

/// The law y' = -1/y: y^2 decreases linearly, and y reaches zero with infinite rate at t = 1/2.
struct Falling;

impl<S: Over<f64> + Analytic> Ode<S> for Falling {
    fn dimension(&self) -> usize {
        1
    }

    fn rates(&self, _t: S, y: &[S], dy: &mut [S]) {
        dy[0] = -S::one() / y[0];
    }
}

impl System for Falling {}

impl Switches for Falling {
    fn count(&self) -> usize {
        1
    }

    fn signals(&self, _time: f64, y: &[f64], out: &mut [Signal]) {
        out[0] = Signal { value: y[0], rate: -1.0 / y[0], ..Signal::default() };
    }
}

#[test]
fn a_zero_with_an_infinite_rate_is_an_event_and_no_collapse_of_the_step() {
    for method in [Method::DormandPrince5, Method::DormandPrince8, Method::Verner9, Method::Radau5] {
        let span = Span::new(0.0, 1.0, &[1.0]);
        let tolerance = Tolerance::both(1e-12);
        let (outcome, event) = integrate_to_event(&Falling, method, &tolerance, &span, &Falling, &mut ());
        assert!(event.is_some_and(|event| (event.time - 0.5).abs() < 1e-9), "{method:?}: {event:?} {outcome:?}");
    }
}

/// The law q'' = -1, undefined for |q| < 1e-6: a position that the coordinates do not describe.
struct Undescribed;

impl<S: Over<f64> + Analytic> Ode<S> for Undescribed {
    fn dimension(&self) -> usize {
        2
    }

    fn rates(&self, _t: S, y: &[S], dy: &mut [S]) {
        let root = (y[0] * y[0] - S::lift(1e-12)).sqrt();
        (dy[0], dy[1]) = (y[1], -root / root);
    }
}

impl System for Undescribed {}

#[test]
fn an_event_where_the_law_has_no_numbers_is_found_from_both_sides() {
    for method in ADAPTIVE.into_iter().filter(|method| *method != Method::Taylor) {
        let span = Span::new(0.0, 2.0, &[1.0, 0.0]);
        let (_, event) = integrate_to_event(&Undescribed, method, &Tolerance::both(1e-9), &span, &Above(0.0), &mut ());
        assert!(event.is_some_and(|event| (event.time - 2.0_f64.sqrt()).abs() < 1e-9), "{method:?}: {event:?}");
    }
}
