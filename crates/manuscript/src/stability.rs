//! Claims about the stability of a steady motion: the printed inequality is compared with the conditions on the eigenvalues of the linear equations and,
//! for a conservative system, with those for a minimum of the energy.

use crate::admissible::admissible;
use crate::certificate::Record;
use crate::claim_text::ClaimText;
use crate::condition_products;
use crate::conditions::{Hypothesis, assume, conditions};
use crate::consequence::is_of_inertia;
use crate::display::{Told, divisors, readable, tell_point};
use crate::equation::Outcome;
use crate::exact_points::{Effort, search};
use crate::extent::{exclude_each_other, is_met};
use crate::feedback::Feedback;
use crate::finding::Finding;
use crate::inequalities::sides;
use crate::letters::Letters;
use crate::linear_equations::{Comparison, LinearEquations, Multiple};
use crate::linear_motion::LinearMotion;
use crate::minimum_certificate::minimum;
use crate::motion::Motion;
use crate::real_signs;
use crate::refutation::{Refutation, sign};
use crate::signs::{Shown, shows};
use crate::stability_region::{Criterion, Region, Theorem};
use crate::steady_motion::Resting;
use crate::verdict::neither;
use claims::{Condition, Verdict};
use latex::{Relation, Statement};
use reader::Issue;
use symbolic::{Hypotheses, Sym, coefficients, normal};

/// Judges the claim that the motion on which the letters of `resting` are constant is stable if and only if `a > b`: under the hypotheses, and if this
/// fails under the additional hypotheses that parameters of inertia do not vanish.
pub(crate) fn stability(
    claim: &ClaimText,
    statement: &Statement,
    letters: &Letters<'_, '_>,
    assumed: &[Hypothesis],
    finding: &mut Finding,
    record: &mut Record,
) -> Result<(), Issue> {
    stability_within(claim, statement, letters, assumed, finding, record)?;
    let inertia = inertia(claim, letters, assumed);
    if finding.judged.verdict != Verdict::Undecided || inertia.is_empty() {
        return Ok(());
    }
    let (mut trial, mut with_inertia) = (finding.clone(), Record::of(record.is_wanted()));
    trial.judged.requires.extend(inertia.iter().map(|one| one.told.clone()));
    let assumed = [assumed, &inertia].concat();
    stability_within(claim, statement, letters, &assumed, &mut trial, &mut with_inertia)?;
    if trial.judged.verdict == Verdict::Proved {
        (*finding, *record) = (trial, with_inertia);
    }
    Ok(())
}

/// Hypotheses that the parameters without which the model has no inertia do not vanish.
fn inertia(claim: &ClaimText, letters: &Letters<'_, '_>, assumed: &[Hypothesis]) -> Vec<Hypothesis> {
    let motion = Motion::without_anything(letters.trace);
    let is_new =
        |of: &Sym| assumed.iter().all(|one| one.condition.is_none_or(|condition| condition.expression() != *of));
    let parameters =
        letters.trace.parameters.iter().filter(|one| is_of_inertia(**one, &motion)).filter(|one| is_new(one));
    let hypothesis = |&parameter: &Sym| {
        let own = letters.told(parameter);
        Hypothesis {
            told: (format!("{own} != 0"), format!(r"{} \neq 0", own.latex())),
            own: None,
            equality: None,
            scales: false,
            condition: Some(Condition::NonZero(parameter)),
            at: claim.formula.span.clone(),
        }
    };
    parameters.map(hypothesis).collect()
}

fn stability_within(
    claim: &ClaimText,
    statement: &Statement,
    letters: &Letters<'_, '_>,
    assumed: &[Hypothesis],
    finding: &mut Finding,
    record: &mut Record,
) -> Result<(), Issue> {
    let sides = sides(claim, statement, letters)?;
    let differs = statement.chains.iter().any(|chain| chain.relations.contains(&Relation::NotEqual));
    if !sides.is_strict || differs {
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
        "the linear equations about the steady motion, without the roots zero of speeds that stay as they are; the energy of a conservative system"
            .to_owned();
    let linear = LinearMotion::of(&resting, letters, &motion, &Feedback::of(trace, assumed));
    match linear.and_then(|linear| Ok((Region::of(&linear, &motion, &known)?, linear))) {
        Ok((region, linear)) => {
            let printed = motion.reduced(sides.greater);
            let there = [&known[..], &[Condition::Positive(printed)]].concat();
            if !is_met(&there) && exclude_each_other(&there) {
                finding.judged.verdict = Verdict::Undefined;
                finding.judged.evidence =
                    "the printed inequality holds nowhere within the hypotheses, so that no stable motion is claimed"
                        .to_owned();
                return Ok(());
            }
            let compared = Compared { region: &region, printed, own: sides.own, motion: &motion, known: &known };
            let shown = compared.judged(letters, finding);
            let equations = region.roots.map(|roots| LinearEquations::of(&linear, roots));
            match (equations, shown, &region.energy) {
                (Some(equations), Some(shown), _) => record.stability(&motion, assumed, &equations, printed, shown),
                (_, None, Some(form)) if finding.judged.verdict == Verdict::Proved => {
                    minimum(record, (&motion, assumed, &known), &linear, form, printed);
                }
                _ => record.leave_out(),
            }
        }
        Err(why) => neither(Outcome::Undecided(why), letters, finding),
    }
    Ok(())
}

/// A printed condition, and the region of stability with which it is compared.
struct Compared<'a, 't, 'm> {
    region: &'a Region,
    printed: Sym,
    own: [Sym; 2],
    motion: &'a Motion<'t, 'm>,
    known: &'a [Condition],
}

impl Compared<'_, '_, '_> {
    /// Writes the verdict into the finding; returns the part of its proof that the second checker can repeat.
    fn judged(&self, letters: &Letters<'_, '_>, finding: &mut Finding) -> Option<Comparison> {
        let told = Told(letters);
        if let Some((criterion, multiple)) = self.multiple() {
            finding.judged.verdict = Verdict::Proved;
            finding.judged.requires.extend(divisors(&self.motion.divisors, told));
            finding.judged.evidence = format!(
                "in the first approximation the motion is {} where the printed inequality holds, and not where its sides are exchanged: the \
                 condition of the roots is a positive multiple of it{}",
                criterion.theorem.kind(),
                self.beyond_roots()
            );
            return Some(Comparison::Same(multiple));
        }
        if let Some(evidence) = self.by_signs() {
            finding.judged.verdict = Verdict::Proved;
            finding.judged.requires.extend(divisors(&self.motion.divisors, told));
            finding.judged.evidence = evidence;
            return None;
        }
        let Some((refutation, holds, by_roots)) = self.refutation() else {
            let why = "neither the signs of the conditions of stability show the printed one, nor was an exact point found at which they differ";
            neither(Outcome::Undecided(why.to_owned()), letters, finding);
            return None;
        };
        finding.judged.verdict = Verdict::Refuted;
        finding.judged.evidence = match holds {
            true => "at the exact point the printed inequality holds, and a root has a positive real part, so that the motion is unstable \
                     (A. M. Lyapunov)"
                .to_owned(),
            false => format!("at the exact point the printed inequality fails, and {}", self.region.told_stable(by_roots)),
        };
        tell_point(self.own, &refutation, self.motion, told, finding);
        // with gyroscopic terms, a minimum is not necessary for stability
        let is_needed = |one: &&Criterion| one.theorem.is_of_roots() || !self.region.is_gyroscopic;
        let needed = self.region.criteria.iter().filter(is_needed).map(|one| self.open(one));
        if let Some([condition]) = needed.map(|open| <[Sym; 1]>::try_from(open).ok()).next().flatten()
            && let Some(condition) = readable(condition, self.own, self.motion, told)
        {
            finding.judged.evidence += &format!("; the condition of stability is {condition} > 0");
        }
        by_roots.then_some(Comparison::Other(refutation))
    }

    /// The conditions of a criterion that the hypotheses alone do not prove positive.
    fn open(&self, criterion: &Criterion) -> Vec<Sym> {
        let is_positive = |of: &Sym| shows(*of, self.motion, self.known).is_some_and(|shown| shown.is_strict);
        criterion.conditions.iter().copied().filter(|condition| !is_positive(condition)).collect()
    }

    /// The criterion by eigenvalues, if its only open condition is a positive multiple of the printed one.
    fn multiple(&self) -> Option<(&Criterion, Multiple)> {
        let criterion = self.region.criteria.iter().find(|one| one.theorem.is_of_roots())?;
        let [condition] = self.open(criterion)[..] else { return None };
        let ratio = condition / self.printed;
        // squares of nonzero expressions are positive factors
        let apart = self.known.iter().enumerate().filter_map(|(place, condition)| match condition {
            Condition::NonZero(e) | Condition::Positive(e) => Some((place, *e)),
            _ => None,
        });
        let without = apart.flat_map(|(place, e)| [2, 4].map(|power| (ratio / e.powi(power), Some((place, power)))));
        let multiple = std::iter::once((ratio, None)).chain(without).find_map(|(ratio, square)| {
            let ratio = normal(ratio, &Hypotheses::none()).ok()?.to_sym();
            let is_positive = shows(ratio, self.motion, self.known).is_some_and(|shown| shown.is_strict);
            is_positive.then_some(Multiple { ratio, square })
        });
        multiple.map(|multiple| (criterion, multiple))
    }

    /// A sentence about eigenvalues on the imaginary axis, which do not imply stability of the nonlinear equations without an energy.
    fn beyond_roots(&self) -> String {
        let is_minimum = |one: &&Criterion| one.theorem == Theorem::Minimum && self.shows_all(&one.conditions);
        let is_asymptotic = self.region.criteria.iter().any(|one| one.theorem == Theorem::Hurwitz);
        match self.region.criteria.iter().find(is_minimum) {
            _ if is_asymptotic => String::new(),
            Some(_) if self.region.is_lagrangian => "; the potential energy has a minimum there, so that the motion is stable without an approximation (Lagrange, Dirichlet); \
                        where both sides are equal nothing is decided"
                .to_owned(),
            _ if self.region.is_gyroscopic => "; gyroscopic terms hold roots on the imaginary axis, which decide the linear equations alone".to_owned(),
            _ => String::new(),
        }
    }

    /// Whether all conditions are proved positive where the printed inequality holds.
    fn shows_all(&self, conditions: &[Sym]) -> bool {
        let there = [self.known, &[Condition::Positive(self.printed)]].concat();
        conditions.iter().all(|&condition| has_sign(condition, true, self.motion, &there))
    }

    /// The evidence that the printed condition implies the conditions of a criterion, and that the necessary conditions imply the printed one.
    fn by_signs(&self) -> Option<String> {
        let criterion = self.region.criteria.iter().find(|one| self.shows_all(&one.conditions))?;
        let stable =
            self.region.necessary.iter().map(|&condition| without_positive(condition, self.motion, self.known));
        let stable: Vec<Condition> = stable.map(Condition::NotNegative).collect();
        let follows = has_sign(self.printed, false, self.motion, &[self.known, &stable].concat());
        let against = [self.known, &[Condition::Positive(Sym::ZERO - self.printed)]].concat();
        let fails = || {
            let opposite = self.region.necessary.iter().map(|&condition| Sym::ZERO - condition);
            opposite.into_iter().any(|one| has_sign(one, true, self.motion, &against))
        };
        (follows || fails()).then(|| {
            format!(
                "where the printed inequality holds {}; where its sides are exchanged a root has a positive real part, so that the motion is \
                 unstable (A. M. Lyapunov); where they are equal nothing is decided",
                self.region.told(criterion.theorem)
            )
        })
    }

    /// A point at which the printed inequality and stability disagree, whether the inequality holds there, and whether eigenvalues alone show this.
    fn refutation(&self) -> Option<(Refutation, bool, bool)> {
        let of_roots = |one: &&Criterion| one.theorem.is_of_roots();
        let roots: Vec<&Criterion> = self.region.criteria.iter().filter(of_roots).collect();
        let all: Vec<&Criterion> = self.region.criteria.iter().collect();
        let by_roots = roots.first().map(|one| one.conditions.clone()).unwrap_or_default();
        let found = |criteria: &[&Criterion], necessary: &[Sym]| {
            let mut expressions = vec![self.printed];
            let mut parts: Vec<std::ops::Range<usize>> = Vec::new();
            for list in criteria.iter().map(|one| &one.conditions[..]).chain([necessary]) {
                parts.push(expressions.len()..expressions.len() + list.len());
                expressions.extend(list);
            }
            let last = parts.pop()?;
            let disagree = |signs: &[i8]| {
                let is_stable = parts.iter().any(|part| signs[part.clone()].iter().all(|sign| *sign == 1));
                let is_unstable = signs[last.clone()].contains(&-1);
                signs[0] == 1 && is_unstable || signs[0] == -1 && is_stable
            };
            let within =
                |known: &[Condition], effort: Effort| search(&expressions, known, self.motion, effort, disagree);
            let found = within(self.known, Effort::Whole)?;
            Some(admissible(found, self.motion, self.known, |known| within(known, Effort::Part)))
        };
        let with_roots = || if by_roots.is_empty() { None } else { found(&roots, &by_roots) };
        let (refutation, is_by_roots) = match with_roots() {
            Some(refutation) => (refutation, true),
            None => (found(&all, &self.region.necessary)?, false),
        };
        let value = refutation.value(self.printed).and_then(sign);
        Some((refutation, value == Some(1), is_by_roots))
    }
}

/// Whether an expression is proved positive (`is_strict`) or nonnegative where conditions hold, as a whole or by the signs of its factors.
fn has_sign(expression: Sym, is_strict: bool, motion: &Motion<'_, '_>, known: &[Condition]) -> bool {
    let shown = |of: Sym| {
        let is_enough = |found: Shown| found.is_strict || !is_strict;
        shows(of, motion, known).is_some_and(is_enough)
            || real_signs::shows(of, known).is_some_and(is_enough)
            || condition_products::show(of, is_strict, known)
    };
    let left = without_positive(expression, motion, known);
    shown(left) || left != expression && shown(expression)
}

/// An expression without its positive factors.
fn without_positive(expression: Sym, motion: &Motion<'_, '_>, known: &[Condition]) -> Sym {
    let is_positive = |of: Sym| {
        shows(of, motion, known).is_some_and(|shown| shown.is_strict) || condition_products::show(of, true, known)
    };
    let Ok(form) = normal(expression, &Hypotheses::none()) else { return expression };
    let (above, below) = (form.numerator(), form.denominator());
    let mut left = above;
    for letter in above.symbols_of() {
        let Ok(terms) = coefficients(above, &[letter]) else { continue };
        let least = terms.iter().map(|(exponents, _)| exponents[0]).min().unwrap_or(0);
        let power = if is_positive(letter) { least } else { least - least % 2 };
        if power > 0 && is_positive(letter.powi(power as i32)) {
            left /= letter.powi(power as i32);
        }
    }
    let whole = if is_positive(below) { left } else { left / below };
    normal(whole, &Hypotheses::none()).map_or(expression, |form| form.to_sym())
}
