//! Judging a claim: verdict, evidence and objections.

use crate::premises::told;
use crate::proof::Finding;
use crate::{Claim, Condition, Line, Proof, Statement, Verdict, examine};
use symbolic::{Decision, Dimension, Hypotheses, decide, normal};

/// The most characters of a statement with its formulas; a longer one is its sentence alone.
const AT_ONCE: usize = 600;

/// A claim with its verdict and evidence, as text only: it can leave the thread of its expressions.
#[derive(Clone, Debug, Default)]
pub struct Judged {
    pub id: String,
    pub section: String,
    pub equation: String,
    pub says: String,
    pub verdict: Verdict,
    pub expected: Verdict,
    /// The statement in LaTeX, one entry for each formula.
    pub latex: Vec<String>,
    /// The statement as text, one entry for each formula.
    pub text: Vec<String>,
    /// Hypotheses, and divisors that must not vanish: text and LaTeX.
    pub requires: Vec<(String, String)>,
    /// Hypotheses of sign: text and LaTeX.
    pub signs: Vec<(String, String)>,
    /// The evidence for the verdict: the method of proof and its result.
    pub evidence: String,
    /// The point at which the claim fails: name and exact value.
    pub counterexample: Vec<(String, String)>,
    /// The derived expression less the printed one, text and LaTeX, where it is not zero.
    pub difference: Option<(String, String)>,
    pub correction: Option<Box<Judged>>,
    /// Why the print fails, for a refuted claim.
    pub why: String,
    /// The reading of a damaged or ambiguous text; empty where there was nothing to choose.
    pub reading: String,
    pub note: String,
    /// The objections of the cross-examination: empty for a sound claim.
    pub objections: Vec<String>,
}

impl Judged {
    /// The statement for reading alone: its sentence, and its formulas where both are short enough.
    pub fn statement(&self) -> String {
        let formulas = self.text.join("; ");
        if self.says.is_empty() {
            return formulas;
        }
        let whole = format!("{}: {formulas}", self.says);
        if formulas.is_empty() || whole.chars().count() > AT_ONCE { self.says.clone() } else { whole }
    }

    /// Whether the verdict is the expected one, here and in the correction, and there are no objections.
    pub fn sound(&self) -> Result<(), String> {
        if self.verdict != self.expected {
            return Err(format!(
                "{}: {} was expected, found {}: {}",
                self.id,
                self.expected.name(),
                self.verdict.name(),
                self.evidence
            ));
        }
        if let Some(objection) = self.objections.first() {
            return Err(format!("{}: {objection}", self.id));
        }
        self.correction.as_ref().map_or(Ok(()), |correction| correction.sound())
    }
}

impl Claim {
    /// Decides the claim and cross-examines it. `dimension` gives the dimensions of the page's symbols.
    pub fn judge(&self, dimension: fn(&str) -> Option<Dimension>) -> Judged {
        let mut judged = Judged {
            id: self.id.clone(),
            section: self.section.into(),
            equation: self.equation.into(),
            says: self.says.clone(),
            expected: self.expected,
            why: self.why.clone(),
            reading: self.reading.clone(),
            note: self.note.clone(),
            correction: self.correction.as_ref().map(|correction| Box::new(correction.judge(dimension))),
            ..Judged::default()
        };
        match &self.statement {
            Statement::Definition(lines) => {
                judged.verdict = Verdict::Definition;
                judged.evidence = "introduces names".into();
                judged.show(lines);
            }
            Statement::Equations { lines, hypotheses } => {
                judged.show(lines);
                judged.requires = stated(hypotheses);
                judged.equations(lines, hypotheses);
                judged.objections = examine::equations(lines, hypotheses, dimension);
                judged.mixed(examine::mixed_lines(lines, dimension));
            }
            Statement::Theorem(theorem) => {
                let conclusions = theorem.then.iter().filter(|_| !self.in_words);
                (judged.text, judged.latex) = conclusions.filter_map(|c| c.shown(&theorem.rules)).unzip();
                judged.requires = stated(&theorem.rules);
                for condition in &theorem.given {
                    judged.presuppose(*condition);
                }
                let finding = theorem.decide();
                (judged.verdict, judged.evidence) = (finding.verdict, finding.evidence);
                judged.divided_by(&finding.divisors, &theorem.given);
                if let Proof::Counterexample(point) | Proof::Example(point) | Proof::NoRoot { at: point, .. } =
                    &theorem.proof
                {
                    judged.counterexample =
                        point.values().iter().map(|(name, value)| (name.to_string(), value.to_string())).collect();
                }
                if let (Proof::NormalForm, Verdict::Refuted, Some(witness)) =
                    (&theorem.proof, judged.verdict, theorem.witness())
                {
                    judged.counterexample =
                        witness.point.iter().map(|(name, value)| (name.to_string(), value.to_string())).collect();
                }
                judged.objections = examine::theorem(theorem, dimension);
                judged.mixed(examine::mixed_conclusions(theorem, dimension));
            }
        }
        judged
    }
}

impl Judged {
    fn show(&mut self, lines: &[Line]) {
        self.text = lines.iter().map(|line| format!("{} = {}", line.left, line.right)).collect();
        self.latex = lines.iter().map(Line::latex).collect();
    }

    /// Mixed dimensions are evidence against a false claim, and an objection to one that is said to hold.
    fn mixed(&mut self, mismatches: Vec<String>) {
        match (self.verdict, mismatches.first()) {
            (Verdict::Refuted, Some(first)) => self.evidence += &format!("; {first}"),
            _ => self.objections.extend(mismatches),
        }
    }

    fn equations(&mut self, lines: &[Line], hypotheses: &Hypotheses) {
        (self.verdict, self.evidence) = (Verdict::Proved, "normal form of the difference is zero".into());
        for line in lines {
            let finding = self.line(line, hypotheses);
            self.divided_by(&finding.divisors, &[]);
            if finding.verdict != Verdict::Proved {
                (self.verdict, self.evidence) = (finding.verdict, finding.evidence);
                return;
            }
        }
    }

    fn line(&mut self, line: &Line, hypotheses: &Hypotheses) -> Finding {
        let difference = line.derived - line.printed();
        match decide(difference, hypotheses) {
            Decision::Zero(proof) => Finding { divisors: proof.requires, ..Finding::of(Verdict::Proved, "") },
            Decision::NonZero(witness) => {
                self.counterexample =
                    witness.point.iter().map(|(name, value)| (name.to_string(), value.to_string())).collect();
                self.difference =
                    normal(difference, hypotheses).ok().map(|form| (form.to_string(), form.to_sym().latex()));
                let mut evidence = format!("at the exact point the sides differ by {}", witness.value);
                if !witness.formal.is_empty() {
                    evidence += "; sines and cosines are taken there as independent of their angles";
                }
                Finding::of(Verdict::Refuted, evidence)
            }
            Decision::Undefined(denominator) => {
                Finding::of(Verdict::Undefined, format!("{denominator} vanishes identically"))
            }
            Decision::GaveUp(reason) => Finding::of(Verdict::Undecided, reason),
        }
    }
}

fn stated(hypotheses: &Hypotheses) -> Vec<(String, String)> {
    let equations = hypotheses.statements().iter().map(|&(left, right)| Condition::Equal(left, right));
    equations.map(told).collect()
}
