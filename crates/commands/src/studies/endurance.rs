//! The study of long runs: the growth of errors with the number of revolutions.

use super::{extent, million};
use crate::job_pool::JobPool;
use charts::{AreaCurve, Areas, Study, Table, significant};
use integrators::Means;
use std::path::Path;
use studies::long_runs::{LongRun, MethodRun, PACES, Sample};

/// The number of revolutions that the report computes. Results for a million revolutions, which take minutes, are read from a file.
const REVOLUTIONS: u32 = 2_000;

/// The smallest error that is shown; smaller errors are rounding errors.
const FLOOR: f64 = 1e-17;

/// The long runs of the methods, each a separate job.
#[derive(Default)]
pub struct Endurance {
    courses: [Option<Option<MethodRun>>; PACES.len()],
}

impl Endurance {
    /// Adds the jobs of the study.
    pub fn enlist<'s>(&'s mut self, crew: &mut JobPool<'s>) {
        for (place, pace) in self.courses.iter_mut().zip(PACES) {
            crew.add(1.2, place, move || LongRun::new().map(|run| run.course(pace, REVOLUTIONS)));
        }
    }

    /// The completed study for the report; results of longer runs are read from a file next to the folder of scenes.
    pub fn study(self, scenes: &Path) -> Study {
        let courses: Vec<MethodRun> = self.courses.into_iter().flatten().flatten().collect();
        let mut study = Study {
            id: "long-runs".into(),
            title: "Long runs".into(),
            lead: r"A heavy symmetric top with a free rotor, whose nutation is known in closed form: $u=\nu\cdot l=u_3-(u_3-u_2)\,\mathrm{sn}^2$. What is left of the exact motion after $n$ periods and a quarter, by methods that take about 320 evaluations of the law, or flows of all pieces, for a period. The splitting methods turn $\nu$ and $x$ by exact rotations, so that $|\nu|$ and $x\cdot\nu$ err by rounding alone.".into(),
            note: r"Theory, for order $p$ and $n$ revolutions: the law is reversible, so that the error of the energy of order $h^p$ swings back in every nutation, and what is lost is $h^{p+1}n$ (for even $p$; the phase then errs as $h^pn$ and, since the frequency goes with the energy, as $h^{p+1}n^2$); a splitting keeps an energy near the true one, so that the error of the energy is bounded and that of the phase grows as $h^pn$; what rounding adds to an invariant walks at random, $\sqrt n$, and to the phase as $n^{3/2}$ (Brouwer). The exponents of the table are measured between a hundredth of the run and its end, or the loss of the phase. The implicit midpoint rule keeps quadratic invariants but for the tolerance of its iteration, whose rest has a direction.".into(),
            ..Study::default()
        };
        if courses.is_empty() {
            study.note = "The top has no nutation.".into();
            return study;
        }
        study.tables.push(table(&courses));
        let drawn = match million::courses(scenes) {
            Ok(longer) => {
                study.tables.push(table(&longer));
                study.note += &format!(
                    " A million revolutions, which the pictures show, are from the last {}.",
                    million::COMMAND
                );
                longer
            }
            Err(reason) => {
                study.note += &format!(" {reason}");
                courses
            }
        };
        let energy = "log₁₀ of the largest relative error so far";
        let momentum = "log₁₀ of the relative error of x·ν";
        study.pictures = vec![
            picture(&drawn, "Energy", energy, |sample| Some(sample.swing)),
            picture(&drawn, "Length of the vertical", "log₁₀ of |ν² − 1|", |sample| Some(sample.length)),
            picture(&drawn, "Vertical momentum", momentum, |sample| Some(sample.momentum)),
            picture(&drawn, "Phase", "log₁₀ of the error, revolutions", |sample| sample.phase),
        ];
        study
    }
}

/// A picture of an error over the revolutions, with logarithmic axes.
fn picture(courses: &[MethodRun], title: &str, label: &str, of: impl Fn(&Sample) -> Option<f64>) -> Areas {
    let curve = |course: &MethodRun| {
        let point = |sample: &Sample| Some((sample.revolutions.log10(), of(sample)?.abs().max(FLOOR).log10()));
        AreaCurve { name: name(course), points: course.samples.iter().filter_map(point).collect() }
    };
    let curves: Vec<AreaCurve> = courses.iter().map(curve).collect();
    Areas {
        title: title.into(),
        x: ("log₁₀ of the revolutions".into(), [0.0, revolutions(courses).log10() + 0.1]),
        y: (label.into(), extent(&curves, |point| point.1)),
        curves,
        ..Areas::default()
    }
}

fn revolutions(courses: &[MethodRun]) -> f64 {
    courses.iter().flat_map(|course| &course.samples).fold(1.0, |most, sample| most.max(sample.revolutions))
}

fn name(course: &MethodRun) -> String {
    if course.method.traits().adaptive {
        return format!("{}, tolerance {:e}", course.method, course.tolerance);
    }
    crate::speed::family(Means::Integrated(course.method))
}

const QUANTITIES: [fn(&Sample) -> Option<f64>; 5] =
    [|s| Some(s.energy), |s| Some(s.swing), |s| Some(s.length), |s| Some(s.momentum), |s| s.phase];

/// The table of errors at the end of the runs, with the exponents of their growth.
fn table(courses: &[MethodRun]) -> Table {
    let head = [
        "Method",
        "Steps",
        "Error of the energy",
        "as n to the",
        "its largest",
        "as n to the",
        "of ν²",
        "as n to the",
        "of x·ν",
        "as n to the",
        "of the phase",
        "as n to the",
    ];
    let row = |course: &MethodRun| {
        let mut cells = vec![name(course), course.work.steps.to_string()];
        if let Some(failure) = course.failure {
            cells.push(failure.to_string());
            return cells;
        }
        for of in QUANTITIES {
            let last = course.samples.last().and_then(of);
            cells.push(last.map_or_else(|| "lost".into(), |error| significant(error.abs(), 2)));
            cells.push(course.growth(of).map_or_else(String::new, |growth| format!("{growth:.1}")));
        }
        cells
    };
    let caption = format!("After {:.0} revolutions", revolutions(courses).floor());
    Table { caption, head: head.map(String::from).into(), rows: courses.iter().map(row).collect() }
}
