//! The letters that are constant on a steady motion: coordinates and speeds.

use crate::claim_text::ClaimText;
use crate::conditions::scalar;
use crate::letters::Letters;
use crate::passage::placed;
use latex::{Form, read};
use reader::Issue;
use symbolic::Sym;

/// The indices of the constant coordinates and of the constant speeds.
pub(crate) struct Resting {
    pub coordinates: Vec<usize>,
    pub speeds: Vec<usize>,
}

impl Resting {
    /// Reads the letters of `resting` of a claim.
    ///
    /// # Errors
    /// A letter is neither a coordinate nor a speed.
    pub fn of(claim: &ClaimText, letters: &Letters<'_, '_>) -> Result<Self, Issue> {
        let trace = letters.trace;
        let accepted = r"letters of coordinates, and their rates: '\theta', '\dot{\varphi}'";
        let mut found = Resting { coordinates: Vec::new(), speeds: Vec::new() };
        for text in &claim.resting {
            let statement = read(&text.text, &letters.spelt()).map_err(|fault| placed(text, fault))?;
            let side = &statement.chains[0].sides[0];
            if !matches!(side.form, Form::Letter(_) | Form::Rate(..)) {
                return Err(
                    Issue::at(text.span.clone(), "what rests is one letter, or its rate", "here").accepted(accepted)
                );
            }
            let (symbol, _) = scalar(text, side, letters)?;
            let coordinate = trace.coordinates.iter().take(trace.speeds.len()).position(|one| *one == symbol);
            match (coordinate, trace.speeds.iter().position(|one| *one == symbol)) {
                (Some(place), _) => found.coordinates.push(place),
                (None, Some(place)) => found.speeds.push(place),
                (None, None) => {
                    let title = format!("`{}` is neither a coordinate of the model nor a speed", text.text);
                    return Err(Issue::at(text.span.clone(), title, "here").accepted(accepted));
                }
            }
        }
        Ok(found)
    }

    /// The speeds that are constant, and need not be zero.
    pub fn constant_speeds(&self, letters: &Letters<'_, '_>) -> Vec<Sym> {
        self.speeds.iter().map(|&place| letters.trace.speeds[place]).collect()
    }

    /// The rates that vanish on the motion, each with the value zero.
    pub fn rates(&self, letters: &Letters<'_, '_>) -> Vec<(Sym, Sym)> {
        let trace = letters.trace;
        let of_coordinates =
            self.coordinates.iter().flat_map(|&place| [trace.speeds[place], trace.accelerations[place]]);
        let of_speeds = self.speeds.iter().map(|&place| trace.accelerations[place]);
        of_coordinates.chain(of_speeds).map(|rate| (rate, Sym::ZERO)).collect()
    }
}
