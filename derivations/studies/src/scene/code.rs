//! A scene's right-hand side and Jacobian as straight-line programs, for export to other languages.

use super::{Scene, Setup};
use motor::Bench;
use simulation::{Axes, TracedOde, traced};
use symbolic::{Sym, Tape, Untapeable};
use systems::gyrostat::driven::Driven;

impl Scene {
    /// The rates of the states as a tape over the states, in the axes of a form; the scene's data are constants in it.
    ///
    /// # Errors
    /// [`Untapeable`] where the law divides by the constant zero.
    pub fn tape(&self, axes: Axes) -> Result<Tape, Untapeable> {
        self.read(axes, |TracedOde { state, rates, .. }| Tape::record(state, rates))
    }

    /// The tape of the Jacobian of the rates, row by row, by exact differentiation of the recorded expressions.
    ///
    /// # Errors
    /// [`Untapeable`] where the law divides by the constant zero.
    pub fn jacobian_tape(&self, axes: Axes) -> Result<Tape, Untapeable> {
        self.read(axes, |TracedOde { state, rates, .. }| {
            let entries: Vec<Sym> = rates.iter().flat_map(|rate| state.iter().map(|&by| rate.diff(by))).collect();
            Tape::record(state, &entries)
        })
    }

    fn read(&self, axes: Axes, read: fn(&TracedOde) -> Result<Tape, Untapeable>) -> Result<Tape, Untapeable> {
        let machine = self.machine.clone();
        match (&self.system, axes) {
            (Setup::Gyrostat(bodies), Axes::First) => traced(&Driven::new(bodies.first_form().0, machine), read),
            (Setup::Gyrostat(bodies), Axes::Second) => traced(&Driven::new(bodies.second_form().0, machine), read),
            (Setup::Bench { axial }, _) => traced(&Bench { machine, axial: *axial }, read),
        }
    }
}
