//! The study of a synchronous motor under load: its steady and periodic motions, and the starts that synchronise.

mod carried;
mod pictures;

use crate::job_pool::JobPool;
use carried::Carried;
use charts::{Study, Table, significant};
use pictures::{by_bars, plain, slipping, standing};
use studies::scene::{Scene, Setup};
use studies::synchronism::basin::Share;
use studies::synchronism::branches::{OutOfStep, Standing};
use studies::synchronism::loaded::{Loaded, with_bars};
use studies::synchronism::maps::{Row, over_damping, over_starts};
use studies::synchronism::pull_in::{Onset, PullIn};

/// The numbers of bars in the map; [`DRAWN`] are those whose asynchronous motions are continued.
const BARS: [usize; 9] = [0, 1, 2, 3, 4, 5, 6, 7, 8];
const DRAWN: [usize; 5] = [0, 1, 2, 3, 8];
/// The damping f / √(A' b₀) of each row of the map for the motor without currents.
const DAMPINGS: [f64; 10] = [0.05, 0.2, 0.35, 0.5, 0.65, 0.8, 0.95, 1.1, 1.25, 1.4];
/// The number of columns of a map, which extends from zero load to [`MOST`] times the pull-out torque.
const COLUMNS: usize = 24;
const MOST: f64 = 1.08;
/// The numbers of initial angles and initial slips for each cell.
const STARTS: (usize, usize) = (5, 5);
/// The duration of the run from each start of a motor with bars, in units of 1/ω, where ω is the angular frequency of small oscillations.
const SWINGS: f64 = 120.0;

/// The results for a number of bars: asynchronous motions, pull-in, and the outcomes of the starts.
struct OfBars {
    /// The number of bars.
    bars: usize,
    slipping: Option<OutOfStep>,
    pull_in: Option<PullIn>,
    shares: Vec<Share>,
}

/// The parts of the study, each a separate job.
#[derive(Default)]
pub struct Synchronism {
    title: String,
    motor: Option<Loaded>,
    in_step: Vec<Standing>,
    /// The pull-out load, N m.
    pull_out: f64,
    bars: [Option<Option<OfBars>>; BARS.len()],
    rows: [Option<Option<Row>>; DAMPINGS.len()],
    carried: Option<Option<Carried>>,
}

impl Synchronism {
    /// Adds the jobs for the first scene with a motor with bars on a bench, and for the first scene with such a motor in a gyrostat.
    pub fn enlist<'s>(&'s mut self, scenes: impl Iterator<Item = &'s Scene>, crew: &mut JobPool<'s>) {
        let scenes: Vec<&Scene> = scenes.filter(|scene| with_bars(scene, 0).is_some()).collect();
        let on_bench = |scene: &&&Scene| matches!(scene.system, Setup::Bench { .. });
        if let Some(scene) = scenes.iter().copied().find(|scene| matches!(scene.system, Setup::Gyrostat(_))) {
            crew.add(6.0, &mut self.carried, move || Carried::of(scene));
        }
        let Some(scene) = scenes.iter().find(on_bench).copied() else { return };
        let Ok(motor) = Loaded::of(scene) else { return };
        self.title.clone_from(&scene.title);
        self.in_step = motor.in_step();
        let Some(pull_out) = Loaded::pull_out(&self.in_step).map(|standing| standing.load) else { return };
        self.pull_out = pull_out;
        let span = SWINGS / motor.facts.frequency;
        self.motor = Some(motor);
        for (place, bars) in self.bars.iter_mut().zip(BARS) {
            crew.add(1.0, place, move || of_bars(scene, bars, pull_out, span));
        }
        for (place, damping) in self.rows.iter_mut().zip(DAMPINGS) {
            crew.add(0.4, place, move || over_damping(scene, damping, &columns(1.0), STARTS).ok());
        }
    }

    /// The completed study for the report.
    pub fn study(self) -> Option<Study> {
        let motor = self.motor?;
        let all: Vec<OfBars> = self.bars.into_iter().flatten().flatten().collect();
        let rows: Vec<Row> = self.rows.into_iter().flatten().flatten().collect();
        let carried = self.carried.flatten();
        let pictures = vec![
            standing(&self.in_step, self.pull_out),
            slipping(&all, self.pull_out, motor.facts.field_speed),
            plain(&rows),
            by_bars(&all, self.pull_out),
        ];
        Some(Study {
            id: "motor-under-load".into(),
            title: "A synchronous motor under load".into(),
            lead: format!(
                r"{}, with an additional constant torque $M$ (in N m) against the rotation of the rotor. Up to the pull-out torque, $M+f\Omega=b_0$, the motor can run in synchronism, whatever its damper; from the pull-in torque on it can slip for ever, and between the two the start decides. Both are found by continuation: of the synchronous angles over the load, and of the slipping motions, which repeat after one revolution, with the Floquet multipliers of this revolution. In addition a grid of starts is run; a start counts as synchronous if its energy $V$, which never grows, is below that of both unstable equilibria next to it, so that the motor stays in synchronism for ever.",
                self.title
            ),
            pictures,
            tables: std::iter::once(table(&all, self.pull_out)).chain(carried.as_ref().map(Carried::table)).collect(),
            note: carried.as_ref().map(Carried::told).unwrap_or_default()
                + r"Pull-in at an equilibrium: the period of the slipping motion tends to infinity, and the motion connects one unstable equilibrium with the next. Pull-in at a fold: a stable and an unstable slipping motion merge; the torque of a damper with three bars or more has a maximum over the slip, as Kloss' torque, beyond which friction alone balances a larger load. Without currents the pull-in is Tricomi's curve, which begins as $\frac4\pi$ of the damping and meets the pull-out at the damping 1.19. In a gyrostat the carrier moves too: there a start counts as synchronous if the rotor has not slipped in the last quarter of the time. One scene: dalembert motor scenes/bench.toml, or scenes/spin_up.toml.",
            ..Study::default()
        })
    }
}

/// The midpoints of the columns, which divide the range from zero to [`MOST`] times `whole`.
fn columns(whole: f64) -> Vec<f64> {
    (0..COLUMNS).map(|i| whole * MOST * (i as f64 + 0.5) / COLUMNS as f64).collect()
}

fn of_bars(scene: &Scene, bars: usize, pull_out: f64, span: f64) -> Option<OfBars> {
    let scene = with_bars(scene, bars)?;
    let slipping = DRAWN.contains(&bars).then(|| Loaded::of(&scene).ok()?.out_of_step().ok()).flatten();
    let pull_in = slipping.as_ref().and_then(|all| all.pull_in(pull_out));
    let shares = over_starts(&scene, &columns(pull_out), STARTS, span).ok()?;
    Some(OfBars { bars, slipping, pull_in, shares })
}

fn named(bars: usize) -> String {
    if bars == 1 { "1 bar".into() } else { format!("{bars} bars") }
}

fn table(all: &[OfBars], pull_out: f64) -> Table {
    let head = [
        "Bars",
        "Pull-in, N m",
        "of the pull-out",
        "Slipping begins",
        "Long turns at, N m",
        "Starts in step",
        "of",
        "undecided",
        "Median time under the least load, s",
    ];
    let row = |one: &OfBars| {
        let (load, share, by) = match one.pull_in {
            None => ("—".into(), "—".into(), "not followed".into()),
            Some(PullIn { load, by }) => (significant(load, 6), significant(load / pull_out, 4), onset(by)),
        };
        let sum = |of: fn(&Share) -> usize| one.shares.iter().map(of).sum::<usize>().to_string();
        let limit = one.slipping.as_ref().and_then(|all| all.limit);
        let time = one.shares.first().and_then(|share| share.time);
        let shown =
            |value: Option<f64>, digits| value.map_or_else(|| "—".to_owned(), |value| significant(value, digits));
        let counts = [sum(|s| s.in_step), sum(|s| s.starts), sum(Share::undecided)];
        [one.bars.to_string(), load, share, by, shown(limit, 6)]
            .into_iter()
            .chain(counts)
            .chain([shown(time, 2)])
            .collect()
    };
    let caption = format!("Pull-out at {} N m; starts of all loads of the map", significant(pull_out, 6));
    Table {
        caption,
        head: head.map(String::from).into(),
        rows: all.iter().filter(|one| DRAWN.contains(&one.bars)).map(row).collect(),
    }
}

/// The way in which asynchronous motions begin to exist, in words.
pub fn onset(by: Onset) -> String {
    match by {
        Onset::Balance => "with a period that tends to infinity, from one unstable equilibrium to the next".into(),
        Onset::Fold { slip } => format!("with a fold at a mean slip of {} rad/s", significant(slip, 4)),
        Onset::PullOut => "at the pull-out: no hysteresis".into(),
        Onset::End { slip } => format!("at the fastest slip that was followed, {} rad/s", significant(slip, 4)),
    }
}
