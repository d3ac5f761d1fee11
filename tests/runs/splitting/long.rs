//! Long runs compared with a closed form: errors grow as theory predicts.
//!
//! The modified equation of a method of even order p is f + h^p f_p + h^(p+1) f_(p+1) + .. . The law is reversible, and
//! so is f_p, while f_(p+1) has the opposite symmetry. A nutation is symmetric in time, hence f_p causes no net change
//! of energy over it. After a whole number of revolutions (plus a quarter, in all samples) the errors are therefore
//!
//!   energy = a h^p + b h^(p+1) n ,   phase = c h^p n + d h^(p+1) n^2 ,   v.v as the energy ;
//!
//! Here b and d are zero if a modified energy is conserved. All coefficients are determined from samples at a few n.

use dalembert_derivations::studies::long_runs::{Constant, LongRun, MethodRun, Pace, Sample};
use integrators::{Method, Span, Splitting, Tolerance, integrate};

const SPLITTINGS: [(Constant, u32, u32); 4] = [
    (|steps| Method::Split { splitting: Splitting::Strang, steps }, 2, 640),
    (|steps| Method::Split { splitting: Splitting::BlanesMoan4, steps }, 4, 80),
    (|steps| Method::Split { splitting: Splitting::BlanesMoan6, steps }, 6, 40),
    (|steps| Method::Split { splitting: Splitting::KahanLi8, steps }, 8, 20),
];

fn course(pace: Pace, revolutions: u32) -> MethodRun {
    let course = LongRun::new().expect("the top nutates").course(pace, revolutions);
    assert_eq!(course.failure, None, "{}", course.method);
    course
}

/// The sample after n revolutions.
fn at(course: &MethodRun, n: u32) -> &Sample {
    let near = |sample: &&Sample| (sample.revolutions - f64::from(n) - 0.25).abs() < 1e-6;
    course.samples.iter().find(near).expect("it is sampled")
}

/// The slope of the line through two of the samples.
fn slope(course: &MethodRun, [from, to]: [u32; 2], of: fn(&Sample) -> f64) -> f64 {
    let (from, to) = (at(course, from), at(course, to));
    (of(to) - of(from)) / (to.revolutions - from.revolutions)
}

fn phase(sample: &Sample) -> f64 {
    sample.phase.expect("it is in sight")
}

/// The coefficients (c, d) of phase = c t + d t^2 from two of the samples.
fn parabola(course: &MethodRun, [one, two]: [u32; 2]) -> (f64, f64) {
    let mean = |n| {
        let sample = at(course, n);
        (sample.revolutions, phase(sample) / sample.revolutions)
    };
    let ((t, a), (s, b)) = (mean(one), mean(two));
    let d = (b - a) / (s - t);
    (a - d * t, d)
}

/// The closed form and a method of order 12 use only the data in common, and agree up to rounding.
#[test]
fn the_closed_form_is_the_motion() {
    let run = LongRun::new().expect("the top nutates");
    let course = run.course(Pace::Tolerance(Method::Gauss { stages: 6 }, 1e-14), 1);
    let phase = course.samples[0].phase.expect("it is in sight");
    assert!(phase.abs() < 1e-12, "{phase:e}");
}

#[test]
fn runge_kutta_loses_energy_and_length_as_h5_n_and_phase_as_h4_n_and_h5_n2() {
    let [coarse, fine] = [320, 640].map(|each| course(Pace::Steps(|steps| Method::RungeKutta4 { steps }, each), 500));
    for course in [&coarse, &fine] {
        for of in [|s: &Sample| s.energy, |s: &Sample| s.length] {
            let [early, late] = [[1, 100], [200, 500]].map(|range| slope(course, range, of));
            assert!((late / early - 1.0).abs() < 0.02, "{early:e} {late:e}");
        }
        let [early, late] = [[50, 200], [100, 500]].map(|pair| parabola(course, pair).1);
        assert!((late / early - 1.0).abs() < 0.05, "{early:e} {late:e}");
    }
    let order = |of: &dyn Fn(&MethodRun) -> f64| (of(&coarse) / of(&fine)).log2();
    let energy = order(&|course| slope(course, [1, 500], |s| s.energy));
    let length = order(&|course| slope(course, [1, 500], |s| s.length));
    let [linear, quadratic] =
        [order(&|course| parabola(course, [50, 500]).0), order(&|course| parabola(course, [50, 500]).1)];
    assert!([energy, length, quadratic].iter().all(|order| (order - 5.0).abs() < 0.1), "{energy} {length} {quadratic}");
    assert!((linear - 4.0).abs() < 0.1, "{linear}");
}

/// The step size adapts to the motion, with many steps per nutation: each nutation loses the same energy.
#[test]
fn a_method_that_follows_a_tolerance_loses_energy_linearly_and_phase_quadratically() {
    let course = course(Pace::Tolerance(Method::DormandPrince8, 1e-8), 500);
    let [early, late] = [[1, 200], [200, 500]].map(|range| slope(&course, range, |s| s.energy));
    assert!((late / early - 1.0).abs() < 0.05, "{early:e} {late:e}");
    let [early, late] = [[50, 200], [100, 500]].map(|pair| parabola(&course, pair).1);
    assert!((late / early - 1.0).abs() < 0.1, "{early:e} {late:e}");
}

#[test]
fn a_splitting_bounds_its_energy_and_loses_its_phase_linearly_both_as_its_order_says() {
    for (method, order, each) in SPLITTINGS {
        let [coarse, fine] = [each, 2 * each].map(|each| course(Pace::Steps(method, each), 500));
        // the bound is nearly attained once all phases of nutation and rotation have occurred
        let [early, late] = [50, 200].map(|n| at(&coarse, n).swing);
        assert!(late < 1.02 * early, "{}: {early:e} {late:e}", coarse.method);
        let [early, late] = [[20, 200], [200, 500]].map(|range| slope(&coarse, range, phase));
        assert!((late / early - 1.0).abs() < 0.02, "{}: {early:e} {late:e}", coarse.method);
        let swing = (at(&coarse, 200).swing / at(&fine, 200).swing).log2();
        let lag = (phase(at(&coarse, 500)) / phase(at(&fine, 500))).log2();
        let theory = f64::from(order);
        assert!((swing - theory).abs() < 0.2 && (lag - theory).abs() < 0.2, "{}: {swing} {lag}", coarse.method);
    }
}

/// The sum of the energy changes of single steps from points of the exact motion, and the energy change of a run, over
/// the steps that begin at `from`. They agree up to a relative difference of order h: an independent check of the
/// constants above.
fn gains(method: Constant, each: u32, [from, to]: [u32; 2]) -> [f64; 2] {
    let run = LongRun::new().expect("the top nutates");
    let (system, step) = (run.system(), run.period() / f64::from(each));
    let after = |method: Method, time: f64, state: &[f64]| {
        let outcome = integrate(&system, method, &Tolerance::both(1e-14), &Span::new(0.0, time, state), &mut ());
        assert!(outcome.reached(), "{:?}", outcome.end);
        outcome.state
    };
    let (mut single, mut motion) = (0.0, run.start().to_vec());
    let mut gone = run.start().to_vec();
    let mut begin = 0.0;
    for k in 0..to {
        if k == from {
            begin = run.energy(&gone);
        }
        if k >= from {
            single += run.energy(&after(method(1), step, &motion)) - run.energy(&motion);
        }
        motion = after(Method::Gauss { stages: 6 }, step, &motion);
        gone = after(method(1), step, &gone);
    }
    [single, run.energy(&gone) - begin]
}

#[test]
fn what_single_steps_gain_on_the_true_motion_adds_up_to_what_runs_gain() {
    let kutta: Constant = |steps| Method::RungeKutta4 { steps };
    // over a whole nutation, only the loss of order h^5; over a quarter, the oscillation of order h^p
    let mut cases = vec![(kutta, 160, [40, 200]), (kutta, 320, [0, 80])];
    cases.extend(SPLITTINGS[..2].iter().map(|(method, _, each)| (*method, 2 * each, [0, each / 2])));
    for (method, each, range) in cases {
        let [single, run] = gains(method, each, range);
        assert!((single / run - 1.0).abs() < 0.03, "{}, {range:?}: {single:e} {run:e}", method(each));
    }
}

/// Comparison with double-double, over twelve initial states that differ by a rotation about the axis. The root mean
/// square of a random walk grows as the square root of its length; if rounding were biased, it would grow linearly.
/// Order 8 makes the energy oscillation negligible.
#[test]
fn what_rounding_adds_walks_at_random() {
    let method: Constant = |steps| Method::Split { splitting: Splitting::KahanLi8, steps };
    let walk = |revolutions: u32| {
        let starts = (0..12).map(|k| LongRun::turned(0.52 * f64::from(k)).expect("the top nutates"));
        let squares = starts.map(|run| run.rounding(method, 16, revolutions).expect("it arrives").map(|x| x * x));
        let sum = squares.reduce(|a, b| std::array::from_fn(|k| a[k] + b[k])).expect("there are starts");
        sum.map(|sum| (sum / 12.0).sqrt())
    };
    let [few, many] = [walk(4), walk(400)];
    let growth: [f64; 3] = std::array::from_fn(|k| (many[k] / few[k]).log(100.0));
    assert!(growth.iter().all(|growth| (growth - 0.5).abs() < 0.2), "energy, v.v, x.v: {growth:.2?}");
}
