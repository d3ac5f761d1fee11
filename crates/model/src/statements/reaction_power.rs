//! The power of constraint reactions.
//!
//! The reaction J^T lambda has the power lambda J u. Along a motion f' = 0 for constraints of positions, and f = 0 for constraints of speeds. With
//!
//!   J u = n f' + w    or    J u = n f + w
//!
//! the power is lambda w. For a constraint linear in the speeds n = 1, and -w is the part of its rate without speeds.
//! For a constraint homogeneous of degree n in the speeds w = 0 (Euler's theorem). A stabilised (programmed) constraint is nonzero along a
//! motion: there n = 0, and w = J u. The law of a coordinate without inertia has no reaction: its multiplier is zero.

use crate::Trace;
use crate::equations::{Equation, Level, vanishes};
use crate::presentation::{is_sum, reading_of, simplified};
use field::Scalar as _;
use symbolic::Sym;

/// The decomposition J u = n f + w for one constraint.
pub(super) struct ReactionPower {
    /// J u, the power per unit of the multiplier.
    pub along: Sym,
    /// n f' or n f, which vanishes along every motion.
    pub idle: Sym,
    /// w; the constant zero if it vanishes identically.
    pub working: Sym,
}

/// The degrees of homogeneity that are tried, the usual one first.
const DEGREES: [i64; 5] = [1, 2, 0, 3, 4];

/// Longer expressions are not brought to normal form.
const MOST_SIMPLIFIED: usize = 300;

/// Longer expressions are not printed.
const MOST_WRITTEN: usize = 60;

impl ReactionPower {
    pub fn of(trace: &Trace<'_>, constraint: &Equation) -> Self {
        let along =
            constraint.row.iter().zip(&trace.speeds).fold(Sym::ZERO, |sum, (&slope, &speed)| sum + slope * speed);
        if constraint.law.is_some() {
            // the multiplier of such a law is zero
            return ReactionPower { along, idle: along, working: Sym::ZERO };
        }
        let by_speeds = constraint.row.iter().flat_map(|slope| slope.symbols_of());
        let is_linear =
            constraint.level == Level::Position || !by_speeds.into_iter().any(|one| trace.speeds.contains(&one));
        let at_rest = || {
            let rest: Vec<(Sym, Sym)> = trace.speeds.iter().map(|&speed| (speed, Sym::ZERO)).collect();
            -constraint.rate.substitute(&rest)
        };
        let split = |degree: i64| {
            let idle = Sym::int(degree) * constraint.rate;
            let working = if is_linear && degree == 1 { at_rest() } else { along - idle };
            ReactionPower { along, idle, working: in_short(working) }
        };
        let splits: Vec<ReactionPower> = match (&constraint.gains, is_linear) {
            (Some(_), _) => vec![split(0)],
            (None, true) => vec![split(1)],
            (None, false) => DEGREES.map(split).into(),
        };
        let size = |one: &ReactionPower| if one.is_zero() { 0 } else { 1 + Sym::operations_of(&[one.working]) };
        let splits = splits.into_iter().map(|one| ReactionPower { working: or_zero(one.working), ..one });
        splits.min_by_key(size).unwrap_or(ReactionPower { along, idle: Sym::ZERO, working: along })
    }

    /// Returns whether the power vanishes along every motion.
    pub fn is_zero(&self) -> bool {
        self.working == Sym::ZERO
    }

    /// Returns lambda w for printing, with the number of the constraint; `None` if the expression is long.
    pub fn written(&self, trace: &Trace<'_>, place: usize) -> Option<String> {
        let letter = multiplier(trace, place);
        if Sym::operations_of(&[self.working]) > MOST_WRITTEN {
            return None;
        }
        let factor = reading_of(trace).of(self.working).decimal_text();
        Some(match (factor.as_str(), factor.strip_prefix('-')) {
            ("1", _) => letter,
            ("-1", _) => format!("-{letter}"),
            (sum, _) if is_sum(sum) => format!("{letter}*({factor})"),
            _ if factor.trim_start_matches('-').starts_with(|digit: char| digit.is_ascii_digit()) => {
                format!("{factor}*{letter}")
            }
            (_, Some(size)) => format!("-{letter}*{size}"),
            _ => format!("{letter}*{factor}"),
        })
    }
}

/// Returns the printed name of a multiplier: `lambda1`, or `multiplier1` if the system uses names such as `lambda1`.
pub(super) fn multiplier(trace: &Trace<'_>, place: usize) -> String {
    let names = trace.parameters.iter().chain(&trace.coordinates).map(Sym::to_string);
    let names = names.chain(trace.model.inputs.iter().map(|input| input.name.clone()));
    let mut numbers = names.filter_map(|name| name.strip_prefix("lambda").map(str::to_owned));
    let is_taken = numbers.any(|number| !number.is_empty() && number.chars().all(|digit| digit.is_ascii_digit()));
    format!("{}{}", if is_taken { "multiplier" } else { "lambda" }, place + 1)
}

fn in_short(expression: Sym) -> Sym {
    if Sym::operations_of(&[expression]) > MOST_SIMPLIFIED { expression } else { simplified(expression) }
}

/// Returns the constant zero for an expression that vanishes identically.
pub(super) fn or_zero(expression: Sym) -> Sym {
    if vanishes(expression) { Sym::ZERO } else { expression }
}

/// Returns the sum of the powers of all reactions for printing; `None` if one of them is long.
pub(super) fn sum_written(trace: &Trace<'_>, powers: &[ReactionPower]) -> Option<String> {
    let mut sum = String::new();
    for (place, power) in powers.iter().enumerate().filter(|(_, power)| !power.is_zero()) {
        let written = power.written(trace, place)?;
        sum = match (sum.is_empty(), written.strip_prefix('-')) {
            (true, _) => written,
            (false, Some(size)) => format!("{sum} - {size}"),
            (false, None) => format!("{sum} + {written}"),
        };
    }
    Some(sum)
}
