//! What a splitting does at every step between two, proved: a motor on its bench, at an angle that it keeps.
//!
//! There every piece rests, so that a step is the product M(h) of the pieces' matrices, whatever its length. Over an interval of
//! steps its entries are Taylor models in h. With s = (2/h)(z - 1)/(z + 1) for a multiplier z the unit disc is the left half-plane,
//! and Routh's chain counts, for all steps of the interval at once. Where the chain has a zero that is no threshold, what grows is told
//! by a multiplier beyond a line further out, and where it grows by much, by the size of a coefficient alone. Where a sign stays open
//! the interval is halved; what is open still at a part in a thousand million holds a threshold, or touches one, and stays open.

use super::motions::{Rotor, Stationed};
use super::pieces::{Matrix, Piece, Write};
use crate::scene::{Scene, System};
use field::Rational;
use integrators::Splitting;
use mechanics::first_approximation::{HalfPlanes, characteristic};
use symbolic::real::{Ordered, TaylorModel};

/// A motor at rest on its bench, ready to be composed.
#[derive(Clone, Debug)]
pub struct Resting {
    pieces: [Piece; 2],
    /// cos g, sin g
    angle: [TaylorModel; 2],
    /// Nothing takes energy: every piece is Hamilton's, and with a multiplier z there is 1/z.
    symmetric: bool,
}

/// All steps from one to another, s, with whether the map grows at each of them: `None` where that is open.
pub type Stretch = (f64, f64, Option<bool>);

/// What is proved of all steps between two.
#[derive(Clone, Debug, PartialEq)]
pub struct Proved {
    /// Neighbours.
    pub stretches: Vec<Stretch>,
    /// How many intervals were looked at.
    pub looked: usize,
}

/// Intervals, as shares of their steps, that are not halved any more.
const FINEST: f64 = 1e-9;
/// Intervals that are looked at in all: what is left then stays open.
const MOST: usize = 1_500;
/// Lines to the right of which a root is looked for, as shares of 1/h.
const FURTHER: [f64; 3] = [0.003, 0.03, 0.3];

impl Resting {
    /// Of a scene at a stationary motion; `None` in a gyrostat, whose pieces do not rest at its stationary motions, for motors
    /// whose flow is not known, and for those with another moment than one linear in the slip.
    pub fn of(scene: &Scene, motion: &Stationed) -> Option<Self> {
        let (System::Bench { axial }, Rotor::InStep { .. }) = (&scene.system, &motion.rotor) else { return None };
        let write = Write { data: &scene.machine_data, name: scene.machine.name(), axial: *axial };
        let (pieces, symmetric) = scene.machine.clone().apply(write)?;
        Some(Resting { pieces, angle: motion.at.angle.each_ref().map(TaylorModel::enclosed), symmetric })
    }

    /// Whether the map grows, for every step from one to another, s.
    pub fn course(&self, splitting: Splitting, [from, to]: [f64; 2]) -> Proved {
        let schedule: Vec<(usize, Rational)> =
            splitting.schedule::<f64>(2).into_iter().map(|(piece, share)| (piece, Rational::exactly(share))).collect();
        let known = |low: f64, high: f64| (low, high, self.grows(&schedule, [low, high]));
        let (mut all, mut looked) = (vec![known(from, to)], 1);
        // the widest first: what no halving settles must not cost the others their turn
        while looked < MOST {
            let open = |(low, high, grows): &Stretch| grows.is_none() && high - low > FINEST * low;
            let before = looked;
            let halved = all.iter().flat_map(|stretch| {
                let (low, high, _) = *stretch;
                let middle = (low * high).sqrt();
                if !open(stretch) || looked >= MOST {
                    return vec![*stretch];
                }
                looked += 2;
                vec![known(low, middle), known(middle, high)]
            });
            all = halved.collect();
            if looked == before {
                break;
            }
        }
        let mut stretches = Vec::<Stretch>::new();
        for (low, high, grows) in all {
            match stretches.last_mut() {
                Some((_, end, known)) if *known == grows => *end = high,
                _ => stretches.push((low, high, grows)),
            }
        }
        Proved { stretches, looked }
    }

    /// For all steps in an interval.
    fn grows(&self, schedule: &[(usize, Rational)], [low, high]: [f64; 2]) -> Option<bool> {
        let step = TaylorModel::over_range(low, high);
        let map = self.map(schedule, &step)?;
        if leaves(&characteristic(&map, &step)) {
            return Some(true);
        }
        let rate = |(i, row): (usize, &Vec<TaylorModel>)| -> Option<Vec<TaylorModel>> {
            let less = |(j, entry): (usize, &TaylorModel)| entry.minus(&step.integer(i64::from(i == j))).over(&step);
            row.iter().enumerate().map(less).collect()
        };
        let rates: Matrix = map.iter().enumerate().map(rate).collect::<Option<_>>()?;
        let mut plane = on_the_plane(&characteristic(&rates, &step), &step);
        if self.symmetric {
            // with s there is -s
            plane.iter_mut().rev().skip(1).step_by(2).for_each(|odd| *odd = step.integer(0));
        }
        match HalfPlanes::of(&plane) {
            Some(places) => Some(places.right > 0),
            None => FURTHER.iter().find_map(|share| {
                let line = TaylorModel::constant(share / high);
                HalfPlanes::of(&shifted(&plane, &line)).filter(|places| places.right > 0).map(|_| true)
            }),
        }
    }

    /// The matrix of a step.
    fn map(&self, schedule: &[(usize, Rational)], step: &TaylorModel) -> Option<Matrix> {
        // a composition that is its own mirror image has every flow twice
        let mut flows: Vec<(&(usize, Rational), Matrix)> = Vec::new();
        let mut whole: Option<Matrix> = None;
        for one in schedule {
            if flows.iter().all(|(other, _)| *other != one) {
                let (piece, share) = one;
                let length = step.times(&step.fraction(*share)?);
                flows.push((one, self.pieces[*piece].over(&self.angle, &length)?));
            }
            let (_, flow) = flows.iter().find(|(other, _)| *other == one)?;
            whole = Some(whole.map_or_else(|| flow.clone(), |before| product(flow, &before)));
        }
        whole
    }
}

/// Whether a coefficient of the polynomial of the multipliers is larger than any that are on the unit circle or inside could make.
fn leaves(polynomial: &[TaylorModel]) -> bool {
    let n = polynomial.len().saturating_sub(1) as i64;
    let mut choices = 1;
    (0..).zip(polynomial).any(|(k, c)| {
        let most = c.integer(choices);
        choices = choices * (n - k) / (k + 1);
        [*c, c.integer(0).minus(c)].iter().any(|c| c.minus(&most).sign() == Some(1))
    })
}

/// The polynomial in s = (2/h)(z - 1)/(z + 1) of one in w = (z - 1)/h, both with the highest power first: w = 2 s/(2 - h s).
fn on_the_plane(rates: &[TaylorModel], step: &TaylorModel) -> Vec<TaylorModel> {
    let n = rates.len().saturating_sub(1);
    let (zero, two) = (step.integer(0), step.integer(2));
    let mut sum = vec![zero; n + 1];
    for (k, rate) in rates.iter().rev().enumerate() {
        // rate (2 s)^k (2 - h s)^(n - k), the constant first
        let mut term = vec![zero; k];
        term.push((0..k).fold(*rate, |term, _| term.times(&two)));
        for _ in k..n {
            let doubled = term.iter().map(|c| c.times(&two)).chain([zero]);
            let turned = std::iter::once(zero).chain(term.iter().map(|c| c.times(step)));
            term = doubled.zip(turned).map(|(a, b)| a.minus(&b)).collect();
        }
        sum.iter_mut().rev().zip(&term).for_each(|(sum, c)| *sum = sum.plus(c));
    }
    sum
}

/// p(s + line), by Horner's rule again and again.
fn shifted(polynomial: &[TaylorModel], line: &TaylorModel) -> Vec<TaylorModel> {
    let mut shifted = polynomial.to_vec();
    for end in (1..shifted.len()).rev() {
        for k in 1..=end {
            shifted[k] = shifted[k].plus(&shifted[k - 1].times(line));
        }
    }
    shifted
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let entry = |row: &[TaylorModel], j: usize| {
        row.iter().zip(b).fold(TaylorModel::constant(0.0), |sum, (entry, other)| sum.plus(&entry.times(&other[j])))
    };
    a.iter().map(|row| (0..b.len()).map(|j| entry(row, j)).collect()).collect()
}

impl Proved {
    /// The steps at which that changes, s, each with the width of the interval in which it does so.
    pub fn edges(&self) -> Vec<(f64, f64)> {
        let between = self.stretches.windows(3).filter(|three| {
            matches!((three[0].2, three[1].2, three[2].2), (Some(before), None, Some(after)) if before != after)
        });
        between.map(|three| (0.5 * (three[1].0 + three[1].1), three[1].1 - three[1].0)).collect()
    }

    /// What is open but for its edges, s, from, to.
    pub fn open(&self) -> Vec<(f64, f64)> {
        let edges = self.edges();
        let open = self
            .stretches
            .iter()
            .filter(|(low, high, grows)| grows.is_none() && !edges.iter().any(|(at, _)| (low..=high).contains(&at)));
        open.map(|(low, high, _)| (*low, *high)).collect()
    }

    /// In words, after "the map"; edges that are not known to five digits are told from where to where.
    pub fn told(&self) -> String {
        let mut known = None;
        let mut told = String::new();
        for (low, high, grows) in &self.stretches {
            let narrow = high - low < SHARP * low;
            told += &match (grows, known) {
                (Some(grows), None) => format!("{}{}", if told.is_empty() { "" } else { ", then " }, does(*grows)),
                (Some(grows), Some(last)) if *grows != last => format!(", {} from h = {low:.4e} on", does(*grows)),
                (None, _) if !narrow => {
                    format!("{}is undecided from {low:.4e} to {high:.4e}", if told.is_empty() { "" } else { ", " })
                }
                (None, _) if self.open().contains(&(*low, *high)) => format!(", undecided at h = {low:.6e}"),
                _ => String::new(),
            };
            known = grows.or(known);
        }
        told
    }
}

/// What the map does.
pub(super) fn does(grows: bool) -> &'static str {
    if grows { "grows" } else { "does not grow" }
}

/// Edges known to this share are told by one number.
const SHARP: f64 = 3e-5;
