//! `dalembert stationary --along A=FROM..TO --along B=FROM..TO`: the numbers of steady motions and of stable ones over two parameters.

use super::Args;
use super::refusals::{reason, refused};
use super::steady_box::{number, unit};
use super::verdict::verdict;
use crate::arguments::Format;
use crate::clock::has_time;
use crate::exit::{Exit, print, warn};
use crate::job_pool::JobPool;
use crate::output::{Form, Writes};
use crate::progress::Progress;
use ::scenes::steady_motions::{Direction, NoSteadyMotions, PlaneCell, Range, SteadySearch, middles};
use charts::{AreaCurve, Areas};
use model::Model;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fmt::Write;

/// The default number of cells in each direction.
const CELLS: usize = 24;

/// The number of kinds of cells with their own colours; the rarest kinds share one.
const COLOURS: usize = 12;

/// The numbers of motions, stable motions, undecided motions and families in a cell; `None` where the search is incomplete.
type Count = Option<[usize; 4]>;

/// A map of steady motions over two parameters.
struct Map<'a> {
    title: String,
    names: [&'a str; 2],
    ranges: [Range; 2],
    units: [String; 2],
    /// The cells of each column from below.
    columns: Vec<Vec<PlaneCell>>,
    /// Brackets of the boundaries: pairs of points of the plane between which the motions change.
    borders: Vec<[[f64; 2]; 2]>,
}

/// Prints the map, and writes the requested picture.
pub(super) fn show(asked: &Args, [first, second]: [&(String, Range); 2]) -> Result<Exit, Exit> {
    if first.0 == second.0 {
        return Err(Exit::refused(format!("--along {} is given twice; two different names are accepted", first.0)));
    }
    let writes = Writes { command: "stationary", force: asked.force, reads: vec![&asked.scene] };
    let output = writes.optional(asked.out.as_deref(), &[Form::Picture])?;
    let (title, model, wanted) = asked.steady.along(&asked.scene, &[&first.0, &second.0])?;
    let names = [first.0.as_str(), second.0.as_str()];
    let directions = [(names[0], first.1), (names[1], second.1)];
    let columns = cells((&wanted, asked.values.unwrap_or(CELLS)), &model, directions);
    let left_out: Vec<&NoSteadyMotions> = columns.iter().flatten().filter_map(|cell| cell.left_out.as_ref()).collect();
    if let Some(why) = left_out.first().filter(|_| columns.iter().flatten().all(|cell| cell.left_out.is_some())) {
        return Err(refused(&asked.scene, (&model, wanted.text.as_deref()), (*why).clone()));
    }
    if let Some(why) = left_out.first() {
        warn(&format!(
            "warning: {}: steady motions are not sought in {} of the cells, of which the first: {}",
            asked.scene.display(),
            left_out.len(),
            reason(&model, wanted.text.as_deref(), (*why).clone()).title
        ));
    }
    let borders = borders(&wanted, &model, names, &columns);
    let units = names.map(|name| unit(&model, name));
    let map = Map { title, names, ranges: [first.1, second.1], units, columns, borders };
    print(&match asked.format {
        Format::Text => map.text(),
        Format::Json => format!("{:#}\n", map.object()),
    })?;
    if let Some(output) = output {
        output.write_text(&map.picture().svg())?.tell(asked.format)?;
    }
    let open = map.columns.iter().flatten().filter(|cell| !cell.is_complete()).count();
    if open == 0 {
        return Ok(Exit::Done);
    }
    warn(&format!(
        "warning: {}: {open} cells are not decided: more time (--seconds), more boxes (--boxes {}) or narrower ranges (--range) may decide more",
        asked.scene.display(),
        10 * asked.steady.boxes
    ));
    Ok(Exit::Stopped)
}

/// The cells of all columns.
fn cells(
    (wanted, count): (&SteadySearch, usize),
    model: &Model,
    directions: [Direction<'_>; 2],
) -> Vec<Vec<PlaneCell>> {
    let mut progress = Progress::new("the map");
    let mut columns: Vec<Option<Vec<PlaneCell>>> = (0..count).map(|_| None).collect();
    let mut crew = JobPool::default();
    for (value, place) in middles(directions[0].1, count).into_iter().zip(&mut columns) {
        crew.add(1.0, place, move || PlaneCell::column(model, wanted, directions, (value, count), has_time));
    }
    crew.work(|done| progress.set(done));
    columns.into_iter().flatten().collect()
}

/// Narrow brackets of the changes between adjacent cells that differ.
fn borders(wanted: &SteadySearch, model: &Model, names: [&str; 2], columns: &[Vec<PlaneCell>]) -> Vec<[[f64; 2]; 2]> {
    let beside = columns.windows(2).flat_map(|pair| pair[0].iter().zip(&pair[1]));
    let above = columns.iter().flat_map(|column| column.iter().zip(column.iter().skip(1)));
    let pairs: Vec<_> = beside.chain(above).filter(|(a, b)| !a.is_like(b)).collect();
    let mut progress = Progress::new("the boundaries");
    let mut found: Vec<Option<[[f64; 2]; 2]>> = pairs.iter().map(|_| None).collect();
    let mut crew = JobPool::default();
    for ((one, other), place) in pairs.into_iter().zip(&mut found) {
        crew.add(1.0, place, move || one.border(other, model, wanted, names, has_time));
    }
    crew.work(|done| progress.set(done));
    found.into_iter().flatten().collect()
}

fn count(cell: &PlaneCell) -> Count {
    let found = &cell.found;
    let told: Vec<&str> = found.motions.iter().map(|motion| verdict(motion, &found.cyclic).0).collect();
    let of = |words: &[&str]| told.iter().filter(|told| words.contains(told)).count();
    let (stable, unstable) = (of(&["stable", "asymptotically stable"]), of(&["unstable"]));
    let open = told.len() - stable - unstable;
    cell.is_complete().then_some([told.len(), stable, open, found.families.len()])
}

fn said(count: Count) -> String {
    let Some([all, stable, open, families]) = count else { return "not decided".to_owned() };
    let motions = if all == 1 { "1 steady motion".to_owned() } else { format!("{all} steady motions") };
    let open = if open == 0 { String::new() } else { format!(", {open} neither known to be stable nor unstable") };
    match (all, families) {
        (0, 0) => "no steady motion".to_owned(),
        (0, 1) => "one family of steady motions".to_owned(),
        (0, families) => format!("{families} families of steady motions"),
        (_, 0) => format!("{motions}: {stable} stable{open}"),
        (_, 1) => format!("{motions}: {stable} stable{open}; and one family"),
        (_, families) => format!("{motions}: {stable} stable{open}; and {families} families"),
    }
}

impl Map<'_> {
    /// The kinds of cells with their numbers of cells, the most frequent first.
    fn kinds(&self) -> Vec<(Count, usize)> {
        let mut kinds: BTreeMap<Count, usize> = BTreeMap::new();
        for cell in self.columns.iter().flatten() {
            *kinds.entry(count(cell)).or_default() += 1;
        }
        let mut kinds: Vec<(Count, usize)> = kinds.into_iter().collect();
        kinds.sort_by_key(|(kind, cells)| (std::cmp::Reverse(*cells), *kind));
        kinds
    }

    /// The cells of a row, as indices into the kinds.
    fn row(&self, row: usize, kinds: &[(Count, usize)]) -> Vec<usize> {
        let place = |cell: &PlaneCell| kinds.iter().position(|(kind, _)| *kind == count(cell)).unwrap_or(0);
        self.columns.iter().map(|column| place(&column[row])).collect()
    }

    fn text(&self) -> String {
        let [first, second] = self.names;
        let kinds = self.kinds();
        let mut out = format!("{}\n", self.title);
        let letter = |place: usize| char::from(b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz*"[place.min(52)]);
        // writing to a String cannot fail
        for (place, (kind, cells)) in kinds.iter().enumerate() {
            let _ = writeln!(out, "  {}  {} ({cells} cells)", letter(place), said(*kind));
        }
        let rows = self.columns.first().map_or(0, Vec::len);
        let _ = writeln!(
            out,
            "\n{second} upwards from {} to {}{}, {first} to the right from {} to {}{}: the motions in the middle of each cell",
            number(self.ranges[1].from),
            number(self.ranges[1].to),
            self.units[1],
            number(self.ranges[0].from),
            number(self.ranges[0].to),
            self.units[0]
        );
        for row in (0..rows).rev() {
            let line: String = self.row(row, &kinds).into_iter().map(letter).collect();
            let _ = writeln!(out, "  {:>14}  {line}", number(self.columns[0][row].values[1]));
        }
        let _ = match self.borders.len() {
            0 => writeln!(out, "\nno two neighbours differ; a region smaller than a cell may be missed"),
            places => writeln!(
                out,
                "\n{places} places of boundaries, each between two values 1/32 of a cell apart; a region smaller than a cell may be missed"
            ),
        };
        out
    }

    fn picture(&self) -> Areas {
        let kinds = self.kinds();
        let shown = if kinds.len() > COLOURS { COLOURS - 1 } else { kinds.len() };
        let mut names: Vec<String> = kinds.iter().take(shown).map(|(kind, _)| said(*kind)).collect();
        names.extend((kinds.len() > shown).then(|| "other numbers, each in few cells".to_owned()));
        let rows = self.columns.first().map_or(0, Vec::len);
        let row = |row: usize| self.row(row, &kinds).into_iter().map(|kind| kind.min(shown)).collect();
        let middle = |[a, b]: &[[f64; 2]; 2]| (0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]));
        let label = |place: usize| match self.units[place].as_str() {
            "" => self.names[place].to_owned(),
            unit => format!("{},{unit}", self.names[place]),
        };
        let range = |place: usize| [self.ranges[place].from, self.ranges[place].to];
        let dots = AreaCurve {
            name: "the number or the stability of motions changes, bracketed".to_owned(),
            points: self.borders.iter().map(middle).collect(),
        };
        Areas {
            title: self.title.clone(),
            x: (label(0), range(0)),
            y: (label(1), range(1)),
            kinds: names,
            rows: (0..rows).map(row).collect(),
            dots: if self.borders.is_empty() { Vec::new() } else { vec![dots] },
            ..Areas::default()
        }
    }

    fn object(&self) -> Value {
        let cell = |cell: &PlaneCell| {
            let count = count(cell);
            json!({
                "values": cell.values,
                "complete": count.is_some(),
                "motions": count.map(|[all, ..]| all),
                "stable": count.map(|[_, stable, ..]| stable),
                "undecided": count.map(|[.., open, _]| open),
                "families": count.map(|[.., families]| families),
            })
        };
        json!({
            "title": self.title,
            "along": self.names,
            "units": self.units.each_ref().map(|unit| unit.trim()),
            "cells": self.columns.iter().flatten().map(cell).collect::<Vec<_>>(),
            "boundaries": self.borders,
        })
    }
}
