//! Identities that shorten a recurrence: cos^2 + sin^2 = 1, and quotients instead of a reciprocal with a product.

use super::build::{Builder, Definition, Part};
use super::form::{Atom, Form};

impl Builder<'_> {
    /// Replaces c^2 + s^2 by 1 if both squares have the same coefficient, as in many kinetic energies. A divisor in
    /// which no quantity remains then becomes a constant.
    pub fn on_circles(&self, mut form: Form) -> Form {
        for &cos in &self.circles {
            let squares = [cos, cos + 1].map(|point| (point, point));
            let [Some(&count), Some(other)] = squares.map(|square| form.products.get(&square)) else { continue };
            if count == *other {
                form.products.retain(|pair, _| !squares.contains(pair));
                form.constant.0 += count.0;
            }
        }
        form
    }

    /// Merges each reciprocal that occurs in a single product with that product to a quotient: two series products
    /// become one.
    pub fn merge_quotients(&mut self) {
        let readers = self.readers();
        for atom in 0..self.definitions.len() {
            let Definition::Product(a, b) = self.definitions[atom] else { continue };
            let divisor = |part: Atom| match self.definitions[part] {
                Definition::Quotient(None, below) if readers[part] == 1 => Some(below),
                _ => None,
            };
            let merged = [(a, b), (b, a)].into_iter().find_map(|(above, part)| Some((above, divisor(part)?)));
            if let Some((above, below)) = merged.filter(|_| readers[atom] > 0) {
                self.definitions[atom] = Definition::Quotient(Some(above), below);
            }
        }
    }

    /// The number of uses of each quantity in quantities that a rate depends on; a square counts twice.
    fn readers(&self) -> Vec<usize> {
        let mut readers = vec![0; self.definitions.len()];
        let forms = self.rates.iter().flat_map(|rate| rate.linear.keys().copied());
        let solved = self.reduction.iter().flat_map(|reduction| reduction.entries.iter().chain(&reduction.right));
        let solved = solved.filter_map(|part| match part {
            Part::Moving(atom) => Some(*atom),
            Part::Fixed(_) => None,
        });
        forms.chain(solved).for_each(|atom| readers[atom] += 1);
        for (definition, used) in self.definitions.iter().zip(self.used()) {
            let mut read = |atom: Atom| readers[atom] += 1;
            match definition {
                _ if !used => {}
                Definition::State | Definition::Unknown => {}
                Definition::Sum(form) => form.linear.keys().copied().for_each(read),
                Definition::Product(a, b) => [*a, *b].into_iter().for_each(read),
                Definition::Quotient(above, below) => above.iter().chain([below]).copied().for_each(read),
                Definition::Root(of) => read(*of),
            }
        }
        readers
    }
}
