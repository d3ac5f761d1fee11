//! Recording of expressions as a tape.

use super::{Operation, Register, Tape};
use crate::Sym;
use crate::evaluate::constant;
use crate::graph::Node;
use field::{Analytic, Elementary, Rational};
use rustc_hash::FxHashMap;
use std::fmt;

/// The reason why expressions have no straight-line program.
#[derive(Clone, Debug, PartialEq)]
pub enum Untapeable {
    /// This symbol is not among the inputs.
    Unbound(String),
    /// This arbitrary function has no values.
    Function(String),
    /// An expression contains a division by the constant zero.
    Undefined,
    /// The number of rates of a differential equation differs from the number of its states.
    Shape { rates: usize, states: usize },
}

impl fmt::Display for Untapeable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Untapeable::Unbound(name) => write!(f, "`{name}` occurs but is not among the inputs"),
            Untapeable::Function(name) => write!(f, "`{name}` is an arbitrary function and has no values"),
            Untapeable::Undefined => write!(f, "a division by the constant zero"),
            Untapeable::Shape { rates, states } => write!(f, "{rates} rates for {states} states: wanted one for each"),
        }
    }
}

impl std::error::Error for Untapeable {}

/// A number during recording: inputs, constants and results are numbered separately, each in order of occurrence.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
enum Place {
    Input(u32),
    Constant(u32),
    Result(u32),
}

#[derive(Default)]
struct Recorder {
    constants: Vec<Rational>,
    constant_of: FxHashMap<Sym, Place>,
    steps: Vec<Step>,
    known: FxHashMap<Step, Place>,
    results: u32,
}

/// An operation before registers are assigned.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
struct Step {
    operation: Kind,
    a: Place,
    b: Place,
}

#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Kind {
    Sum,
    Difference,
    Product,
    Quotient,
    Negation,
    Root,
    Circle,
    Elementary(Elementary),
}

impl Tape {
    /// Records the program that computes the outputs from the inputs. Common subexpressions are computed once, including a + b and b + a, and cosine and sine
    /// of an angle are computed together. An input is usually a symbol; any other expression counts as an input wherever it occurs.
    ///
    /// # Errors
    /// [`Untapeable`] if a symbol is not among the inputs, a function is arbitrary, or an expression divides by the constant zero.
    pub fn record(inputs: &[Sym], outputs: &[Sym]) -> Result<Tape, Untapeable> {
        let mut recorder = Recorder::default();
        let mut places: FxHashMap<Sym, Place> =
            inputs.iter().enumerate().map(|(number, &input)| (input, Place::Input(number as u32))).collect();
        for each in Sym::reached(outputs, |each, _| !places.contains_key(&each)) {
            if !places.contains_key(&each) {
                let place = recorder.place(each, &places)?;
                places.insert(each, place);
            }
        }
        let outputs: Vec<Place> = outputs.iter().map(|output| places[output]).collect();
        Ok(recorder.finish(inputs.len(), &outputs))
    }
}

impl Recorder {
    fn place(&mut self, each: Sym, places: &FxHashMap<Sym, Place>) -> Result<Place, Untapeable> {
        let of = |a: Sym| places[&a];
        Ok(match each.node() {
            Node::Constant(_) => self.constant(each)?,
            Node::Symbol(_) => return Err(Untapeable::Unbound(each.to_string())),
            Node::Function(..) => return Err(Untapeable::Function(each.to_string())),
            Node::Sum(a, b) => match (a.node(), b.node()) {
                (_, Node::Negation(b)) => self.step(Kind::Difference, of(a), of(b)),
                (Node::Negation(a), _) => self.step(Kind::Difference, of(b), of(a)),
                _ => self.step(Kind::Sum, of(a), of(b)),
            },
            Node::Difference(a, b) => match b.node() {
                Node::Negation(b) => self.step(Kind::Sum, of(a), of(b)),
                _ => self.step(Kind::Difference, of(a), of(b)),
            },
            Node::Product(a, b) => self.step(Kind::Product, of(a), of(b)),
            Node::Quotient(a, b) => self.step(Kind::Quotient, of(a), of(b)),
            Node::Negation(a) => self.step(Kind::Negation, of(a), of(a)),
            Node::Power(a, n) => self.power(of(a), n),
            Node::Root(a) => match a.as_constant().map(|_| a.sqrt()) {
                Some(root) if root.as_constant().is_some() => self.constant(root)?,
                _ => self.step(Kind::Root, of(a), of(a)),
            },
            Node::Elementary(function, a, b) => self.step(Kind::Elementary(function), of(a), of(b)),
            Node::Cos(a) => self.step(Kind::Circle, of(a), of(a)),
            Node::Sin(a) => match self.step(Kind::Circle, of(a), of(a)) {
                Place::Result(cosine) => Place::Result(cosine + 1),
                other => other,
            },
        })
    }

    fn constant(&mut self, constant: Sym) -> Result<Place, Untapeable> {
        if let Some(&known) = self.constant_of.get(&constant) {
            return Ok(known);
        }
        let value = constant.as_constant().filter(|value| value.is_defined()).ok_or(Untapeable::Undefined)?;
        let place = Place::Constant(self.constants.len() as u32);
        self.constants.push(value);
        self.constant_of.insert(constant, place);
        Ok(place)
    }

    /// Computes a power by repeated squaring: x^5 = (x^2)^2 x.
    fn power(&mut self, base: Place, exponent: u32) -> Place {
        let mut power = base;
        for bit in (0..exponent.ilog2()).rev() {
            power = self.step(Kind::Product, power, power);
            if exponent >> bit & 1 == 1 {
                power = self.step(Kind::Product, power, base);
            }
        }
        power
    }

    fn step(&mut self, operation: Kind, a: Place, b: Place) -> Place {
        let commutes = matches!(operation, Kind::Sum | Kind::Product);
        let step = if commutes && b < a { Step { operation, a: b, b: a } } else { Step { operation, a, b } };
        if let Some(&known) = self.known.get(&step) {
            return known;
        }
        let place = Place::Result(self.results);
        self.results += if operation == Kind::Circle { 2 } else { 1 };
        self.steps.push(step);
        self.known.insert(step, place);
        place
    }

    /// Removes operations that no output needs, and assigns registers.
    fn finish(self, inputs: usize, outputs: &[Place]) -> Tape {
        let mut needed = vec![false; self.results as usize];
        let need = |place: &Place, needed: &mut Vec<bool>| {
            if let Place::Result(number) = *place {
                needed[number as usize] = true;
            }
        };
        outputs.iter().for_each(|place| need(place, &mut needed));
        let mut number = self.results as usize;
        let mut kept = Vec::new();
        for step in self.steps.iter().rev() {
            let results = if step.operation == Kind::Circle { 2 } else { 1 };
            number -= results;
            if needed[number..number + results].contains(&true) {
                need(&step.a, &mut needed);
                need(&step.b, &mut needed);
                kept.push((number, step));
            }
        }
        kept.reverse();
        let mut registers = inputs + self.constants.len();
        let mut register_of = vec![0; self.results as usize + 1];
        let register = |place: Place, register_of: &[Register]| match place {
            Place::Input(number) => number,
            Place::Constant(number) => inputs as u32 + number,
            Place::Result(number) => register_of[number as usize],
        };
        let mut operations = Vec::with_capacity(kept.len());
        for (number, step) in kept {
            let (a, b) = (register(step.a, &register_of), register(step.b, &register_of));
            let operation = match step.operation {
                Kind::Sum => Operation::Sum(a, b),
                Kind::Difference => Operation::Difference(a, b),
                Kind::Product if matches!(step.a, Place::Constant(_)) => Operation::Multiple(a, b),
                Kind::Product if matches!(step.b, Place::Constant(_)) => Operation::Multiple(b, a),
                Kind::Product => Operation::Product(a, b),
                Kind::Quotient if matches!(step.b, Place::Constant(_)) => Operation::Part(a, b),
                Kind::Quotient => Operation::Quotient(a, b),
                Kind::Negation => Operation::Negation(a),
                Kind::Root => Operation::Root(a),
                Kind::Circle => Operation::Circle(a),
                Kind::Elementary(function) => Operation::Elementary(function, a, b),
            };
            register_of[number] = registers as Register;
            register_of[number + 1] = registers as Register + 1;
            registers += operation.results();
            operations.push(operation);
        }
        let outputs = outputs.iter().map(|&place| register(place, &register_of)).collect();
        let rounded = self.constants.iter().map(|value| constant(*value)).collect();
        Tape { inputs, constants: self.constants, rounded, operations, outputs, registers, once: false }
    }
}
