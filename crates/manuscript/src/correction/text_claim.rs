//! A refuted claim of a paper as the context of edits, which are judged by its model.

use super::edit::Edit;
use super::ground::{Ground, Look, Proof, cleared};
use super::letter_rates::{LetterRate, rates};
use super::lost::{count, lack, lost, lost_on_a_side, sought_values};
use super::places::Places;
use super::probe::{Probe, own_difference, with_formal_functions};
use super::redundancy::{are_alike, common_factors, on_both_sides, redundancies, summands, vanishing_factors};
use crate::admissible::positive_parameters;
use crate::claim_text::{ClaimText, Kind};
use crate::conditions::{Hypothesis, assume, hypotheses};
use crate::finding::Finding;
use crate::inequalities::sides;
use crate::integrals::known;
use crate::letters::{Letters, rate};
use crate::motion::Motion;
use crate::refutation::LONG;
use crate::signs::is_written_as_positive;
use crate::steady_motion::Resting;
use claims::{Condition, Verdict};
use latex::{Form, NoValue, Statement, Term, Value, value};
use symbolic::{Hypotheses, Identity, Sym, decide, identified, normal};

/// The functions by which an edited claim is judged.
pub(crate) struct Judge<'a> {
    /// Reads and decides a claim; `None` if it cannot be read.
    pub decide: &'a dyn Fn(&ClaimText) -> Option<Finding>,
    /// Whether there is time for further edits.
    pub goes_on: &'a dyn Fn() -> bool,
    /// The terms that the right side lacks, as text and LaTeX, if they are known.
    pub missing: Option<&'a (String, String)>,
}

/// A refuted claim with the letters of its paper.
pub(super) struct TextClaim<'a, 't, 'm> {
    pub claim: &'a ClaimText,
    pub letters: &'a Letters<'t, 'm>,
    pub judge: &'a Judge<'a>,
    rates: Vec<LetterRate>,
    /// The differences of the sides of hypotheses, in the symbols of the model.
    given: Vec<Sym>,
    /// The motion under constraints and hypotheses, with the letters of the claim constant.
    allowed: Motion<'t, 'm>,
    probe: Option<Probe<'t, 'm>>,
}

impl<'a, 't, 'm> TextClaim<'a, 't, 'm> {
    pub fn of(
        claim: &'a ClaimText,
        statement: &Statement,
        letters: &'a Letters<'t, 'm>,
        assumed: &[Hypothesis],
        judge: &'a Judge<'a>,
    ) -> Self {
        let probe = match claim.kind {
            Kind::Number => None,
            _ => Probe::of(claim, statement, letters, assumed),
        };
        // rates that vanish on the steady motion cannot correct its condition
        let resting = match claim.kind {
            Kind::SteadyMotion | Kind::Stability => {
                Resting::of(claim, letters).map(|rests| (rests.rates(letters), rests.constant_speeds(letters)))
            }
            _ => Ok((Vec::new(), Vec::new())),
        };
        let (resting, constant) = resting.unwrap_or_default();
        let rests = |rate: &LetterRate| resting.iter().any(|(symbol, _)| *symbol == rate.value);
        let motion = match resting.is_empty() {
            true => Motion::by_equations(letters.trace).ok(),
            false => Some(Motion::at_rest(letters.trace, &resting)),
        };
        let under_hypotheses = |mut motion: Motion<'t, 'm>| {
            // an error is reported where the claim is judged
            let _ = assume(&mut motion, assumed);
            motion
        };
        let motion = motion.map(under_hypotheses);
        let allowed = match resting.is_empty() {
            true => under_hypotheses(Motion::by_constraints(letters.trace)),
            false => under_hypotheses(Motion::at_rest(letters.trace, &resting)),
        };
        // a letter that is a deviation in a linear equation vanishes on the motion about which it is linear
        let is_linear = claim.kind == Kind::LinearisedEquation;
        let vanishes = |value: Sym| !is_linear && motion.as_ref().is_some_and(|motion| vanishes_on(motion, value));
        let with_motion = |rate: LetterRate| LetterRate { vanishes: vanishes(rate.value), ..rate };
        // a condition is not corrected by a rate of a letter that it does not contain, or by a rate that vanishes
        let is_condition =
            matches!(claim.kind, Kind::SteadyMotion | Kind::Stability | Kind::Equivalence | Kind::Inequality);
        let atoms = Places::of(statement, &claim.formula.text).atoms;
        let is_printed =
            |rate: &LetterRate| atoms.iter().any(|atom| atom.name == rate.name) || constant.contains(&rate.value);
        let corrects = |rate: &LetterRate| !is_condition || rate.order == 0 || is_printed(rate) && !rate.vanishes;
        let all = rates(letters).into_iter().filter(|rate| !rests(rate)).map(with_motion);
        let rates = all.filter(corrects).collect();
        let given = hypotheses(&claim.given, letters).unwrap_or_default();
        let given = given.iter().filter_map(|hypothesis| hypothesis.equality.map(|(zero, _)| zero)).collect();
        TextClaim { claim, letters, judge, rates, given, allowed, probe }
    }

    /// The difference of the two sides of a formula in the symbols of the model.
    fn difference(&self, statement: &Statement) -> Option<Sym> {
        let [chain] = &statement.chains[..] else { return None };
        let [left, right] = &chain.sides[..] else { return None };
        match [left, right].map(|side| value(side, &self.letters.in_model())) {
            [Ok(Value::Scalar(left)), Ok(Value::Scalar(right))] => Some(left - right),
            _ => None,
        }
    }

    /// The claim with another formula.
    pub fn edited(&self, text: &str) -> ClaimText {
        let mut claim = self.claim.clone();
        claim.formula = claim.formula.with_text(text.to_owned());
        claim.expected = None;
        claim
    }

    /// The proof of a claim; `None` if it is not proved.
    pub fn proof(&self, claim: &ClaimText) -> Option<Proof> {
        let found = (self.judge.decide)(claim).filter(|finding| is_sound(finding, claim));
        found.map(|Finding { judged, certificate, .. }| Proof { judged, certificate })
    }
}

impl Ground for TextClaim<'_, '_, '_> {
    fn text(&self) -> &str {
        &self.claim.formula.text
    }

    fn known(&self) -> Vec<String> {
        known(self.claim.kind, self.letters)
    }

    fn rates(&self) -> &[LetterRate] {
        &self.rates
    }

    fn own_difference(&self, statement: &Statement) -> Option<Sym> {
        let own = own_difference(statement, self.letters)?;
        // an identity that holds without properties of sines, cosines and roots is one between letters
        Some(if self.claim.kind == Kind::Identity { with_formal_functions(own) } else { own })
    }

    fn redundancies(&self, statement: &Statement) -> usize {
        let scalar = |value: Result<Value, NoValue>| match value {
            Ok(Value::Scalar(value)) => Some(value),
            _ => None,
        };
        let own = |term: &Term| scalar(value(term, &self.letters.in_paper()));
        // a term of an integral that is constant by itself states nothing
        let rests = |term: &&Term| {
            let rate = scalar(value(term, &self.letters.in_model())).map(|value| rate(self.letters.trace, value));
            matches!(rate, Some(Ok(rate)) if decide(rate, &Hypotheses::none()).is_zero())
        };
        let of_kind = match self.claim.kind {
            Kind::IntegralOfMotion => {
                let sides = statement.chains.iter().flat_map(|chain| &chain.sides);
                sides.flat_map(summands).map(|(_, term)| term).filter(rests).count()
            }
            // an inequality that holds for all values of its letters states nothing about the model
            Kind::Inequality => usize::from(sides(self.claim, statement, self.letters).is_ok_and(|sides| {
                let [left, right] = sides.own;
                [left - right, right - left].into_iter().any(|side| is_written_as_positive(side, &[]).is_some())
            })),
            // a stability condition that all models satisfy states nothing
            Kind::Stability => usize::from(sides(self.claim, statement, self.letters).is_ok_and(|sides| {
                let given = hypotheses(&self.claim.given, self.letters).unwrap_or_default();
                let given = given.iter().filter_map(|hypothesis| hypothesis.condition);
                let known: Vec<Condition> = given.chain(positive_parameters(self.letters.trace)).collect();
                is_written_as_positive(sides.greater, &known).is_some()
            })),
            // a formula must define a letter that stands alone on a side
            Kind::Formula => {
                usize::from(!has_quantity_alone(statement, &own)) + usize::from(has_number_for_letter(statement, &own))
            }
            _ => 0,
        };
        // a formula that repeats a hypothesis is not a correction
        let is_given = |zero: Sym| self.given.iter().any(|given| are_alike(zero, *given));
        // for a printed number, the hypotheses are the data
        let states = self.claim.kind != Kind::Number;
        let repeated = usize::from(states && self.difference(statement).is_some_and(is_given));
        // letters that stand for products are compared by their meanings
        let meaning = |term: &Term| scalar(value(term, &self.letters.in_model()));
        // in a linearised equation, letters vanish on the base motion as deviations; so may one composed factor, but not several
        let is_linear = self.claim.kind == Kind::LinearisedEquation;
        let is_deviation = |term: &Term| is_linear && matches!(term.form, Form::Letter(_) | Form::Rate(..));
        let vanishes =
            |term: &Term| !is_deviation(term) && meaning(term).is_some_and(|value| vanishes_on(&self.allowed, value));
        let empty = vanishing_factors(statement, &vanishes).min(if is_linear { 1 } else { usize::MAX });
        let moves = |leaf: Sym| {
            let value = leaf.substitute(&self.letters.meanings(leaf));
            !value.symbols_of().iter().all(|symbol| self.letters.trace.parameters.contains(symbol))
        };
        // an identity between multiples of a sine may have a common factor
        let is_identity = self.claim.kind == Kind::Identity;
        let empty = empty + if is_identity { 0 } else { common_factors(statement, &own, &moves) };
        redundancies(statement, &meaning) + on_both_sides(statement, &own) + of_kind + repeated + empty
    }

    fn has_points(&self) -> bool {
        self.probe.is_some()
    }

    fn look(&self, text: &str, statement: &Statement) -> Look {
        self.probe.as_ref().map_or(Look::Open, |probe| probe.look(&self.edited(text), statement, self.letters))
    }

    fn residual(&self, statement: &Statement) -> Option<Vec<f64>> {
        let probe = self.probe.as_ref()?;
        // the rate of a quotient is not the rate of its numerator
        let cleared = cleared(statement).filter(|_| self.claim.kind != Kind::IntegralOfMotion);
        let of = |statement: &Statement| probe.residual(self.claim, statement, self.letters);
        cleared.as_ref().map_or_else(|| of(statement), |(cleared, _)| of(cleared))
    }

    fn lack(&self, statement: &Statement) -> Option<Sym> {
        lack(statement, self.letters, self.probe.as_ref()?)
    }

    fn sought(&self, statement: &Statement) -> Vec<Sym> {
        self.probe.as_ref().map_or_else(Vec::new, |probe| sought_values(self, statement, probe))
    }

    fn lost(&self, places: &Places, most: usize) -> Vec<Edit> {
        match (&self.probe, self.judge.missing) {
            (Some(probe), _) => lost(self, places, probe, most),
            (None, Some((text, latex))) if self.claim.kind == Kind::SteadyMotion && count(text) <= most => {
                lost_on_a_side(places, self.text(), latex)
            }
            _ => Vec::new(),
        }
    }

    fn proved(&self, text: &str) -> Option<Proof> {
        self.proof(&self.edited(text))
    }

    fn goes_on(&self) -> bool {
        (self.judge.goes_on)()
    }
}

fn vanishes_on(motion: &Motion<'_, '_>, value: Sym) -> bool {
    let reduced = motion.reduced(value);
    let is_free = motion.hypotheses.statements().is_empty();
    // a random point of a prime field shows what the normal form of a long expression would
    if is_free && Sym::operations_of(&[reduced]) > LONG && matches!(identified(&[reduced]), Identity::NotZero) {
        return false;
    }
    normal(reduced, &motion.hypotheses).is_ok_and(|form| form.to_sym() == Sym::ZERO)
}

/// Whether the formula sets a letter equal to a number.
fn has_number_for_letter(statement: &Statement, own: &dyn Fn(&Term) -> Option<Sym>) -> bool {
    let sides: Vec<&Term> = statement.chains.iter().flat_map(|chain| &chain.sides).collect();
    let is_number = |side: &&Term| own(side).is_some_and(|value| value.as_constant().is_some());
    sides.iter().any(|side| matches!(side.form, Form::Letter(_))) && sides.iter().any(is_number)
}

/// Whether a letter or rate stands alone on one side and does not occur on the others.
fn has_quantity_alone(statement: &Statement, own: &dyn Fn(&Term) -> Option<Sym>) -> bool {
    let sides = || statement.chains.iter().flat_map(|chain| &chain.sides);
    let is_letter = |side: &Term| matches!(side.form, Form::Letter(_) | Form::Rate(..));
    sides().enumerate().any(|(place, side)| {
        let others = || sides().enumerate().filter(|(other, _)| *other != place).filter_map(|(_, other)| own(other));
        is_letter(side) && own(side).is_some_and(|letter| others().all(|other| !other.symbols_of().contains(&letter)))
    })
}

/// Whether a claim is proved without objections, and its formula has values inside its domain and not only on its boundary; for printed numbers a proof
/// by enclosures suffices.
fn is_sound(finding: &Finding, claim: &ClaimText) -> bool {
    let verdict = finding.judged.verdict;
    let is_shown =
        verdict == Verdict::Proved && finding.has_inside || verdict == Verdict::Enclosed && claim.kind == Kind::Number;
    is_shown && finding.judged.objections.is_empty()
}
