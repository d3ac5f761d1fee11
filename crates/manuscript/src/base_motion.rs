//! The motion about which an equation is linearised. Letters that are constant on it stay so only where the equations of motion give no acceleration.

use crate::admissible::admissible;
use crate::consequence::is_apart;
use crate::display::factors;
use crate::equation::{Outcome, vanishes};
use crate::exact_points::{Effort, completed, search};
use crate::half_turn::sign_of_number;
use crate::letters::Letters;
use crate::motion::Motion;
use crate::refutation::Refutation;
use claims::Condition;
use symbolic::{Decision, Hypotheses, Sym, decide, normal};

/// Accelerations of letters that a claim states to be constant, with the nonzero values that the equations of motion give them on the base motion.
pub(crate) struct Residuals(Vec<(Sym, Sym)>);

impl Residuals {
    /// The residuals of these accelerations on `base`; their values are those along every motion.
    pub fn of(
        base: &Motion<'_, '_>,
        accelerations: impl Iterator<Item = (Sym, Sym)>,
        conditions: &[Condition],
    ) -> Self {
        let there = accelerations.map(|(acceleration, value)| (acceleration, base.reduced(value)));
        let is_open = |(_, value): &(Sym, Sym)| match decide(*value, &base.hypotheses) {
            Decision::NonZero(_) => true,
            // the decision is given up for values with numbers such as sin(1)
            Decision::GaveUp(_) => vanishing(*value, base, conditions).is_empty(),
            Decision::Zero(_) | Decision::Undefined(_) => false,
        };
        Residuals(there.filter(is_open).collect())
    }

    /// A sentence on the first residual that cannot vanish, which shows that no such motion exists; `None` without one.
    pub fn excluded(
        &self,
        base: &Motion<'_, '_>,
        conditions: &[Condition],
        letters: &Letters<'_, '_>,
    ) -> Option<String> {
        let (acceleration, value) = self.0.iter().find(|(_, value)| vanishing(*value, base, conditions).is_empty())?;
        let value = normal(*value, &Hypotheses::none()).map_or(*value, |form| form.to_sym());
        let (acceleration, value) = (letters.told(*acceleration), letters.told(value));
        Some(format!(
            "the letters of `resting` do not stay constant: the equations of motion give {acceleration} = {value} there"
        ))
    }

    /// Whether all residuals vanish at a point, so that the letters are constant there.
    pub fn vanish_at(&self, found: &Refutation) -> bool {
        self.0.iter().all(|(_, value)| found.value(*value) == Some(Sym::ZERO))
    }

    /// An exact point at which all residuals vanish and this expression does not.
    pub fn failing(&self, expression: Sym, base: &Motion<'_, '_>, conditions: &[Condition]) -> Option<Refutation> {
        let values: Vec<Sym> = self.0.iter().map(|(_, value)| *value).chain([expression]).collect();
        let is_it = |signs: &[i8]| {
            signs.split_last().is_some_and(|(last, all)| *last != 0 && all.iter().all(|sign| *sign == 0))
        };
        let within = |conditions: &[Condition], effort: Effort| {
            let found = search(&values, conditions, base, effort, is_it);
            found.or_else(|| self.failing_at_quarter_turns(expression, base, conditions))
        };
        let found = within(conditions, Effort::Whole)?;
        Some(admissible(found, base, conditions, |wanted| within(wanted, Effort::Part)))
    }

    /// An exact point like that of [`Residuals::failing`] at which one angle is a multiple of a right angle.
    fn failing_at_quarter_turns(
        &self,
        expression: Sym,
        base: &Motion<'_, '_>,
        conditions: &[Condition],
    ) -> Option<Refutation> {
        let (pi, two) = (base.trace.pi, Sym::ONE + Sym::ONE);
        let quarters = [Sym::ZERO, pi / two, pi, Sym::ZERO - pi / two];
        let angles = base
            .trace
            .coordinates
            .iter()
            .filter(|angle| self.0.iter().any(|(_, value)| value.symbols_of().contains(angle)));
        angles.flat_map(|angle| quarters.map(|value| (*angle, value))).find_map(|turned| {
            let mut there = base.clone();
            there.set(vec![turned]);
            let stays = self.0.iter().all(|(_, value)| decide(there.reduced(*value), &there.hypotheses).is_zero());
            let known: Vec<Condition> =
                conditions.iter().map(|condition| condition.mapped(|of| there.reduced(of))).collect();
            match stays.then(|| vanishes(&there, expression, &known))? {
                Outcome::NonZero(found) => {
                    let point = [&[turned][..], &found.point].concat();
                    completed(Refutation { point, ..found }, &known)
                }
                _ => None,
            }
        })
    }

    /// The conditions under which the letters are constant, as text and LaTeX: the equations that must hold on the base motion.
    pub fn told(
        &self,
        base: &Motion<'_, '_>,
        conditions: &[Condition],
        letters: &Letters<'_, '_>,
    ) -> Vec<(String, String)> {
        let line = |(_, value): &(Sym, Sym)| {
            let product = vanishing(*value, base, conditions).into_iter().reduce(|product, factor| product * factor);
            let own = letters.told(product.unwrap_or(*value));
            (format!("{own} = 0"), format!("{} = 0", own.latex()))
        };
        self.0.iter().map(line).collect()
    }
}

/// The factors of a value that may vanish. Parameters are not among them, since a model in which they vanish is another model.
fn vanishing(value: Sym, base: &Motion<'_, '_>, conditions: &[Condition]) -> Vec<Sym> {
    let parts = normal(value, &Hypotheses::none()).map_or(vec![value], |form| factors(form.numerator()));
    let stays = |factor: &Sym| {
        let is_number = || sign_of_number(*factor).is_some_and(|sign| sign != 0);
        base.trace.parameters.contains(factor) || is_number() || is_apart(*factor, base, conditions)
    };
    parts.into_iter().filter(|part| !stays(part)).collect()
}
