//! Charts of quantities along the cone of permanent rotations, over the angular velocity.

use super::pieces::{Piece, class};
use super::{Case, reach};
use charts::{Panel, Table, Track, significant};
use nalgebra::Vector3;

/// For each branch of the cone, the angle between the vertical and the centre of mass (degrees), and the vertical angular momentum (N m s).
pub(super) fn along(case: &Case) -> charts::Trajectory {
    let (conditions, reach) = (&case.conditions, reach(case));
    let down = conditions.weight.normalize();
    let angle = |v: &Vector3<f64>, _: f64| v.dot(&down).clamp(-1.0, 1.0).acos().to_degrees();
    let momentum = |v: &Vector3<f64>, w: f64| {
        v.component_mul(&conditions.moments).dot(v) * w + conditions.spin * conditions.axis.dot(v)
    };
    let panel = |y: &str, value: &dyn Fn(&Vector3<f64>, f64) -> f64| {
        // the series are in the order of the classes, so that they have the colours of the sphere
        let mut pieces: Vec<&Piece> = case.pieces.iter().filter(|piece| piece.fate.is_some()).collect();
        pieces.sort_by_key(|piece| class(piece).0);
        let track = |piece: &&Piece| Track {
            name: class(piece).1.to_owned(),
            points: piece.points.iter().filter(|(_, w)| w.abs() <= reach).map(|(v, w)| (*w, value(v, *w))).collect(),
            stopped: None,
        };
        let series = pieces.iter().map(track).filter(|track| !track.points.is_empty()).collect();
        Panel { y: y.to_owned(), series }
    };
    charts::Trajectory {
        title: format!("The angular velocity along the cone, the rotor at {} rad/s", significant(case.speed, 4)),
        x: "angular velocity of the carrier, rad/s".into(),
        panels: vec![panel("angle from e, degrees", &angle), panel("vertical momentum, N m s", &momentum)],
        note: "A vertical line meets the upper curves in all stationary motions with that angular velocity; a horizontal one \
               meets the lower curves in all with that momentum, which every motor conserves."
            .into(),
    }
}

pub(super) fn table(case: &Case) -> Option<Table> {
    let census = case.census.as_ref()?;
    let bound =
        |w: f64| if w.is_finite() { significant(w, 6) } else { (if w < 0.0 { "−∞" } else { "∞" }).to_owned() };
    let rows = census.stretches.iter().map(|stretch| {
        let families = if stretch.families > 0 { format!(" and {} families", stretch.families) } else { String::new() };
        vec![bound(stretch.from), bound(stretch.to), format!("{}{families}", stretch.isolated)]
    });
    Some(Table {
        caption: format!("How many stationary motions, the rotor at {} rad/s", significant(case.speed, 4)),
        head: ["from, rad/s", "to, rad/s", "motions"].map(String::from).into(),
        rows: rows.collect(),
    })
}
