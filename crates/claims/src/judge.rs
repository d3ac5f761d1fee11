//! Decisions on claims: verdict, evidence and objections.

use crate::premises::told;
use crate::proof::Finding;
use crate::{Claim, Condition, Line, Proof, Statement, Verdict, examine};
use symbolic::{Decision, Dimension, Hypotheses, decide, normal};

/// The largest length in characters of a sentence together with its formulas; in a longer statement the formulas are left out.
const AT_ONCE: usize = 600;

/// A claim with its verdict and evidence. It contains text only, so that it can leave the thread that owns its expressions.
#[derive(Clone, Debug, Default)]
pub struct Judged {
    pub id: String,
    pub section: String,
    pub equation: String,
    pub says: String,
    pub verdict: Verdict,
    pub expected: Verdict,
    /// The statement as LaTeX, one entry for each formula.
    pub latex: Vec<String>,
    /// The statement as text, one entry for each formula.
    pub text: Vec<String>,
    /// Hypotheses, and divisors that must not vanish, each as (text, LaTeX).
    pub requires: Vec<(String, String)>,
    /// Hypotheses about signs, each as (text, LaTeX).
    pub signs: Vec<(String, String)>,
    /// The evidence for the verdict: the method of proof and its result.
    pub evidence: String,
    /// The point at which the claim fails, as pairs (name, exact value).
    pub counterexample: Vec<(String, String)>,
    /// The derived expression minus the printed one as (text, LaTeX); `None` where it is zero.
    pub difference: Option<(String, String)>,
    pub correction: Option<Box<Judged>>,
    /// The reason for which the printed statement fails; empty where it holds.
    pub why: String,
    /// The reading of a damaged or ambiguous text; empty where the printed formula is unambiguous.
    pub reading: String,
    pub note: String,
    /// The objections of the cross-examination; empty for a sound claim.
    pub objections: Vec<String>,
}

impl Judged {
    /// The sentence of the claim, with its formulas where the whole is short enough.
    pub fn statement(&self) -> String {
        let formulas = self.text.join("; ");
        if self.says.is_empty() {
            return formulas;
        }
        let whole = format!("{}: {formulas}", self.says);
        if formulas.is_empty() || whole.chars().count() > AT_ONCE { self.says.clone() } else { whole }
    }

    /// Checks that the verdict is the expected one, also of the correction, and that there are no objections.
    ///
    /// # Errors
    /// A message about the first deviation.
    pub fn sound(&self) -> Result<(), String> {
        if self.verdict != self.expected {
            return Err(format!(
                "{}: expected {}, got {}: {}",
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
    /// Decides the claim and cross-examines it. `dimension` returns the dimensions of the letters of the page.
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

    /// Records mixed dimensions: as evidence against a refuted claim, and as an objection to any other claim.
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
