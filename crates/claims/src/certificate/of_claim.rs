//! The certificate of a claim of a page.

use super::{Certificate, Part, PartProof, Relation, Relations, Step};
use crate::{Claim, Condition, Judged, Proof, Statement, Theorem, Verdict};
use symbolic::{Decision, Hypotheses, Sym, Witness, decide};

impl Certificate {
    /// The certificate of a claim, followed by those of its corrections.
    pub fn of(claim: &Claim, judged: &Judged) -> Vec<Self> {
        let mut all = vec![Certificate::of_one(claim, judged)];
        if let (Some(claim), Some(judged)) = (&claim.correction, &judged.correction) {
            let corrected = Certificate::of(claim, judged);
            all.extend(corrected.into_iter().map(|one| Certificate { id: format!("{} (correction)", one.id), ..one }));
        }
        all
    }

    fn of_one(claim: &Claim, judged: &Judged) -> Self {
        let certificate = Certificate::for_claim(judged);
        if let Some(reason) = Certificate::reason_without(judged.verdict) {
            return certificate.proved_by(Vec::new(), Vec::new(), reason);
        }
        let mut relations = Relations::default();
        let parts = match &claim.statement {
            Statement::Definition(_) => Vec::new(),
            Statement::Equations { lines, hypotheses } => {
                let lines = lines.iter().map(|line| Condition::Equal(line.derived, line.printed()));
                equalities(lines.collect(), &[], hypotheses, judged.verdict, &mut relations)
            }
            Statement::Theorem(theorem) => of_theorem(theorem, judged.verdict, &mut relations),
        };
        certificate.proved_by(relations.recorder.finished(), parts, "no exact point was found for this verdict")
    }
}

/// The conditions `given` and the equalities of the rules as relations, and the steps that the rules allow.
fn premises(given: &[Condition], rules: &Hypotheses, relations: &mut Relations) -> (Vec<Relation>, Vec<Step>) {
    let mut all = relations.all(given);
    let mut steps = Vec::new();
    relations.rules(rules, &mut all, &mut steps);
    (all, steps)
}

/// One part that states that all equalities hold, or, for a refuted claim, a part about the first equality that fails.
fn equalities(
    then: Vec<Condition>,
    given: &[Condition],
    rules: &Hypotheses,
    verdict: Verdict,
    relations: &mut Relations,
) -> Vec<Part> {
    let (premises, steps) = premises(given, rules, relations);
    let part = |then: Vec<Relation>, proof: PartProof| Part {
        given: premises.clone(),
        steps: steps.clone(),
        rates: Vec::new(),
        then,
        proof,
    };
    if verdict == Verdict::Proved {
        return vec![part(relations.all(&then), PartProof::Identity)];
    }
    let fails = then.iter().find_map(|conclusion| match decide(conclusion.expression(), rules) {
        Decision::NonZero(Witness { point, .. }) if verdict == Verdict::Refuted => {
            Some((*conclusion, PartProof::Counterexample { point: relations.point(&point) }))
        }
        Decision::Undefined(divisor) if verdict == Verdict::Undefined => {
            Some((*conclusion, PartProof::Undefined { divisor: relations.recorder.place(divisor) }))
        }
        _ => None,
    });
    fails.into_iter().map(|(conclusion, proof)| part(vec![relations.of(conclusion)], proof)).collect()
}

fn of_theorem(theorem: &Theorem, verdict: Verdict, relations: &mut Relations) -> Vec<Part> {
    let Theorem { given, then, rules, proof } = theorem;
    if let Proof::NormalForm = proof {
        return equalities(then.clone(), given, rules, verdict, relations);
    }
    let (premises, steps) = premises(given, rules, relations);
    let about: Vec<Sym> = (given.iter().chain(then)).map(|condition| condition.expression()).collect();
    let proof = match proof {
        Proof::Combinations(all) => {
            PartProof::Combination { combinations: all.iter().map(|one| relations.combined(one)).collect() }
        }
        Proof::Signs { positive } => PartProof::Signs { positive: relations.recorder.places(positive.iter().copied()) },
        Proof::Counterexample(point) => PartProof::Counterexample { point: relations.named_point(point, &about) },
        Proof::Example(point) => PartProof::Example { point: relations.named_point(point, &about) },
        Proof::NoRoot { unknown, at } => {
            PartProof::NoRoot { unknown: relations.recorder.place(*unknown), point: relations.named_point(at, &about) }
        }
        Proof::NormalForm => PartProof::Identity,
    };
    vec![Part { given: premises, steps, rates: Vec::new(), then: relations.all(then), proof }]
}
