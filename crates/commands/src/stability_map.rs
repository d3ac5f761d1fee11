//! Stability maps over two data of a scene whose rotor and weight lie along one principal axis.

use charts::{AreaCurve, Areas};
use studies::scene::{Scene, Setup};
use studies::stationary::stability::datum::Datum;
use studies::stationary::stability::map::Column;
use studies::stationary::stability::plane::{Cell, NoPlane, Plane};
use studies::stationary::stability::reduced::Fate;
use studies::stationary::stability::region::nodes;
use systems::gyrostat::Gyrostat;

/// The numbers of columns and rows of cells.
const CELLS: (usize, usize) = (96, 72);

/// The label of cells in which the load exceeds the pull-out torque of the motor.
const BEYOND: &str = "no stationary motion: the motor is pulled out";

/// A map of a scene over two data, each in its range.
pub struct MapRequest<'a> {
    pub scene: &'a Scene,
    /// The two data with their ranges, in SI units.
    pub data: [(&'a Datum, [f64; 2]); 2],
    /// The angular velocity about the vertical, rad/s.
    pub speed: f64,
    /// Whether the centre of mass hangs below the fixed point; otherwise it is above.
    pub hanging: bool,
}

/// The maps of the report for each gyrostat with this symmetry and a motor: over the angular velocity and the rotor speed, and over the load and
/// the height of the carrier's centre of mass.
pub fn all(scenes: &[&Scene]) -> Vec<Areas> {
    let mut known: Vec<&Gyrostat<f64>> = Vec::new();
    let mut maps = Vec::new();
    for &scene in scenes {
        let Setup::Gyrostat(bodies) = &scene.system else { continue };
        let bodies: &Gyrostat<f64> = bodies;
        if scene.machine.name() == "free_rotor" || known.contains(&bodies) {
            continue;
        }
        known.push(bodies);
        maps.extend([false, true].into_iter().flat_map(|hanging| of_gyrostat(scene, bodies, hanging)));
    }
    maps
}

fn of_gyrostat(scene: &Scene, bodies: &Gyrostat<f64>, hanging: bool) -> Vec<Areas> {
    let [w, rotor] = reach(bodies);
    let height = bodies.carrier.centre.iter().position(|c| *c != 0.0).map(|axis| (axis, bodies.carrier.centre[axis]));
    let map = |names: [&str; 2], ranges: [[f64; 2]; 2], speed: f64| {
        let [first, second] = names.map(|name| Datum::named(scene, name).ok());
        let (first, second) = (first?, second?);
        let [own, other] = ranges;
        let asked = MapRequest { scene, data: [(&first, own), (&second, other)], speed, hanging };
        Some(asked.map(&asked.columns().ok()?))
    };
    let speeds = map(["omega0", "rotor_speed"], [[-w, w], [-rotor, rotor]], 0.0);
    let loads = height.and_then(|(axis, c)| {
        let load = Datum::named(scene, "load").ok()?;
        let held = Plane::of(scene, [&load, &load_free(scene)?], 0.0, true).ok()?.bears()?;
        let most = 1.25 * held.greatest.max(-held.least);
        let name = format!("carrier.centre.{}", axis + 1);
        map(["load", &name], [[-most, most], [-2.0 * c.abs(), 2.0 * c.abs()]], 0.5 * w)
    });
    speeds.into_iter().chain(loads).collect()
}

/// A datum on which the motor does not depend.
fn load_free(scene: &Scene) -> Option<Datum> {
    Datum::named(scene, "gravity").ok()
}

/// The ranges of the angular velocity and of the rotor speed in the maps, rad/s, at which the torques of weight and of rotation are comparable.
fn reach(bodies: &Gyrostat<f64>) -> [f64; 2] {
    let derived = bodies.derived();
    let size = derived.full.moments.max();
    let w = 2.5 * (derived.gamma / size).sqrt();
    let rotor = 2.5 * 2.0 * (derived.gamma * size).sqrt() / bodies.rotor.axial;
    [w, rotor].map(rounded)
}

/// A value rounded to two digits, which shortens the exact arithmetic with it.
fn rounded(value: f64) -> f64 {
    format!("{value:.1e}").parse().unwrap_or(value)
}

impl MapRequest<'_> {
    /// The columns of the map: values of the first datum, each with the intervals of the second datum and their verdicts.
    ///
    /// # Errors
    /// [`NoPlane`], where the scene has no such symmetry or the data cannot be varied.
    pub fn columns(&self) -> Result<Vec<(f64, Cell)>, NoPlane> {
        let [(first, [low, high]), (second, range)] = self.data;
        let along = self.weighs_along() == self.hanging;
        let plane = Plane::of(self.scene, [first, second], self.speed, along)?;
        nodes([low, high], CELLS.0).into_iter().map(|value| Ok((value, plane.cell(value, range)?))).collect()
    }

    /// Whether the centre of mass of the scene lies on the positive side of the axis.
    fn weighs_along(&self) -> bool {
        match &self.scene.system {
            Setup::Gyrostat(bodies) => bodies.weight().iter().find(|g| **g != 0.0).is_none_or(|g| *g > 0.0),
            Setup::Bench { .. } => true,
        }
    }

    /// The curve of pull-out loads, beyond which the motor has no synchronous motion; `None` without a motor that synchronises.
    fn pull_out(&self) -> Option<AreaCurve> {
        let [(first, [low, high]), (second, [bottom, top])] = self.data;
        let held = Plane::of(self.scene, [first, second], self.speed, true).ok()?.bears()?;
        let ends = [held.least, held.greatest].into_iter().filter(|load| (low..high).contains(load));
        let points = ends.flat_map(|load| [(load, bottom), (load, top), (load, f64::INFINITY)]).collect();
        Some(AreaCurve { name: "pull-out".into(), points })
    }

    /// The map as a picture.
    pub fn map(&self, columns: &[(f64, Cell)]) -> Areas {
        let [(first, own), (second, range)] = self.data;
        let beyond = Fate::ALL.len();
        let kind = |cell: &Cell, at: f64| match cell {
            Cell::Decided(column) => Fate::ALL.iter().position(|known| *known == column.at(at)).unwrap_or(0),
            Cell::PulledOut => beyond,
        };
        let row = |k: usize| {
            let at = range[0] + (range[1] - range[0]) * (2 * k + 1) as f64 / (2 * CELLS.1) as f64;
            columns.iter().map(|(_, cell)| kind(cell, at)).collect()
        };
        let rows: Vec<Vec<usize>> = (0..CELLS.1).map(row).collect();
        let mut kinds: Vec<String> = Fate::ALL.iter().map(|fate| fate.name().into()).collect();
        // this kind is in the legend only if it occurs
        kinds.extend(rows.iter().flatten().any(|one| *one == beyond).then(|| BEYOND.to_owned()));
        let place = if self.hanging { "hanging" } else { "upright" };
        let turning = [first, second].iter().all(|datum| datum.name != "omega0");
        let turning = if turning { format!(" Angular velocity: {} rad/s.", self.speed) } else { String::new() };
        Areas {
            title: format!("Where the {place} rotation is stable"),
            x: (labelled(first), own),
            y: (labelled(second), range),
            names: Vec::new(),
            kinds,
            rows,
            curves: [curve(columns, true, "a tilt costs no energy"), curve(columns, false, "two pairs of roots meet")]
                .into_iter()
                .chain(self.pull_out())
                .collect(),
            dots: Vec::new(),
            marks: Vec::new(),
            note: format!(
                "The gyrostat of: {}.{turning} In each column the edges are the real roots, isolated exactly, of two \
                 polynomials in {}, and between two of them the verdict is computed once, exactly; where it is unstable on \
                 both sides, roots become complex there. A motor along the vertical does not feel the tilt: the map is the \
                 same with every motor that is stable by itself.",
                self.scene.title, second.name
            ),
        }
    }
}

/// The name of a datum with its unit.
pub fn labelled(datum: &Datum) -> String {
    format!("{}, {}", datum.name, datum.unit)
}

/// The curves of boundaries of one kind, neutral or not, joined from column to column as long as their number does not change. A point outside the
/// picture separates the pieces.
fn curve(columns: &[(f64, Cell)], neutral: bool, name: &str) -> AreaCurve {
    let mut pieces: Vec<Vec<(f64, f64)>> = Vec::new();
    let mut open = 0;
    for (x, cell) in columns {
        let edges = match cell {
            Cell::Decided(Column { edges, .. }) => &edges[..],
            _ => &[],
        };
        let here: Vec<f64> = edges.iter().filter(|edge| edge.neutral == neutral).map(|edge| edge.at).collect();
        if here.len() != open {
            open = here.len();
            pieces.extend(here.iter().map(|_| Vec::new()));
        }
        let first = pieces.len() - open;
        pieces[first..].iter_mut().zip(here).for_each(|(piece, at)| piece.push((*x, at)));
    }
    let part = |mut piece: Vec<(f64, f64)>| {
        piece.push((0.0, f64::INFINITY));
        piece
    };
    AreaCurve { name: name.into(), points: pieces.into_iter().flat_map(part).collect() }
}
