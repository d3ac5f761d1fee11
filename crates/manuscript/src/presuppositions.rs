//! The presuppositions of a claim: its hypotheses, and the domain of its formula. If no point satisfies them, the claim is vacuous.

use crate::claim_text::{ClaimText, Kind};
use crate::conditions::{Hypothesis, assume, conditions};
use crate::domains::{NoValue, domains};
use crate::equation::Outcome;
use crate::extent::{Contradiction, contradiction, has_inside, is_met};
use crate::finding::Finding;
use crate::half_turn;
use crate::letters::Letters;
use crate::motion::Motion;
use crate::paper_text::PaperText;
use crate::verdict::neither;
use claims::{Condition, Verdict};
use latex::Statement;
use reader::Issue;
use symbolic::Sym;

/// The hypotheses `assumed` of a claim that state a sign or that an expression is not zero, after the hypotheses that are equalities were inserted
/// into them. `kind` says whether the equations of motion or only the constraints hold.
///
/// # Errors
/// The hypotheses contradict each other.
pub(crate) fn where_they_hold(
    paper: &PaperText,
    kind: Kind,
    assumed: &[Hypothesis],
    letters: &Letters<'_, '_>,
) -> Result<Vec<Condition>, Issue> {
    let is_acceleration = |symbol: &Sym| letters.trace.accelerations.contains(symbol);
    let conditions_of = || assumed.iter().filter_map(|hypothesis| hypothesis.condition);
    let is_dynamic = conditions_of().any(|condition| condition.expression().symbols_of().iter().any(is_acceleration));
    let constrained = || Motion::by_constraints(letters.trace);
    let base = match kind {
        Kind::Identity | Kind::LinearisedEquation => constrained(),
        _ if is_dynamic => Motion::by_equations(letters.trace).unwrap_or_else(|_| constrained()),
        _ => constrained(),
    };
    let mut motion = base.clone();
    // an error is reported where the claim is judged
    let is_assumed = assume(&mut motion, assumed).is_ok();
    let there = match is_assumed {
        true => conditions(&motion, assumed),
        false => conditions_of().collect(),
    };
    if there.is_empty() || motion.squares.is_empty() && is_met(&there) {
        return Ok(there);
    }
    match contradiction(&base, assumed, &[]) {
        Some(Contradiction { hypotheses, .. }) => {
            let printed: Vec<&Hypothesis> = printed(&hypotheses, assumed).collect();
            let each = printed.iter().map(|one| of_line(paper, one)).collect::<Vec<_>>().join(", ");
            let title = format!("these hypotheses contradict each other, so that nothing is claimed: {each}");
            let last = printed.last().map_or(0..0, |one| one.at.clone());
            Err(Issue::at(last, title, "excluded by the others").accepted("hypotheses that hold together"))
        }
        None => Ok(there),
    }
}

/// The hypotheses with these indices except the bounds of π, which are not in the file.
fn printed<'a>(places: &'a [usize], assumed: &'a [Hypothesis]) -> impl Iterator<Item = &'a Hypothesis> {
    let is_bound = |one: &Hypothesis| one.condition.is_some_and(|condition| half_turn::bounds().contains(&condition));
    places.iter().map(|&place| &assumed[place]).filter(move |one| !is_bound(one))
}

/// A hypothesis as text, with its line in the file.
fn of_line(paper: &PaperText, hypothesis: &Hypothesis) -> String {
    format!("`{}` (line {})", hypothesis.told.0, paper.line_of(&hypothesis.at))
}

/// Adds the domain of a formula to the requirements of a finding. A formula without a value at any point that satisfies its hypotheses is undefined.
pub(crate) fn presupposed(
    paper: &PaperText,
    claim: &ClaimText,
    statement: &Statement,
    letters: &Letters<'_, '_>,
    (assumed, there): (&[Hypothesis], &[Condition]),
    finding: &mut Finding,
) {
    let constrained = || Motion::by_constraints(letters.trace);
    let base = match claim.kind {
        Kind::Identity | Kind::LinearisedEquation => constrained(),
        _ => Motion::by_equations(letters.trace).unwrap_or_else(|_| constrained()),
    };
    let mut motion = base.clone();
    // an error has been reported where the claim was judged
    if assume(&mut motion, assumed).is_err() {
        return;
    }
    let is_open = matches!(finding.judged.verdict, Verdict::Proved | Verdict::Undecided);
    let demands = match domains(statement, letters, &motion, assumed, there) {
        Ok(demands) => demands,
        Err(NoValue::Divisor(of)) if is_open => return neither(Outcome::Undefined(of), letters, finding),
        Err(NoValue::Logarithm(of)) if is_open => {
            let told = letters.told(of);
            finding.judged.verdict = Verdict::Undefined;
            finding.judged.evidence =
                format!("it has the logarithm of {told}, which vanishes wherever the model and the hypotheses hold");
            return;
        }
        Err(_) => return,
    };
    let found = (!demands.is_empty()).then(|| contradiction(&base, assumed, &demands)).flatten();
    if let Some(Contradiction { hypotheses, demands: demanded }) = found {
        let asked: Vec<&str> = demanded.iter().map(|&place| demands[place].told.0.as_str()).collect();
        let given: Vec<String> = printed(&hypotheses, assumed).map(|one| of_line(paper, one)).collect();
        let beside = match given.is_empty() {
            true => "which no point satisfies".to_owned(),
            false => format!("which is satisfied nowhere together with {}", given.join(", ")),
        };
        finding.judged.verdict = Verdict::Undefined;
        finding.judged.evidence =
            format!("the formula has a value nowhere: its parts ask for {}, {beside}", asked.join(" and "));
    } else if finding.judged.verdict == Verdict::Proved {
        finding.has_inside = has_inside(&motion, there, &demands);
        for demand in demands.into_iter().filter(|demand| !demand.is_shown) {
            if !finding.judged.requires.contains(&demand.told) {
                finding.judged.requires.push(demand.told);
            }
        }
    }
}
