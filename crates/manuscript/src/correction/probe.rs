//! Points of the motion at which a claim must hold: most candidates fail there, before anything is decided exactly.

use crate::claim_text::{ClaimText, Kind};
use crate::conditions::{Hypothesis, assume, conditions};
use crate::equation::{Outcome, vanishes};
use crate::integrals::difference;
use crate::letters::{Letters, rate};
use crate::lines::{Line, lines};
use crate::motion::Motion;
use crate::refutation::Refutation;
use latex::{Chain, Statement, Term, Value, value};
use symbolic::{Hypotheses, Identity, Sym, decide, identified};

/// The motion of a claim with the point at which its print fails.
pub(super) struct Probe<'t, 'm> {
    motion: Motion<'t, 'm>,
    /// The point, with what follows from it: accelerations, multipliers, what constraints give.
    at: Option<Refutation>,
    kind: Kind,
    /// Lines that say nothing in the print itself.
    empty: usize,
}

impl<'t, 'm> Probe<'t, 'm> {
    /// That of a refuted claim; none where it is not refuted by equalities.
    pub fn of(
        claim: &ClaimText,
        statement: &Statement,
        letters: &Letters<'t, 'm>,
        assumed: &[Hypothesis],
    ) -> Option<Self> {
        let is_static = claim.kind == Kind::Identity;
        let trace = letters.trace;
        let motion = if is_static { Ok(Motion::by_constraints(trace)) } else { Motion::by_equations(trace) };
        let mut motion = motion.ok()?;
        assume(&mut motion, assumed).ok()?;
        let mut probe = Probe { motion, at: None, kind: claim.kind, empty: 0 };
        let lines = probe.lines(claim, statement, letters)?;
        probe.empty = lines.iter().filter(|line| says_nothing(line)).count();
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

    /// What must vanish, with both sides in the paper's letters.
    fn lines(&self, claim: &ClaimText, statement: &Statement, letters: &Letters<'_, '_>) -> Option<Vec<Line>> {
        match self.kind {
            Kind::EquationOfMotion | Kind::Formula | Kind::Identity => lines(claim, statement, letters).ok(),
            Kind::IntegralOfMotion => {
                let (is, own) = difference(claim, statement, letters).ok()?;
                let changing = rate(letters.trace, is).ok()?;
                Some(vec![Line { model: [changing, Sym::ZERO], own: [own, Sym::ZERO] }])
            }
            _ => None,
        }
    }

    /// Whether an edited claim says something, and holds at the points: it may then be true.
    pub fn may_hold(&self, claim: &ClaimText, statement: &Statement, letters: &Letters<'_, '_>) -> bool {
        let Some(lines) = self.lines(claim, statement, letters) else { return false };
        let fails = |line: &Line| {
            let zero = line.model[0] - line.model[1];
            self.at.as_ref().and_then(|at| at.value(zero)).is_some_and(|value| value != Sym::ZERO)
        };
        if lines.iter().any(fails) || lines.iter().filter(|line| says_nothing(line)).count() > self.empty {
            return false;
        }
        // a constant of the letters alone is no integral, and no equation of motion holds without the equations
        let is_empty = |line: &Line| decide(line.model[0] - line.model[1], &Hypotheses::none()).is_zero();
        if matches!(self.kind, Kind::IntegralOfMotion | Kind::EquationOfMotion) && lines.iter().any(is_empty) {
            return false;
        }
        if !self.motion.hypotheses.statements().is_empty() {
            return true;
        }
        let reduced: Vec<Sym> = lines.iter().map(|line| self.motion.reduced(line.model[0] - line.model[1])).collect();
        identified(&reduced) != Identity::NotZero
    }
}

/// Both sides are one expression of the letters.
pub(super) fn says_nothing(line: &Line) -> bool {
    decide(line.own[0] - line.own[1], &Hypotheses::none()).is_zero()
}

/// The difference of the sides in the paper's letters, of a formula with one equality.
pub(super) fn own_difference(statement: &Statement, letters: &Letters<'_, '_>) -> Option<Sym> {
    let [Chain { sides, .. }] = &statement.chains[..] else { return None };
    let own = |term: &Term| match value(term, &letters.in_paper()).ok()? {
        Value::Scalar(own) => Some(own),
        Value::Matrix(_) => None,
    };
    match &sides[..] {
        [left, right] => Some(own(left)? - own(right)?),
        _ => None,
    }
}
