//! Implications between two conditions "expression = 0": a proof, or an exact point at which the implication fails.

use crate::admissible::admissible;
use crate::display::{Told, divisors, factors, tell_point};
use crate::equation::{Outcome, vanishes_within};
use crate::exact_points::{Effort, completed, search};
use crate::finding::Finding;
use crate::letters::Letters;
use crate::motion::{Motion, Solution, solution};
use crate::natural_domain::written_divisors;
use crate::polynomial_factors::polynomial_factors;
use crate::real_signs::vanishes_by_signs;
use crate::refutation::Refutation;
use crate::signs::shows;
use crate::square_sums;
use crate::verdict::neither;
use claims::{Condition, Verdict};
use model::equations::Equations;
use symbolic::{Hypotheses, Sym, decide, normal};

/// The way in which an implication was proved.
pub(crate) enum Way<'t, 'm> {
    /// The conclusion is the condition times this factor.
    Multiple(Sym),
    /// The conclusion vanishes on this motion, which assumes the condition.
    Solved(Box<Motion<'t, 'm>>),
    /// The conclusion vanishes by the signs of roots of squares.
    Signs,
    /// The conclusion is a multiple of the product of those factors of the condition that may vanish.
    Factors,
}

/// The result for an implication.
pub(crate) enum Step<'t, 'm> {
    /// The conclusion follows if these divisors are not zero.
    Follows(Vec<Sym>, Way<'t, 'm>),
    /// The conclusion fails at this point.
    Fails(Refutation),
    Open(Outcome),
}

/// Decides whether `then` vanishes wherever `zero` vanishes and both are defined.
pub(crate) fn step<'t, 'm>(motion: &Motion<'t, 'm>, zero: Sym, then: Sym, conditions: &[Condition]) -> Step<'t, 'm> {
    match step_within(motion, zero, then, conditions, Effort::Whole) {
        Step::Fails(refutation) => {
            let again = |within: &[Condition]| match step_within(motion, zero, then, within, Effort::Part) {
                Step::Fails(refutation) => Some(refutation),
                _ => None,
            };
            Step::Fails(admissible(refutation, motion, conditions, again))
        }
        Step::Follows(mut divisors, way) => {
            // the reduction of both expressions solved constraints and divided by these expressions
            let reduced = [zero, then].map(|each| motion.reduced(each));
            let hidden = reduced.into_iter().flat_map(written_divisors);
            for divisor in hidden.filter(|divisor| !is_apart(*divisor, motion, conditions)) {
                if !divisors.contains(&divisor) {
                    divisors.push(divisor);
                }
            }
            Step::Follows(divisors, way)
        }
        step => step,
    }
}

/// The decision of [`step`] with the given effort in the search for points.
fn step_within<'t, 'm>(
    motion: &Motion<'t, 'm>,
    zero: Sym,
    then: Sym,
    conditions: &[Condition],
    effort: Effort,
) -> Step<'t, 'm> {
    let mut there = motion.clone();
    let written = [written_divisors(zero), written_divisors(then)].concat();
    if !written.is_empty() && there.assume(zero, None).is_ok() {
        let is_zero = |divisor: &&Sym| decide(there.reduced(**divisor), &there.hypotheses).is_zero();
        if let Some(divisor) = written.iter().find(is_zero) {
            return Step::Open(Outcome::Undefined(*divisor));
        }
    }
    let (zero, then) = (motion.reduced(zero), motion.reduced(then));
    // parameters of inertia are taken as positive: a model without inertia has no motion, and negative masses do not help a reader
    let inertia = [zero, then].into_iter().flat_map(Sym::symbols_of).filter(|symbol| is_of_inertia(*symbol, motion));
    let inertia: Vec<Condition> = inertia.map(Condition::Positive).collect();
    let conditions = &[conditions, &inertia].concat()[..];
    if decide(zero, &motion.hypotheses).is_zero() {
        // the condition holds everywhere
        return match vanishes_within(motion, then, conditions, effort) {
            Outcome::Zero(divided) => Step::Follows(divided, Way::Solved(Box::new(motion.clone()))),
            Outcome::NonZero(refutation) => Step::Fails(refutation),
            other => Step::Open(other),
        };
    }
    let open = |factor: &Sym| !is_apart(*factor, motion, conditions);
    let written = normal(zero, &motion.hypotheses).map_or(vec![zero], |form| factors(form.numerator()));
    let parts: Vec<Sym> = written.into_iter().flat_map(polynomial_factors).collect();
    if zero != Sym::ZERO && !parts.iter().any(open) {
        return Step::Open(Outcome::Undecided(format!("{zero} vanishes nowhere within the hypotheses")));
    }
    // a multiple of the condition vanishes where the condition does
    if let Ok(form) = normal(then / zero, &motion.hypotheses) {
        let below = factors(form.denominator());
        if !below.iter().any(open) {
            return Step::Follows(below, Way::Multiple(form.to_sym()));
        }
    }
    // a power of a factor vanishes where the factor does
    let essential = parts.iter().copied().filter(open).fold(Sym::ONE, |product, part| product * part);
    if let Ok(form) = normal(then / essential, &motion.hypotheses) {
        let below = factors(form.denominator());
        if zero != Sym::ZERO && !below.iter().any(open) {
            let divided = parts.into_iter().filter(|part| !open(part)).chain(below);
            return Step::Follows(divided.collect(), Way::Factors);
        }
    }
    let Some(Solution { symbol, value, divisor }) = solution(motion.trace, zero, None) else {
        let parts: Vec<Sym> = parts.into_iter().filter(open).collect();
        return by_cases(motion, (zero, &parts), then, conditions, effort);
    };
    let mut there = motion.clone();
    if let Err(why) = there.assume(zero, Some(symbol)) {
        return Step::Open(Outcome::Undecided(format!("the printed condition was not solved: {why}")));
    }
    let below = normal(divisor, &Hypotheses::none()).map_or(vec![divisor], |form| factors(form.numerator()));
    let known = reduced(conditions, &there);
    let outcome = vanishes_within(&there, then, &known, effort);
    let is_zero = matches!(outcome, Outcome::Zero(_));
    if !is_zero && below.iter().all(|factor| !open(factor)) && vanishes_by_signs(there.reduced(then), &known) {
        return Step::Follows(below, Way::Signs);
    }
    match outcome {
        Outcome::Zero(_) => match below.iter().copied().filter(open).collect::<Vec<_>>()[..] {
            [] => Step::Follows(below, Way::Solved(Box::new(there))),
            ref divided => {
                let failing =
                    divided.iter().find_map(|&factor| exhibit(motion, factor, [zero, then], conditions, effort));
                failing.map_or_else(|| Step::Open(Outcome::Undecided(undivided(divided[0]))), Step::Fails)
            }
        },
        Outcome::NonZero(mut refutation) => {
            if let Some(value) = refutation.value(value) {
                refutation.point.push((symbol, value));
            }
            match completed(refutation, conditions) {
                Some(refutation) => Step::Fails(refutation),
                None => {
                    Step::Open(Outcome::Undecided("no exact point was found that satisfies the hypotheses".to_owned()))
                }
            }
        }
        other => Step::Open(other),
    }
}

/// Decides an implication whose condition cannot be solved for a letter: by the cases in which a factor vanishes, otherwise by points of small numbers.
fn by_cases<'t, 'm>(
    motion: &Motion<'t, 'm>,
    (zero, parts): (Sym, &[Sym]),
    then: Sym,
    conditions: &[Condition],
    effort: Effort,
) -> Step<'t, 'm> {
    // only a shorter factor is a case, otherwise the recursion might not end
    let is_shorter = |part: Sym| Sym::operations_of(&[part]) < Sym::operations_of(&[zero]);
    let is_part = |part: &&Sym| parts.len() > 1 && is_shorter(**part) || solution(motion.trace, **part, None).is_some();
    let mut divided: Vec<Sym> = Vec::new();
    let mut has_all = parts.iter().all(|part| is_part(&part));
    for part in parts.iter().filter(is_part) {
        match step_within(motion, *part, then, conditions, effort) {
            Step::Follows(below, _) => divided.extend(below),
            failing @ Step::Fails(_) => return failing,
            Step::Open(_) => has_all = false,
        }
    }
    if has_all {
        return Step::Follows(divided, Way::Factors);
    }
    let fails = |signs: &[i8]| matches!(signs, [0, other] if *other != 0);
    let why = "a condition is linear in none of its letters, so that it was not solved, and no exact point was found at which it holds and the other does not";
    let found = search(&[zero, then], conditions, motion, effort, fails).filter(|found| found.is_on(motion));
    found.map_or_else(|| Step::Open(Outcome::Undecided(why.to_owned())), Step::Fails)
}

fn undivided(factor: Sym) -> String {
    format!("one condition follows from the other by a division by {factor}, which no hypothesis keeps from vanishing")
}

fn reduced(conditions: &[Condition], motion: &Motion<'_, '_>) -> Vec<Condition> {
    conditions.iter().map(|condition| condition.mapped(|e| motion.reduced(e))).collect()
}

/// A point at which a divisor is zero, where the condition holds and the conclusion does not.
fn exhibit(
    motion: &Motion<'_, '_>,
    factor: Sym,
    [zero, then]: [Sym; 2],
    conditions: &[Condition],
    effort: Effort,
) -> Option<Refutation> {
    let known = [&motion.trace.coordinates[..], &motion.trace.speeds, &motion.trace.parameters].concat();
    let at_zero = known.iter().filter(|symbol| {
        factor.symbols_of().contains(symbol)
            && decide(factor.substitute(&[(**symbol, Sym::ZERO)]), &motion.hypotheses).is_zero()
    });
    let at_zero = at_zero.map(|&symbol| (symbol, symbol));
    // the condition is solved again with the divisor set to zero
    let mut places: Vec<Motion<'_, '_>> = Vec::new();
    for (held, alone) in at_zero.chain([(factor, factor)]) {
        let mut there = motion.clone();
        let alone = alone.symbol_name().map(|_| alone);
        if there.assume(held, alone).is_ok() && there.assume(zero, None).is_ok() {
            places.push(there);
        }
    }
    places.into_iter().find_map(|there| {
        let known = reduced(conditions, &there);
        let Outcome::NonZero(mut found) = vanishes_within(&there, then, &known, effort) else { return None };
        for symbol in there.replaced() {
            let is_listed = found.point.iter().any(|(known, _)| *known == symbol);
            if let (false, Some(value)) = (is_listed, found.value(there.reduced(symbol))) {
                found.point.push((symbol, value));
            }
        }
        completed(found, &known)
    })
}

/// Whether a divisor never vanishes: by hypotheses and signs, because the model gives it a value, or because the model needs it as inertia. The
/// verdict lists the last two reasons among its hypotheses.
pub(crate) fn is_apart(factor: Sym, motion: &Motion<'_, '_>, conditions: &[Condition]) -> bool {
    let by_model = |symbol: &Sym| is_of_inertia(*symbol, motion) || has_value(*symbol, motion);
    let by_model = factor.symbols_of().into_iter().filter(by_model).map(Condition::Positive);
    is_apart_by(factor, motion, &conditions.iter().copied().chain(by_model).collect::<Vec<_>>())
}

/// Whether conditions and signs exclude that a divisor vanishes.
pub(crate) fn is_apart_by(factor: Sym, motion: &Motion<'_, '_>, known: &[Condition]) -> bool {
    if factor.as_constant().is_some() {
        return true;
    }
    // a numerical multiple vanishes where the factor does
    let letters = factor.symbols_of();
    let is_multiple = |part: Sym| {
        let ratio =
            || normal(part / factor, &Hypotheses::none()).is_ok_and(|ratio| ratio.to_sym().as_constant().is_some());
        part == factor || part == -factor || part.symbols_of() == letters && ratio()
    };
    let is_stated = known.iter().any(|condition| match condition {
        Condition::NonZero(e) | Condition::Positive(e) => {
            normal(*e, &motion.hypotheses).is_ok_and(|form| factors(form.numerator()).into_iter().any(is_multiple))
        }
        _ => false,
    });
    let shown = |e: Sym| {
        shows(e, motion, known).is_some_and(|shown| shown.is_strict) || square_sums::shows(e, known) == Some(true)
    };
    is_stated || shown(factor) || shown(-factor)
}

/// Whether a symbol is a parameter without which a coordinate of the model has no inertia.
pub(crate) fn is_of_inertia(symbol: Sym, motion: &Motion<'_, '_>) -> bool {
    motion.trace.parameters.contains(&symbol) && takes_inertia(symbol, motion)
}

/// Whether a symbol is a coordinate at whose zero a coordinate has no inertia, as the radius in polar coordinates.
pub(crate) fn is_pole(symbol: Sym, motion: &Motion<'_, '_>) -> bool {
    motion.trace.coordinates.contains(&symbol) && takes_inertia(symbol, motion)
}

/// Whether a diagonal entry of the mass matrix vanishes where a symbol is zero.
fn takes_inertia(symbol: Sym, motion: &Motion<'_, '_>) -> bool {
    let mass = Equations::of(motion.trace).mass;
    (0..mass.len()).any(|k| mass[k][k].substitute(&[(symbol, Sym::ZERO)]) == Sym::ZERO)
}

/// Whether the model gives a parameter a positive value.
fn has_value(symbol: Sym, motion: &Motion<'_, '_>) -> bool {
    let mut all = motion.trace.model.parameters.iter();
    all.any(|one| Sym::symbol(&one.name) == symbol && one.value.is_some_and(|value| value > 0.0))
}

/// Whether an implication is proved; otherwise its verdict is written into the finding.
pub(crate) fn followed(
    step: Step<'_, '_>,
    own: [Sym; 2],
    motion: &Motion<'_, '_>,
    conditions: &[Condition],
    letters: &Letters<'_, '_>,
    finding: &mut Finding,
) -> bool {
    match step {
        Step::Follows(divided, _) => {
            divided.into_iter().for_each(|divisor| require(divisor, conditions, letters, finding));
            true
        }
        Step::Fails(refutation) => {
            finding.judged.verdict = Verdict::Refuted;
            finding.judged.evidence = "at the exact point one condition holds and the other does not".to_owned();
            tell_point(own, &refutation, motion, Told(letters), finding);
            false
        }
        Step::Open(outcome) => {
            neither(outcome, letters, finding);
            false
        }
    }
}

/// Adds the factors of a divisor to the requirements of a finding, except those that hypotheses exclude from being zero.
pub(crate) fn require(divisor: Sym, conditions: &[Condition], letters: &Letters<'_, '_>, finding: &mut Finding) {
    let known = conditions.iter().filter_map(|condition| match condition {
        Condition::NonZero(e) | Condition::Positive(e) => Some(*e),
        _ => None,
    });
    let known = divisors(&known.collect::<Vec<Sym>>(), Told(letters));
    for line in divisors(&[divisor], Told(letters)) {
        if !known.contains(&line) && !finding.judged.requires.contains(&line) {
            finding.judged.requires.push(line);
        }
    }
}
