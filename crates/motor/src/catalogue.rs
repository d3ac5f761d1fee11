//! The catalogue of motors by name, from every crate that is linked.
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

/// A motor of the catalogue: its data, and its laws in letters that stand for them.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// The name in scene files.
    pub name: &'static str,
    /// A summary in one line, for lists and reports.
    pub summary: &'static str,
    /// The data in their order; none has the name of a letter of the motion, g, g', phi', or of a current.
    pub data: &'static [Quantity],
    /// Whole numbers of at least one that make the motor, such as that of its bars.
    pub counts: &'static [Count],
    /// Records the laws as expressions.
    pub write: fn(&mut MachineLetters) -> Result<Laws, TooLong>,
}

/// A whole number of at least one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Count {
    pub name: &'static str,
    pub meaning: &'static str,
}

/// The motors that a crate brings, in the order of lists; catalogues are ordered by name.
#[derive(Clone, Copy, Debug)]
pub struct Catalogue {
    pub name: &'static str,
    pub motors: &'static [&'static Entry],
}

inventory::collect!(Catalogue);

/// Rotors without a motor.
const ROTORS: &[&Entry] = &[&constant_speed::ENTRY, &free_rotor::ENTRY];

/// Every motor with a name, after the rotors without a motor.
pub fn entries() -> Vec<&'static Entry> {
    let mut catalogues: Vec<&Catalogue> = inventory::iter::<Catalogue>().collect();
    catalogues.sort_by_key(|catalogue| catalogue.name);
    ROTORS.iter().chain(catalogues.iter().flat_map(|catalogue| catalogue.motors)).copied().collect()
}

/// The motor with this name.
pub fn entry(name: &str) -> Option<&'static Entry> {
    entries().into_iter().find(|entry| entry.name == name)
}

/// Whether several motors have this name: a file cannot mean one of them then.
pub fn is_ambiguous(name: &str) -> bool {
    name == text::NAME && entry(name).is_some() || entries().iter().filter(|entry| entry.name == name).count() > 1
}

impl Entry {
    /// The laws for these counts, in the order of [`Entry::counts`].
    ///
    /// # Errors
    /// [`TooLong`].
    pub fn laws(&'static self, counts: &[usize]) -> Result<Arc<Laws>, TooLong> {
        let counts: Vec<(Count, usize)> = self.counts.iter().copied().zip(counts.iter().copied()).collect();
        apart(|| (self.write)(&mut MachineLetters { entry: self, counts, settled: Vec::new() })).map(Arc::new)
    }
}

/// A motor of the catalogue, with this value for each quantity and this one for each count, without their bounds.
pub fn sampled(name: &str, value: impl FnMut(&Quantity) -> f64, count: usize) -> Option<Motor> {
    let entry = entry(name)?;
    let laws = entry.laws(&vec![count; entry.counts.len()]).ok()?;
    Some(Motor::new(laws, entry.data.iter().map(value).collect(), Allowed::ALL))
}

/// The letter of a datum.
///
/// # Errors
/// None.
pub fn letter(quantity: &Quantity) -> Result<Sym, TooLong> {
    Ok(Sym::symbol(&quantity.name))
}

/// The letters and counts for which the laws of a motor are recorded.
#[derive(Debug)]
pub struct MachineLetters {
    entry: &'static Entry,
    counts: Vec<(Count, usize)>,
    settled: Vec<(Sym, Sym)>,
}

impl MachineLetters {
    /// The count of a name; one where there is none of this name.
    pub fn count(&self, name: &str) -> usize {
        self.counts.iter().find(|(count, _)| count.name == name).map_or(1, |(_, number)| *number)
    }

    /// A letter for a value of the data alone, computed once in the field in which they are given: angles of bars, roots.
    pub fn settled(&mut self, value: Sym) -> Sym {
        let letter = Sym::symbol(&format!("settled {}", self.settled.len()));
        self.settled.push((letter, value));
        letter
    }

    /// Letters for a point of the circle, likewise computed once.
    pub fn settled_point(&mut self, Circle { cos, sin }: Circle<Sym>) -> Circle<Sym> {
        Circle { cos: self.settled(cos), sin: self.settled(sin) }
    }

    /// The laws of a machine over letters.
    ///
    /// # Errors
    /// [`TooLong`].
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
