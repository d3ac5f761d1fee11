//! Translation of a tape to source code of other languages.

use super::{Operation, Register, Tape};
use field::Elementary;
use std::fmt::{self, Write};

/// A target language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    C,
    Python,
    Rust,
    Modelica,
}

/// A tape as a function in a target language; prints itself by [`Display`](fmt::Display).
///
/// | language | signature | needs |
/// |---|---|---|
/// | C | `void NAME(const double *y, double *dy)` | `math.h` |
/// | Python | `def NAME(y, cos=cos, sin=sin, sqrt=sqrt)`, returns a list | these functions, for floats, arrays or symbols; other elementary functions by their names |
/// | Rust | `pub fn NAME(y: &[f64; N], dy: &mut [f64; M])` | |
/// | Modelica | `function NAME`, from y to dy | |
///
/// The constants are rounded to `f64`, hence the code agrees with the tape up to rounding errors.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    tape: &'a Tape,
    language: Language,
    name: &'a str,
    /// Texts that replace the components of y.
    inputs: Option<&'a [String]>,
}

/// A tape as statements of a language. The caller writes the head and the end of the function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Statements {
    /// The statements. Each follows those whose results it reads.
    pub lines: Vec<String>,
    /// The outputs: names of results, or numbers.
    pub outputs: Vec<String>,
}

impl Tape {
    /// Returns the tape as a function with the given name.
    pub fn source<'a>(&'a self, language: Language, name: &'a str) -> Source<'a> {
        Source { tape: self, language, name, inputs: None }
    }

    /// Returns the tape as statements. `inputs` are the texts of the inputs, one for each. The results are named r0, r1, ... In Modelica the statements
    /// are equations of a model, which must declare the results.
    pub fn statements(&self, language: Language, inputs: &[String]) -> Statements {
        let source = Source { tape: self, language, name: "", inputs: Some(inputs) };
        let outputs = self.outputs.iter().map(|&output| source.number(output)).collect();
        Statements { lines: source.lines(), outputs }
    }

    /// Returns the number of additions, multiplications, divisions and roots of an evaluation. Negations, sines and cosines, and elementary functions are not
    /// counted.
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
    /// Returns the text of an operand, in parentheses if it begins with a sign.
    fn operand(&self, register: Register) -> String {
        let text = self.number(register);
        if text.starts_with('-') { format!("({text})") } else { text }
    }

    /// Returns the text of an input, constant or result.
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

    /// Returns whether each result is an operand or an output. Often only one of cosine and sine is.
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

    /// Returns a call of an elementary function.
    fn elementary(&self, function: Elementary, a: &str, b: &str) -> String {
        let name = match (self.language, function) {
            (Language::C | Language::Python | Language::Modelica, Elementary::Ln) => "log",
            _ => function.name(),
        };
        match (self.language, function.arguments()) {
            // a method call on a literal would not compile in Rust
            (Language::Rust, 1) => format!("f64::{name}({a})"),
            (Language::Rust, _) => format!("f64::{name}({a}, {b})"),
            (_, 1) => format!("{name}({a})"),
            (_, _) => format!("{name}({a}, {b})"),
        }
    }

    /// Returns a statement for each operation.
    fn lines(&self) -> Vec<String> {
        let (mut next, used) = (0, self.used());
        let mut lines = Vec::with_capacity(self.tape.operations.len());
        for &operation in &self.tape.operations {
            lines.push(self.statement(operation, next, &used));
            next += operation.results();
        }
        lines
    }

    /// Returns the statement for one operation, whose first result has the number `next`.
    fn statement(&self, operation: Operation, next: usize, used: &[bool]) -> String {
        let [a, b, c] = operation.operands().map(|operand| self.operand(operand));
        let (start, end) = match self.language {
            Language::C => ("const double ", ";"),
            Language::Python => ("", ""),
            Language::Modelica => ("", ";"),
            Language::Rust => ("let ", ";"),
        };
        // equations of a model need `=`, statements of a function `:=`
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
