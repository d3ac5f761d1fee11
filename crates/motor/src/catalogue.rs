//! The catalogue of motors, from all linked crates.
//!
//! ```
//! let motor = dalembert_motor::catalogue::entry("perpetuum_mobile");
//! assert!(motor.is_none());
//! ```

use super::laws::{Expressions, Laws, TooLong, Winding};
use super::text::{self, ANGLE, SLIP, SPEED};
use super::{Machine, Motor, constant_speed, free_rotor};
use field::{Analytic, Circle};
use reader::{Allowed, Quantity};
use std::sync::Arc;
use symbolic::{Sym, apart};

/// A motor of the catalogue: its data, and its laws as symbolic expressions of them.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// The name in scene files.
    pub name: &'static str,
    /// A summary in one line, for lists and reports.
    pub summary: &'static str,
    /// The data in order. Their names differ from the symbols of the motion (g, g', phi') and of the currents.
    pub data: &'static [Quantity],
    /// Integer parameters of at least one, such as the number of bars.
    pub counts: &'static [Count],
    /// Records the laws as expressions.
    pub write: fn(&mut MachineLetters) -> Result<Laws, TooLong>,
}

/// An integer parameter of at least one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Count {
    pub name: &'static str,
    pub meaning: &'static str,
}

/// The motors of a crate, in the order of lists; catalogues are sorted by name.
#[derive(Clone, Copy, Debug)]
pub struct Catalogue {
    pub name: &'static str,
    pub motors: &'static [&'static Entry],
}

inventory::collect!(Catalogue);

/// Rotors without a motor.
const ROTORS: &[&Entry] = &[&constant_speed::ENTRY, &free_rotor::ENTRY];

/// All motors, after the rotors without a motor.
pub fn entries() -> Vec<&'static Entry> {
    let mut catalogues: Vec<&Catalogue> = inventory::iter::<Catalogue>().collect();
    catalogues.sort_by_key(|catalogue| catalogue.name);
    ROTORS.iter().chain(catalogues.iter().flat_map(|catalogue| catalogue.motors)).copied().collect()
}

/// The motor with this name.
pub fn entry(name: &str) -> Option<&'static Entry> {
    entries().into_iter().find(|entry| entry.name == name)
}

/// Whether several motors have this name, so that a file cannot refer to one of them.
pub fn is_ambiguous(name: &str) -> bool {
    name == text::NAME && entry(name).is_some() || entries().iter().filter(|entry| entry.name == name).count() > 1
}

impl Entry {
    /// The laws for given counts, in the order of [`Entry::counts`].
    ///
    /// # Errors
    /// [`TooLong`] where a law exceeds the registers of a program.
    pub fn laws(&'static self, counts: &[usize]) -> Result<Arc<Laws>, TooLong> {
        let counts: Vec<(Count, usize)> = self.counts.iter().copied().zip(counts.iter().copied()).collect();
        apart(|| (self.write)(&mut MachineLetters { entry: self, counts, settled: Vec::new() })).map(Arc::new)
    }
}

/// A motor of the catalogue with the given value for each quantity and for each count, without a check of bounds.
pub fn sampled(name: &str, value: impl FnMut(&Quantity) -> f64, count: usize) -> Option<Motor> {
    let entry = entry(name)?;
    let laws = entry.laws(&vec![count; entry.counts.len()]).ok()?;
    Some(Motor::new(laws, entry.data.iter().map(value).collect(), Allowed::ALL))
}

/// The symbol of a datum.
///
/// # Errors
/// None; the type is that of the other steps of a recording.
pub fn letter(quantity: &Quantity) -> Result<Sym, TooLong> {
    Ok(Sym::symbol(&quantity.name))
}

/// The symbols and counts with which the laws of a motor are recorded.
#[derive(Debug)]
pub struct MachineLetters {
    entry: &'static Entry,
    counts: Vec<(Count, usize)>,
    settled: Vec<(Sym, Sym)>,
}

impl MachineLetters {
    /// The count with this name; 1 if there is none.
    pub fn count(&self, name: &str) -> usize {
        self.counts.iter().find(|(count, _)| count.name == name).map_or(1, |(_, number)| *number)
    }

    /// A symbol for a value that depends on the data only, such as an angle of a bar. It is computed once, in the
    /// scalar type of the data.
    pub fn settled(&mut self, value: Sym) -> Sym {
        let letter = Sym::symbol(&format!("settled {}", self.settled.len()));
        self.settled.push((letter, value));
        letter
    }

    /// Symbols for a point of the unit circle that depends on the data only, each computed once.
    pub fn settled_point(&mut self, Circle { cos, sin }: Circle<Sym>) -> Circle<Sym> {
        Circle { cos: self.settled(cos), sin: self.settled(sin) }
    }

    /// The laws of a machine as symbolic expressions.
    ///
    /// # Errors
    /// [`TooLong`] where a law exceeds the registers of a program.
    pub fn laws(&self, machine: &impl Machine<Sym>) -> Result<Laws, TooLong> {
        let angle = Sym::symbol(ANGLE).circle();
        let names: Vec<String> = (0..machine.windings()).map(|k| machine.current_name(k)).collect();
        let currents: Vec<Sym> = names.iter().map(|name| Sym::symbol(name)).collect();
        let winding = |(k, current): (usize, String)| Winding {
            current,
            flux: machine.linkage(k, angle),
            supply: machine.supply(k, angle),
            motional: machine.motional(k, &currents),
            inductance: machine.inductance(k),
            resistance: machine.resistance(k),
        };
        let expressions = Expressions {
            rotor: machine.rotor(),
            frame_speed: machine.frame_speed(),
            energy: machine.field_energy(angle),
            torque: machine.torque_law(Sym::symbol(SLIP), Sym::symbol(SPEED)),
            windings: names.into_iter().enumerate().map(winding).collect(),
            settled: self.settled.clone(),
        };
        Laws::new(self.entry.name, self.entry.data.to_vec(), self.counts.clone(), &expressions)
    }
}
