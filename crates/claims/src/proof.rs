//! Proofs and disproofs of theorems.

use crate::univariate::{polynomial, vanish_at_zero_alone};
use crate::{Condition, Point, Theorem, Verdict};
use num_traits::{One, Zero};
use symbolic::{Decision, Hypotheses, Sym, Witness, coefficients, decide, normal};

/// A proof or a disproof of an implication. All of them are verified by exact arithmetic.
#[derive(Clone, Debug)]
pub enum Proof {
    /// For each conclusion, an equality, the difference of the sides has the normal form zero under the rules alone.
    NormalForm,
    /// A combination for each conclusion. For f = 0: m f = Σ c_k g_k identically, where g_k = 0 are given equalities and the multiplier m is
    /// a product of expressions given as non-zero or positive. For f ≠ 0: d f = m + Σ c_k g_k with any factor d.
    Combinations(Vec<Combination>),
    /// Every conclusion f > 0 (or f ≠ 0) holds because f is a quotient of polynomials whose coefficients have one sign, in
    /// symbols that are positive or occur only to even powers. Where all terms could vanish together, a given
    /// condition excludes that the symbols involved all vanish.
    Signs { positive: Vec<Sym> },
    /// An exact point at which all given conditions hold and a conclusion fails.
    Counterexample(Point),
    /// An exact point of all letters except the unknown, at which the conclusions are polynomials in the unknown without a
    /// common root other than zero, so that no value of the unknown satisfies them.
    NoRoot { unknown: Sym, at: Point },
    /// For a theorem of existence: an exact point at which all given conditions and all conclusions hold.
    Example(Point),
}

/// The certificate of one conclusion in [`Proof::Combinations`].
#[derive(Clone, Debug, Default)]
pub struct Combination {
    /// The indices of the given conditions whose expressions multiply to m; empty for m = 1.
    pub multiplier: Vec<usize>,
    /// Pairs (index of the given condition g_k, cofactor c_k).
    pub cofactors: Vec<(usize, Sym)>,
    /// The factor d, for a conclusion f ≠ 0.
    pub factor: Option<Sym>,
}

/// The result of the verification of a proof.
pub(crate) struct Finding {
    pub verdict: Verdict,
    /// The reason in a few words.
    pub evidence: String,
    /// The divisors of the proof, none of which may vanish.
    pub divisors: Vec<Sym>,
}

impl Finding {
    pub fn of(verdict: Verdict, evidence: impl Into<String>) -> Self {
        Finding { verdict, evidence: evidence.into(), divisors: Vec::new() }
    }
}

impl Theorem {
    pub(crate) fn decide(&self) -> Finding {
        match &self.proof {
            Proof::NormalForm => self.all(|_, conclusion| self.follows(conclusion)),
            Proof::Combinations(certificates) => self.all(|k, conclusion| match certificates.get(k) {
                Some(certificate) => self.combine(certificate, conclusion),
                None => Finding::of(Verdict::Open, format!("no certificate is given for {conclusion}")),
            }),
            Proof::Signs { positive } => self.all(|_, conclusion| self.sign(positive, conclusion)),
            Proof::Counterexample(point) => self.refute(point),
            Proof::NoRoot { unknown, at } => self.without_root(*unknown, at),
            Proof::Example(point) => {
                match self.given.iter().chain(&self.then).find(|c| c.holds_at(point) != Some(true)) {
                    Some(condition) => {
                        Finding::of(Verdict::Undecided, format!("the example does not satisfy {condition}"))
                    }
                    None => Finding::of(Verdict::Proved, "an exact example"),
                }
            }
        }
    }

    fn all(&self, check: impl Fn(usize, Condition) -> Finding) -> Finding {
        let findings = self.then.iter().enumerate().map(|(k, &conclusion)| check(k, conclusion));
        let mut last = Finding::of(Verdict::Open, "nothing is concluded");
        let mut divisors = Vec::new();
        for finding in findings {
            if finding.verdict != Verdict::Proved {
                return finding;
            }
            divisors.extend(finding.divisors);
            last = Finding { divisors: Vec::new(), ..finding };
        }
        Finding { divisors, ..last }
    }

    /// The first counterexample among those that the normal forms of the conclusions (equalities) give: an exact point at which all given
    /// conditions hold and a conclusion fails.
    pub(crate) fn witness(&self) -> Option<Witness> {
        self.then.iter().find_map(|conclusion| match decide(conclusion.expression(), &self.rules) {
            Decision::NonZero(witness) => Some(witness).filter(|witness| self.admits(witness)),
            _ => None,
        })
    }

    /// Whether the given conditions hold at the point of a witness; the rules hold at every witness.
    fn admits(&self, witness: &Witness) -> bool {
        let values = witness.point.iter().filter_map(|(symbol, value)| Some((*symbol, value.as_constant()?)));
        let point = Point::of(values);
        self.given.iter().all(|condition| condition.holds_at(&point) == Some(true))
    }

    fn follows(&self, conclusion: Condition) -> Finding {
        match decide(conclusion.expression(), &self.rules) {
            Decision::NonZero(witness) if self.admits(&witness) => {
                Finding::of(Verdict::Refuted, format!("the difference is not zero: {witness}"))
            }
            _ => self.vanishes(conclusion.expression()),
        }
    }

    fn vanishes(&self, expression: Sym) -> Finding {
        match decide(expression, &self.rules) {
            Decision::Zero(proof) => {
                Finding { divisors: proof.requires, ..Finding::of(Verdict::Proved, "normal form zero") }
            }
            // the failure is one of this proof and refutes only the proof, not the statement
            Decision::NonZero(_) => Finding::of(Verdict::Undecided, "the proof that is given does not show it"),
            Decision::Undefined(denominator) => {
                Finding::of(Verdict::Undefined, format!("{denominator} vanishes identically"))
            }
            Decision::GaveUp(reason) => Finding::of(Verdict::Undecided, reason.to_string()),
        }
    }

    fn combine(&self, certificate: &Combination, conclusion: Condition) -> Finding {
        let mut multiplier = Sym::one();
        for &k in &certificate.multiplier {
            match self.given.get(k) {
                Some(Condition::NonZero(factor) | Condition::Positive(factor)) => multiplier *= *factor,
                _ => return Finding::of(Verdict::Open, format!("given {k} is not said to differ from zero")),
            }
        }
        let mut sum = Sym::zero();
        for &(k, cofactor) in &certificate.cofactors {
            match self.given.get(k) {
                Some(relation @ (Condition::Zero(_) | Condition::Equal(..))) => sum += cofactor * relation.expression(),
                _ => return Finding::of(Verdict::Open, format!("given {k} is no equality")),
            }
        }
        let gap = match (conclusion, certificate.factor) {
            (Condition::Zero(_) | Condition::Equal(..), None) => multiplier * conclusion.expression() - sum,
            (Condition::NonZero(f), Some(factor)) => factor * f - multiplier - sum,
            _ => return Finding::of(Verdict::Open, format!("no such certificate shows {conclusion}")),
        };
        match self.vanishes(gap) {
            proved if proved.verdict == Verdict::Proved => {
                Finding { evidence: "linear combination of the given equations".into(), ..proved }
            }
            finding => finding,
        }
    }

    fn without_root(&self, unknown: Sym, at: &Point) -> Finding {
        let free = |c: &&Condition| !c.expression().symbols_of().contains(&unknown);
        if let Some(condition) = self.given.iter().filter(free).find(|c| c.holds_at(at) != Some(true)) {
            return Finding::of(Verdict::Undecided, format!("the counterexample does not satisfy {condition}"));
        }
        let polynomials: Option<Vec<_>> =
            self.then.iter().map(|c| polynomial(at.restrict(c.expression(), unknown), unknown)).collect();
        match polynomials.map(vanish_at_zero_alone) {
            Some(true) => {
                Finding::of(Verdict::Refuted, format!("no {unknown} other than zero satisfies the conclusion there"))
            }
            Some(false) => Finding::of(Verdict::Undecided, format!("some {unknown} satisfies the conclusion there")),
            None => Finding::of(Verdict::Undecided, "the conclusion is no polynomial there"),
        }
    }

    fn sign(&self, positive: &[Sym], conclusion: Condition) -> Finding {
        if let Some(stranger) = positive.iter().find(|s| !self.given.contains(&Condition::Positive(**s))) {
            return Finding::of(Verdict::Open, format!("{stranger} > 0 is not given"));
        }
        let nonzero = |symbol: &Sym| self.given.contains(&Condition::NonZero(*symbol));
        let strictly = |polynomial: Sym| {
            let (sign, vanishing) = weak_sign(polynomial, positive, &nonzero)?;
            let excluded = vanishing.is_none_or(|all| self.given.iter().any(|c| excludes(*c, &all)));
            excluded.then_some(sign)
        };
        let form = match normal(conclusion.expression(), &self.rules) {
            Ok(form) => form,
            Err(reason) => return Finding::of(Verdict::Undecided, reason.to_string()),
        };
        let sign = match (strictly(form.numerator()), strictly(form.denominator())) {
            (Some(a), Some(b)) => a * b,
            _ => return Finding::of(Verdict::Undecided, format!("the terms of {form} differ in sign")),
        };
        let finding = match conclusion {
            Condition::Positive(_) if sign > 0 => Finding::of(Verdict::Proved, "every term is positive"),
            Condition::NonZero(_) => Finding::of(Verdict::Proved, "all terms have one sign"),
            _ => Finding::of(Verdict::Undecided, "every term is negative"),
        };
        Finding { divisors: form.requires().to_vec(), ..finding }
    }

    fn refute(&self, point: &Point) -> Finding {
        if let Some(condition) = self.given.iter().find(|c| c.holds_at(point) != Some(true)) {
            return Finding::of(Verdict::Undecided, format!("the counterexample does not satisfy {condition}"));
        }
        match self.then.iter().find(|c| c.holds_at(point) == Some(false)) {
            Some(condition) => {
                let said = condition.shown(&self.rules).map_or("the conclusion".into(), |(text, _)| text);
                Finding::of(Verdict::Refuted, format!("{said} fails"))
            }
            None => Finding::of(Verdict::Undecided, "the conclusion holds at the supposed counterexample"),
        }
    }
}

/// The sign of a polynomial, 1 or -1, if all its terms have this sign and it cannot vanish; `None` otherwise.
pub(crate) fn one_sign(polynomial: Sym, positive: &[Sym], nonzero: &impl Fn(&Sym) -> bool) -> Option<i32> {
    weak_sign(polynomial, positive, nonzero).and_then(|(sign, vanishing)| vanishing.is_none().then_some(sign))
}

/// The sign of a polynomial whose terms all have it, 1 or -1, and the symbols that all vanish wherever the polynomial
/// does (`None` where the polynomial does not vanish).
fn weak_sign(polynomial: Sym, positive: &[Sym], nonzero: &impl Fn(&Sym) -> bool) -> Option<(i32, Option<Vec<Sym>>)> {
    let symbols = polynomial.symbols_of();
    let terms = coefficients(polynomial, &symbols).ok()?;
    let mut common = 0;
    let mut strict = false;
    let mut vanishing = Vec::new();
    for (exponents, coefficient) in terms {
        let sign = coefficient.as_constant()?.sign()?;
        let mut open = Vec::new();
        for (symbol, exponent) in symbols.iter().zip(exponents) {
            if exponent > 0 && !positive.contains(symbol) {
                if exponent % 2 == 1 {
                    return None;
                }
                if !nonzero(symbol) {
                    open.push(*symbol);
                }
            }
        }
        if common != 0 && sign != common {
            return None;
        }
        common = sign;
        strict |= open.is_empty();
        if let [alone] = open[..] {
            vanishing.push(alone);
        }
    }
    (common != 0).then(|| (common, (!strict).then_some(vanishing)))
}

/// Whether a condition implies that these symbols do not all vanish.
fn excludes(condition: Condition, all: &[Sym]) -> bool {
    let zero: Vec<(Sym, Sym)> = all.iter().map(|symbol| (*symbol, Sym::ZERO)).collect();
    match condition {
        Condition::NonZero(e) | Condition::Positive(e) => decide(e.substitute(&zero), &Hypotheses::none()).is_zero(),
        Condition::Zero(_) | Condition::Equal(..) | Condition::NotNegative(_) => false,
    }
}
