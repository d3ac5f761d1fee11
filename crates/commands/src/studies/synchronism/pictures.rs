//! The pictures of the study: angles and slips over the load, and maps of the starts that synchronise.

use super::{DAMPINGS, DRAWN, MOST, OfBars, columns, named};
use crate::studies::extent;
use charts::{AreaCurve, Areas};
use std::f64::consts::PI;
use studies::synchronism::basin::Share;
use studies::synchronism::branches::{Slipping, Standing};
use studies::synchronism::maps::Row;

/// The points of those elements for which `keep` holds, with a gap at the others.
fn gapped<T>(all: &[T], keep: impl Fn(&T) -> bool, point: impl Fn(&T) -> (f64, f64)) -> Vec<(f64, f64)> {
    all.iter().map(|one| if keep(one) { point(one) } else { (point(one).0, f64::NAN) }).collect()
}

/// The picture of the synchronous angles over the load.
pub fn standing(all: &[Standing], pull_out: f64) -> Areas {
    let point = |one: &Standing| (one.load, one.angle.to_degrees());
    let curve = |name: &str, keep: &dyn Fn(&Standing) -> bool| AreaCurve {
        name: name.into(),
        points: gapped(all, keep, point),
    };
    let curves = vec![
        curve("stable", &|one| one.growth <= 0.0 || one.fold),
        curve("unstable", &|one| one.growth > 0.0 || one.fold),
    ];
    let folds = all.iter().filter(|one| one.fold);
    // space for the name on the right
    let [least, most] = extent(&curves, |point| point.0);
    let most = most + 0.2 * (most - least);
    Areas {
        title: "In step: the angle over the load".into(),
        x: ("load M, N m".into(), [least, most]),
        y: ("angle γ, degrees".into(), [-190.0, 190.0]),
        dots: Vec::new(),
        marks: folds
            .map(|one| {
                (
                    one.load,
                    one.angle.to_degrees(),
                    if one.load == pull_out { "pull-out" } else { "as a generator" }.into(),
                )
            })
            .collect(),
        curves,
        note: "The same for any number of bars.".into(),
        ..Areas::default()
    }
}

/// The picture of the asynchronous motions over the load.
pub fn slipping(all: &[OfBars], pull_out: f64, field_speed: f64) -> Areas {
    let drawn = || all.iter().filter(|one| DRAWN.contains(&one.bars));
    let point = |one: &Slipping| (one.load, one.slip() / field_speed.abs());
    let motions = |one: &OfBars| one.slipping.as_ref().map_or_else(Vec::new, |all| all.motions.clone());
    let mut curves: Vec<AreaCurve> = drawn()
        .map(|one| {
            let mut points = gapped(&motions(one), |motion| motion.stable() || motion.fold, point);
            // the curve ends at its limit: as the period grows, the mean slip tends to zero like the inverse of a logarithm
            points.extend(one.slipping.as_ref().and_then(|all| all.limit).map(|load| (load, 0.0)));
            AreaCurve { name: named(one.bars), points }
        })
        .collect();
    let unstable = drawn().flat_map(|one| {
        let mut points = gapped(&motions(one), |motion| !motion.stable() || motion.fold, point);
        points.push((0.0, f64::NAN));
        points
    });
    curves.push(AreaCurve { name: "unstable".into(), points: unstable.collect() });
    curves.push(AreaCurve { name: "in step".into(), points: vec![(0.0, 0.0), (pull_out, 0.0)] });
    let within = |points: Vec<(f64, f64)>| {
        points.into_iter().map(|(x, y)| (x, if (0.0..=MOST * pull_out).contains(&x) { y } else { f64::NAN }))
    };
    for curve in &mut curves {
        curve.points = within(std::mem::take(&mut curve.points)).collect();
    }
    Areas {
        title: "Out of step: the mean slip over the load".into(),
        x: ("load M, N m".into(), [0.0, MOST * pull_out]),
        y: ("mean slip / Ω".into(), [-3.0, 0.15]),
        curves,
        note: "Under a load with both a synchronous and a slipping motion both are stable, and the start decides. Below -1 the load turns \
               the rotor backwards."
            .into(),
        ..Areas::default()
    }
}

/// The kinds of cells.
const KINDS: [&str; 4] = ["every start comes into step", "half of the starts or more", "none", "fewer than half"];

fn kind(share: &Share) -> usize {
    match share.in_step {
        0 => 2,
        all if all == share.starts => 0,
        some if 2 * some >= share.starts => 1,
        _ => 3,
    }
}

fn map(title: &str, rows: Vec<Vec<usize>>, x: (String, [f64; 2]), y: (String, [f64; 2])) -> Areas {
    Areas { title: title.into(), x, y, kinds: KINDS.map(String::from).into(), rows, ..Areas::default() }
}

/// The map over load and damping for the motor without currents.
pub fn plain(rows: &[Row]) -> Areas {
    let step = DAMPINGS[1] - DAMPINGS[0];
    let bounds = [DAMPINGS[0] - 0.5 * step, DAMPINGS[DAMPINGS.len() - 1] + 0.5 * step];
    let cells = rows.iter().map(|row| row.shares.iter().map(kind).collect()).collect();
    let curve = |row: &Row| {
        // the load in excess of the drag, in the unit of the columns
        let (first, last) = (row.shares.first()?, row.shares.last()?);
        let all = columns(1.0);
        let unit = (all.last()? - all.first()?) / (last.load - first.load);
        Some((all.first()? + (row.pull_in? - first.load) * unit, row.damping))
    };
    let line = |damping: f64| (4.0 / PI * damping, damping);
    let mut areas = map(
        "Without currents: load and damping",
        cells,
        ("(M + f Ω) / b₀".into(), [0.0, MOST]),
        ("damping f / √(A′ b₀)".into(), bounds),
    );
    areas.curves = vec![
        AreaCurve {
            name: "pull-in, by continuation (Tricomi's curve)".into(),
            points: rows.iter().filter_map(curve).collect(),
        },
        AreaCurve { name: "4/π of the damping".into(), points: vec![line(bounds[0]), line(PI / 4.0 * MOST)] },
    ];
    areas
}

/// The map over load and number of bars.
pub fn by_bars(all: &[OfBars], pull_out: f64) -> Areas {
    let cells = all.iter().map(|one| one.shares.iter().map(kind).collect()).collect();
    let most = all.last().map_or(0.5, |one| one.bars as f64 + 0.5);
    let mut areas = map(
        "With currents: load and bars",
        cells,
        ("load M, N m".into(), [0.0, MOST * pull_out]),
        ("bars of the damper".into(), [-0.5, most]),
    );
    let point = |one: &OfBars| Some((one.pull_in?.load.max(0.0), one.bars as f64));
    let long = |one: &OfBars| Some((one.slipping.as_ref()?.limit?.max(0.0), one.bars as f64));
    areas.curves = vec![
        AreaCurve { name: "pull-in, by continuation".into(), points: all.iter().filter_map(point).collect() },
        AreaCurve { name: "pull-out".into(), points: vec![(pull_out, -0.5), (pull_out, most)] },
        AreaCurve {
            name: "slipping with a period that tends to infinity".into(),
            points: all.iter().filter_map(long).collect(),
        },
    ];
    areas.note =
        "Starts from standstill to synchronism: some motions that slip at the pull-in are faster than these. One and two bars are one winding, whose torque depends on the angle; \
                  three or more are two windings with a uniform torque."
            .into();
    areas
}
