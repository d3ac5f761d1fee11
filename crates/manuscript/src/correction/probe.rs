//! Test points of the motion, at which a correct claim must hold. They exclude most edits before an exact decision.

use super::ground::Look;
use super::samples::Samples;
use crate::claim_text::{ClaimText, Kind};
use crate::conditions::{Hypothesis, assume, conditions};
use crate::equation::{Outcome, vanishes};
use crate::feedback::Feedback;
use crate::integrals::{difference, is_constant};
use crate::letters::{Letters, rate};
use crate::linearisation::Linearisation;
use crate::lines::{Line, lines};
use crate::motion::Motion;
use crate::refutation::Refutation;
use latex::{Chain, Statement, Term, Value, value};
use symbolic::{Hypotheses, Identity, Node, Sym, decide, identified, normal};

/// The motion of a refuted claim with a point at which the printed claim fails.
pub(super) struct Probe<'t, 'm> {
    motion: Motion<'t, 'm>,
    /// The point, extended by accelerations, multipliers and other values that follow from it.
    at: Option<Refutation>,
    kind: Kind,
    /// The number of lines that state nothing in the printed formula.
    empty: usize,
    /// Letters that are not in the printed formula and denote expressions in printed letters, with these expressions.
    foreign: Vec<(Sym, Sym)>,
    samples: Option<Samples>,
    linear: Option<Linearisation<'t, 'm>>,
    feedback: Feedback,
    /// The motion under the hypotheses only.
    assumed: Motion<'t, 'm>,
}

impl<'t, 'm> Probe<'t, 'm> {
    /// The probe of a refuted claim; `None` if the refutation does not consist of failing equalities.
    pub fn of(
        claim: &ClaimText,
        statement: &Statement,
        letters: &Letters<'t, 'm>,
        assumed: &[Hypothesis],
    ) -> Option<Self> {
        let linear = match claim.kind {
            Kind::LinearisedEquation => Some(Linearisation::of(claim, letters, assumed).ok()?.ok()?),
            _ => None,
        };
        let is_static = claim.kind == Kind::Identity;
        let trace = letters.trace;
        let motion = if is_static { Ok(Motion::by_constraints(trace)) } else { Motion::by_equations(trace) };
        let mut motion = match &linear {
            Some(linear) => linear.base.clone(),
            None => motion.ok()?,
        };
        if linear.is_none() {
            assume(&mut motion, assumed).ok()?;
        }
        let samples = Samples::of(&motion.hypotheses);
        let mut hypothetical = Motion::without_anything(trace);
        assume(&mut hypothetical, assumed).ok()?;
        let foreign = Vec::new();
        let feedback = Feedback::of(trace, assumed);
        let kind = claim.kind;
        let mut probe =
            Probe { motion, at: None, kind, empty: 0, foreign, samples, assumed: hypothetical, linear, feedback };
        let lines = probe.lines(claim, statement, letters)?;
        let printed: Vec<Sym> = lines.iter().flat_map(|line| line.own).flat_map(Sym::symbols_of).collect();
        let is_foreign = |value: Sym, own: Sym| value.symbol_name().is_none() && !printed.contains(&own);
        let foreign = letters.scalars().filter(|(_, value, own, _)| is_foreign(*value, *own));
        probe.foreign = foreign.map(|(_, value, own, _)| (own, letters.told(value))).collect();
        // a letter with the meaning of a printed letter, or of its rate, is also replaced
        let known: Vec<(Sym, Sym)> = printed.iter().flat_map(|own| letters.meanings(*own)).collect();
        let others =
            letters.scalars().filter(|(_, value, own, _)| value.symbol_name().is_some() && !printed.contains(own));
        probe.foreign.extend(others.filter_map(|(_, value, own, _)| {
            known.iter().find(|(_, meaning)| *meaning == value).map(|(printed, _)| (own, *printed))
        }));
        probe.empty = lines.iter().filter(|line| probe.is_empty(line)).count();
        let conditions = conditions(&probe.motion, assumed);
        let refuted =
            lines.iter().find_map(|line| match vanishes(&probe.motion, line.model[0] - line.model[1], &conditions) {
                Outcome::NonZero(refutation) => Some(refutation),
                _ => None,
            });
        let mut refutation = refuted?;
        let multipliers = model::equations::constraints_of(trace).into_iter().map(|one| one.multiplier);
        let all = probe.motion.replaced().into_iter().chain(trace.accelerations.iter().copied()).chain(multipliers);
        for symbol in all {
            if let Some(value) = refutation.value(probe.motion.reduced(symbol)) {
                refutation.point.push((symbol, value));
            }
        }
        probe.at = Some(refutation);
        Some(probe)
    }

    pub fn motion(&self) -> &Motion<'t, 'm> {
        &self.motion
    }

    /// The linearisation, for a linearised equation.
    pub fn linear(&self) -> Option<&Linearisation<'t, 'm>> {
        self.linear.as_ref()
    }

    /// The equalities that must hold, with both sides also in the paper's letters.
    fn lines(&self, claim: &ClaimText, statement: &Statement, letters: &Letters<'_, '_>) -> Option<Vec<Line>> {
        match self.kind {
            Kind::EquationOfMotion | Kind::Formula | Kind::Identity => lines(claim, statement, letters).ok(),
            Kind::LinearisedEquation => {
                let linear = self.linear.as_ref()?;
                let lines = lines(claim, statement, letters).ok()?;
                let of = |line: Line| {
                    let parts = linear.parts(line.model[0] - line.model[1]).into_iter();
                    parts.map(move |(part, _)| Line { model: [part, Sym::ZERO], own: line.own }).collect::<Vec<_>>()
                };
                Some(lines.into_iter().flat_map(of).collect())
            }
            Kind::IntegralOfMotion => {
                let (is, own) = difference(claim, statement, letters).ok()?;
                let changing = rate(letters.trace, self.feedback.put_in(is)).ok()?;
                Some(vec![Line { model: [changing, Sym::ZERO], own: [own, Sym::ZERO] }])
            }
            _ => None,
        }
    }

    /// Whether a line states nothing. For an identity: whether both sides are equal if sines, cosines and roots are independent letters.
    fn is_empty(&self, line: &Line) -> bool {
        if self.kind != Kind::Identity {
            return says_nothing(line);
        }
        says_nothing(&Line { model: line.model, own: line.own.map(with_formal_functions) })
    }

    /// The residual of a claim at the test points, in double precision.
    pub fn residual(&self, claim: &ClaimText, statement: &Statement, letters: &Letters<'_, '_>) -> Option<Vec<f64>> {
        let lines = self.lines(claim, statement, letters)?;
        let zeros: Vec<Sym> = lines.iter().map(|line| self.motion.reduced(line.model[0] - line.model[1])).collect();
        self.samples.as_ref()?.values(&zeros)
    }

    /// Whether, under constraints and hypotheses, the expression of an integral depends on parameters only.
    fn is_number_of_model(&self, claim: &ClaimText, statement: &Statement, letters: &Letters<'_, '_>) -> bool {
        let Ok((is, _)) = difference(claim, statement, letters) else { return false };
        let form = normal(self.motion.reduced(is), &self.motion.hypotheses).map(|form| form.to_sym());
        form.is_ok_and(|form| form.symbols_of().iter().all(|symbol| letters.trace.parameters.contains(symbol)))
    }

    /// The result of the test points for an edited claim.
    pub fn look(&self, claim: &ClaimText, statement: &Statement, letters: &Letters<'_, '_>) -> Look {
        let Some(lines) = self.lines(claim, statement, letters) else { return Look::Fails };
        let zeros: Vec<Sym> = lines.iter().map(|line| line.model[0] - line.model[1]).collect();
        let at = |zero: &Sym| self.at.as_ref().and_then(|at| at.value(*zero));
        let values: Vec<Option<Sym>> = zeros.iter().map(at).collect();
        let fails = values.iter().flatten().any(|value| *value != Sym::ZERO);
        // a letter that abbreviates an expression is replaced by it, since its definition states nothing
        let plain = |line: &Line| Line { model: line.model, own: line.own.map(|own| own.substitute(&self.foreign)) };
        if fails || lines.iter().filter(|line| self.is_empty(&plain(line))).count() > self.empty {
            return Look::Fails;
        }
        // an expression in parameters is trivially constant along every motion
        if self.kind == Kind::IntegralOfMotion && self.is_number_of_model(claim, statement, letters) {
            return Look::Fails;
        }
        // an expression that is constant without the equations of motion is not an integral, and an identity is not an equation of motion
        let is_empty = |zero: &Sym| decide(*zero, &Hypotheses::none()).is_zero();
        if matches!(self.kind, Kind::IntegralOfMotion | Kind::EquationOfMotion) && zeros.iter().any(is_empty) {
            return Look::Fails;
        }
        if self.linear.as_ref().is_some_and(|linear| {
            let printed = crate::lines::lines(claim, statement, letters).unwrap_or_default();
            printed.iter().any(|line| linear.is_of_second_order(line.model[0] - line.model[1]))
        }) {
            return Look::Fails;
        }
        // a formula with two sides that vanish by the hypotheses states nothing
        let vanishes = |side: Sym| decide(self.assumed.reduced(side), &self.assumed.hypotheses).is_zero();
        if self.linear.is_none()
            && !self.assumed.held.is_empty()
            && lines.iter().any(|line| line.model.into_iter().all(vanishes))
        {
            return Look::Fails;
        }
        let reduced: Vec<Sym> = zeros.iter().map(|zero| self.motion.reduced(*zero)).collect();
        // in a prime field the sign of a square root is not determined
        let has_root =
            reduced.iter().any(|zero| zero.leaves_of().iter().any(|leaf| matches!(leaf.node(), Node::Root(_))));
        match identified(&reduced) {
            // prime fields cannot use the rules of hypotheses
            Identity::NotZero if self.motion.hypotheses.statements().is_empty() && !has_root => Look::Fails,
            Identity::Identified { .. } => Look::Holds,
            _ if values.iter().all(Option::is_some) => Look::Holds,
            _ => Look::Open,
        }
    }
}

/// An expression with its functions replaced by letters; the same letter stands for functions of an angle and of its opposite.
pub(super) fn with_formal_functions(expression: Sym) -> Sym {
    let plain = |angle: Sym| normal(angle, &Hypotheses::none()).map_or(angle, |form| form.to_sym());
    let letter = |word: &str, of: Sym| Sym::symbol(&format!("{word} of {of}"));
    let of_leaf = |leaf: Sym| match leaf.node() {
        Node::Cos(angle) | Node::Sin(angle) => {
            let (one, other) = (plain(angle), plain(Sym::ZERO - angle));
            let is_turned = other.to_string().len() < one.to_string().len();
            let of = if is_turned { other } else { one };
            match (leaf.node(), is_turned) {
                (Node::Cos(_), _) => letter("cosine", of),
                (_, true) => Sym::ZERO - letter("sine", of),
                (_, false) => letter("sine", of),
            }
        }
        _ => letter("value", leaf),
    };
    let leaves = expression.leaves_of().into_iter();
    let leaves = leaves.filter(|leaf| leaf.symbol_name().is_none() && leaf.as_constant().is_none());
    expression.substitute(&leaves.map(|leaf| (leaf, of_leaf(leaf))).collect::<Vec<_>>())
}

/// Whether both sides are equal as expressions in the paper's letters.
pub(super) fn says_nothing(line: &Line) -> bool {
    decide(line.own[0] - line.own[1], &Hypotheses::none()).is_zero()
}

/// The difference of the sides in the paper's letters, for a formula with one equality; zero for an equivalence of two identical conditions.
pub(super) fn own_difference(statement: &Statement, letters: &Letters<'_, '_>) -> Option<Sym> {
    match &statement.chains[..] {
        [chain] => sides_apart(chain, letters),
        [one, other] => {
            let (one, other) = (sides_apart(one, letters)?, sides_apart(other, letters)?);
            let is_one = [one - other, one + other].into_iter().any(|zero| decide(zero, &Hypotheses::none()).is_zero());
            is_one.then_some(Sym::ZERO)
        }
        _ => None,
    }
}

fn sides_apart(chain: &Chain, letters: &Letters<'_, '_>) -> Option<Sym> {
    let own = |term: &Term| match value(term, &letters.in_paper()).ok()? {
        Value::Scalar(own) => Some(own),
        Value::Matrix(_) => None,
    };
    // a constant without a value states nothing about the other side
    let sides: Vec<&Term> = chain.sides.iter().filter(|side| !is_constant(side)).collect();
    match sides[..] {
        [left, right] => Some(own(left)? - own(right)?),
        [left] if chain.sides.len() == 2 => own(left),
        _ => None,
    }
}
