//! Maps of stability over the angular velocity and the rotor's speed, where rotor and weight lie along one principal axis.

use charts::{AreaCurve, Areas};
use derivations::scene::{Scene, System};
use derivations::stationary::energies::Energies;
use derivations::stationary::motions::decimals;
use derivations::stationary::stability::map::{Column, OneAxis};
use derivations::stationary::stability::reduced::Fate;
use derivations::systems::gyrostat::Gyrostat;

/// Of the rotor's speed in the picture, lest its numbers be long.
const THOUSANDTH: f64 = 1e-3;
/// Columns and rows.
const CELLS: (usize, usize) = (96, 72);

/// Upright and hanging, for each gyrostat of this kind that turns by a motor.
pub fn all(scenes: &[&Scene]) -> Vec<Areas> {
    let mut known: Vec<&Gyrostat<f64>> = Vec::new();
    let mut maps = Vec::new();
    for scene in scenes {
        let System::Gyrostat(bodies) = &scene.system else { continue };
        let bodies: &Gyrostat<f64> = bodies;
        let driven = scene.machine.name() != "free_rotor";
        if !driven || known.contains(&bodies) {
            continue;
        }
        let energies = Energies::of(&decimals(bodies));
        let both = [false, true].map(|hanging| OneAxis::of(&energies, hanging));
        known.push(bodies);
        let places = both.into_iter().zip(["upright", "hanging"]);
        maps.extend(places.filter_map(|(axis, place)| Some(map(&axis?, place, bodies, &scene.title))));
    }
    maps
}

/// The size of angular velocities and rotor speeds at which weight and rotation are in balance.
fn reach(bodies: &Gyrostat<f64>) -> [f64; 2] {
    let derived = bodies.derived();
    let size = derived.full.moments.max();
    let w = 2.5 * (derived.gamma / size).sqrt();
    let rotor = 2.5 * 2.0 * (derived.gamma * size).sqrt() / bodies.rotor.axial;
    [w, rotor]
}

fn map(axis: &OneAxis, place: &str, bodies: &Gyrostat<f64>, title: &str) -> Areas {
    let [w, rotor] = reach(bodies);
    let columns = axis.columns(w, CELLS.0);
    let place_of = |fate: Fate| Fate::ALL.iter().position(|known| *known == fate).unwrap_or(0);
    let row = |k: usize| {
        let speed = rotor * ((2 * k + 1) as f64 / CELLS.1 as f64 - 1.0);
        columns.iter().map(|column| place_of(column.at(speed))).collect()
    };
    Areas {
        title: format!("Where the {place} rotation is stable"),
        x: ("angular velocity, rad/s".into(), [-w, w]),
        y: ("rotor's relative speed, 1000 rad/s".into(), [-rotor * THOUSANDTH, rotor * THOUSANDTH]),
        kinds: Fate::ALL.iter().map(|fate| fate.name().into()).collect(),
        rows: (0..CELLS.1).map(row).collect(),
        curves: vec![
            curve(&columns, true, "a tilt costs no energy"),
            curve(&columns, false, "two pairs of roots meet"),
        ],
        marks: Vec::new(),
        note: format!(
            "The gyrostat of: {title}. In each column the edges are the real roots, isolated exactly, of two polynomials in \
             the rotor's speed, and between two of them the verdict is computed once, exactly; where it is unstable on both sides, roots become \
             complex there. A motor along the vertical does \
             not feel the tilt: the map is the same with every motor that is stable by itself."
        ),
    }
}

/// The k-th edge of a kind from column to column, as long as their number is the same. What lies beyond the picture parts one
/// piece from the next.
fn curve(columns: &[Column], neutral: bool, name: &str) -> AreaCurve {
    let mut pieces: Vec<Vec<(f64, f64)>> = Vec::new();
    let mut open = 0;
    for column in columns {
        let edges = column.edges.iter().filter(|edge| edge.neutral == neutral);
        let here: Vec<f64> = edges.map(|edge| edge.rotor_speed).collect();
        if here.len() != open {
            open = here.len();
            pieces.extend(here.iter().map(|_| Vec::new()));
        }
        let first = pieces.len() - open;
        pieces[first..]
            .iter_mut()
            .zip(here)
            .for_each(|(piece, speed)| piece.push((column.speed.to_f64(), speed * THOUSANDTH)));
    }
    let part = |mut piece: Vec<(f64, f64)>| {
        piece.push((0.0, f64::INFINITY));
        piece
    };
    AreaCurve { name: name.into(), points: pieces.into_iter().flat_map(part).collect() }
}
