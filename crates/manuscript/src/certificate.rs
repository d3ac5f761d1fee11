//! Certificates of findings: the sides of a formula as read, the equations of the model, and the steps of the proof.

use crate::condition_products;
use crate::conditions::Hypothesis;
use crate::consequence::{Step, Way};
use crate::equation::Outcome;
use crate::line_signs::least;
use crate::linear_equations::{Comparison, HURWITZ, LinearEquations, Multiple};
use crate::motion::Motion;
use crate::natural_domain::natural_domain;
use crate::premises::premises;
use crate::refutation::Refutation;
use crate::square_sums::{SquareSum, square_sum};
use claims::Condition;
use claims::certificate::{Certificate, Combined, Part, PartProof, Relation, Relations, Stability};
use claims::{Judged, Verdict};
use symbolic::{Hypotheses, NotNormal, Sym, normal};

/// Records the proof of a finding, if a certificate is requested.
#[derive(Default)]
pub(crate) struct Record {
    is_wanted: bool,
    /// Whether a step of the proof cannot be certified.
    is_incomplete: bool,
    relations: Relations,
    parts: Vec<Part>,
}

impl Record {
    pub fn of(is_wanted: bool) -> Self {
        Record { is_wanted, ..Record::default() }
    }

    /// Discards the recorded steps and starts a new proof.
    pub fn restart(&mut self) {
        *self = Record::of(self.is_wanted);
    }

    pub fn is_wanted(&self) -> bool {
        self.is_wanted
    }

    /// Records that a step of the proof cannot be certified.
    pub fn leave_out(&mut self) {
        self.is_incomplete = true;
    }

    /// Records conclusions about a motion with their proof.
    pub fn part(
        &mut self,
        motion: &Motion<'_, '_>,
        assumed: &[Hypothesis],
        then: &[Condition],
        proof: impl FnOnce(&mut Relations) -> PartProof,
    ) {
        if self.is_wanted {
            let (given, steps) = premises(motion, assumed, &mut self.relations);
            let then = self.relations.all(then);
            let proof = proof(&mut self.relations);
            self.parts.push(Part { given, steps, rates: Vec::new(), then, proof });
        }
    }

    /// Records a step of an equivalence: `then` is zero where `zero` is, or differs from zero at an exact point there.
    pub fn step(
        &mut self,
        motion: &Motion<'_, '_>,
        assumed: &[Hypothesis],
        [zero, then]: [Sym; 2],
        step: &Step<'_, '_>,
    ) {
        match step {
            Step::Follows(_, Way::Solved(there)) => self.vanishes(there, assumed, &[Condition::Zero(then)]),
            Step::Follows(_, Way::Multiple(factor)) => self.multiple(motion, assumed, [zero, then], *factor),
            Step::Fails(refutation) => self.fails_where(motion, assumed, &[zero], then, refutation),
            Step::Follows(_, Way::Signs | Way::Factors) => self.leave_out(),
            Step::Open(_) => {}
        }
    }

    /// Records that `then` is zero because it is `factor` times `zero`.
    fn multiple(&mut self, motion: &Motion<'_, '_>, assumed: &[Hypothesis], [zero, then]: [Sym; 2], factor: Sym) {
        let before = self.parts.len();
        self.vanishes(motion, assumed, &[Condition::Zero(then)]);
        for part in &mut self.parts[before..] {
            let cofactors = vec![(part.given.len(), self.relations.recorder.place(factor))];
            let one = Combined { multiplier: Vec::new(), cofactors, factor: None };
            part.proof = PartProof::Combination { combinations: vec![one] };
            part.given.push(self.relations.of(Condition::Zero(zero)));
        }
    }

    /// Records an exact point at which some expressions vanish and another one does not.
    pub fn fails_where(
        &mut self,
        motion: &Motion<'_, '_>,
        assumed: &[Hypothesis],
        zeros: &[Sym],
        then: Sym,
        refutation: &Refutation,
    ) {
        let before = self.parts.len();
        self.fails(motion, assumed, Condition::Zero(then), refutation);
        for part in &mut self.parts[before..] {
            part.given.extend(zeros.iter().map(|&zero| self.relations.of(Condition::Zero(zero))));
        }
    }

    /// Records conclusions whose sides have a vanishing difference.
    pub fn vanishes(&mut self, motion: &Motion<'_, '_>, assumed: &[Hypothesis], then: &[Condition]) {
        self.part(motion, assumed, then, |_| PartProof::Identity);
    }

    /// Records an exact point at which a conclusion fails.
    pub fn fails(&mut self, motion: &Motion<'_, '_>, assumed: &[Hypothesis], then: Condition, refutation: &Refutation) {
        // if a step of the solution divides by zero at the point, its letters have no values there
        let is_defined = |symbol: Sym| {
            let value = motion.reduced(symbol).substitute(&refutation.point);
            !matches!(normal(value, &Hypotheses::none()), Err(NotNormal::Undefined(_)))
        };
        let mut solved = motion.rounds.iter().flat_map(|round| &round.values);
        if self.is_wanted && solved.all(|&(symbol, _)| is_defined(symbol)) {
            self.part(motion, assumed, &[then], |relations| PartProof::Counterexample {
                point: relations.point(&refutation.point),
            });
        }
    }

    /// Records a divisor that vanishes on the motion, or a difference that was shown to be zero only in prime fields.
    pub fn undecided(&mut self, motion: &Motion<'_, '_>, assumed: &[Hypothesis], then: Condition, outcome: &Outcome) {
        match outcome {
            // a program cannot contain a written division by zero
            Outcome::Undefined(divisor) if [*divisor, then.expression()].contains(&Sym::UNDEFINED) => self.leave_out(),
            Outcome::Undefined(divisor) => self.part(motion, assumed, &[then], |relations| PartProof::Undefined {
                divisor: relations.recorder.place(*divisor),
            }),
            Outcome::Identified(_) => self.vanishes(motion, assumed, &[then]),
            _ => {}
        }
    }

    /// Records that the time derivative of an expression is zero along the motion, or, with a refutation, that it differs from zero at a point.
    pub fn constant(
        &mut self,
        motion: &Motion<'_, '_>,
        assumed: &[Hypothesis],
        is: Sym,
        refutation: Option<&Refutation>,
    ) {
        if self.is_wanted {
            let (given, steps) = premises(motion, assumed, &mut self.relations);
            let (left, right) = (self.relations.recorder.place(is), self.relations.recorder.place(Sym::ZERO));
            let trace = motion.trace;
            let moving = [&trace.coordinates[..], &trace.speeds, &[trace.time]].concat();
            let rates = moving.into_iter().map(|letter| {
                let recorder = &mut self.relations.recorder;
                (recorder.place(letter), recorder.place(trace.rate_of(letter)))
            });
            let rates = rates.collect();
            let proof = match refutation {
                None => PartProof::Identity,
                Some(found) => PartProof::Counterexample { point: self.relations.point(&found.point) },
            };
            self.parts.push(Part { given, steps, rates, then: vec![Relation { is: "rate", left, right }], proof });
        }
    }

    /// Records a linearisation. `printed` is replaced by `form`, which is equal along every motion; its value and its first derivatives by letters
    /// vanish on the base motion, or one of them (named in `failure`; `None`: the value) differs from zero at a point.
    pub fn linear(
        &mut self,
        [along, base]: [&Motion<'_, '_>; 2],
        assumed: &[Hypothesis],
        [printed, form]: [Sym; 2],
        letters: &[Sym],
        failure: Option<(Option<Sym>, &Refutation)>,
    ) {
        if !self.is_wanted {
            return;
        }
        match failure {
            None => {
                self.vanishes(along, &[], &[Condition::Equal(printed, form)]);
                self.vanishes(base, assumed, &[Condition::Zero(form)]);
            }
            Some((None, refutation)) => return self.fails(base, assumed, Condition::Zero(form), refutation),
            Some(_) => {}
        }
        let deviation = |letter: Sym| Sym::symbol(&format!("deviation of {letter}"));
        let (given, steps) = premises(base, assumed, &mut self.relations);
        let recorder = &mut self.relations.recorder;
        let then = Relation { is: "rate", left: recorder.place(form), right: recorder.place(Sym::ZERO) };
        let rates = letters.iter().map(|&letter| (recorder.place(letter), recorder.place(deviation(letter)))).collect();
        let proof = match failure {
            Some((by, refutation)) => {
                let one = |letter: &Sym| if Some(*letter) == by { Sym::ONE } else { Sym::ZERO };
                let mut point = refutation.point.clone();
                point.extend(letters.iter().map(|letter| (deviation(*letter), one(letter))));
                PartProof::Counterexample { point: self.relations.point(&point) }
            }
            None => PartProof::Identity,
        };
        self.parts.push(Part { given, steps, rates, then: vec![then], proof });
    }

    /// Records that an expression is positive because all terms of its normal form are.
    pub fn positive(&mut self, motion: &Motion<'_, '_>, assumed: &[Hypothesis], greater: Sym) {
        let positive = assumed.iter().filter_map(|hypothesis| match hypothesis.condition {
            Some(Condition::Positive(letter)) if letter.symbol_name().is_some() => Some(letter),
            _ => None,
        });
        self.part(motion, assumed, &[Condition::Positive(greater)], |relations| PartProof::Signs {
            positive: relations.recorder.places(positive),
        });
    }

    /// Records that an expression is positive because all its terms, without simplification, are; `side` is the expression after the steps.
    pub fn positive_as_written(
        &mut self,
        motion: &Motion<'_, '_>,
        assumed: &[Hypothesis],
        [greater, side]: [Sym; 2],
        is_strict: bool,
    ) {
        self.vanishes(motion, assumed, &[Condition::Equal(greater, side)]);
        self.part(motion, assumed, &[Condition::Positive(side)], |_| PartProof::WrittenSigns);
        self.weaken(is_strict);
    }

    /// Records that an expression is positive as a sum of squares, where necessary under the conditions for its having a value.
    pub fn positive_by_squares(
        &mut self,
        motion: &Motion<'_, '_>,
        assumed: &[Hypothesis],
        [greater, reduced]: [Sym; 2],
        is_strict: bool,
        conditions: &[Condition],
    ) {
        if !self.is_wanted {
            return;
        }
        if let Some(SquareSum { written, known }) = square_sum(reduced, is_strict, conditions) {
            self.positive_as_written(motion, assumed, [greater, written], is_strict);
            let known = self.relations.all(&known);
            if let Some(part) = self.parts.last_mut() {
                part.given.extend(known);
            }
        }
    }

    /// Records that an expression is positive by products of conditions, among them the negated conclusion.
    pub fn positive_by_products(
        &mut self,
        motion: &Motion<'_, '_>,
        assumed: &[Hypothesis],
        reduced: Sym,
        is_strict: bool,
        conditions: &[Condition],
    ) {
        if !self.is_wanted {
            return;
        }
        match condition_products::proof(reduced, is_strict, conditions) {
            Some((known, products)) => {
                let known = &known[..known.len() - 1];
                let part = self.shown_by_signs(motion, assumed, (reduced, is_strict), known, Some(&products));
                self.parts.push(part);
            }
            None => self.positive_by_roots(motion, assumed, reduced, is_strict, conditions),
        }
    }

    /// A part which states that an expression is positive (or not negative) under conditions, by the given products or by its written terms.
    pub fn shown_by_signs(
        &mut self,
        motion: &Motion<'_, '_>,
        assumed: &[Hypothesis],
        (expression, is_strict): (Sym, bool),
        known: &[Condition],
        products: Option<&[condition_products::Product]>,
    ) -> Part {
        let (mut given, steps) = premises(motion, assumed, &mut self.relations);
        let before = given.len();
        given.extend(self.relations.all(known));
        let mut then = self.relations.of(Condition::Positive(expression));
        then.is = if is_strict { ">" } else { ">=" };
        let proof = products.map_or(PartProof::WrittenSigns, |products| {
            let told = products.iter().map(|one| one.told(before, &mut self.relations)).collect();
            PartProof::Products { products: told }
        });
        Part { given, steps, rates: Vec::new(), then: vec![then], proof }
    }

    /// Records that an expression in one unknown is positive, by real roots of polynomials.
    fn positive_by_roots(
        &mut self,
        motion: &Motion<'_, '_>,
        assumed: &[Hypothesis],
        reduced: Sym,
        is_strict: bool,
        conditions: &[Condition],
    ) {
        let known = [conditions, &natural_domain(&[reduced])].concat();
        if least(reduced, &known).is_some_and(|least| least.sign > 0 || least.sign == 0 && !is_strict) {
            self.part(motion, assumed, &[Condition::Positive(reduced)], |_| PartProof::RealRoots);
            self.weaken(is_strict);
            let known = self.relations.all(&known);
            if let Some(part) = self.parts.last_mut() {
                part.given.extend(known);
            }
        }
    }

    /// Weakens the conclusion of the last part from `>` to `>=`, unless `is_strict`.
    fn weaken(&mut self, is_strict: bool) {
        if let (Some(part), false) = (self.parts.last_mut(), is_strict) {
            part.then.iter_mut().for_each(|relation| relation.is = ">=");
        }
    }

    /// Records an exact point at which an expression is negative, or zero although the claim states that it is positive.
    pub fn is_below(
        &mut self,
        motion: &Motion<'_, '_>,
        assumed: &[Hypothesis],
        greater: Sym,
        is_strict: bool,
        refutation: &Refutation,
    ) {
        self.fails(motion, assumed, Condition::Positive(greater), refutation);
        self.weaken(is_strict);
    }

    /// Records the comparison of a printed stability condition with the condition on the eigenvalues.
    pub fn stability(
        &mut self,
        motion: &Motion<'_, '_>,
        assumed: &[Hypothesis],
        linear: &LinearEquations,
        printed: Sym,
        shown: Comparison,
    ) {
        if !self.is_wanted {
            return;
        }
        let (given, steps) = premises(motion, assumed, &mut self.relations);
        let relations = &mut self.relations;
        let conditions = assumed.iter().filter(|hypothesis| hypothesis.condition.is_some()).count();
        // the conditions are the last relations of `given`
        let place = |place: usize| given.len() - conditions + place;
        let (ratio, point) = match shown {
            Comparison::Same(Multiple { ratio, square }) => {
                let square = square.map(|(of, power)| (place(of), power));
                (Some((relations.recorder.place(ratio), square)), None)
            }
            Comparison::Other(refutation) => (None, Some(relations.point(&refutation.point))),
        };
        let trace = motion.trace;
        let mut places = |expressions: &[Sym]| relations.recorder.places(expressions.iter().copied());
        let stability = Stability {
            theorem: HURWITZ,
            equations: places(&linear.equations),
            coordinates: places(&trace.coordinates),
            speeds: places(&trace.speeds),
            accelerations: places(&trace.accelerations),
            resting: linear.resting.clone(),
            root: places(&[linear.root])[0],
            scale: places(&[linear.scale])[0],
            coefficients: places(&linear.coefficients),
            neutral: linear.neutral,
            printed: places(&[printed])[0],
            ratio,
            point,
        };
        let then = vec![relations.of(Condition::Positive(printed))];
        let proof = PartProof::Stability(Box::new(stability));
        self.parts.push(Part { given, steps, rates: Vec::new(), then, proof });
    }

    /// The certificate of a claim with its final verdict; `None` if none is requested.
    pub fn finished(self, judged: &Judged, otherwise: &str) -> Option<Certificate> {
        if !self.is_wanted {
            return None;
        }
        let certificate = Certificate::for_claim(judged);
        if let Some(reason) = Certificate::reason_without(judged.verdict).filter(|_| self.parts.is_empty()) {
            return Some(certificate.proved_by(Vec::new(), Vec::new(), reason));
        }
        // only parts that support the verdict; lines before a failing one also hold
        let says = |part: &Part| match part.proof {
            PartProof::Counterexample { .. } | PartProof::Excluded => judged.verdict == Verdict::Refuted,
            PartProof::Stability(_) => true,
            PartProof::Undefined { .. } => judged.verdict == Verdict::Undefined,
            _ => matches!(judged.verdict, Verdict::Proved | Verdict::Identified | Verdict::Tested | Verdict::Enclosed),
        };
        let parts = self.parts.into_iter().filter(says).filter(|_| !self.is_incomplete).collect();
        Some(certificate.proved_by(self.relations.recorder.finished(), parts, otherwise))
    }
}
