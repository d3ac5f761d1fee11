//! Time intervals in which functions of the time alone change rapidly, so that no step misses them.
//!
//! Each function is enclosed by interval arithmetic over the whole run, and over halves of wide cells, until it changes
//! within each cell by at most a fraction of its range: the lengths of the cells are its time scale. Enclosures contain
//! all values, hence no pulse is missed however short. A function that oscillates throughout has equal cells and gives
//! no bound: error estimates detect it.

use crate::law::program::Program;
use field::Interval;
use integrators::{FastInterval, StepBounds};
use std::cmp::Ordering;
use std::collections::BinaryHeap;
use std::sync::{Arc, Mutex, PoisonError};
use symbolic::Tape;

/// The fraction of a function's range by which it may change within a cell.
const PART: f64 = 0.25;

/// The largest number of functions, and of enclosures of each.
const MOST_FUNCTIONS: usize = 24;
const MOST_ENCLOSURES: usize = 6_000;

/// The largest number of halvings of a cell.
const MOST_HALVINGS: u32 = 40;

/// The largest number of halvings of a cell at whose ends the function is undefined.
const LOOKED_FOR_VALUES: u32 = 6;

/// At this number of cells the function is checked: if cells that cover half of the run are short, it oscillates
/// throughout.
const LOOKED_AT: usize = 64;

/// A cell is short if it is at most this fraction of the run.
const SHORT: f64 = 1.0 / 32.0;

/// The steps of a method need a bound for short cells only if the function was quiet before: no cell as short lies
/// within this many of its lengths before it, nor all the way from the start.
const QUIET: f64 = 24.0;
const QUIET_AT_START: f64 = 8.0;

/// The distance in cell lengths over which steps are bounded, and the largest step there.
const BOUNDED: f64 = 16.0;
const LONGEST: f64 = 2.0;

/// A run shorter than this fraction of its time is not examined: rounding of the time would appear as changes.
const LEAST_WAY: f64 = 1e-7;

/// The functions of the time alone in a program, and the bounds found so far.
#[derive(Debug)]
pub struct TimeScales {
    functions: Vec<Tape>,
    known: Mutex<Option<Known>>,
}

/// The time interval of a run, with the bounds found on it.
#[derive(Debug)]
struct Known {
    from: f64,
    to: f64,
    found: Arc<[FastInterval]>,
}

impl TimeScales {
    /// The functions of a program; `None` if it depends on the time through linear functions only.
    pub fn of(program: &Program) -> Option<Self> {
        let mut functions = program.parts_of_time();
        functions.truncate(MOST_FUNCTIONS);
        (!functions.is_empty()).then(|| TimeScales { functions, known: Mutex::new(None) })
    }

    /// The bounds of the step size for a run from one time to another (s).
    pub fn bounds(&self, from: f64, to: f64) -> StepBounds {
        if (to - from).abs() <= LEAST_WAY * from.abs().max(to.abs()) {
            return StepBounds::default();
        }
        let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        let holds = |known: &&Known| {
            let way = (known.to - known.from).signum();
            (to - from) * way > 0.0 && (from - known.from) * way >= 0.0 && (known.to - to) * way >= 0.0
        };
        let found = match known.as_ref().filter(holds) {
            Some(known) => Arc::clone(&known.found),
            None => {
                let all = self.functions.iter().flat_map(|function| hastes(function, from, to));
                let found: Arc<[FastInterval]> = all.collect();
                *known = Some(Known { from, to, found: Arc::clone(&found) });
                found
            }
        };
        StepBounds::of(from, to, &found)
    }
}

/// A part of a run, whose time is scaled to the interval from 0 to 1, with the range of the function.
#[derive(Clone, Copy, Debug)]
struct Cell {
    begin: f64,
    halvings: u32,
    width: f64,
    /// The values of the function at both ends.
    ends: [f64; 2],
}

impl Cell {
    fn length(&self) -> f64 {
        (-f64::from(self.halvings)).exp2()
    }
}

impl PartialEq for Cell {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Cell {}

impl PartialOrd for Cell {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// Orders cells by width, then by length, for a priority queue.
impl Ord for Cell {
    fn cmp(&self, other: &Self) -> Ordering {
        self.width
            .total_cmp(&other.width)
            .then(other.halvings.cmp(&self.halvings))
            .then(other.begin.total_cmp(&self.begin))
    }
}

/// The time intervals in which a function changes rapidly.
fn hastes(function: &Tape, from: f64, to: f64) -> Vec<FastInterval> {
    let at = |part: f64| from + (to - from) * part;
    let cells = cells(|a, b| function.range_over_last_input(Interval::new(at(a), at(b))));
    let length = (to - from).abs();
    let bounded = |(begin, end, scale): (f64, f64, f64)| FastInterval {
        from: at(begin),
        to: at(end.min(begin + BOUNDED * scale)),
        step: LONGEST * scale * length,
    };
    stretches(&cells).into_iter().map(bounded).collect()
}

/// The cells of a function on the interval from 0 to 1, in order; none for a function that oscillates throughout.
fn cells(range: impl Fn(f64, f64) -> Interval) -> Vec<Cell> {
    let value =
        |at: f64| Some(range(at, at)).filter(|value| value.size().is_finite()).map_or(f64::NAN, Interval::middle);
    let cell = |begin: f64, halvings: u32, ends: [f64; 2]| {
        let mut cell = Cell { begin, halvings, width: 0.0, ends };
        let over = range(begin, begin + cell.length());
        // an exponential may overflow on a part of the interval where a condition selects another formula
        let has_no_value = halvings >= LOOKED_FOR_VALUES && ends.iter().all(|end| end.is_nan());
        // a cell at the largest number of halvings contains a jump or an undefined value
        cell.width = if halvings < MOST_HALVINGS && !has_no_value { over.width() } else { 0.0 };
        cell
    };
    let first = [value(0.0), value(1.0)];
    let mut spread = first.iter().filter(|value| !value.is_nan()).fold(None, wider);
    let mut open = BinaryHeap::from([cell(0.0, 0, first)]);
    let mut enclosures = 1;
    while let Some(widest) = open.peek().copied() {
        let whole = spread.map_or(0.0, |[least, most]: [f64; 2]| most - least);
        let rounding = f64::EPSILON.sqrt() * spread.map_or(0.0, |[least, most]| least.abs().max(most.abs()));
        if widest.width <= PART * whole || widest.width <= rounding || enclosures >= MOST_ENCLOSURES {
            break;
        }
        if open.len() == LOOKED_AT {
            let changes = |cell: &&Cell| (cell.ends[1] - cell.ends[0]).abs() >= 0.5 * PART * whole;
            if open.iter().filter(changes).map(Cell::length).sum::<f64>() > 0.5 {
                return Vec::new();
            }
        }
        open.pop();
        let halvings = widest.halvings + 1;
        let middle = widest.begin + 0.5 * widest.length();
        let between = value(middle);
        spread = Some(between).iter().filter(|value| !value.is_nan()).fold(spread, wider);
        open.push(cell(widest.begin, halvings, [widest.ends[0], between]));
        open.push(cell(middle, halvings, [between, widest.ends[1]]));
        enclosures += 2;
    }
    let mut cells = open.into_vec();
    cells.sort_by(|a, b| a.begin.total_cmp(&b.begin));
    cells
}

fn wider(spread: Option<[f64; 2]>, value: &f64) -> Option<[f64; 2]> {
    Some(spread.map_or([*value; 2], |[least, most]| [least.min(*value), most.max(*value)]))
}

/// Where cells of some length begin after an interval without such cells, where they end, and their length.
fn stretches(cells: &[Cell]) -> Vec<(f64, f64, f64)> {
    let mut levels: Vec<u32> = cells.iter().map(|cell| cell.halvings).collect();
    levels.sort_unstable();
    levels.dedup();
    let mut found = Vec::new();
    for level in levels {
        let scale = (-f64::from(level)).exp2();
        if scale > SHORT {
            continue;
        }
        let mut own: Vec<[f64; 2]> = Vec::new();
        for cell in cells.iter().filter(|cell| cell.halvings >= level) {
            let end = cell.begin + cell.length();
            match own.last_mut() {
                Some([_, last]) if cell.begin - *last < QUIET * scale => *last = end,
                _ => own.push([cell.begin, end]),
            }
        }
        let is_met = |[begin, _]: &[f64; 2]| *begin >= QUIET_AT_START * scale;
        found.extend(own.into_iter().filter(is_met).map(|[begin, end]| (begin, end, scale)));
    }
    found
}

#[cfg(test)]
mod tests {
    use super::TimeScales;
    use crate::law::program::Program;
    use field::{Analytic, Elementary, Scalar};
    use integrators::StepBounds;
    use symbolic::Sym;

    fn scales(function: impl FnOnce(Sym) -> Sym + Send) -> Option<TimeScales> {
        TimeScales::of(&Program::of(1, |t, y| vec![function(t) - y[0]]).expect("it has values"))
    }

    fn bell(t: Sym, about: Sym, width: Sym) -> Sym {
        (-((t - about) / width).squared()).elementary(Elementary::Exp, t)
    }

    #[test]
    fn a_pulse_of_any_width_bounds_the_steps_that_come_to_it() {
        for digits in 1..=6 {
            let width = 10.0_f64.powi(-digits);
            let scales = scales(|t| bell(t, Sym::ratio(33, 10), Sym::ratio(1, 10_i64.pow(digits as u32))));
            let bounds = scales.expect("a function of time").bounds(0.0, 10.0);
            for from in [0.0, 1.0, 3.0] {
                assert!(from + bounds.longest(from, 10.0) < 3.3, "{width} {from}");
            }
            assert!(bounds.longest(3.3, 10.0) <= 2.0 * width && bounds.longest(5.0, 5.0) == 5.0, "{width} {bounds:?}");
            let back = scales_back(digits);
            assert!(back < 6.7 + 8.0 * width, "{width} {back}");
        }
    }

    fn scales_back(digits: i32) -> f64 {
        let scales = scales(|t| bell(t, Sym::ratio(33, 10), Sym::ratio(1, 10_i64.pow(digits as u32))));
        scales.expect("a function of time").bounds(10.0, 0.0).longest(0.0, 10.0)
    }

    #[test]
    fn what_swings_or_grows_all_the_time_bounds_nothing() {
        let swings = scales(|t| (Sym::int(40) * t).circle().cos).expect("a function of time");
        let fast = scales(|t| (Sym::int(4_000) * t).circle().sin).expect("a function of time");
        let grows = scales(|t| t * t * t).expect("a function of time");
        for one in [swings, fast, grows] {
            let both = [one.bounds(0.0, 10.0), one.bounds(10.0, 0.0)];
            assert!(both.iter().all(StepBounds::is_empty), "{both:?}");
        }
        assert!(scales(|t| Sym::int(3) * t).is_none());
    }

    #[test]
    fn each_pulse_of_a_train_and_a_front_are_found() {
        // sin(t)^256 has pulses of width 0.1 at odd multiples of pi/2
        let train = scales(|t| (0..8).fold(t.circle().sin, |power, _| power.squared())).expect("a function of time");
        let bounds = train.bounds(0.0, 100.0);
        for pulse in 0..31 {
            let about = std::f64::consts::PI * (f64::from(pulse) + 0.5);
            assert!(bounds.longest(about - 1.0, 5.0) < 1.1, "{about}");
            assert!(bounds.longest(about - 0.05, 5.0) < 0.3, "{about}");
        }
        let waves = scales(|t| (-Sym::int(400) * t.circle().sin.squared()).elementary(Elementary::Exp, t));
        let bounds = waves.expect("a function of time").bounds(0.0, 10.0);
        for pulse in 1..=3 {
            let about = std::f64::consts::PI * f64::from(pulse);
            assert!(bounds.longest(about - 1.0, 5.0) < 1.0 && bounds.longest(about, 5.0) < 0.1, "{about} {bounds:?}");
        }
        let front = scales(|t| (Sym::int(1_000) * (t - Sym::int(7))).elementary(Elementary::Tanh, t));
        let bounds = front.expect("a function of time").bounds(0.0, 10.0);
        assert!(bounds.longest(0.0, 10.0) < 7.0 && bounds.longest(7.0, 3.0) < 4e-3);
    }

    /// exp(u)/(1 + exp(2 u)) is a pulse at u = 0; its evaluation overflows for u > 709.
    #[test]
    fn a_pulse_before_a_part_without_values_is_found() {
        let pulse = |t: Sym| {
            let grows =
                |times: i64| (Sym::int(1_000 * times) * (t - Sym::ratio(33, 10))).elementary(Elementary::Exp, t);
            grows(1) / (Sym::int(1) + grows(2))
        };
        let bounds = scales(pulse).expect("a function of time").bounds(0.0, 10.0);
        assert!(bounds.longest(0.0, 10.0) < 3.3 && bounds.longest(3.3, 1.0) < 4e-3, "{bounds:?}");
    }

    #[test]
    fn a_part_of_a_way_that_is_known_has_its_bounds() {
        let scales = scales(|t| bell(t, Sym::int(5), Sym::ratio(1, 100))).expect("a function of time");
        let whole = scales.bounds(0.0, 10.0);
        let rest = scales.bounds(2.0, 10.0);
        assert!((whole.longest(2.0, 8.0) - rest.longest(0.0, 8.0)).abs() < 1e-12);
    }
}
