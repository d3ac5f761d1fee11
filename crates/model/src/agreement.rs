//! Agreement of principles: decides whether two principles give the same equations of motion. The residuals, which are linear in the accelerations, are compared
//! directly.

use crate::divisors::named;
use crate::equations::constraints_of;
use crate::principles::{NotApplicable, Principle, Projection, linear};
use crate::real_points::{equal_digits, value_at_start};
use crate::theorem;
use crate::{Trace, Work};
use std::fmt;
use symbolic::{Decision, Hypotheses, Identity, IdentityTest, Sym, decide, identified};

/// The degree to which the agreement of two sides is certain.
#[derive(Clone, Debug, PartialEq)]
pub enum Agreement {
    /// The normal form of every difference is zero, hence both sides are equal for all values for which no divisor vanishes. `at_start` lists
    /// the divisors that vanish at the start of the model; `None` if it has no start.
    Proved { divisors: Vec<String>, at_start: Option<Vec<String>> },
    /// The theorem on principles holds for the model, and every difference vanishes at random points of prime fields. The formed equations
    /// are those of the theorem, with a probability of error of at most 2^`error`.
    Theorem { points: usize, error: f64 },
    /// Every difference vanishes at random points of prime fields, with a probability of error of at most 2^`error`.
    Identified { points: usize, error: f64 },
    /// Both sides have equal values at real points, up to the given number of digits.
    Tested { points: usize, digits: f64 },
    /// The difference of equation `equation` (counted from 0) is not zero at the given point.
    Refuted { equation: usize, point: String },
    /// The agreement was not decided; the text gives the reason.
    Undecided { equation: usize, reason: String },
}

impl Agreement {
    /// Returns the degree as one word.
    pub fn degree(&self) -> &'static str {
        match self {
            Self::Proved { .. } | Self::Theorem { .. } => "proved",
            Self::Identified { .. } => "identified",
            Self::Tested { .. } => "tested",
            Self::Refuted { .. } => "refuted",
            Self::Undecided { .. } => "undecided",
        }
    }
}

impl Agreement {
    /// Returns the result as a sentence that refers to an earlier line, with the title `line`, instead of repeating its list of divisors.
    pub fn said_behind(&self, line: &str) -> String {
        match self {
            Self::Proved { divisors, at_start } if !divisors.is_empty() => {
                let values = "proved by normal form: equal for all values for which none of the divisors of";
                format!("{values} `{line}` vanishes{}", of_start(at_start.as_deref()))
            }
            _ => self.to_string(),
        }
    }
}

/// Returns the divisors that vanish at the start, in parentheses.
fn of_start(vanishing: Option<&[String]>) -> String {
    match vanishing {
        None => String::new(),
        Some([]) => " (true at the start)".to_owned(),
        Some(vanishing) => format!(" (at the start {} vanishes)", vanishing.join(" and ")),
    }
}

impl fmt::Display for Agreement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Proved { divisors, .. } if divisors.is_empty() => {
                write!(f, "proved by normal form: equal for all values of all letters")
            }
            Self::Proved { divisors, at_start } => write!(
                f,
                "proved by normal form: equal for all values for which none of these vanishes: {}{}",
                divisors.join("; "),
                of_start(at_start.as_deref())
            ),
            Self::Theorem { points, error } => write!(
                f,
                "proved by the theorem on principles: equal for any masses, inertias and forces; these equations are equal at {points} random \
                 points modulo large random primes (probability of error below 2^{:.0})",
                error.ceil()
            ),
            Self::Identified { points, error } => write!(
                f,
                "identified: equal at {points} random points modulo large random primes; the probability of error is below 2^{:.0}",
                error.ceil()
            ),
            Self::Tested { points, digits } => {
                write!(f, "tested: equal to {:.0} digits at {points} real points; nothing is proved", digits.floor())
            }
            Self::Refuted { equation, point } => {
                write!(f, "refuted in equation {}: the difference is {point}", equation + 1)
            }
            Self::Undecided { equation, reason } => write!(f, "undecided in equation {}: {reason}", equation + 1),
        }
    }
}

/// Longer expressions, in operations, are tested at random points, since their normal forms may become very large.
const MOST_EXPANDED: usize = 4_000;

/// The corresponding limit if the theorem on principles states the equality.
const MOST_BESIDE_THEOREM: usize = 1_200;

/// The corresponding limit for quotients by determinants.
const MOST_OF_QUOTIENTS: usize = 300;

/// Compares the residuals of two principles. Equations too long for normal forms are compared by the theorem on principles together with a test at
/// random points, since the theorem does not cover the code that forms the equations.
///
/// # Errors
/// One of the principles does not apply to the model.
pub fn agreement(trace: &Trace<'_>, one: Principle, other: Principle) -> Result<Agreement, NotApplicable> {
    let (of_one, of_other) = (one.residual(trace)?, other.residual(trace)?);
    let pairs: Vec<(Sym, Sym)> = of_one.into_iter().zip(of_other).collect();
    let subject = format!("{} = {}", one.name(), other.name());
    let holds = || theorem::holds(trace, one) && theorem::holds(trace, other);
    Ok(with_theorem(trace, &subject, &pairs, MOST_BESIDE_THEOREM, holds))
}

/// Compares pairs of residuals. `holds` decides whether the theorem on principles states their equality; long residuals then need no normal form.
fn with_theorem(
    trace: &Trace<'_>,
    subject: &str,
    pairs: &[(Sym, Sym)],
    most: usize,
    holds: impl Fn() -> bool,
) -> Agreement {
    let differences: Vec<Sym> = pairs.iter().map(|&(one, other)| one - other).collect();
    let is_long = Sym::operations_of(&differences) > most;
    let most = if is_long && holds() { most } else { MOST_EXPANDED };
    match up_to(trace, subject, pairs, most) {
        Agreement::Identified { points, error } if holds() => Agreement::Theorem { points, error },
        decided => decided,
    }
}

/// The agreement of a projection, which builds the constraints in, with Lagrange's equations, and the points at which it was decided.
#[derive(Clone, Debug, PartialEq)]
pub struct Projected {
    pub agreement: Agreement,
    /// A description of the points.
    pub points: String,
}

/// Compares a projection with Lagrange's equations of the first kind after elimination of the multipliers.
///
/// # Errors
/// The projection does not apply to the model, or the model has no constraints.
pub fn projected_agreement(trace: &Trace<'_>, projection: Projection) -> Result<Projected, NotApplicable> {
    let constraints = constraints_of(trace);
    if constraints.is_empty() {
        return Err(NotApplicable("without constraints its equations are those of lagrange".to_owned()));
    }
    let characteristics = trace.characteristics();
    let named = |places: &mut dyn Iterator<Item = usize>| {
        places.map(|place| trace.speeds[place].to_string()).collect::<Vec<_>>().join(", ")
    };
    let dependent = named(&mut characteristics.dependent.iter().map(|&(place, _)| place));
    let independent = named(&mut characteristics.independent.iter().copied());
    let subject = format!("{} = {}", Principle::Lagrange.name(), projection.name());
    match projection {
        Projection::Maggi => {
            // symbols replace inertia minus forces, hence the result holds for any system with these constraints
            let any: Vec<Sym> = (0..trace.speeds.len()).map(|i| Sym::symbol(&format!("residual {}", i + 1))).collect();
            let (by_maggi, by_multipliers) = (characteristics.along(&any), characteristics.without_reactions(&any));
            let pairs: Vec<(Sym, Sym)> = by_multipliers.into_iter().zip(by_maggi).collect();
            let agreement = with_theorem(trace, &subject, &pairs, MOST_OF_QUOTIENTS, theorem::holds_for_any_rows);
            let points = format!(
                "for any inertia and any forces: multipliers drop out along du/dw, with {dependent} by {}",
                or_nothing(&independent)
            );
            Ok(Projected { agreement, points })
        }
        Projection::Shulgin => {
            let by_shulgin = projection.residual(trace, &constraints, characteristics)?;
            let by_multipliers = characteristics.without_reactions(&Principle::Lagrange.residual(trace)?);
            let motion = linear(&constraints, characteristics.motion(trace, &constraints))?;
            let by_multipliers = motion.on_constraints(&by_multipliers);
            // a variable mass may depend on dependent speeds
            let by_shulgin = motion.on_constraints(&trace.with_masses(&by_shulgin));
            let pairs: Vec<(Sym, Sym)> = by_multipliers.into_iter().zip(by_shulgin).collect();
            let agreement =
                with_theorem(trace, &subject, &pairs, MOST_BESIDE_THEOREM, || theorem::holds_on_constraints(trace));
            let points = format!(
                "at points on the constraints: all letters and {} are free, {dependent} and their rates follow",
                or_nothing(&independent)
            );
            Ok(Projected { agreement, points })
        }
    }
}

fn or_nothing(names: &str) -> &str {
    if names.is_empty() { "no speed" } else { names }
}

/// Decides whether both sides of every pair are equal, with variable masses replaced by their expressions. Uses the strongest method that
/// succeeds.
pub(crate) fn decided(trace: &Trace<'_>, subject: &str, pairs: &[(Sym, Sym)]) -> Agreement {
    up_to(trace, subject, pairs, MOST_EXPANDED)
}

/// Decides with normal forms of differences of up to `most` operations.
fn up_to(trace: &Trace<'_>, subject: &str, pairs: &[(Sym, Sym)], most: usize) -> Agreement {
    let (ones, others): (Vec<Sym>, Vec<Sym>) = pairs.iter().copied().unzip();
    let (ones, others) = (trace.with_masses(&ones), trace.with_masses(&others));
    let pairs: Vec<(Sym, Sym)> = ones.into_iter().zip(others).collect();
    let announce = |test: &IdentityTest| {
        let (operations, points, degree) = (test.operations(), test.points(), test.degree());
        let by_normal_form = points.is_none() || operations <= most;
        trace.announce(&Work { subject: subject.to_owned(), operations, points, degree, by_normal_form });
    };
    compared(&pairs, most, announce, |divisor| value_at_start(trace, divisor), |divisor| named(trace, divisor))
}

/// Divisors with smaller absolute values count as zero at the start.
const VANISHES: f64 = 1e-12;

/// Decides whether both sides of every pair are equal. `value_at_start` and `named` give the value at the start and the name of a divisor that may vanish.
fn compared(
    pairs: &[(Sym, Sym)],
    most: usize,
    announce: impl Fn(&IdentityTest),
    value_at_start: impl Fn(Sym) -> Option<f64>,
    named: impl Fn(Sym) -> Option<String>,
) -> Agreement {
    let differences: Vec<Sym> = pairs.iter().map(|&(one, other)| one - other).collect();
    let test = IdentityTest::of(&differences);
    announce(&test);
    let identity = test.outcome();
    if let (Identity::Identified { points, error, .. }, true) = (&identity, test.operations() > most) {
        return Agreement::Identified { points: *points, error: *error };
    }
    if identity == Identity::NotZero {
        // the normal form of a long difference would only cost time
        let fails = |difference: &Sym| identified(&[*difference]) == Identity::NotZero;
        let first = differences.iter().position(fails);
        let is_long = |place: &usize| Sym::operations_of(&[differences[*place]]) > MOST_EXPANDED;
        if let Some(equation) = first.filter(is_long) {
            return Agreement::Refuted { equation, point: "not zero at a random point of a prime field".to_owned() };
        }
    }
    let mut divisors: Vec<Sym> = Vec::new();
    for (equation, difference) in differences.into_iter().enumerate() {
        let reason = match (decide(difference, &Hypotheses::none()), &identity) {
            (Decision::Zero(proof), _) => {
                for divisor in proof.requires {
                    if divisors.iter().all(|known| known.to_string() != divisor.to_string()) {
                        divisors.push(divisor);
                    }
                }
                continue;
            }
            (Decision::NonZero(witness), _) => {
                return Agreement::Refuted { equation, point: witness.to_string() };
            }
            (_, Identity::Identified { points, error, .. }) => {
                return Agreement::Identified { points: *points, error: *error };
            }
            (Decision::Undefined(divisor), _) => format!("the divisor {divisor} vanishes everywhere"),
            (Decision::GaveUp(reason), _) => reason,
        };
        return match equal_digits(pairs) {
            Some((points, digits)) => Agreement::Tested { points, digits },
            None => Agreement::Undecided { equation, reason },
        };
    }
    let (divisors, names): (Vec<Sym>, Vec<String>) =
        divisors.into_iter().filter_map(|divisor| Some((divisor, named(divisor)?))).unzip();
    let values: Option<Vec<f64>> = divisors.iter().map(|divisor| value_at_start(*divisor)).collect();
    let vanishing = |values: Vec<f64>| {
        let vanishing = names.iter().zip(values).filter(|(_, value)| value.abs() <= VANISHES);
        without_repeats(vanishing.map(|(name, _)| name.clone()).collect())
    };
    let at_start = values.map(vanishing);
    Agreement::Proved { divisors: without_repeats(names), at_start }
}

/// Removes repeated names, in the given order.
fn without_repeats(names: Vec<String>) -> Vec<String> {
    let mut once: Vec<String> = Vec::new();
    for name in names {
        if !once.contains(&name) {
            once.push(name);
        }
    }
    once
}

#[cfg(test)]
mod tests {
    use super::*;
    use field::{Analytic, Scalar};
    use symbolic::{apart, symbols};

    #[test]
    fn a_difference_is_refuted_and_an_identity_with_roots_is_not() {
        apart(|| {
            let [x, y] = symbols(["x", "y"]);
            let root = (x * x + y * y).sqrt();
            let compared = |pairs: &[(Sym, Sym)]| {
                compared(pairs, MOST_EXPANDED, |_| (), |_| None, |divisor| Some(divisor.to_string()))
            };
            assert!(matches!(compared(&[(root * root, x * x + y * y)]), Agreement::Proved { .. }));
            assert!(matches!(compared(&[(root, x + y)]), Agreement::Refuted { .. }));
        });
    }

    #[test]
    fn divisors_that_vanish_at_the_start_are_told() {
        apart(|| {
            let [x, y] = symbols(["x", "y"]);
            let pairs = [(x / y, x * x / (x * y))];
            let at = |x: f64, y: f64| {
                let value =
                    |divisor: Sym| divisor.evaluate_analytic(&|name: &str| Some(if name == "x" { x } else { y })).ok();
                compared(&pairs, MOST_EXPANDED, |_| (), value, |divisor| Some(divisor.to_string())).to_string()
            };
            let none =
                compared(&pairs, MOST_EXPANDED, |_| (), |_| None, |divisor| Some(divisor.to_string())).to_string();
            assert!(none.starts_with("proved") && !none.contains("at the start"), "{none}");
            assert!(at(2.0, 3.0).ends_with(" (true at the start)"), "{}", at(2.0, 3.0));
            assert!(at(0.0, 3.0).ends_with(" (at the start x vanishes)"), "{}", at(0.0, 3.0));
        });
    }

    #[test]
    fn a_long_difference_is_refuted_without_its_normal_form() {
        apart(|| {
            let [x, y] = symbols(["x", "y"]);
            let long = (0..2_500).fold(x, |sum, k| sum * y + Sym::int(k));
            let found = compared(&[(x, x), (long, long * Sym::int(2))], MOST_EXPANDED, |_| (), |_| None, |_| None);
            let Agreement::Refuted { equation: 1, point } = found else { panic!("{found}") };
            assert_eq!(point, "not zero at a random point of a prime field");
        });
    }

    #[test]
    fn what_agrees_to_some_digits_alone_is_not_tested() {
        apart(|| {
            let [x, y] = symbols(["x", "y"]);
            let close = x * Sym::ratio(1_000_000_001, 1_000_000_000);
            assert_eq!(equal_digits(&[(x, close)]), None);
            // each letter has its own value
            assert_eq!(equal_digits(&[(x, y)]), None);
            assert!(equal_digits(&[(x.circle().sin * y, y * x.circle().sin)]).is_some());
            // no real point gives a value
            assert_eq!(equal_digits(&[((-x).sqrt(), (-x).sqrt() + y)]), None);
        });
    }
}
