//! A tape as source text: straight-line code of other languages, every common part once.

use super::{Operation, Register, Tape};
use field::Elementary;
use std::fmt::{self, Write};

/// A language in which a tape can be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    C,
    Python,
    Rust,
    Modelica,
}

/// A tape as a function of a language, for display.
///
/// | language | signature | needs |
/// |---|---|---|
/// | C | `void NAME(const double *y, double *dy)` | `math.h` |
/// | Python | `def NAME(y, cos=cos, sin=sin, sqrt=sqrt)`, gives a list | the three functions: of floats, arrays or symbols |
/// | Rust | `pub fn NAME(y: &[f64; N], dy: &mut [f64; M])` | |
/// | Modelica | `function NAME`, from y to dy | |
///
/// The constants are rounded to `f64`: the code agrees with the law to round-off.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    tape: &'a Tape,
    language: Language,
    name: &'a str,
    /// The texts of the inputs, instead of the components of y.
    inputs: Option<&'a [String]>,
}

/// A tape as statements of a language, for a function whose head and end are written elsewhere.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Statements {
    /// One a line, each after those that it reads.
    pub lines: Vec<String>,
    /// The outputs: names or numbers.
    pub outputs: Vec<String>,
}

impl Tape {
    /// The tape as a function with this name.
    pub fn source<'a>(&'a self, language: Language, name: &'a str) -> Source<'a> {
        Source { tape: self, language, name, inputs: None }
    }

    /// The tape as statements over inputs with these texts, one for each; results have the names r0, r1, ...; in Modelica the statements
    /// are equations of a model, which declares the results.
    pub fn statements(&self, language: Language, inputs: &[String]) -> Statements {
        let source = Source { tape: self, language, name: "", inputs: Some(inputs) };
        let outputs = self.outputs.iter().map(|&output| source.number(output)).collect();
        Statements { lines: source.lines(), outputs }
    }

    /// The numbers of additions, multiplications, divisions and roots; a circle point is counted apart, negations are
    /// free.
    pub fn flops(&self) -> usize {
        let of = |operation: &Operation| match operation {
            Operation::Circle(_) | Operation::Elementary(..) | Operation::Negation(_) => 0,
            Operation::ProductAnd(..) | Operation::ProductLess(..) | Operation::LessProduct(..) => 2,
            _ => 1,
        };
        self.operations.iter().map(of).sum()
    }
}

impl Source<'_> {
    /// The text of an operand: in brackets where it begins with a sign.
    fn operand(&self, register: Register) -> String {
        let text = self.number(register);
        if text.starts_with('-') { format!("({text})") } else { text }
    }

    /// The text of a number.
    fn number(&self, register: Register) -> String {
        let number = register as usize;
        let Tape { inputs, rounded, .. } = self.tape;
        match number.checked_sub(*inputs) {
            None => match self.inputs.and_then(|inputs| inputs.get(number)) {
                Some(name) => name.clone(),
                None => format!("y[{}]", number + usize::from(self.language == Language::Modelica)),
            },
            Some(place) => match rounded.get(place) {
                Some(value) => format!("{value:?}"),
                None => format!("r{}", place - rounded.len()),
            },
        }
    }

    /// Whether each result is an operand or an output: often only one coordinate of a circle point is.
    fn used(&self) -> Vec<bool> {
        let Tape { inputs, constants, operations, outputs, registers, .. } = self.tape;
        let first = inputs + constants.len();
        let mut used = vec![false; registers - first];
        let operands = operations.iter().flat_map(|operation| operation.operands());
        for register in operands.chain(outputs.iter().copied()) {
            if let Some(place) = (register as usize).checked_sub(first) {
                used[place] = true;
            }
        }
        used
    }

    /// A call of an elementary function.
    fn elementary(&self, function: Elementary, a: &str, b: &str) -> String {
        let name = match (self.language, function) {
            (Language::C | Language::Python | Language::Modelica, Elementary::Ln) => "log",
            _ => function.name(),
        };
        match (self.language, function.arguments()) {
            // a literal has no methods
            (Language::Rust, 1) => format!("f64::{name}({a})"),
            (Language::Rust, _) => format!("f64::{name}({a}, {b})"),
            (_, 1) => format!("{name}({a})"),
            (_, _) => format!("{name}({a}, {b})"),
        }
    }

    /// A statement for every operation.
    fn lines(&self) -> Vec<String> {
        let (mut next, used) = (0, self.used());
        let mut lines = Vec::with_capacity(self.tape.operations.len());
        for &operation in &self.tape.operations {
            lines.push(self.statement(operation, next, &used));
            next += operation.results();
        }
        lines
    }

    /// The statement that computes one operation into registers from `next` on.
    fn statement(&self, operation: Operation, next: usize, used: &[bool]) -> String {
        let [a, b, c] = operation.operands().map(|operand| self.operand(operand));
        let (start, end) = match self.language {
            Language::C => ("const double ", ";"),
            Language::Python => ("", ""),
            Language::Modelica => ("", ";"),
            Language::Rust => ("let ", ";"),
        };
        // equations of a model, statements of a function
        let is = if self.language == Language::Modelica && self.inputs.is_none() { ":=" } else { "=" };
        let value = match operation {
            Operation::Sum(..) => format!("{a} + {b}"),
            Operation::Difference(..) => format!("{a} - {b}"),
            Operation::Product(..) | Operation::Multiple(..) => format!("{a} * {b}"),
            Operation::Quotient(..) | Operation::Part(..) => format!("{a} / {b}"),
            Operation::Negation(_) => format!("-{a}"),
            Operation::ProductAnd(..) => format!("{a} * {b} + {c}"),
            Operation::ProductLess(..) => format!("{a} * {b} - {c}"),
            Operation::LessProduct(..) => format!("{c} - {a} * {b}"),
            Operation::Elementary(function, ..) => self.elementary(function, &a, &b),
            // a literal has no methods
            Operation::Root(_) if self.language == Language::Rust => format!("f64::sqrt({a})"),
            Operation::Root(_) => format!("sqrt({a})"),
            Operation::Circle(_) => {
                let part = |function: &str, register: usize| match self.language {
                    Language::Rust => format!("{start}r{register} {is} f64::{function}({a}){end}"),
                    _ => format!("{start}r{register} {is} {function}({a}){end}"),
                };
                let parts = [("cos", next), ("sin", next + 1)].into_iter().filter(|(_, register)| used[*register]);
                return parts.map(|(function, register)| part(function, register)).collect::<Vec<_>>().join("\n    ");
            }
        };
        format!("{start}r{next} {is} {value}{end}")
    }
}

impl fmt::Display for Source<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Source { tape, language, name, .. } = *self;
        let (n, m) = (tape.inputs(), tape.outputs());
        match language {
            Language::C => writeln!(f, "void {name}(const double *y, double *dy)\n{{")?,
            Language::Python => writeln!(f, "def {name}(y, cos=cos, sin=sin, sqrt=sqrt):")?,
            Language::Rust => writeln!(f, "pub fn {name}(y: &[f64; {n}], dy: &mut [f64; {m}]) {{")?,
            Language::Modelica => {
                writeln!(f, "function {name}\n  input Real y[{n}];\n  output Real dy[{m}];\nprotected")?;
                let mut results = self.used().into_iter().enumerate().filter(|(_, used)| *used);
                results.try_for_each(|(result, _)| writeln!(f, "  Real r{result};"))?;
                writeln!(f, "algorithm")?;
            }
        }
        for line in self.lines() {
            writeln!(f, "    {line}")?;
        }
        let outputs = tape.outputs.iter().map(|&output| self.number(output));
        if language == Language::Python {
            return writeln!(f, "    return [{}]", outputs.collect::<Vec<_>>().join(", "));
        }
        let mut text = String::new();
        for (place, output) in outputs.enumerate() {
            match language {
                Language::Modelica => writeln!(text, "    dy[{}] := {output};", place + 1)?,
                _ => writeln!(text, "    dy[{place}] = {output};")?,
            }
        }
        match language {
            Language::Modelica => writeln!(f, "{text}end {name};"),
            _ => writeln!(f, "{text}}}"),
        }
    }
}
