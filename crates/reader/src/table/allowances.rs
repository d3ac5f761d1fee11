//! Checks of data against their bounds, and the key `allow`, which extends the bounds.

use super::quantities::with_article;
use super::{At, Table};
use crate::issue::Issue;
use crate::{Allowed, Quantity};
use units::nearest;

/// The key for allowances, at the top of a file.
const KEY: &str = "allow";

/// Advice in messages about mutual inductances, which no law of this program has.
pub const NO_MUTUAL_INDUCTANCE: &str = "no law here holds the voltage M di/dt that one winding induces in another: `motional` holds \
     voltages per speed alone. Linear combinations of the currents that make the matrices of inductances and of resistances \
     diagonal, both at once, are accepted (they exist where all resistances are positive; CONTRIBUTING.md shows how)";

/// Returns whether the name of a key suggests a mutual inductance.
pub(super) fn is_mutual_inductance(key: &str) -> bool {
    let key = key.to_lowercase();
    key.contains("mutual") || key.contains("coupling")
}

impl Table<'_> {
    /// Reads the key `allow`. The allowances apply to the tables inside this one that are read later.
    pub fn read_allowed(&mut self) {
        for At { value: word, span } in self.texts(KEY, "[\"negative resistance\"]") {
            if self.allowed.add(&word) {
                continue;
            }
            let list = Allowed::WORDS.map(|word| format!("\"{word}\"")).join(", ");
            let accepted = match nearest(&word, Allowed::WORDS) {
                Some(nearest) => format!("is \"{nearest}\" meant? Known: {list}"),
                None => format!("known: {list}"),
            };
            self.report(Issue::at(span, format!("`{word}` cannot be allowed"), "not known").accepted(accepted));
        }
    }

    /// Returns the allowances of the file.
    pub fn allowed(&self) -> Allowed {
        self.allowed
    }

    /// Reads a number in SI units and checks its bound. A value outside the bound is reported, and returned.
    pub fn datum(&mut self, quantity: &Quantity) -> At<f64> {
        let found = self.scalar(&quantity.name, &quantity.meaning, &quantity.unit);
        if !quantity.bound.holds(found.value, self.allowed) {
            let (name, meaning, broken) = (&quantity.name, &quantity.meaning, quantity.bound.broken());
            let title = format!("`{name}`, {}, {broken}", with_article(meaning));
            let label = format!("it is {}{}", found.value, in_unit(&quantity.unit));
            self.report(Issue::at(found.span.clone(), title, label).accepted(quantity.bound.accepted(found.value)));
        }
        found
    }
}

/// Returns the unit with a leading space, to follow a number; an empty text for a pure number.
pub fn in_unit(unit: &str) -> String {
    if unit == "1" { String::new() } else { format!(" {unit}") }
}
