//! Detection of keys below the wrong heading, usually because their own heading is missing.

use super::{Elaborator, Sound};
use crate::{Fault, Text};

/// Keys, and the heading below which they belong.
const KEYS: [(&[&str], &str); 5] = [
    (&["centre", "mass", "inertia", "frame", "turns"], "[bodies.NAME]"),
    (&["on", "between", "is"], "[[force]] or [[torque]]"),
    (&["zero", "programmed"], "[[constraint]]"),
    (&["when", "direction", "set", "end"], "[[event]]"),
    (&["span", "tolerance", "method", "samples", "through_singular_positions"], "[run]"),
];

/// Returns the fault of a key below the heading of another table; `None` if no other table has this key.
pub fn misplaced(key: &Text, table: &str) -> Option<Fault> {
    let (_, heading) = KEYS.iter().find(|(keys, _)| keys.contains(&key.text.as_str()))?;
    let title = format!("`{}` stands under [{table}]", key.text);
    let accepted = format!("`{}` is a key of {heading}: that heading stands above it", key.text);
    Some(Fault::at(key.span(), title, "a heading is missing above", accepted))
}

impl Elaborator<'_> {
    /// Replaces the fault of a wrong value by a fault of the heading, if the name is a key of another table.
    pub(super) fn under<T>(&mut self, table: &str, name: &Text, found: Sound<T>) -> Sound<T> {
        found.map_err(|fault| match misplaced(name, table) {
            Some(heading) => {
                // reported once per table, since all its keys have this cause
                if !self.headless.iter().any(|(known, _)| known == table) {
                    self.headless.push((table.to_owned(), heading));
                }
                Box::new(Fault::consequence(fault.span))
            }
            None => fault,
        })
    }
}
