//! The symbols of a system with their texts in a language, and statements over them.

use super::super::identifiers::identifiers;
use super::super::matrix_form::MatrixForm;
use super::{c, modelica, rust};
use crate::Trace;
use std::f64::consts::PI;
use symbolic::{Language, Statements, Sym, Tape};

/// Time, coordinates, speeds, parameters, cases of conditions and pi, each with its text.
#[derive(Clone)]
pub(super) struct Letters {
    language: Language,
    symbols: Vec<Sym>,
    texts: Vec<String>,
    /// Identifiers of the parameters and of inputs without a value.
    pub names: Vec<String>,
    /// The names of these in the file.
    pub quoted: Vec<String>,
}

impl Letters {
    /// Returns the symbols of a form: components of `q`, `u` and `s`, members of `p`.
    pub fn of(trace: &Trace<'_>, form: &MatrixForm, language: Language) -> Self {
        let words = match language {
            Language::C => c::WORDS,
            Language::Python => "",
            Language::Rust => rust::WORDS,
            Language::Modelica => modelica::WORDS,
        };
        let given: Vec<Sym> = form.parameters.iter().chain(&form.inputs).copied().collect();
        let names = identifiers(&given, words);
        let quoted: Vec<String> = given.iter().map(Sym::to_string).collect();
        let access = |place: usize| match language {
            Language::C => format!("p->{}", names[place]),
            Language::Python => format!("p[{:?}]", quoted[place]),
            Language::Rust => format!("p.{}", names[place]),
            Language::Modelica => names[place].clone(),
        };
        let component = |name: &'static str, count: usize| (0..count).map(move |i| format!("{name}[{i}]"));
        let texts: Vec<String> = std::iter::once("t".to_owned())
            .chain(component("q", form.positions.len()))
            .chain(component("u", form.speeds.len()))
            .chain((0..names.len()).map(access))
            .chain((0..form.switches.len()).map(|k| format!("s[{k}]")))
            .chain([format!("{PI:?}")])
            .collect();
        let symbols = std::iter::once(form.time)
            .chain([&form.positions, &form.speeds, &given].into_iter().flatten().copied())
            .chain(form.switches.iter().map(|(letter, _)| *letter))
            .chain([trace.pi])
            .collect();
        Letters { language, symbols, texts, names, quoted }
    }

    /// Returns the symbols with additional ones, or with other texts for some.
    pub fn with(&self, more: impl IntoIterator<Item = (Sym, String)>) -> Self {
        let mut with = self.clone();
        for (symbol, text) in more {
            match with.symbols.iter().position(|own| *own == symbol) {
                Some(place) => with.texts[place] = text,
                None => {
                    with.symbols.push(symbol);
                    with.texts.push(text);
                }
            }
        }
        with
    }

    /// Returns statements that compute expressions.
    ///
    /// # Errors
    /// An expression contains an unknown symbol, divides by the constant zero, or contains a constant beyond the range of double precision.
    pub fn statements(&self, expressions: &[Sym]) -> Result<Statements, String> {
        let tape = Tape::record(&self.symbols, expressions).map_err(|error| error.to_string())?;
        match tape.beyond_range() {
            None => Ok(tape.statements(self.language, &self.texts)),
            Some(_) => Err("a constant of the equations is beyond the range of double precision".to_owned()),
        }
    }
}
