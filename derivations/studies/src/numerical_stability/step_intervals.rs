//! Proved stability of a splitting for all step sizes of an interval, by bisection.
//!
//! An interval of step sizes is examined as a whole, and bisected where the result is undecided. A narrow undecided
//! interval contains a threshold, or is adjacent to one.

/// An interval of step sizes, s, and whether the one-step map is unstable for all of them: `None` if undecided.
pub type StepRange = (f64, f64, Option<bool>);

/// The proved verdicts for all step sizes of an interval.
#[derive(Clone, Debug, PartialEq)]
pub struct Proved {
    /// Adjacent intervals with their verdicts.
    pub stretches: Vec<StepRange>,
    /// The intervals in which no fixed point of the splitting could be enclosed.
    pub lost: Vec<(f64, f64)>,
    /// Single step sizes, s, within undecided intervals, and whether the map is unstable there.
    pub alone: Vec<(f64, bool)>,
    /// The number of intervals that were examined.
    pub looked: usize,
}

/// The verdict for all step sizes of an interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Found {
    Grows(bool),
    /// A sign is undecided.
    Open,
    /// No fixed point of the splitting is enclosed.
    Lost,
}

/// The limits of bisection.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    /// The smallest relative width of intervals with an undecided sign.
    pub sign: f64,
    /// The smallest relative width of intervals without an enclosed fixed point.
    pub motion: f64,
    /// The largest number of intervals that are examined; the rest stays undecided.
    pub most: usize,
}

/// Thresholds known to this relative width are displayed as one number.
const SHARP: f64 = 3e-5;

impl Proved {
    /// The verdicts by bisection, with `look` as the verdict on an interval.
    pub(super) fn by(look: impl Fn([f64; 2]) -> Found, [from, to]: [f64; 2], limits: Limits) -> Self {
        let known = |low: f64, high: f64| (low, high, look([low, high]));
        let (mut all, mut looked) = (vec![known(from, to)], 1);
        // level by level: an interval that no bisection decides must not use up the budget of the others
        while looked < limits.most {
            let open = |low: f64, high: f64, found: Found| match found {
                Found::Grows(_) => false,
                Found::Open => high - low > limits.sign * low,
                Found::Lost => high - low > limits.motion * low,
            };
            let before = looked;
            let halved = all.iter().flat_map(|&(low, high, found)| {
                let middle = (low * high).sqrt();
                if !open(low, high, found) || looked >= limits.most {
                    return vec![(low, high, found)];
                }
                looked += 2;
                vec![known(low, middle), known(middle, high)]
            });
            all = halved.collect();
            if looked == before {
                break;
            }
        }
        let mut merged = Vec::<(f64, f64, Found)>::new();
        for (low, high, found) in all {
            match merged.last_mut() {
                Some((_, end, known)) if *known == found => *end = high,
                _ => merged.push((low, high, found)),
            }
        }
        let grows = |found: Found| if let Found::Grows(grows) = found { Some(grows) } else { None };
        Proved {
            lost: merged
                .iter()
                .filter(|(.., found)| *found == Found::Lost)
                .map(|(low, high, _)| (*low, *high))
                .collect(),
            alone: Vec::new(),
            stretches: merged.into_iter().map(|(low, high, found)| (low, high, grows(found))).collect(),
            looked,
        }
    }

    /// Whether the map is unstable at a step size, s.
    pub fn at(&self, step: f64) -> Option<bool> {
        let single = self.alone.iter().find(|(at, _)| *at == step).map(|(_, grows)| *grows);
        let stretch = self.stretches.iter().find(|(low, high, _)| (*low..=*high).contains(&step));
        single.or(stretch.and_then(|(.., grows)| *grows))
    }

    /// The thresholds, s, at which stability changes, each with the width of its enclosing interval.
    pub fn edges(&self) -> Vec<(f64, f64)> {
        let between = self.stretches.windows(3).filter(|three| {
            let changes =
                matches!((three[0].2, three[1].2, three[2].2), (Some(before), None, Some(after)) if before != after);
            changes && three[1].1 - three[1].0 < SHARP * three[1].0
        });
        between.map(|three| (0.5 * (three[1].0 + three[1].1), three[1].1 - three[1].0)).collect()
    }

    /// The undecided intervals, s, without those that enclose thresholds.
    pub fn open(&self) -> Vec<[f64; 2]> {
        let edges = self.edges();
        let open = self
            .stretches
            .iter()
            .filter(|(low, high, grows)| grows.is_none() && !edges.iter().any(|(at, _)| (low..=high).contains(&at)));
        open.map(|(low, high, _)| [*low, *high]).collect()
    }

    /// The verdicts in words, to follow "the map".
    pub fn told(&self) -> String {
        let mut known = None;
        let mut told = Vec::new();
        for (low, high, grows) in &self.stretches {
            let narrow = high - low < SHARP * low;
            match (grows, known) {
                (Some(grows), Some(last)) if *grows == last => {}
                (Some(grows), Some(_)) => told.push(format!("{} from h = {low:.4e} on", does(*grows))),
                (Some(grows), None) if told.is_empty() => told.push(does(*grows).to_owned()),
                (Some(grows), None) => told.push(format!("then {}", does(*grows))),
                (None, _) if self.lost.contains(&(*low, *high)) => {
                    told.push(format!("has no enclosed motion of its own from {low:.4e} to {high:.4e}"));
                }
                (None, _) if !narrow => told.push(format!("is undecided from {low:.4e} to {high:.4e}")),
                (None, _) if self.open().contains(&[*low, *high]) => told.push(format!("undecided at h = {low:.6e}")),
                (None, _) => {}
            }
            known = grows.or(known);
        }
        told.join(", ")
    }
}

/// The words for a verdict.
pub(super) fn does(grows: bool) -> &'static str {
    if grows { "grows" } else { "does not grow" }
}
