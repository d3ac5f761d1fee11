//! Reference solutions agree with known solutions, and report if they have too few digits.

use crate::problems::{Chain, Explosion, Kaps, Kepler, Lorenz, Pendulum, distance};
use dalembert_integrators::{
    Attempt, Benchmark, Failure, Means, Method, Record, Span, System, Timed, Tolerance, judge, measure, reference,
};
use field::DoubleDouble;
use std::time::Duration;

/// The states of a reference that claims enough digits, its error estimate, and its second method.
fn trusted(system: &dyn System, span: &Span<'_, f64>) -> (Vec<Vec<DoubleDouble>>, f64, Method) {
    let reference = reference(system, span).unwrap_or_else(|failure| panic!("{failure}"));
    assert!(reference.is_trusted(), "{} digits", reference.digits);
    (reference.states, reference.digits, reference.methods[1])
}

#[test]
fn an_ellipse_is_known_to_as_many_digits_as_claimed() {
    let ellipse = Kepler { eccentricity: 0.5 };
    // the pericentre 1/2 is exact in f64, the speed is not, since its square is 3
    let start: Vec<f64> = ellipse.state::<DoubleDouble>(0.0).iter().map(|y| y.hi()).collect();
    let ellipse = Rounded { start: start.clone() };
    let span = Span::new(0.0, 20.0, &start).with_outputs(&[5.0, 10.0, 20.0]);
    let (states, digits, second) = trusted(&ellipse.law(), &span);
    assert_eq!(second, Method::GraggBulirschStoer);
    for state in states {
        let lost = ellipse.energy_error(&state);
        assert!(-lost.log10() > digits - 1.5 && digits > 24.0, "{lost:.1e}, {digits} digits claimed");
    }
}

/// An ellipse with rounded initial data: its energy and its angular momentum are still known.
struct Rounded {
    start: Vec<f64>,
}

impl Rounded {
    fn law(&self) -> Kepler {
        Kepler { eccentricity: 0.5 }
    }

    fn energy_error(&self, y: &[DoubleDouble]) -> f64 {
        let energy = |y: &[DoubleDouble]| {
            let radius = (y[0] * y[0] + y[1] * y[1]).sqrt();
            (y[2] * y[2] + y[3] * y[3]) / DoubleDouble::from(2.0) - DoubleDouble::from(1.0) / radius
        };
        let start: Vec<DoubleDouble> = self.start.iter().map(|y| DoubleDouble::from(*y)).collect();
        (energy(y) - energy(&start)).hi().abs()
    }
}

#[test]
fn a_fast_pendulum_keeps_its_energy_to_the_digits_claimed() {
    let pendulum = Pendulum { frequency: 300.0 };
    let span = Span::new(0.0, 0.5, &[2.0, 0.0]).with_even_outputs(5);
    let (states, digits, _) = trusted(&pendulum, &span);
    let start = pendulum.energy(&[DoubleDouble::from(2.0), DoubleDouble::from(0.0)]);
    let energy = states.iter().map(|y| ((pendulum.energy(y) - start).hi() / 9e4).abs()).fold(0.0, f64::max);
    assert!(energy < 1e-23 && digits > 23.0, "{energy:.1e}, {digits} digits claimed");
}

#[test]
fn twelve_states_at_300_radians_a_second_are_known_to_more_than_20_digits() {
    let chain = Chain { bars: 6, frequency: 300.0 };
    let start: Vec<f64> = (0..12).map(|i| if i % 2 == 0 { 0.3 + 0.1 * f64::from(i) } else { 0.0 }).collect();
    let (_, digits, _) = trusted(&chain, &Span::new(0.0, 0.5, &start));
    assert!(digits > 23.0, "{digits}");
}

#[test]
fn a_stiff_problem_is_known_to_26_digits_at_every_stiffness() {
    for lambda in [1e3, 1e4, 1e5, 1e6] {
        let span = Span::new(0.0, 5.0, &[1.0, 1.0]).with_even_outputs(5);
        let (states, digits, second) = trusted(&Kaps { lambda }, &span);
        assert_eq!(second, Method::RadauIIA { stages: 15 }, "{lambda}");
        assert!(digits > 26.0, "{lambda}: {digits}");
        for (t, state) in span.outputs.iter().zip(states) {
            let error = distance(&state, &Kaps::state(*t));
            assert!(error < 1e-25, "{lambda} at {t}: {error:.1e}");
        }
    }
}

#[test]
fn a_chaotic_solution_is_claimed_only_as_far_as_it_is_known() {
    let digits = |end: f64| {
        let known = reference(&Lorenz, &Span::new(0.0, end, &[1.0, 1.0, 1.0]));
        known.map_or(f64::NAN, |known| known.digits)
    };
    assert!(digits(5.0) > 23.0, "{}", digits(5.0));
    assert!(digits(40.0) < 20.0 && digits(40.0) > 5.0, "{}", digits(40.0));
}

#[test]
fn a_solution_that_explodes_has_no_reference() {
    let failure = reference(&Explosion, &Span::new(0.0, 2.0, &[1.0])).err();
    assert!(matches!(failure, Some(Failure::StepCollapsed { .. })), "{failure:?}");
}

#[test]
fn work_against_precision_has_a_point_for_every_method_and_tolerance() {
    let kaps = Kaps { lambda: 1e6 };
    let span = Span::new(0.0, 1.0, &[1.0, 1.0]).with_evaluations(20_000);
    let known = reference(&kaps, &span).unwrap_or_else(|failure| panic!("{failure}"));
    let methods = [Method::Radau5, Method::RungeKutta4 { steps: 100 }, Method::RadauIIA { stages: 5 }];
    let allowed = Duration::from_millis(200);
    let attempts = methods.map(|method| Attempt::Integrated(&kaps, method));
    let error = |record: &Record<f64>| known.error(record);
    let course = Benchmark { span: &span, sizes: &known.sizes, error: &error };
    let mut points = judge(&attempts, &course, &[1e-5, 1e-8], allowed);
    assert!(points.iter().all(|point| point.time.is_none()));
    for point in points.iter_mut().filter(|point| point.error.is_ok()) {
        let attempt = *attempts.iter().find(|attempt| attempt.means() == point.means).expect("it was judged");
        let tolerance = Tolerance::scaled(point.tolerance.unwrap_or(f64::EPSILON), &known.sizes);
        let error = point.error.unwrap_or(f64::NAN);
        let timed = Timed { attempt, span: &span, tolerance, error, evaluations: point.evaluations };
        point.time = measure(&[timed], allowed)[0];
        assert_eq!(point.evaluations, point.work.rates + 2 * point.work.jacobians);
    }
    assert_eq!(points.len(), 5);
    for point in &points {
        match point.means {
            Means::Integrated(Method::RungeKutta4 { .. }) => {
                assert!(point.tolerance.is_none());
                assert!(matches!(point.error, Err(Failure::LeftTheNumbers { .. })), "{:?}", point.error);
                assert!(point.time.is_none());
            }
            means => {
                let (error, tolerance) = (point.error.unwrap_or(f64::NAN), point.tolerance.unwrap_or(f64::NAN));
                assert!(error < 300.0 * tolerance, "{means}: {error:.1e} at {tolerance:e}");
                assert!(point.time.is_some_and(|time| time.seconds > 0.0) && point.work.rates > 0);
            }
        }
    }
}

#[test]
fn a_record_at_other_times_has_no_error() {
    let kaps = Kaps { lambda: 1e3 };
    let known = reference(&kaps, &Span::new(0.0, 1.0, &[1.0, 1.0])).unwrap_or_else(|failure| panic!("{failure}"));
    assert!(known.error(&Record::new()).is_nan());
}
