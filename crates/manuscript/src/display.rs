//! Findings expressed in the letters of the paper.

use crate::admissible::{Unusual, unusual};
use crate::claim_text::Kind;
use crate::finding::Finding;
use crate::letter_forms::ways_to_tell;
use crate::letters::Letters;
use crate::lines::Line;
use crate::motion::Motion;
use crate::position_letters::by_position_letters;
use crate::refutation::Refutation;
use field::Elementary;
use model::equations::Equations;
use std::cell::OnceCell;
use symbolic::{Hypotheses, Node, Sym, normal};

/// The letters of a paper, in which results are printed.
#[derive(Clone, Copy)]
pub(crate) struct Told<'a, 't, 'm>(pub &'a Letters<'t, 'm>);

/// The largest length of a printed difference in characters.
const READABLE: usize = 600;

/// An equation as text and LaTeX, without simplification.
pub(crate) fn shown([left, right]: [Sym; 2]) -> (String, String) {
    (format!("{left} = {right}"), format!("{} = {}", left.latex(), right.latex()))
}

/// The conditions that divisors do not vanish, as text and LaTeX, each once and in its shortest form.
pub(crate) fn divisors(found: &[Sym], told: Told<'_, '_, '_>) -> Vec<(String, String)> {
    let mut all: Vec<(String, String)> = Vec::new();
    let mut known: Vec<Sym> = Vec::new();
    let constrained = OnceCell::new();
    // papers have no letters for the coordinates of a free frame; other letters of position express them
    let by_letters = |part: Sym| {
        let coordinates = &told.0.trace.coordinates;
        let is_foreign = |symbol: &Sym| coordinates.contains(symbol) && has_no_letter(&told.0.told(*symbol), told);
        let hypotheses = || &constrained.get_or_init(|| Motion::by_constraints(told.0.trace)).hypotheses;
        let found = || by_position_letters(told.0, part, hypotheses());
        let own = part.symbols_of().iter().any(is_foreign).then(found).flatten()?;
        normal(own, &Hypotheses::none()).ok().map(|form| form.numerator())
    };
    let is_multiple = |part: Sym, of: &Sym| {
        normal(part / *of, &Hypotheses::none()).is_ok_and(|quotient| quotient.as_constant().is_some())
    };
    // the quaternion of a free frame has length one
    let unit = Motion::without_anything(told.0.trace).with_free_frames(Hypotheses::none());
    let is_exponential = |part: Sym| matches!(part.node(), Node::Elementary(Elementary::Exp, ..));
    let never_vanishes =
        |part: Sym| is_exponential(part) || normal(part, &unit).is_ok_and(|form| form.to_sym().as_constant().is_some());
    for &divisor in found {
        // a quotient vanishes where its numerator does; its denominator is a divisor of its own
        let parts = normal(divisor, &Hypotheses::none()).map_or(vec![divisor], |form| factors(form.numerator()));
        for part in parts.into_iter().filter(|part| !never_vanishes(*part)) {
            let part = sine_of(part).unwrap_or(part);
            let own = by_letters(part).unwrap_or_else(|| told.0.told(part));
            if known.iter().any(|of| is_multiple(own, of)) {
                continue;
            }
            known.push(own);
            let line = (format!("{own} != 0"), format!(r"{} \neq 0", own.latex()));
            if !all.contains(&line) {
                all.push(line);
            }
        }
    }
    all.sort_by_key(|(text, _)| (text.chars().count(), text.clone()));
    all
}

/// The sine whose square divides an expression with a numerical quotient, since the normal form expresses sin² by cosines.
fn sine_of(expression: Sym) -> Option<Sym> {
    let angles = expression.leaves_of().into_iter().filter_map(|leaf| match leaf.node() {
        Node::Cos(angle) => Some(angle),
        _ => None,
    });
    let mut sines = angles.map(|angle| Sym::from_node(Node::Sin(angle)));
    let is_square = |sine: &Sym| {
        let quotient = normal(expression / (*sine * *sine), &Hypotheses::none());
        quotient.is_ok_and(|quotient| quotient.to_sym().as_constant().is_some())
    };
    sines.find(is_square)
}

/// The factors of a product, without signs and exponents.
pub(crate) fn factors(product: Sym) -> Vec<Sym> {
    match product.node() {
        Node::Product(a, b) => [factors(a), factors(b)].concat(),
        Node::Negation(a) | Node::Power(a, _) => factors(a),
        _ => vec![product],
    }
}

/// Adds a counterexample to a finding in the paper's letters: the value of each letter of the formula, then the other values that define the point.
pub(crate) fn tell_point(
    own: [Sym; 2],
    refutation: &Refutation,
    motion: &Motion<'_, '_>,
    told: Told<'_, '_, '_>,
    finding: &mut Finding,
) {
    let mut listed: Vec<(String, String)> = Vec::new();
    let mut add = |name: String, value: Sym| {
        if listed.iter().all(|(known, _)| *known != name) {
            listed.push((name, value.to_string()));
        }
    };
    for (letter, meaning) in told.0.meanings(own[0] - own[1]) {
        if let Some(value) = refutation.value(motion.reduced(meaning)) {
            add(letter.to_string(), value);
        }
    }
    // values of roots are left out, since the letters in them have values; so are sines and cosines of angles with values
    let has_value = |letter: &Sym| refutation.point.iter().any(|(known, _)| known == letter);
    let is_told = |symbol: Sym| match symbol.node() {
        Node::Product(..) | Node::Root(_) => false,
        Node::Cos(angle) | Node::Sin(angle) => refutation.is_formal || !angle.symbols_of().iter().all(has_value),
        _ => true,
    };
    for &(symbol, value) in refutation.point.iter().filter(|(symbol, _)| is_told(*symbol)) {
        add(told.0.told(symbol).to_string(), value);
    }
    for symbol in motion.replaced() {
        if let Some(value) = refutation.value(motion.reduced(symbol)) {
            add(told.0.told(symbol).to_string(), value);
        }
    }
    finding.judged.counterexample = listed;
    let Unusual { not_positive, mut zero } = unusual(refutation, motion);
    // a formula in one letter alone determines the value of this letter
    zero.retain(|one| (own[0] - own[1]).symbols_of() != [told.0.told(*one)]);
    let listed =
        |letters: Vec<Sym>| letters.into_iter().map(|one| told.0.told(one).to_string()).collect::<Vec<_>>().join(", ");
    finding.unusual = match (not_positive.is_empty(), zero.is_empty()) {
        (true, true) => String::new(),
        (true, false) => format!("no point was found at which it fails and {} does not vanish", listed(zero)),
        _ => format!("no point was found at which it fails with positive {}", listed(not_positive)),
    };
}

/// The number of operations, common parts counted once, beyond which the normal form of a difference is not computed for display.
const MANY: usize = 1_000;

/// Adds the terms to a finding that the right side lacks: relative to the closest equation of motion, or to the derived value.
pub(crate) fn missing(kind: Kind, line: &Line, motion: &Motion<'_, '_>, told: Told<'_, '_, '_>, finding: &mut Finding) {
    let short = |expression: Sym| {
        let form = normal(expression, &motion.hypotheses).ok()?;
        plainest(form.to_sym(), line.own, motion, told)
    };
    let [left, right] = line.model;
    // reactions for which the paper has no letters say nothing to its reader
    let has_no_reaction =
        |(own, _): &(Sym, String)| !own.symbols_of().iter().any(|symbol| symbol.to_string().starts_with("multiplier "));
    let of_equations = (kind == Kind::EquationOfMotion).then(|| closest(left - right, motion, &short)).flatten();
    let of_equations = of_equations.filter(has_no_reaction);
    let along = motion.reduced(left) - motion.reduced(right);
    let is_short = of_equations.is_none() || Sym::operations_of(&[along]) <= MANY;
    let value = if is_short { short(along) } else { None }.map(|own| (own, String::new()));
    let found = match (value, of_equations) {
        (Some(value), Some(equation)) if length(equation.0) < length(value.0) => Some(equation),
        (value, equation) => value.or(equation),
    };
    let Some((own, of)) = found.filter(|(own, _)| length(*own) <= READABLE) else { return };
    finding.judged.difference = Some((own.to_string(), own.latex()));
    if !of.is_empty() {
        finding.judged.evidence += &format!("; with the terms below on its right side it is {of}");
    }
}

/// An expression in normal form in the letters of a printed formula, if it is short enough to read.
pub(crate) fn readable(left: Sym, print: [Sym; 2], motion: &Motion<'_, '_>, told: Told<'_, '_, '_>) -> Option<Sym> {
    let form = normal(left, &motion.hypotheses).ok()?;
    plainest(form.to_sym(), print, motion, told).filter(|own| length(*own) <= READABLE)
}

/// The form of an expression in the paper's letters with the fewest symbols for which the paper has no letter, and among these with the fewest symbols
/// that the printed formula does not contain.
pub(crate) fn plainest(
    expression: Sym,
    print: [Sym; 2],
    motion: &Motion<'_, '_>,
    told: Told<'_, '_, '_>,
) -> Option<Sym> {
    let plain = |way: Sym| normal(way, &Hypotheses::none()).map_or(way, |form| form.to_sym());
    let printed: Vec<Sym> = print.into_iter().flat_map(Sym::symbols_of).collect();
    let others = |way: &Sym| {
        let symbols = way.symbols_of();
        let foreign = symbols.iter().filter(|symbol| has_no_letter(symbol, told)).count();
        (foreign, symbols.iter().filter(|symbol| !printed.contains(symbol)).count())
    };
    ways_to_tell(told.0, expression, &motion.hypotheses).into_iter().map(plain).min_by_key(others)
}

/// Whether the paper has no letter for a symbol.
fn has_no_letter(symbol: &Sym, told: Told<'_, '_, '_>) -> bool {
    symbol.symbol_name().is_none_or(|name| told.0.dimension(&name).is_none())
}

pub(crate) fn length(expression: Sym) -> usize {
    expression.to_string().chars().count()
}

/// The shortest difference between a printed equation and multiples of the equations of the model, with a description of the equation.
fn closest(printed: Sym, motion: &Motion<'_, '_>, short: &impl Fn(Sym) -> Option<Sym>) -> Option<(Sym, String)> {
    let trace = motion.trace;
    let Equations { mass, bias, constraints } = Equations::of(trace);
    let mut best: Option<(Sym, String)> = None;
    for (k, row) in mass.iter().enumerate() {
        let inertia = row.iter().zip(&trace.accelerations).fold(bias[k], |sum, (&entry, &rate)| sum + entry * rate);
        let equation = constraints.iter().fold(inertia, |sum, one| sum - one.multiplier * one.row[k]);
        for (j, &entry) in row.iter().enumerate() {
            let factor = trace.by_acceleration(printed, j);
            if factor == Sym::ZERO || entry == Sym::ZERO {
                continue;
            }
            let Some(own) = normal(factor / entry, &Hypotheses::none())
                .ok()
                .and_then(|factor| short(printed - factor.to_sym() * equation))
            else {
                continue;
            };
            if best.as_ref().is_none_or(|(known, _)| length(own) < length(*known)) {
                let name = trace.direction(k);
                best = Some((own, format!("a multiple of the model's equation of {name}")));
            }
        }
    }
    best
}
