//! What of the inputs is no polynomial in them: circle points, roots, reciprocals.

use super::WIDTH;
use crate::graph::Node;
use crate::recurrence::Pick;
use crate::{Fraction, Sym, Tape};
use field::Analytic;
use std::collections::BTreeSet;

/// Registers of the program of parts: of a quotient or two, and of the longest. To clear them takes longer than the program.
const FEW: usize = 32;
const SOME: usize = 64;
const MANY: usize = 256;

/// The parts of expressions that are variables of their own, behind whole groups of inputs.
#[derive(Clone, Debug)]
pub(super) struct Parts {
    inputs: usize,
    /// The inputs whose circle points occur: cosines and sines in turn.
    angles: Vec<usize>,
    /// The inputs of which fractions occur, and these.
    fractions: Vec<(usize, Fraction<f64>)>,
    /// From the inputs, zeros up to the first part, and those points and fractions: all others.
    others: Tape,
    constants: Vec<f64>,
}

impl Parts {
    /// With the expressions, in their order; `None` where a part has no value, or is too long.
    pub fn of(inputs: &[Sym], outputs: &[Sym]) -> Option<(Self, Vec<Sym>)> {
        let (angles, mut others) = found(inputs, outputs);
        let first = Self::first(inputs.len());
        let points = angles.iter().flat_map(|&angle| {
            let point = inputs[angle].circle();
            [point.cos, point.sin]
        });
        let mut known: Vec<Sym> = points.collect();
        let mut fractions = Vec::new();
        others.retain(|&other| match fraction(inputs, other) {
            Some(own) => {
                known.push(other);
                fractions.push(own);
                false
            }
            None => true,
        });
        // between the inputs and the points there are zeros, and are read as that
        let zeros = vec![Sym::ZERO; first - inputs.len()];
        let tape = Tape::record(&[inputs, &zeros, &known].concat(), &others).ok()?;
        if tape.registers() > MANY {
            return None;
        }
        known.extend(others);
        Some((Parts { inputs: inputs.len(), angles, fractions, constants: tape.constants(), others: tape }, known))
    }

    /// Where they begin among the numbers of an evaluation.
    pub fn first(inputs: usize) -> usize {
        inputs.next_multiple_of(WIDTH)
    }

    pub fn flops(&self) -> usize {
        self.others.flops() + self.fractions.iter().map(|(_, fraction)| fraction.flops()).sum::<usize>()
    }

    /// Writes the inputs and their parts, one by one.
    #[inline]
    pub fn fill_singly<const N: usize>(&self, inputs: &[f64], values: &mut [f64; N]) {
        let inputs = &inputs[..self.inputs.min(inputs.len())];
        for (place, input) in inputs.iter().enumerate() {
            values[place % N] = *input;
        }
        let points = Self::first(self.inputs)..;
        for (&angle, place) in self.angles.iter().zip(points.step_by(2)) {
            let Some(angle) = inputs.get(angle) else { continue };
            let point = angle.circle();
            values[place % N] = point.cos;
            values[(place + 1) % N] = point.sin;
        }
        self.fill_others(inputs, values);
    }

    /// Writes the inputs and their parts.
    #[inline(always)]
    pub fn fill<P: Pick<f64>>(&self, pick: P, inputs: &[f64], values: &mut [f64]) {
        let inputs = &inputs[..self.inputs.min(inputs.len())];
        let (whole, rest) = inputs.as_chunks::<WIDTH>();
        let (groups, _) = values.as_chunks_mut::<WIDTH>();
        for (group, eight) in groups.iter_mut().zip(whole) {
            *group = *eight;
        }
        if let Some(group) = groups.get_mut(whole.len()).filter(|_| !rest.is_empty()) {
            *group = pick.store(pick.load_some(rest));
        }
        let first = Self::first(self.inputs);
        for (group, four) in groups.iter_mut().skip(first / WIDTH).zip(self.angles.chunks(WIDTH / 2)) {
            // written as one, or what reads all eight would wait
            let mut eight = pick.load(&[0.0; WIDTH]);
            for (number, &angle) in four.iter().enumerate() {
                let Some(angle) = inputs.get(angle) else { continue };
                let point = angle.circle();
                eight = match number {
                    0 => pick.load(&[point.cos, point.sin, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]),
                    _ => {
                        let with = pick.blend(1 << (2 * number), eight, pick.load(&[point.cos; WIDTH]));
                        pick.blend(2 << (2 * number), with, pick.load(&[point.sin; WIDTH]))
                    }
                };
            }
            *group = pick.store(eight);
        }
        self.fill_others(inputs, values);
    }

    /// Behind circle points: fractions, and what is left.
    #[inline(always)]
    fn fill_others(&self, inputs: &[f64], values: &mut [f64]) {
        let fractions = Self::first(self.inputs) + 2 * self.angles.len();
        for ((input, fraction), value) in self.fractions.iter().zip(values.iter_mut().skip(fractions)) {
            *value = inputs.get(*input).map_or(0.0, |at| fraction.value(*at));
        }
        if self.others.outputs() > 0 {
            let (known, others) = values.split_at_mut((fractions + self.fractions.len()).min(values.len()));
            let known = known.iter().copied();
            let written = match self.others.registers() {
                few if few <= FEW => self.others.evaluate::<f64, FEW>(&self.constants, known, others),
                some if some <= SOME => self.others.evaluate::<f64, SOME>(&self.constants, known, others),
                _ => self.others.evaluate::<f64, MANY>(&self.constants, known, others),
            };
            // its registers were counted when it was recorded
            written.unwrap_or(());
        }
    }
}

/// The inputs of which circle points occur, and all other parts that move with the inputs.
fn found(inputs: &[Sym], outputs: &[Sym]) -> (Vec<usize>, Vec<Sym>) {
    let mut moving: BTreeSet<Sym> = inputs.iter().copied().collect();
    let (mut angles, mut others) = (BTreeSet::new(), Vec::new());
    let all = Sym::ascending(outputs);
    for &each in &all {
        let node = each.node();
        if !node.children().any(|child| moving.contains(&child)) {
            continue;
        }
        moving.insert(each);
        let other = match node {
            Node::Cos(angle) | Node::Sin(angle) => {
                let input = inputs.iter().position(|input| *input == angle);
                angles.extend(input);
                input.is_none().then_some(each)
            }
            Node::Root(_) => Some(each),
            // what alone is divided by something needs no product after it
            Node::Quotient(_, divisor) if moving.contains(&divisor) => {
                let shares = |other: &Sym| matches!(other.node(), Node::Quotient(_, by) if by == divisor);
                let alone = all.iter().filter(|other| shares(other)).count() == 1;
                Some(if alone { each } else { Sym::ONE / divisor })
            }
            _ => None,
        };
        others.extend(other.filter(|other| !others.contains(other)));
    }
    (angles.into_iter().collect(), others)
}

/// Where a part is a fraction in one input alone: that input, and the fraction.
fn fraction(inputs: &[Sym], part: Sym) -> Option<(usize, Fraction<f64>)> {
    let leaves = part.leaves_of();
    let [leaf] = leaves[..] else { return None };
    let input = inputs.iter().position(|input| *input == leaf)?;
    Some((input, Fraction::record(part, leaf)?.over()))
}
