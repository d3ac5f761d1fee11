//! Long runs beside a closed form: errors grow as theory says.

use derivations::long_runs::{Constant, Course, LongRun, Pace, Sample};
use integrators::{Method, Splitting};

fn course(pace: Pace) -> Course {
    let course = LongRun::new().expect("the top nutates").course(pace, 500);
    assert_eq!(course.failure, None, "{}", course.method);
    course
}

fn growth(course: &Course) -> [f64; 3] {
    let of: [fn(&Sample) -> Option<f64>; 3] = [|s| Some(s.energy), |s| Some(s.length), |s| s.phase];
    of.map(|of| course.growth(of).unwrap_or(f64::NAN))
}

/// The closed form and a method of order 12 agree to rounding: two ways that share nothing but the data.
#[test]
fn the_closed_form_is_the_motion() {
    let run = LongRun::new().expect("the top nutates");
    let course = run.course(Pace::Tolerance(Method::Gauss { stages: 6 }, 1e-14), 1);
    let phase = course.samples[0].phase.expect("it is in sight");
    assert!(phase < 1e-12, "{phase:e}");
}

#[test]
fn runge_kutta_loses_its_energy_linearly_and_its_phase_quadratically() {
    for pace in [Pace::Steps(|steps| Method::RungeKutta4 { steps }, 160), Pace::Tolerance(Method::DormandPrince8, 1e-9)]
    {
        let course = course(pace);
        let [energy, length, phase] = growth(&course);
        // the phase has a linear part too, which leads at first
        let theory = (energy - 1.0).abs() < 0.1 && (length - 1.0).abs() < 0.1 && (1.5..2.1).contains(&phase);
        assert!(theory, "{}: {energy:.2} {length:.2} {phase:.2}", course.method);
    }
}

#[test]
fn a_splitting_bounds_its_energy_loses_its_phase_linearly_and_lets_the_vertical_walk_at_random() {
    let paces: [(Constant, u32); 3] = [
        (|steps| Method::Split { splitting: Splitting::BlanesMoan4, steps }, 52),
        (|steps| Method::Split { splitting: Splitting::BlanesMoan6, steps }, 24),
        (|steps| Method::Split { splitting: Splitting::KahanLi8, steps }, 16),
    ];
    for (method, each) in paces {
        let course = course(Pace::Steps(method, each));
        let [_, _, phase] = growth(&course);
        assert!((phase - 1.0).abs() < 0.1, "{}: {phase:.2}", course.method);
        let energies: Vec<f64> = course.samples.iter().map(|sample| sample.energy).collect();
        let (early, late) = energies.split_at(energies.len() / 2);
        let largest = |energies: &[f64]| energies.iter().copied().fold(0.0, f64::max);
        assert!(largest(late) < 4.0 * largest(early), "{}: {energies:?}", course.method);
        // five turns a stage at most, each off by half a unit: a random walk, and four times that for good measure
        let turns = 5.0 * course.work.rates as f64;
        let length = course.samples.last().expect("there are samples").length;
        assert!(length < 4.0 * turns.sqrt() * f64::EPSILON, "{}: {length:e}", course.method);
    }
}
