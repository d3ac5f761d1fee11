//! Neighbouring nodes on a row or column of the map: the motions common to both, and the borders at which a motion ends
//! or its verdict changes.

use super::Region;
use super::law::Ground;
use super::node::{Class, Here, Node, NodeMotions};
use super::spot::{BITS, Raw, Spot};
use crate::stationary::motor::NoMotor;
use algebra::real::Enclosure;
use field::Rational;
use mechanics::steady_rotations::{self, Data, followed};
use std::cell::OnceCell;
use symbolic::{Formulas, Sym, symbols};

/// The relation of two neighbouring nodes.
#[derive(Clone, Debug, Default)]
pub struct Link {
    /// For each common motion, its index at the first node and at the second.
    pub joined: Vec<[usize; 2]>,
    pub borders: Vec<Border>,
    /// The number of motions that could not be continued, although both nodes have equally many.
    pub lost: usize,
}

/// A change between two points; the verdicts at both are proved, as at the nodes.
#[derive(Clone, Debug, PartialEq)]
pub struct Border {
    pub change: Change,
    pub between: [[f64; 2]; 2],
    /// The value of the second datum, w0, rad/s, if it is an isolated root of a polynomial.
    pub exactly: Option<f64>,
    /// The motion that changes: the neighbour (0: first, 1: second), and the index of the motion there.
    pub of: (usize, usize),
}

/// The kind of change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// The verdict on one motion changes.
    Verdict,
    /// Two motions merge (saddle-node bifurcation).
    Fold,
    /// The motor has no steady speed or angle beyond this border.
    PullOut,
}

/// The number of bisections between two neighbours; the remaining interval is a third of a line width in print.
const HALVINGS: usize = 5;

/// K and b along a line on which one datum varies.
struct Line<'a> {
    region: &'a Region<'a>,
    moving: usize,
    formulas: Formulas,
    /// The values of w0, rad/s, at which two motions on this line merge.
    folds: OnceCell<Vec<f64>>,
}

/// A point of the line, with the value of the rotor's constant quantity.
#[derive(Clone)]
struct Stop {
    values: [f64; 2],
    value: Enclosure,
}

impl Region<'_> {
    /// The links between successive nodes of a row (`moving` 0) or a column (1).
    ///
    /// # Errors
    /// [`NoMotor`] if the motor's steady states are not known.
    pub fn links(&self, nodes: &[&Node], moving: usize) -> Result<Vec<Link>, NoMotor> {
        let Some(first) = nodes.first() else { return Ok(Vec::new()) };
        let ground = self.ground(first.values[0])?;
        let Some(line) = Line::of(self, &ground, first.values, moving) else {
            return Ok(vec![Link::default(); nodes.len().saturating_sub(1)]);
        };
        nodes.windows(2).map(|pair| line.link(pair[0], pair[1])).collect()
    }
}

impl<'a> Line<'a> {
    fn of(region: &'a Region<'a>, ground: &Ground, values: [f64; 2], moving: usize) -> Option<Self> {
        let unknowns = symbols(["x", "w0", "kept"]);
        let [x, speed, kept] = unknowns;
        let fixed = region.general.with(region.data[1 - moving], values[1 - moving]);
        let energies = fixed.with(region.data[moving], f64::NAN).energies_in(x)?;
        let (tensor, share) = energies.quadratic(region.kept(ground));
        let matrix = tensor * (speed * speed);
        let vector = share * (speed * kept) + energies.weight;
        // the matrix is symmetric, so the order of rows and columns does not matter
        let all: Vec<Sym> = matrix.iter().chain(vector.iter()).copied().collect();
        Some(Line { region, moving, formulas: Formulas::of(&all, &unknowns).ok()?, folds: OnceCell::new() })
    }

    /// The motion at the point `to` that continues a motion at the point `from`.
    fn followed(
        &self,
        place: &steady_rotations::EnclosedPoint,
        from: &Stop,
        to: &Stop,
    ) -> Option<steady_rotations::EnclosedPoint> {
        let number = |x: f64| Enclosure::rational(Rational::decimal(x), BITS);
        let speed = |stop: &Stop| number(self.region.setting(stop.values).speed);
        let ends = |a: Enclosure, b: Enclosure| (a.clone(), &b - &a);
        let x = ends(number(from.values[self.moving])?, number(to.values[self.moving])?);
        let all = [x, ends(speed(from)?, speed(to)?), ends(from.value.clone(), to.value.clone())];
        let one = Enclosure::integer(1, BITS);
        let path = |t: &Enclosure| -> Option<Data> {
            let at = all.each_ref().map(|(from, way)| from + &(t * way));
            let values = self.formulas.values(&at, &one)?;
            let entry = |k: usize| values[k].clone();
            let row = |i: usize| [entry(3 * i), entry(3 * i + 1), entry(3 * i + 2)];
            Some(([row(0), row(1), row(2)], row(3)))
        };
        followed(&path, place)
    }

    fn link(&self, first: &Node, second: &Node) -> Result<Link, NoMotor> {
        let [a, b] = [first, second].map(Node::isolated);
        let mut link = Link::default();
        let stop = |node: &Node, here: &Here| Stop { values: node.values, value: here.value.clone() };
        for (i, here) in a.iter().enumerate() {
            let Some(other) = b.iter().find(|there| there.state == here.state) else { continue };
            let Some(end) = self.followed(&here.place, &stop(first, here), &stop(second, other)) else { continue };
            let mut all = (0..b.len()).filter(|&j| b[j].state == here.state && b[j].is_in(&end));
            if let (Some(j), None) = (all.next(), all.next()) {
                link.joined.push([i, j]);
            }
        }
        for &[i, j] in &link.joined {
            if Class::from(a[i].verdict) != Class::from(b[j].verdict) {
                let between = self.changed(first, &a[i], second)?;
                link.borders.push(Border { change: Change::Verdict, between, exactly: None, of: (0, i) });
            }
        }
        let last = a.iter().chain(b).map(|here| here.state).max();
        for state in 0..=last.unwrap_or(0) {
            let of_state = |all: &[Here]| -> Vec<usize> { (0..all.len()).filter(|&k| all[k].state == state).collect() };
            let alone = [(0, of_state(a)), (1, of_state(b))].map(|(side, all)| {
                all.into_iter().filter(|k| link.joined.iter().all(|pair| pair[side] != *k)).collect()
            });
            let [of_first, of_second]: [Vec<usize>; 2] = alone;
            let counts = [of_state(a).len(), of_state(b).len()];
            if counts[0] == counts[1] {
                link.lost += of_first.len() + of_second.len();
                continue;
            }
            if [first, second].iter().any(|node| matches!(node.place, NodeMotions::NoBodies | NodeMotions::TooFine)) {
                continue;
            }
            let (between, change) = self.counted(first, second, state, counts[0])?;
            let exactly = if change == Change::Fold { self.fold(state, between)? } else { None };
            let border = |side: usize| move |k: usize| Border { change, between, exactly, of: (side, k) };
            link.borders.extend(of_first.into_iter().map(border(0)));
            link.borders.extend(of_second.into_iter().map(border(1)));
        }
        Ok(link)
    }

    /// The two points, a bisected interval apart, between which the verdict on a motion changes.
    fn changed(&self, first: &Node, here: &Here, second: &Node) -> Result<[[f64; 2]; 2], NoMotor> {
        let class = Class::from(here.verdict);
        let mut low = (Stop { values: first.values, value: here.value.clone() }, here.place.clone());
        let mut high = second.values;
        for _ in 0..HALVINGS {
            let values = self.middle(low.0.values, high);
            let ground = self.region.ground(values[0])?;
            let Some(spot) = Spot::of(self.region, &ground, values) else { break };
            let held = spot.held();
            let Some((motions, _)) = held.get(here.state).and_then(|held| spot.motions(here.state, held)) else {
                break;
            };
            let Some(value) = motions.first().map(|raw| raw.value.clone()) else { break };
            let stop = Stop { values, value };
            let Some(place) = self.followed(&low.1, &low.0, &stop) else { break };
            let mut all = motions.iter().filter(|raw| raw.is_in(&place));
            let (Some(raw), None) = (all.next(), all.next()) else { break };
            match Class::from(spot.judged(raw).verdict) == class {
                true => low = (stop, raw.place.clone()),
                false => high = values,
            }
        }
        Ok([low.0.values, high])
    }

    /// The two points, a bisected interval apart, between which the number of motions with one steady state of the
    /// rotor changes.
    fn counted(
        &self,
        first: &Node,
        second: &Node,
        state: usize,
        number: usize,
    ) -> Result<([[f64; 2]; 2], Change), NoMotor> {
        let (mut low, mut high) = (first.values, second.values);
        let mut held = [first, second].map(|node| !matches!(node.place, NodeMotions::PulledOut));
        for _ in 0..HALVINGS {
            let values = self.middle(low, high);
            let ground = self.region.ground(values[0])?;
            let Some(spot) = Spot::of(self.region, &ground, values) else { break };
            let all = spot.held();
            let found: Option<Vec<Raw<'_>>> = match all.get(state) {
                None => Some(Vec::new()),
                Some(one) => spot.motions(state, one).map(|(motions, _)| motions),
            };
            let Some(found) = found else { break };
            let side = usize::from(found.len() != number);
            held[side] = state < all.len();
            *(if side == 0 { &mut low } else { &mut high }) = values;
        }
        Ok(([low, high], if held[0] == held[1] { Change::Fold } else { Change::PullOut }))
    }

    /// The value of w0 at which two motions merge, if there is exactly one between two points of a line over w0.
    fn fold(&self, state: usize, between: [[f64; 2]; 2]) -> Result<Option<f64>, NoMotor> {
        if self.moving == 0 || !self.region.data[1].is_speed() {
            return Ok(None);
        }
        let folds = match self.folds.get() {
            Some(folds) => folds,
            None => {
                let ground = self.region.ground(between[0][0])?;
                let spot = Spot::of(self.region, &ground, between[0]);
                let all = spot.and_then(|spot| Some(spot.folds(spot.held().get(state)?)));
                self.folds.get_or_init(|| all.flatten().unwrap_or_default())
            }
        };
        let [[_, a], [_, b]] = between;
        let mut inside = folds.iter().copied().filter(|w| (a.min(b)..=a.max(b)).contains(w));
        Ok(inside.next().filter(|_| inside.next().is_none()))
    }

    fn middle(&self, low: [f64; 2], high: [f64; 2]) -> [f64; 2] {
        std::array::from_fn(|k| if k == self.moving { 0.5 * (low[k] + high[k]) } else { low[k] })
    }
}

impl Here {
    fn is_in(&self, place: &steady_rotations::EnclosedPoint) -> bool {
        self.place.iter().zip(place).all(|(a, b)| !a.is_apart_from(b))
    }
}
