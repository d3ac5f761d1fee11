//! A synchronous motor in a gyrostat: its pull-in load and the fractions of starts that synchronise, compared with the same motor on a bench.

use super::{SWINGS, onset};
use charts::{Table, significant};
use studies::scene::{Scene, Setup};
use studies::synchronism::basin::Share;
use studies::synchronism::loaded::{Loaded, giving_way};
use studies::synchronism::maps::{alone, over_starts};
use studies::synchronism::pull_in::PullIn;

/// The loads as fractions of the pull-out torque; [`STARTS`] are the numbers of initial angles and slips under each load.
const LOADS: [f64; 7] = [0.0, 0.1, 0.2, 0.4, 0.7, 0.95, 1.05];
const STARTS: (usize, usize) = (4, 4);

/// The results for a synchronous motor in a gyrostat, compared with the motor on a bench.
pub struct Carried {
    title: String,
    /// The axial moment of inertia A' of the rotor, and its effective value for torques between rotor and carrier, kg m².
    axial: [f64; 2],
    /// The pull-out load, N m.
    pull_out: f64,
    /// The pull-in with the rotor's own moment of inertia, and with the effective one.
    pull_in: [Option<PullIn>; 2],
    /// The starts that synchronise under each load, on the bench and in the gyrostat.
    shares: [Vec<Share>; 2],
}

impl Carried {
    /// Computes the results for a scene with a synchronous motor; `None` on a bench, or for another motor.
    pub fn of(scene: &Scene) -> Option<Self> {
        let Setup::Gyrostat(bodies) = &scene.system else { return None };
        let axial = [bodies.rotor.axial, giving_way(bodies)];
        let motors = axial.map(|axial| Loaded::new(&scene.machine, axial).ok());
        let [Some(own), Some(light)] = motors else { return None };
        let pull_out = Loaded::pull_out(&own.in_step())?.load;
        let pull_in = [&own, &light].map(|motor| motor.out_of_step().ok()?.pull_in(pull_out));
        let loads = LOADS.map(|share| share * pull_out);
        let span = SWINGS / own.facts.frequency;
        let shares = [&alone(scene), scene].map(|scene| over_starts(scene, &loads, STARTS, span).ok());
        let [Some(bench), Some(gyrostat)] = shares else { return None };
        Some(Carried { title: scene.title.clone(), axial, pull_out, pull_in, shares: [bench, gyrostat] })
    }

    /// The text below the table, with the pull-out load and the pull-in loads.
    pub fn told(&self) -> String {
        let Carried { axial: [own, light], pull_out, pull_in, .. } = self;
        let said = |of: &Option<PullIn>| {
            of.map_or_else(
                || "no slipping motion could be followed to it".to_owned(),
                |it| format!("{} N m, {}", significant(it.load, 6), onset(it.by)),
            )
        };
        format!(
            "In the gyrostat the pull-out is that of the bench, {} N m: in synchronism nothing accelerates. Its carrier moves too, so that for a \
             torque between them the rotor has the effective moment of inertia {} kg m², not {}. Pull-in of a rotor of {} kg m²: {}; of one of {}: {}. ",
            significant(*pull_out, 6),
            significant(*light, 4),
            significant(*own, 4),
            significant(*own, 4),
            said(&pull_in[0]),
            significant(*light, 4),
            said(&pull_in[1]),
        )
    }

    /// The table for the page.
    pub fn table(&self) -> Table {
        let Carried { title, shares: [bench, gyrostat], .. } = self;
        let caption = format!("In a gyrostat ({title}): which of {} starts come into step", STARTS.0 * STARTS.1);
        let head =
            ["Load, N m", "of the pull-out", "In step, on the bench", "in the gyrostat", "slipping there", "undecided"];
        let row = |((share, bench), gyrostat): ((&f64, &Share), &Share)| {
            let counts = [bench.in_step, gyrostat.in_step, gyrostat.slipping, gyrostat.undecided()];
            let first = [significant(gyrostat.load, 4), significant(*share, 3)];
            first.into_iter().chain(counts.map(|count| count.to_string())).collect()
        };
        let rows = LOADS.iter().zip(bench).zip(gyrostat).map(row).collect();
        Table { caption, head: head.map(String::from).into(), rows }
    }
}
