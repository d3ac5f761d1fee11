//! Conversion of expressions over symbols to expressions of a model, operation by operation.

use crate::arena::{Arena, AtZero, Function, Number, Scalar, Vector};
use crate::expression::Exponent;
use crate::{Model, ScalarId, Trace};
use field::Rational;
use rustc_hash::FxHashMap;
use symbolic::{Node, Sym};

/// The number of digits of an integer that one number of a model represents exactly.
const DIGITS: usize = 15;

/// Converts expressions over the symbols of a trace. Returns the extended list of expressions, and the index of each result; `None` if an expression contains a
/// symbol that the model does not have.
pub(in crate::elaboration) fn transcribed(trace: &Trace<'_>, scalars: &[Sym]) -> Option<(Arena, Vec<ScalarId>)> {
    let mut arena = trace.model.arena.clone();
    let mut known = letters(trace.model, trace, &mut arena);
    for each in Sym::ascending(scalars) {
        if known.contains_key(&each) {
            continue;
        }
        let of = |part: Sym| known[&part];
        let made = match each.node() {
            Node::Symbol(_) | Node::Function(..) => return None,
            Node::Constant(_) => constant(&mut arena, each.as_constant()?)?,
            Node::Sum(a, b) => arena.scalar(Scalar::Sum(of(a), of(b)), None),
            Node::Difference(a, b) => arena.scalar(Scalar::Difference(of(a), of(b)), None),
            Node::Product(a, b) => arena.scalar(Scalar::Product(of(a), of(b)), None),
            Node::Quotient(a, b) => arena.scalar(Scalar::Quotient(of(a), of(b)), None),
            Node::Negation(a) => arena.scalar(Scalar::Negation(of(a)), None),
            Node::Power(a, power) => {
                let exponent = Exponent { numerator: i32::try_from(power).ok()?, denominator: 1 };
                arena.scalar(Scalar::Power(of(a), exponent), None)
            }
            Node::Cos(a) => arena.scalar(Scalar::Function(Function::Cos, of(a)), None),
            Node::Sin(a) => arena.scalar(Scalar::Function(Function::Sin, of(a)), None),
            Node::Root(a) => arena.scalar(Scalar::Function(Function::Sqrt, of(a)), None),
            Node::Elementary(function, a, b) => arena.scalar(Scalar::Elementary(function, of(a), of(b)), None),
        };
        known.insert(each, made);
    }
    let found = scalars.iter().map(|scalar| known[scalar]).collect();
    Some((arena, found))
}

/// Returns the model's expression for each symbol of a trace.
fn letters(model: &Model, trace: &Trace<'_>, arena: &mut Arena) -> FxHashMap<Sym, ScalarId> {
    let own = &trace.coordinates[..model.coordinates.len()];
    let coordinates = own.iter().enumerate().map(|(place, &letter)| (letter, Scalar::Coordinate(place)));
    let speeds = trace.speeds.iter().enumerate();
    let speeds = speeds.map(|(coordinate, &letter)| (letter, Scalar::Rate { coordinate, order: 1 }));
    let parameters = trace.parameters.iter().enumerate().map(|(place, &letter)| (letter, Scalar::Parameter(place)));
    let switches =
        trace.switches.iter().enumerate().map(|(place, &letter)| (letter, Scalar::Switch(place, AtZero::Half)));
    let open = model.inputs.iter().enumerate().filter(|(_, input)| input.value.is_none());
    let open = open.map(|(place, input)| (Sym::symbol(&input.name), Scalar::Input(place)));
    let alone = [(trace.time, Scalar::Time), (trace.pi, Scalar::Pi)];
    let all = coordinates.chain(speeds).chain(parameters).chain(switches).chain(open).chain(alone);
    let mut known: FxHashMap<Sym, ScalarId> =
        all.map(|(letter, scalar)| (letter, arena.scalar(scalar, None))).collect();
    for (cosines, &frame) in trace.cosines.iter().zip(&model.free) {
        let parent = trace.parent(frame);
        for (row, column) in (0..9).map(|entry| (entry / 3, entry % 3)) {
            let [a, b] =
                [(parent, row), (frame, column)].map(|(frame, axis)| arena.vector(Vector::Axis { frame, axis }));
            known.insert(cosines[row][column], arena.scalar(Scalar::Dot(a, b), None));
        }
    }
    known
}

/// Converts a rational number exactly; `None` if it is undefined.
fn constant(arena: &mut Arena, value: Rational) -> Option<ScalarId> {
    let big = value.to_big()?;
    let above = whole(arena, &big.numerator().to_string());
    let below = big.denominator().to_string();
    Some(match below.as_str() {
        "1" => above,
        _ => {
            let below = whole(arena, &below);
            arena.scalar(Scalar::Quotient(above, below), None)
        }
    })
}

/// Converts an integer, given by its digits, as a sum of groups of digits.
fn whole(arena: &mut Arena, written: &str) -> ScalarId {
    let number =
        |arena: &mut Arena, value: f64| arena.scalar(Scalar::Number(Number { value, times: 1.0, per: 1.0 }), None);
    let digits = written.trim_start_matches('-');
    let first = (digits.len() - 1) % DIGITS + 1;
    let value = |group: &str| group.parse().unwrap_or(0.0);
    let mut sum = number(arena, value(&digits[..first]));
    for group in digits.as_bytes()[first..].chunks(DIGITS) {
        let base = number(arena, 1e15);
        let shifted = arena.scalar(Scalar::Product(sum, base), None);
        let group = group.iter().fold(0.0, |sum, digit| 10.0 * sum + f64::from(digit - b'0'));
        let group = number(arena, group);
        sum = arena.scalar(Scalar::Sum(shifted, group), None);
    }
    if written.starts_with('-') { arena.scalar(Scalar::Negation(sum), None) } else { sum }
}
