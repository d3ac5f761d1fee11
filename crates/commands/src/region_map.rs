//! Maps of all steady motions of a scene over two of its data, computed on all processors, as pictures, text and JSON.

use crate::job_pool::JobPool;
use crate::progress::Progress;
use crate::stability_map::labelled;
use charts::{AreaCurve, Areas, significant};
use mechanics::steady_rotations::Kind;
use serde_json::{Value, json};
use std::fmt::Write;
use studies::scene::Scene;
use studies::stationary::motor::NoMotor;
use studies::stationary::stability::datum::Datum;
use studies::stationary::stability::region::line::Link;
use studies::stationary::stability::region::{
    Atlas, Border, Branch, Change, Class, NoRegion, Node, NodeMotions, Region,
};

/// The numbers of columns and rows of nodes.
const CELLS: [usize; 2] = [28, 21];
/// The largest number of branches that are drawn.
const DRAWN: usize = 8;
/// The work for a column of nodes, relative to the work for the continuation along one line of the grid.
const NODES: f64 = 3.0;

/// The note below the map, on the meaning and the limits of the map.
const NOTE: &str = "In the middle of each cell the motion is isolated and judged exactly. Between neighbours it is followed \
    with proof, and where its verdict changes, or it merges with another, the place is bracketed: a dot lies between two points \
    1/32 of a cell apart that are judged exactly too; where omega0 is the second datum, merging motions are roots of a polynomial \
    up each column. Nothing is interpolated, and an island smaller than a cell may be missed.";

/// A scene with the two data over which it is mapped, and their ranges.
pub struct MapRequest<'a> {
    pub scene: &'a Scene,
    /// The two data with their ranges, in SI units.
    pub data: [(&'a Datum, [f64; 2]); 2],
    /// The angular velocity about the vertical, rad/s.
    pub speed: f64,
}

impl MapRequest<'_> {
    /// The steady motions at all nodes, their continuation between adjacent nodes, and the changes between these.
    ///
    /// # Errors
    /// [`NoRegion`], where the data of the scene cannot be varied over these ranges.
    pub fn atlas(&self) -> Result<Atlas, NoRegion> {
        let region = Region::of(self.scene, self.data, self.speed, CELLS)?;
        let mut progress = Progress::new("map");
        let [columns, rows] = [region.values[0].len(), region.values[1].len()];
        let share = NODES * columns as f64 / (NODES * columns as f64 + (columns + rows) as f64);
        let mut nodes: Vec<Option<Result<Vec<Node>, NoMotor>>> = (0..columns).map(|_| None).collect();
        let mut crew = JobPool::default();
        for (column, place) in nodes.iter_mut().enumerate() {
            let region = &region;
            crew.add(1.0, place, move || region.column(column));
        }
        crew.work(|done| progress.set(share * done));
        let nodes: Vec<Vec<Node>> = nodes.into_iter().flatten().collect::<Result<_, _>>().map_err(NoRegion::Motor)?;
        let lines = (0..rows).map(|row| (0, nodes.iter().map(|column| &column[row]).collect::<Vec<&Node>>()));
        let lines: Vec<_> = lines.chain(nodes.iter().map(|column| (1, column.iter().collect()))).collect();
        let mut links: Vec<Option<Result<Vec<Link>, NoMotor>>> = lines.iter().map(|_| None).collect();
        let mut crew = JobPool::default();
        for ((moving, line), place) in lines.iter().zip(&mut links) {
            let region = &region;
            crew.add(1.0, place, move || region.links(line, *moving));
        }
        crew.work(|done| progress.set(share + (1.0 - share) * done));
        let links: Result<Vec<Vec<Link>>, NoMotor> = links.into_iter().flatten().collect();
        let mut across = links.map_err(NoRegion::Motor)?;
        let upwards = across.split_off(rows);
        Ok(Atlas::of(nodes, across, upwards))
    }

    /// One SVG file with a map for each branch.
    pub fn sheet(&self, atlas: &Atlas) -> String {
        let drawn = atlas.branches.iter().take(DRAWN).enumerate();
        let pictures: Vec<Areas> = drawn.map(|(number, branch)| self.picture(atlas, number, branch)).collect();
        let left_out = match atlas.branches.len().saturating_sub(DRAWN) {
            0 => String::new(),
            count => format!(" Branches that are not drawn, as they are the smallest: {count}."),
        };
        Areas::sheet(&pictures, &self.scene.title, &format!("{}{NOTE}{left_out}", self.turning()))
    }

    fn picture(&self, atlas: &Atlas, number: usize, branch: &Branch) -> Areas {
        let [(first, own), (second, range)] = self.data;
        let rows = atlas.columns.first().map_or(0, Vec::len);
        let kind = |column: usize, row: usize| match atlas.at(branch, column, row) {
            Some(here) => Class::ALL.iter().position(|one| *one == Class::from(here.verdict)).unwrap_or(0),
            None => Class::ALL.len(),
        };
        let borders = |name: &str, wanted: fn(Change) -> bool| {
            let of_branch = atlas.borders.iter().filter(|(of, border)| *of == number && wanted(border.change));
            let middle = |[a, b]: [[f64; 2]; 2]| (0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]));
            let place = |border: &Border| match border.exactly {
                Some(w) => (border.between[0][0], w),
                None => middle(border.between),
            };
            let points = of_branch.map(|(_, border)| place(border)).collect();
            AreaCurve { name: name.into(), points }
        };
        let dots = [
            borders("the verdict changes: bracketed", |change| change == Change::Verdict),
            borders("motions merge, or pull-out: bracketed; up omega0 exact", |change| change != Change::Verdict),
        ];
        let names = Class::ALL.iter().map(|class| name(*class).to_owned());
        Areas {
            title: format!("{}: {}", number + 1, described(atlas, branch)),
            x: (labelled(first), own),
            y: (labelled(second), range),
            kinds: names.chain(["no such motion".to_owned()]).collect(),
            rows: (0..rows).map(|row| (0..atlas.columns.len()).map(|column| kind(column, row)).collect()).collect(),
            dots: dots.into(),
            ..Areas::default()
        }
    }

    fn turning(&self) -> String {
        let given = self.data.iter().any(|(datum, _)| datum.name == "omega0");
        if given { String::new() } else { format!("Angular velocity: {} rad/s. ", self.speed) }
    }

    /// The map as text.
    pub fn text(&self, atlas: &Atlas) -> String {
        let [(first, _), (second, _)] = self.data;
        let mut out = format!("{}\n{}{NOTE}\n", self.scene.title, self.turning());
        // writing to a String cannot fail
        for (number, branch) in atlas.branches.iter().enumerate() {
            let _ = writeln!(out, "branch {}: {}", number + 1, described(atlas, branch));
            for (class, count) in Class::ALL.iter().zip(atlas.verdicts(branch)).filter(|(_, count)| *count > 0) {
                let _ = writeln!(out, "  {} at {count} nodes", name(*class));
            }
            for (_, border) in atlas.borders.iter().filter(|(of, _)| *of == number) {
                let [a, b] = border.between;
                let (datum, other) = if a[0] == b[0] { (1, 0) } else { (0, 1) };
                let names = [&first.name, &second.name];
                let (at, where_else) = match border.exactly {
                    Some(w) => (0, format!("at {} = {}, a root", names[1], shown(w))),
                    None => (other, format!("between {} = {} and {}", names[datum], shown(a[datum]), shown(b[datum]))),
                };
                let _ = writeln!(out, "  at {} = {}: {} {where_else}", names[at], shown(a[at]), changes(border.change));
            }
        }
        for node in atlas.columns.iter().flatten() {
            if let Some(why) = unusual(node) {
                let _ = writeln!(
                    out,
                    "at {} = {}, {} = {}: {why}",
                    first.name,
                    shown(node.values[0]),
                    second.name,
                    shown(node.values[1])
                );
            }
        }
        if atlas.lost > 0 {
            let _ = writeln!(out, "motions that could not be followed to a neighbour that has as many: {}", atlas.lost);
        }
        out
    }

    /// The map as JSON.
    pub fn object(&self, atlas: &Atlas) -> Value {
        let [(first, _), (second, _)] = self.data;
        let nodes = atlas.columns.iter().enumerate().flat_map(|(column, nodes)| {
            nodes.iter().enumerate().map(move |(row, node)| {
                let motions = node.isolated().iter().enumerate().map(|(place, here)| {
                    let of = |branch: &Branch| branch.places[column][row] == Some(place);
                    let v = here.direction;
                    json!({ "direction": [v.x, v.y, v.z], "kind": kind_name(here.kind), "rotor_state": here.state + 1,
                            "verdict": name(Class::from(here.verdict)),
                            "branch": atlas.branches.iter().position(of).map(|k| k + 1) })
                });
                json!({ "values": node.values, "motions": motions.collect::<Vec<_>>(), "unusual": unusual(node) })
            })
        });
        let branches = atlas.branches.iter().map(|branch| {
            let counts = Class::ALL.iter().zip(atlas.verdicts(branch));
            let verdicts: serde_json::Map<String, Value> =
                counts.map(|(class, count)| (name(*class).to_owned(), json!(count))).collect();
            json!({ "rotor_state": branch.state + 1, "nodes": branch.nodes, "verdicts": verdicts })
        });
        let borders = atlas.borders.iter().map(|(branch, border)| {
            json!({ "branch": branch + 1, "change": changes(border.change), "between": border.between,
                    "exactly": border.exactly })
        });
        json!({ "scene": self.scene.title, "model": self.scene.machine.name(), "first": first.name, "second": second.name,
                "note": NOTE, "nodes": nodes.collect::<Vec<_>>(), "branches": branches.collect::<Vec<_>>(),
                "borders": borders.collect::<Vec<_>>(), "lost": atlas.lost })
    }
}

/// A value of a datum as text with nine digits.
fn shown(value: f64) -> String {
    significant(value, 9)
}

/// A description of a branch: its mean direction, its kind, and the number of its nodes.
fn described(atlas: &Atlas, branch: &Branch) -> String {
    let all = atlas.columns.iter().map(Vec::len).sum::<usize>();
    let mut mean = [0.0; 3];
    let mut kinds: Vec<Kind> = Vec::new();
    for (column, nodes) in atlas.columns.iter().enumerate() {
        for here in (0..nodes.len()).filter_map(|row| atlas.at(branch, column, row)) {
            mean.iter_mut().zip(&here.direction).for_each(|(sum, v)| *sum += v / branch.nodes.max(1) as f64);
            kinds.push(here.kind);
        }
    }
    kinds.sort_unstable();
    kinds.dedup();
    let kinds: Vec<&str> = kinds.into_iter().map(kind_name).collect();
    let state = if branch.state > 0 { format!(", the rotor's state {}", branch.state + 1) } else { String::new() };
    let [x, y, z] = mean;
    let kinds = kinds.join(" or ");
    format!("v around ({x:.2}, {y:.2}, {z:.2}), a {kinds} of W, at {} of {all} nodes{state}", branch.nodes)
}

fn kind_name(kind: Kind) -> &'static str {
    match kind {
        Kind::Minimum => "minimum",
        Kind::Saddle => "saddle",
        Kind::Maximum => "maximum",
        Kind::Degenerate => "degenerate point",
    }
}

fn name(class: Class) -> &'static str {
    match class {
        Class::AsymptoticallyStable => "asymptotically stable modulo the integrals",
        Class::Stable => "stable",
        Class::Unstable => "unstable",
        Class::Gyroscopic => "stable by gyroscopic forces at most: linear analysis does not decide",
        Class::Undecided => "not decided",
    }
}

fn changes(change: Change) -> &'static str {
    match change {
        Change::Verdict => "the verdict changes",
        Change::Fold => "the motion merges with another",
        Change::PullOut => "the motor is pulled out",
    }
}

/// A text on a node with connected families of motions or without motions; `None` where all motions are isolated.
fn unusual(node: &Node) -> Option<String> {
    match &node.place {
        NodeMotions::Motions { families, .. } if families.is_empty() => None,
        NodeMotions::Motions { families, .. } => {
            let verdicts = families.iter().flat_map(|(_, verdicts)| verdicts);
            let mut names: Vec<&str> = verdicts.map(|verdict| name(Class::from(*verdict))).collect();
            names.dedup();
            Some(format!("also a connected family of motions: {}", names.join(", along it also ")))
        }
        NodeMotions::PulledOut => Some("the motor is pulled out".into()),
        NodeMotions::NoBodies => Some("no bodies have these data".into()),
        NodeMotions::TooFine => Some("motions lie too close together to be separated".into()),
    }
}
