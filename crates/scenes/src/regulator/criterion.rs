//! The cost of a regulator as a quadratic form of deviations.

use crate::letters::Letters;
use model::equations::vanishes;
use model::{Model, Regulator, ScalarId, Trace};
use nalgebra::DMatrix;
use reader::Issue;
use std::ops::Range;
use symbolic::{Sym, apart};

/// The symmetric matrix S of the quadratic form z^T S z (half the second derivatives); z has displacements, speeds, then inputs.
#[derive(Clone, Debug)]
pub struct Form(pub DMatrix<f64>);

/// The form of the running cost, and that of the terminal cost if one is given.
///
/// # Errors
/// If a cost is not a quadratic form, the terminal cost contains inputs, or the running cost is not positive definite in the inputs.
pub fn forms(model: &Model, regulator: &Regulator) -> Result<(Form, Option<Form>), Issue> {
    let cost = form(model, regulator, regulator.cost, &regulator.at[0])?;
    let last = regulator.last.map(|last| form(model, regulator, last, &regulator.at[1])).transpose()?;
    let k = regulator.inputs.len();
    if let Some(Form(last)) = &last {
        let free = last.nrows() - k;
        if last.view((free, 0), (k, free + k)).amax() > 0.0 {
            let issue = Issue::at(regulator.at[1].clone(), "the cost of the end holds inputs", "an input stands in it");
            return Err(issue.accepted("coordinates and their rates"));
        }
    }
    let inputs = cost.0.view((cost.0.nrows() - k, cost.0.nrows() - k), (k, k)).into_owned();
    if inputs.clone().cholesky().is_none() {
        let title = "the cost grows with every input that a regulator chooses";
        let issue = Issue::at(regulator.at[0].clone(), title, "it is not positive in them");
        return Err(issue.accepted("a square of each input, such as x^2/(1 m)^2 + u^2/(10 N)^2"));
    }
    Ok((cost, last))
}

fn form(model: &Model, regulator: &Regulator, of: ScalarId, at: &Range<usize>) -> Result<Form, Issue> {
    let size = 2 * model.speeds() + regulator.inputs.len();
    let numbers: Result<Vec<f64>, &str> = apart(|| {
        let open = opened(model, regulator);
        let trace = Trace::of(&open);
        let cost = trace.scalar(of);
        let state: Vec<Sym> = trace.coordinates.iter().chain(&trace.speeds).copied().collect();
        let inputs = regulator.inputs.iter().map(|&input| Sym::symbol(&open.inputs[input].name));
        let letters: Vec<Sym> = state.iter().copied().chain(inputs).collect();
        let at_zero: Vec<(Sym, Sym)> = letters.iter().map(|&letter| (letter, Sym::ZERO)).collect();
        let is_zero_there = |value: &Sym| vanishes(value.substitute(&at_zero));
        let slopes: Vec<Sym> = letters.iter().map(|&letter| cost.diff(letter)).collect();
        if !is_zero_there(&cost) || !slopes.iter().all(is_zero_there) {
            return Err("it does not vanish without deviations, or has terms of the first degree");
        }
        let seconds: Vec<Sym> =
            slopes.iter().flat_map(|slope| letters.iter().map(|&letter| slope.diff(letter))).collect();
        if seconds.iter().any(|second| letters.iter().any(|&letter| !vanishes(second.diff(letter)))) {
            return Err("it has terms beyond the second degree");
        }
        let seconds = Letters::with_data(trace.time, &state).put_into(&trace, &seconds);
        let value = |second: Sym| second.substitute(&at_zero).evaluate_analytic(&|_: &str| None).ok();
        let halves: Option<Vec<f64>> =
            seconds.into_iter().map(|second| value(second).map(|value: f64| 0.5 * value)).collect();
        halves.ok_or("a letter in it has no value")
    });
    let title = "the cost of a regulator is a quadratic form of deviations from the motion";
    match numbers {
        Ok(numbers) => Ok(Form(DMatrix::from_row_slice(size, size, &numbers))),
        Err(why) => Err(Issue::at(at.clone(), title, why)
            .accepted("a sum of squares: (x/(1 m))^2 + (theta/(0.1 rad))^2 + (u/(10 N))^2")),
    }
}

/// The model with the inputs of the regulator as free letters, without their values.
pub(super) fn opened(model: &Model, regulator: &Regulator) -> Model {
    let mut open = model.clone();
    for &input in &regulator.inputs {
        open.inputs[input].value = None;
    }
    open
}

impl Form {
    /// The blocks Q, N and R of the form over the state x, from which displacements and speeds follow as `variations` x: the cost is
    /// x^T Q x + 2 x^T N u + u^T R u.
    pub fn parts(&self, variations: &DMatrix<f64>) -> [DMatrix<f64>; 3] {
        let Form(all) = self;
        let own = variations.nrows();
        let inputs = all.nrows() - own;
        let block = |row: usize, column: usize, rows: usize, columns: usize| {
            all.view((row, column), (rows, columns)).into_owned()
        };
        let by_state = variations.transpose() * block(0, 0, own, own) * variations;
        let mixed = variations.transpose() * block(0, own, own, inputs);
        [by_state, mixed, block(own, own, inputs, inputs)]
    }

    /// The block Q of the form.
    pub fn of_state(&self, variations: &DMatrix<f64>) -> DMatrix<f64> {
        let [by_state, ..] = self.parts(variations);
        by_state
    }
}
