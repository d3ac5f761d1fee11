//! Integrals of motion: expressions whose time derivative vanishes along every motion.

use crate::certificate::Record;
use crate::claim_text::{ClaimText, Kind};
use crate::conditions::{Hypothesis, assume, conditions, scalar};
use crate::display::{Told, divisors, readable};
use crate::equation::{Outcome, vanishes, vanishes_or_fails};
use crate::feedback::{Feedback, given_input};
use crate::finding::Finding;
use crate::letters::{Letters, rate};
use crate::lines::Line;
use crate::motion::Motion;
use crate::verdict::{allowed, neither, refute};
use claims::Verdict;
use latex::{Form, Relation, Statement, Term};
use reader::Issue;
use symbolic::{Hypotheses, Sym, normal};

/// The names of a constant without a stated value.
pub(crate) const CONSTANTS: [&str; 3] = [r"\mathrm{const}", r"\text{const}", r"\mathit{const}"];

/// The letters that a formula of this kind may contain; only integrals may contain a constant without a value.
pub(crate) fn known(kind: Kind, letters: &Letters<'_, '_>) -> Vec<String> {
    let mut known = letters.spelt();
    if kind == Kind::IntegralOfMotion {
        known.extend(CONSTANTS.map(str::to_owned));
    }
    known
}

/// Whether a term is a constant without a stated value.
pub(crate) fn is_constant(term: &Term) -> bool {
    matches!(&term.form, Form::Letter(name) if CONSTANTS.contains(&name.as_str()))
}

/// The expression that is claimed to be constant, in the symbols of the model and in the paper's letters.
///
/// # Errors
/// The formula is not an integral of motion.
pub(crate) fn difference(
    claim: &ClaimText,
    statement: &Statement,
    letters: &Letters<'_, '_>,
) -> Result<(Sym, Sym), Issue> {
    let accepted = r"T + V = \mathrm{const}, or an expression that is constant";
    let [chain] = &statement.chains[..] else {
        return Err(Issue::at(claim.formula.span.clone(), "an equivalence is no integral", "here").accepted(accepted));
    };
    let sides: Vec<&Term> = chain.sides.iter().filter(|side| !is_constant(side)).collect();
    if chain.relations.iter().any(|relation| *relation != Relation::Equal) || !(1..=2).contains(&sides.len()) {
        let issue = Issue::at(claim.formula.span.clone(), "an integral is one expression that is constant", "here");
        return Err(issue.accepted(accepted));
    }
    let values: Vec<(Sym, Sym)> =
        sides.iter().map(|side| scalar(&claim.formula, side, letters)).collect::<Result<_, _>>()?;
    Ok(values.into_iter().reduce(|(a, own), (b, other)| (a - b, own - other)).unwrap_or((Sym::ZERO, Sym::ZERO)))
}

/// Judges `T + V = \mathrm{const}`, `T + V = h` or `T + V`: the time derivative of the difference of the sides must vanish.
pub(crate) fn integral(
    claim: &ClaimText,
    statement: &Statement,
    letters: &Letters<'_, '_>,
    assumed: &[Hypothesis],
    finding: &mut Finding,
    record: &mut Record,
) -> Result<(), Issue> {
    let (is, own) = difference(claim, statement, letters)?;
    finding.judged.text = vec![format!("{own} = const")];
    finding.judged.latex = vec![format!(r"{} = \mathrm{{const}}", own.latex())];
    let trace = letters.trace;
    // inputs that hypotheses prescribe are replaced by their values
    let is = Feedback::of(trace, assumed).put_in(is);
    let changing = rate(trace, is).map_err(|why| {
        let title = format!("this expression has no rate along the motion: {why}");
        Issue::at(claim.formula.span.clone(), title, "here").accepted("an expression of positions, speeds and the time")
    })?;
    let mut motion = match Motion::by_equations(trace) {
        Ok(motion) => motion,
        Err(why) => {
            neither(Outcome::Undecided(why), letters, finding);
            return Ok(());
        }
    };
    let free = Motion::by_equations(trace);
    assume(&mut motion, assumed)?;
    finding.allowed = allowed(trace, true);
    let told = Told(letters);
    if let Ok(free) = free {
        let lasting = persistence(assumed, &free, &motion)?;
        finding.judged.requires.extend(divisors(&lasting, told));
    }
    match vanishes_or_fails(&motion, changing, &conditions(&motion, assumed)) {
        Outcome::Zero(found) => {
            record.constant(&motion, assumed, is, None);
            finding.judged.verdict = Verdict::Proved;
            finding.judged.evidence = "normal form of its rate along every motion is zero".to_owned();
            let form = normal(own, &Hypotheses::none()).map(|form| form.to_sym());
            if form.is_ok_and(|form| form.symbols_of().is_empty()) {
                finding.judged.evidence += "; it is a number, so that this says nothing of the model";
            }
            let found = [&found[..], &motion.divisors].concat();
            finding.judged.requires.extend(divisors(&found, told));
        }
        Outcome::NonZero(refutation) => {
            record.constant(&motion, assumed, is, Some(&refutation));
            let line = Line { model: [changing, Sym::ZERO], own: [own, Sym::ZERO] };
            refute(&line, &refutation, &motion, told, finding);
            let at = finding
                .sides
                .take()
                .map_or_else(String::new, |sides| format!(": it is {} at the exact point", sides.left));
            finding.judged.evidence = format!("its rate along the motion does not vanish{at}");
            if let Some(rate) = readable(motion.reduced(changing), [own, Sym::ZERO], &motion, told) {
                finding.judged.evidence += &format!("; the rate is {rate}");
            }
        }
        other => neither(other, letters, finding),
    }
    Ok(())
}

/// The divisors in the proof that hypotheses about the state persist: the time derivative of each vanishes wherever all of them hold.
///
/// # Errors
/// A hypothesis holds only at an instant.
fn persistence(assumed: &[Hypothesis], free: &Motion<'_, '_>, motion: &Motion<'_, '_>) -> Result<Vec<Sym>, Issue> {
    let trace = motion.trace;
    let mut divided = Vec::new();
    for hypothesis in assumed {
        let Some((zero, _)) = hypothesis.equality else { continue };
        if given_input(trace, hypothesis).is_some() {
            continue;
        }
        let outcome = rate(trace, free.reduced(zero)).map(|changing| vanishes(motion, changing, &[]));
        let Ok(Outcome::Zero(found)) = outcome else {
            let title = "a hypothesis on coordinates or speeds holds at an instant alone";
            let issue = Issue::at(hypothesis.at.clone(), title, "its rate does not vanish along every such motion");
            return Err(issue.accepted(
                r"hypotheses that persist: of parameters and inputs, or a state of rest with all its conditions, such as '\theta = 0' with '\dot{\theta} = 0'",
            ));
        };
        divided.extend(found);
    }
    Ok(divided)
}
