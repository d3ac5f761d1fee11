//! Claims that are linearised equations: the printed equation must hold up to second-order terms about a motion on which given letters are constant.

use crate::base_motion::Residuals;
use crate::certificate::Record;
use crate::claim_text::ClaimText;
use crate::conditions::{Hypothesis, assume, conditions};
use crate::display::{Told, divisors, readable, shown};
use crate::equation::{Outcome, vanishes_or_fails};
use crate::feedback::Feedback;
use crate::finding::Finding;
use crate::letters::Letters;
use crate::lines::{Line, lines};
use crate::motion::Motion;
use crate::refutation::Refutation;
use crate::steady_motion::Resting;
use crate::verdict::{neither, refute};
use claims::{Condition, Verdict};
use latex::Statement;
use reader::Issue;
use symbolic::{Sym, decide};

/// The equations of motion, and the base motion about which they are linearised.
pub(crate) struct Linearisation<'t, 'm> {
    along: Motion<'t, 'm>,
    pub base: Motion<'t, 'm>,
    inputs: Vec<Sym>,
    feedback: Feedback,
    /// The rates that vanish on the base motion.
    rates: Vec<Sym>,
}

impl<'t, 'm> Linearisation<'t, 'm> {
    /// Linearises about the motion on which the letters of a claim are constant. An input is small unless a hypothesis prescribes it; a state
    /// feedback is inserted.
    ///
    /// # Errors
    /// A fault of the file (outer result), or the reason for which there are no linear equations (inner result).
    pub fn of(
        claim: &ClaimText,
        letters: &Letters<'t, 'm>,
        assumed: &[Hypothesis],
    ) -> Result<Result<Self, String>, Issue> {
        let trace = letters.trace;
        let resting = Resting::of(claim, letters)?;
        let mut base = Motion::without_anything(trace);
        let rates = resting.rates(letters);
        base.set(rates.clone());
        assume(&mut base, assumed)?;
        let inputs = trace.model.inputs.iter().map(|input| Sym::symbol(&input.name));
        let inputs: Vec<Sym> = inputs.filter(|input| base.reduced(*input) == *input).collect();
        base.set(inputs.iter().map(|&input| (input, Sym::ZERO)).collect());
        let feedback = Feedback::of(trace, assumed);
        let closed = Motion::by_equations(trace).and_then(|mut along| feedback.close(&mut along).map(|()| along));
        let along = match closed {
            Ok(along) => along,
            Err(why) => return Ok(Err(why)),
        };
        if !along.open.is_empty() || !along.hypotheses.statements().is_empty() {
            return Ok(Err(
                "constraints of positions are not solved for a coordinate, so that no small deviation is free"
                    .to_owned(),
            ));
        }
        let rates = rates.into_iter().map(|(rate, _)| rate).collect();
        Ok(Ok(Linearisation { along, base, inputs, feedback, rates }))
    }

    /// The conditions under which the letters are constant on the base motion.
    fn residuals(&self, conditions: &[Condition]) -> Residuals {
        let accelerations = self.rates.iter().filter(|rate| self.base.trace.accelerations.contains(rate));
        let values = accelerations.map(|&acceleration| (acceleration, self.along.reduced(acceleration)));
        Residuals::of(&self.base, values, conditions)
    }

    /// The parts of an expression that a linear equation contains: its value on the base motion, and its derivatives there by each coordinate,
    /// speed and input.
    pub fn parts(&self, expression: Sym) -> Vec<(Sym, Option<Sym>)> {
        let trace = self.base.trace;
        let there = |part: Sym| self.base.reduced(part);
        let along = self.along.reduced(expression);
        let known = along.symbols_of();
        let mut all = vec![(there(along), None)];
        for (place, &coordinate) in trace.coordinates.iter().take(trace.speeds.len()).enumerate() {
            if known.contains(&coordinate) {
                all.push((there(trace.by_coordinate(along, place)), Some(coordinate)));
            }
            if known.contains(&trace.speeds[place]) {
                all.push((there(trace.by_speed(along, place)), Some(trace.speeds[place])));
            }
        }
        for &input in self.inputs.iter().filter(|input| known.contains(input)) {
            all.push((there(along.diff(input)), Some(input)));
        }
        all
    }

    /// An expression to first order in the deviations from the base motion, including deviations of accelerations.
    pub fn form(&self, expression: Sym) -> Sym {
        let trace = self.base.trace;
        let expression = self.feedback.put_in(expression);
        let there = |part: Sym| self.base.reduced(part);
        let from = |letter: Sym| letter - there(letter);
        let by_each = (0..trace.speeds.len()).flat_map(|place| {
            let mut terms = vec![
                there(trace.by_speed(expression, place)) * from(trace.speeds[place]),
                there(trace.by_acceleration(expression, place)) * trace.accelerations[place],
            ];
            let coordinate = trace.coordinates.get(place);
            terms.extend(coordinate.map(|&letter| there(trace.by_coordinate(expression, place)) * from(letter)));
            terms
        });
        let by_inputs = self.inputs.iter().map(|&input| there(expression.diff(input)) * input);
        by_each.chain(by_inputs).fold(there(expression), |sum, term| sum + term)
    }

    /// Whether an expression is of second order for all small accelerations, so that it states nothing about the motion.
    pub fn is_of_second_order(&self, expression: Sym) -> bool {
        let trace = self.base.trace;
        let expression = self.feedback.put_in(expression);
        let by_each = (0..trace.speeds.len()).flat_map(|place| {
            [
                trace.by_coordinate(expression, place),
                trace.by_speed(expression, place),
                trace.by_acceleration(expression, place),
            ]
        });
        let by_inputs = self.inputs.iter().map(|&input| expression.diff(input));
        let mut all = std::iter::once(expression).chain(by_each).chain(by_inputs);
        all.all(|part| decide(self.base.reduced(part), &self.base.hypotheses).is_zero())
    }

    /// The letters of differentiation; `None` for a system with a free frame, whose deviations are not those of its coordinates.
    fn letters(&self) -> Option<Vec<Sym>> {
        let trace = self.base.trace;
        let is_plain = trace.coordinates.len() == trace.speeds.len();
        is_plain.then(|| [&trace.coordinates[..], &trace.speeds, &self.inputs].concat())
    }

    fn record(
        &self,
        difference: Sym,
        assumed: &[Hypothesis],
        failure: Option<(Option<Sym>, &Refutation)>,
        record: &mut Record,
    ) {
        match self.letters() {
            Some(letters) => {
                let sides = [difference, self.along.reduced(difference)];
                record.linear([&self.along, &self.base], assumed, sides, &letters, failure);
            }
            None => record.leave_out(),
        }
    }
}

/// Judges a linearised equation: the equation must hold up to second-order terms about the motion on which the letters of `resting` are constant.
pub(crate) fn linearised(
    claim: &ClaimText,
    statement: &Statement,
    letters: &Letters<'_, '_>,
    assumed: &[Hypothesis],
    finding: &mut Finding,
    record: &mut Record,
) -> Result<(), Issue> {
    let lines = lines(claim, statement, letters)?;
    (finding.judged.text, finding.judged.latex) = lines.iter().map(|line| shown(line.own)).unzip();
    let linearisation = match Linearisation::of(claim, letters, assumed)? {
        Ok(linearisation) => linearisation,
        Err(why) => {
            neither(Outcome::Undecided(why), letters, finding);
            return Ok(());
        }
    };
    finding.allowed =
        "along every motion up to terms of the second order in the deviations from the motion on which the letters of `resting` rest; inputs \
         without a value are small too"
            .to_owned();
    let (base, told) = (&linearisation.base, Told(letters));
    let known = conditions(base, assumed);
    let residuals = linearisation.residuals(&known);
    if let Some(why) = residuals.excluded(base, &known, letters) {
        finding.judged.verdict = Verdict::Undefined;
        finding.judged.evidence = why;
        return Ok(());
    }
    let mut is_open = false;
    for line in &lines {
        let difference = line.model[0] - line.model[1];
        let parts = linearisation.parts(difference);
        for &(part, by) in &parts {
            match vanishes_or_fails(base, part, &known) {
                Outcome::Zero(found) => {
                    let found = [&found[..], &base.divisors].concat();
                    finding.judged.requires.extend(divisors(&found, told));
                }
                Outcome::NonZero(refutation) => {
                    // a counterexample must lie on a motion on which the letters are constant
                    let found = Some(refutation).filter(|found| residuals.vanish_at(found));
                    let Some(refutation) = found.or_else(|| residuals.failing(part, base, &known)) else {
                        is_open = true;
                        continue;
                    };
                    linearisation.record(difference, assumed, Some((by, &refutation)), record);
                    let of_part = Line { model: [part, Sym::ZERO], own: line.own };
                    refute(&of_part, &refutation, base, told, finding);
                    let at = finding
                        .sides
                        .take()
                        .map_or_else(String::new, |sides| format!(": {} at the exact point", sides.left));
                    finding.judged.evidence = match by {
                        None => format!("on the motion itself the two sides differ{at}"),
                        Some(by) => format!(
                            "to the first order in {} the two sides differ by its multiple{at}",
                            letters.told(by)
                        ),
                    };
                    let missing = parts.iter().fold(Sym::ZERO, |sum, &(part, by)| {
                        sum + part * by.map_or(Sym::ONE, |by| by - base.reduced(by))
                    });
                    let missing = readable(missing, line.own, base, told);
                    finding.judged.difference = missing.map(|own| (own.to_string(), own.latex()));
                    return Ok(());
                }
                other => {
                    neither(other, letters, finding);
                    return Ok(());
                }
            }
        }
        linearisation.record(difference, assumed, None, record);
    }
    if is_open {
        let conditions: Vec<String> = residuals.told(base, &known, letters).into_iter().map(|(text, _)| text).collect();
        let why = format!(
            "the letters of `resting` are constant only where {}, and this condition of the motion is missing in `given`",
            conditions.join(" and ")
        );
        neither(Outcome::Undecided(why), letters, finding);
        return Ok(());
    }
    finding.judged.requires.extend(residuals.told(base, &known, letters));
    finding.judged.requires.sort();
    finding.judged.requires.dedup();
    finding.judged.verdict = Verdict::Proved;
    finding.judged.evidence =
        "normal forms of the difference and of its first derivatives on the motion are zero".to_owned();
    Ok(())
}
