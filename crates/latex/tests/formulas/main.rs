//! Formulas in LaTeX that are accepted, rejected, or read back from their printed form.

mod displays;
mod readings;
mod refusals;
mod round_trip;

use dalembert_latex::{Meaning, NotFormula, Value, letter_name, read, value};
use symbolic::Sym;

/// Letters, each with the value of a symbol.
pub struct Plain {
    pub letters: Vec<(String, Value)>,
}

impl Plain {
    /// Creates scalar letters from pairs (LaTeX, name of the symbol).
    pub fn of(letters: &[(&str, &str)]) -> Self {
        let letter = |(latex, name): &(&str, &str)| {
            (letter_name(latex).expect("it is a letter"), Value::Scalar(Sym::named(name, latex)))
        };
        Plain { letters: letters.iter().map(letter).collect() }
    }

    pub fn spelt(&self) -> Vec<String> {
        self.letters.iter().map(|(name, _)| name.clone()).collect()
    }

    /// Returns the value of a formula with one side.
    pub fn side(&self, text: &str) -> Result<Sym, NotFormula> {
        let statement = read(text, &self.spelt())?;
        match value(&statement.chains[0].sides[0], self) {
            Ok(Value::Scalar(scalar)) => Ok(scalar),
            other => panic!("{text}: {other:?}"),
        }
    }
}

impl Meaning for Plain {
    fn letter(&self, name: &str) -> Option<Value> {
        self.letters.iter().find(|(known, _)| known == name).map(|(_, value)| value.clone())
    }

    fn rate(&self, of: Sym) -> Result<Sym, String> {
        let name = of.symbol_name().ok_or("a rate of a letter alone")?;
        Ok(Sym::symbol(&format!("{name}'")))
    }

    fn partial(&self, of: Sym, by: Sym) -> Result<Sym, String> {
        Ok(of.diff(by))
    }

    fn circle(&self, angle: Sym) -> (Sym, Sym) {
        let point = angle.circle_as_written();
        (point.cos, point.sin)
    }
}
