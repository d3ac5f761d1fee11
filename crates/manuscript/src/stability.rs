//! Stability of a steady motion in the first approximation: the printed inequality beside the roots of the linear equations.

use crate::certificate::Record;
use crate::claim_text::ClaimText;
use crate::conditions::{Hypothesis, assume, conditions};
use crate::display::{Told, divisors, point, told_difference};
use crate::equation::Outcome;
use crate::finding::Finding;
use crate::inequalities::sides;
use crate::letters::Letters;
use crate::linear_equations::{Comparison, LinearEquations, Multiple};
use crate::motion::Motion;
use crate::signs::{search, shows};
use crate::steady_motion::Resting;
use crate::verdict::neither;
use claims::{Condition, Verdict};
use latex::Statement;
use model::equations::Equations;
use reader::Issue;
use symbolic::{Hypotheses, Sym, coefficients, decide, normal};

/// Larger systems are not expanded into a polynomial.
const MOST_SPEEDS: usize = 4;

/// `a > b` where, and only where, the motion on which the letters of `resting` are constant is stable in the first approximation.
pub(crate) fn stability(
    claim: &ClaimText,
    statement: &Statement,
    letters: &Letters<'_, '_>,
    assumed: &[Hypothesis],
    finding: &mut Finding,
    record: &mut Record,
) -> Result<(), Issue> {
    let sides = sides(claim, statement, letters)?;
    if !sides.is_strict {
        let issue = Issue::at(
            claim.formula.span.clone(),
            "the edge of stability is decided by no linear equation",
            "not strict",
        );
        return Err(issue.accepted("< or >"));
    }
    (finding.judged.text, finding.judged.latex) = (vec![sides.text.clone()], vec![sides.latex.clone()]);
    let trace = letters.trace;
    let mut motion = Motion::by_constraints(trace);
    let resting = Resting::of(claim, letters)?;
    motion.set(resting.rates(letters));
    assume(&mut motion, assumed)?;
    let known = conditions(&motion, assumed);
    finding.allowed =
        "roots of the linear equations about the steady motion, without the roots zero of speeds that stay as they are"
            .to_owned();
    match roots(&resting, letters, &motion) {
        Ok(found) => {
            let printed = motion.reduced(sides.greater);
            let shown = compared(&found, printed, sides.own, &motion, &known, letters, finding);
            record.stability(&motion, assumed, &found.linear, printed, shown);
        }
        Err(why) => neither(Outcome::Undecided(why), letters, finding),
    }
    Ok(())
}

/// The expressions that must be positive for stability.
struct Roots {
    linear: LinearEquations,
    conditions: Vec<Sym>,
    /// Whether all roots are left of the imaginary axis there, and not on it.
    is_asymptotic: bool,
}

/// The conditions on the coefficients of the characteristic polynomial.
fn roots(resting: &Resting, letters: &Letters<'_, '_>, motion: &Motion<'_, '_>) -> Result<Roots, String> {
    let trace = letters.trace;
    let Equations { mass, bias, constraints } = Equations::of(trace);
    let n = mass.len();
    if !constraints.is_empty() || n != trace.coordinates.len() {
        return Err("stability is decided of systems without constraints and without free frames".to_owned());
    }
    if n > MOST_SPEEDS {
        return Err(format!("stability is decided of up to {MOST_SPEEDS} coordinates, and this system has {n}"));
    }
    let Resting { coordinates, speeds } = resting;
    if let Some(free) = (0..n).find(|place| !coordinates.contains(place) && !speeds.contains(place)) {
        let name = &trace.coordinates[free];
        return Err(format!("neither {name} nor its rate rests, so that the linear equations change with the time"));
    }
    let s = Sym::symbol("root of the linear equations");
    let mut matrix: Vec<Vec<Sym>> = Vec::new();
    let mut equations: Vec<Sym> = Vec::new();
    for (k, row) in mass.iter().enumerate() {
        let equation = row.iter().zip(&trace.accelerations).fold(bias[k], |sum, (&entry, &rate)| sum + entry * rate);
        if !decide(motion.reduced(equation), &motion.hypotheses).is_zero() {
            return Err(format!(
                "the equation of {} does not hold on this motion: its condition is missing in `given`",
                trace.direction(k)
            ));
        }
        equations.push(equation);
        let entry = |j: usize| -> Result<Sym, String> {
            let inertia = motion.reduced(row[j]);
            let damping = motion.reduced(trace.by_speed(equation, j));
            let stiffness = motion.reduced(trace.by_coordinate(equation, j));
            if coordinates.contains(&j) {
                return Ok(inertia * s * s + damping * s + stiffness);
            }
            match decide(stiffness, &motion.hypotheses).is_zero() {
                // of a speed that stays as it is
                true => Ok(inertia * s + damping),
                false => Err(format!("the linear equations know {} itself, which does not rest", trace.coordinates[j])),
            }
        };
        matrix.push((0..n).map(entry).collect::<Result<_, _>>()?);
    }
    let polynomial = normal(determinant(&matrix), &motion.hypotheses).map_err(|why| why.to_string())?;
    let terms = coefficients(polynomial.numerator(), &[s])
        .map_err(|_| "the characteristic polynomial was not formed".to_owned())?;
    let mut powers: Vec<(u32, Sym)> = terms.into_iter().map(|(exponents, value)| (exponents[0], value)).collect();
    powers.sort_by_key(|(power, _)| *power);
    let neutral = powers.first().map_or(0, |(power, _)| *power);
    // each such speed leaves a root zero: a neighbouring motion with other constants
    if neutral as usize > n - coordinates.len() {
        return Err("the linear equations have a root zero beside those of speeds that stay as they are".to_owned());
    }
    let degree = powers.last().map_or(0, |(power, _)| *power) - neutral;
    let of =
        |power: u32| powers.iter().find(|(known, _)| *known == power + neutral).map_or(Sym::ZERO, |(_, value)| *value);
    let all: Vec<Sym> = (0..=degree).map(of).collect();
    let (conditions, is_asymptotic) = conditions_of(&all)?;
    let (resting, scale) = (coordinates.clone(), polynomial.denominator());
    let linear = LinearEquations { equations, resting, root: s, scale, coefficients: all, neutral };
    Ok(Roots { linear, conditions, is_asymptotic })
}

/// The conditions of a polynomial by rising powers: with even powers alone its squares are negative numbers, each of their own; else Hurwitz's.
fn conditions_of(all: &[Sym]) -> Result<(Vec<Sym>, bool), String> {
    let is_even = all.iter().skip(1).step_by(2).all(|odd| *odd == Sym::ZERO);
    let found = match (all, is_even) {
        ([], _) | ([_], _) => return Err("no root is left beside zero".to_owned()),
        ([c, _, a], true) => vec![*a * *c],
        ([e, _, c, _, a], true) => {
            vec![*a * *c, *a * *e, *c * *c - Sym::constant(field::Rational::new(4, 1)) * *a * *e]
        }
        ([b, a], _) => vec![*a * *b],
        ([c, b, a], _) => vec![*a * *b, *a * *c],
        ([d, c, b, a], _) => vec![*a * *b, *a * *d, *b * *c - *a * *d],
        ([e, d, c, b, a], _) => {
            vec![*a * *b, *a * *c, *a * *e, *a * (*d * (*b * *c - *a * *d) - *b * *b * *e)]
        }
        _ => return Err(format!("the characteristic polynomial has the degree {}: up to 4 is decided", all.len() - 1)),
    };
    Ok((found, !is_even))
}

/// By its first row.
pub(crate) fn determinant(matrix: &[Vec<Sym>]) -> Sym {
    let [first, rest @ ..] = matrix else { return Sym::ONE };
    let mut sum = Sym::ZERO;
    for (j, &entry) in first.iter().enumerate() {
        let minor: Vec<Vec<Sym>> = rest
            .iter()
            .map(|row| row.iter().enumerate().filter(|(k, _)| *k != j).map(|(_, value)| *value).collect())
            .collect();
        let term = entry * determinant(&minor);
        sum = if j % 2 == 0 { sum + term } else { sum - term };
    }
    sum
}

/// The condition that its signs leave open beside the printed one.
fn compared(
    found: &Roots,
    printed: Sym,
    own: [Sym; 2],
    motion: &Motion<'_, '_>,
    known: &[Condition],
    letters: &Letters<'_, '_>,
    finding: &mut Finding,
) -> Option<Comparison> {
    let kind = if found.is_asymptotic { "asymptotically stable" } else { "stable" };
    let is_positive = |condition: &&Sym| shows(**condition, motion, known).is_some_and(|shown| shown.is_strict);
    let open: Vec<Sym> = found.conditions.iter().filter(|condition| !is_positive(condition)).copied().collect();
    let same = |condition: Sym| {
        let ratio = condition / printed;
        // squares of what does not vanish have no sign of their own
        let apart = known.iter().enumerate().filter_map(|(place, condition)| match condition {
            Condition::NonZero(e) | Condition::Positive(e) => Some((place, *e)),
            _ => None,
        });
        let without = apart.flat_map(|(place, e)| [2, 4].map(|power| (ratio / e.powi(power), Some((place, power)))));
        std::iter::once((ratio, None)).chain(without).find_map(|(ratio, square)| {
            let ratio = normal(ratio, &Hypotheses::none()).ok()?.to_sym();
            shows(ratio, motion, known).filter(|shown| shown.is_strict).map(|_| Multiple { ratio, square })
        })
    };
    if let [condition] = open[..]
        && let Some(multiple) = same(condition)
    {
        finding.judged.verdict = Verdict::Proved;
        finding.judged.requires.extend(divisors(&motion.divisors, Told(letters)));
        finding.judged.evidence = format!(
            "in the first approximation the motion is {kind} where the printed inequality holds, and not where its sides are exchanged: the \
             condition of the roots is a positive multiple of it"
        );
        return Some(Comparison::Same(multiple));
    }
    let all: Vec<Sym> = std::iter::once(printed).chain(found.conditions.iter().copied()).collect();
    let disagree = |signs: &[i8]| {
        let is_stable = signs[1..].iter().all(|sign| *sign == 1);
        let is_unstable = signs[1..].contains(&-1);
        signs[0] == 1 && is_unstable || signs[0] == -1 && is_stable
    };
    let Some(refutation) = search(&all, known, motion, disagree) else {
        let why = "the condition of the roots is no positive multiple of the printed one, and no exact point was found at which they differ";
        neither(Outcome::Undecided(why.to_owned()), letters, finding);
        return None;
    };
    let holds = refutation.value(printed).and_then(Sym::as_constant).and_then(|value| value.sign()) == Some(1);
    finding.judged.verdict = Verdict::Refuted;
    finding.judged.evidence = match holds {
        true => "at the exact point the printed inequality holds, and a root has a positive real part".to_owned(),
        false => format!(
            "at the exact point the printed inequality fails, and the motion is {kind} in the first approximation"
        ),
    };
    finding.judged.counterexample = point(own, &refutation, motion, Told(letters));
    if let [condition] = open[..] {
        told_difference(condition, motion, Told(letters), finding);
        finding.judged.evidence += "; the expression below must be positive";
    }
    Some(Comparison::Other(refutation))
}
