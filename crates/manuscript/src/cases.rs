//! Cases of hypotheses of the form "a product is zero": one of the factors is zero. A factor that another hypothesis or the model excludes from
//! vanishing gives no case.

use crate::admissible::is_of_every_body;
use crate::circle_signs::circle_signs;
use crate::conditions::Hypothesis;
use crate::consequence::{is_apart, is_apart_by};
use crate::display::factors;
use crate::motion::{Motion, solution};
use crate::polynomial_factors::polynomial_factors;
use claims::Condition;
use reader::Issue;
use symbolic::{Hypotheses, Sym, decide, normal};

/// The largest number of cases of one claim.
const MOST_CASES: usize = 16;

/// One case of the hypotheses of a claim.
#[derive(Clone)]
pub(crate) struct Case<'t, 'm> {
    pub assumed: Vec<Hypothesis>,
    /// The factors that vanish in this case.
    pub chosen: Vec<Sym>,
    /// Whether a hypothesis was replaced by a consequence of it, or by one of its cases.
    pub is_replaced: bool,
    motion: Motion<'t, 'm>,
}

/// The cases of hypotheses; empty if no factor of a product may vanish.
///
/// # Errors
/// There are too many cases, or a case cannot be solved for a letter.
pub(crate) fn cases<'t, 'm>(
    base: &Motion<'t, 'm>,
    assumed: &[Hypothesis],
    told: &dyn Fn(Sym) -> Sym,
) -> Result<Vec<Case<'t, 'm>>, Issue> {
    let given: Vec<Condition> = assumed.iter().filter_map(|one| one.condition).collect();
    // bounds of an angle may exclude that its sine vanishes
    let zeros: Vec<Sym> = assumed.iter().filter_map(|one| one.equality.map(|(zero, _)| base.reduced(zero))).collect();
    let known = [&given[..], &circle_signs(&zeros, &given)].concat();
    let mut all = vec![Case { assumed: Vec::new(), chosen: Vec::new(), is_replaced: false, motion: base.clone() }];
    // products come last, since the value of a letter from another hypothesis may make them vanish
    let is_product =
        |one: &&Hypothesis| one.equality.is_some_and(|(zero, _)| vanishing_factors(base.reduced(zero)).len() > 1);
    let (products, plain): (Vec<&Hypothesis>, Vec<&Hypothesis>) = assumed.iter().partition(is_product);
    for hypothesis in plain.into_iter().chain(products) {
        let mut next = Vec::new();
        for case in all {
            next.extend(case.split(hypothesis, &known, told)?);
        }
        if next.len() > MOST_CASES {
            let title = format!("these hypotheses are products with more than {MOST_CASES} cases");
            let issue = Issue::at(hypothesis.at.clone(), title, "which factor vanishes?");
            return Err(issue.accepted(r"the factor that is zero, 'x = 0', or those that are not, 'x \neq 0'"));
        }
        all = next;
    }
    Ok(all)
}

impl Case<'_, '_> {
    /// The cases that follow from this one with one more hypothesis: one for each factor that may vanish.
    fn split(
        mut self,
        hypothesis: &Hypothesis,
        known: &[Condition],
        told: &dyn Fn(Sym) -> Sym,
    ) -> Result<Vec<Self>, Issue> {
        let Some((zero, first)) = hypothesis.equality else {
            self.assumed.push(hypothesis.clone());
            return Ok(vec![self]);
        };
        let left = self.motion.reduced(zero);
        let parts = if decide(left, &self.motion.hypotheses).is_zero() { Vec::new() } else { vanishing_factors(left) };
        if parts.len() < 2 {
            self.assume(hypothesis.clone());
            return Ok(vec![self]);
        }
        match &self.open(&parts, known)[..] {
            [] => Ok(Vec::new()),
            &[factor] => {
                let is_own = |letter: &Sym| factor.symbols_of().contains(letter);
                let plain = solution(self.motion.trace, left, first).map(|found| found.symbol).filter(is_own);
                let letter = plain
                    .or_else(|| solution(self.motion.trace, factor, first.filter(is_own)).map(|found| found.symbol));
                // a factor that is not linear, as in a power, replaces the product
                let is_linear = letter.is_some_and(|letter| {
                    solution(self.motion.trace, left, Some(letter)).is_some_and(|found| found.symbol == letter)
                });
                let equality = match plain {
                    Some(_) => (zero, first),
                    None => (if is_linear { zero } else { factor }, letter),
                };
                self.is_replaced |= !is_linear;
                self.assume(Hypothesis { equality: Some(equality), ..hypothesis.clone() });
                Ok(vec![self])
            }
            open => open.iter().map(|&factor| self.with(hypothesis, factor, told)).collect(),
        }
    }

    /// The case in which a factor of a hypothesis vanishes.
    fn with(&self, hypothesis: &Hypothesis, factor: Sym, told: &dyn Fn(Sym) -> Sym) -> Result<Self, Issue> {
        if solution(self.motion.trace, factor, None).is_none() {
            let own = told(factor);
            let title = format!("the case of this hypothesis in which {own} is zero is solved for no letter");
            let issue = Issue::at(hypothesis.at.clone(), title, "which factor vanishes?");
            return Err(
                issue.accepted(format!(r"a hypothesis for the other factor alone, or '{} \neq 0'", own.latex()))
            );
        }
        let mut case = self.clone();
        case.chosen.push(factor);
        case.is_replaced = true;
        case.assume(Hypothesis { equality: Some((factor, Some(factor))), ..hypothesis.clone() });
        Ok(case)
    }

    /// The factors that may vanish, each once. If the model excludes all but one of them, only this one remains.
    fn open(&self, parts: &[Sym], known: &[Condition]) -> Vec<Sym> {
        let here = known.iter().map(|condition| condition.mapped(|e| self.motion.reduced(e)));
        let all: Vec<Condition> = known.iter().copied().chain(here).collect();
        let mut open: Vec<Sym> = Vec::new();
        for &part in parts.iter().filter(|part| !is_apart_by(**part, &self.motion, &all)) {
            if !open.iter().any(|one| is_multiple(part, *one)) {
                open.push(part);
            }
        }
        let is_of_model = |part: Sym| is_of_every_body(part, &self.motion) || is_apart(part, &self.motion, &all);
        let beside_model: Vec<Sym> = open.iter().copied().filter(|part| !is_of_model(*part)).collect();
        if beside_model.is_empty() { open } else { beside_model }
    }

    fn assume(&mut self, hypothesis: Hypothesis) {
        if let Some((zero, first)) = hypothesis.equality {
            // an error is reported where the claim is judged
            let _ = self.motion.assume(zero, first);
        }
        self.assumed.push(hypothesis);
    }
}

/// Whether two expressions are numerical multiples of each other, so that they vanish together.
fn is_multiple(one: Sym, other: Sym) -> bool {
    normal(one / other, &Hypotheses::none()).is_ok_and(|form| form.to_sym().as_constant().is_some())
}

/// The factors of an expression that may be zero: its written factors and the factors of their polynomials.
fn vanishing_factors(expression: Sym) -> Vec<Sym> {
    if Sym::operations_of(&[expression]) > MOST_OPERATIONS {
        return vec![expression];
    }
    let numerator = |of: Sym| normal(of, &Hypotheses::none()).map_or(of, |form| form.numerator());
    let written = factors(expression).into_iter().map(numerator).collect::<Vec<Sym>>();
    let written = if written.len() > 1 { written } else { vec![numerator(expression)] };
    let all = written.into_iter().flat_map(polynomial_factors);
    all.filter(|part| part.as_constant().is_none()).collect()
}

/// The largest number of operations of an expression that is factorised.
const MOST_OPERATIONS: usize = 400;
