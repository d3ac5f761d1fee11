//! Symbols for long derivatives of speeds by quasi-velocities: each definition is printed once, and equations contain its symbol.

use super::ShortForms;
use super::inverse::Reading as _;
use symbolic::Sym;

/// A named derivative of a speed by a quasi-velocity, or a named part of a speed that is independent of the quasi-velocities.
#[derive(Clone, Copy, Debug)]
pub struct Coefficient {
    /// The symbol that represents the expression.
    pub letter: Sym,
    /// The expression, a function of coordinates and the time.
    pub is: Sym,
    /// The symbol of the time derivative along the motion.
    pub rate: Sym,
    /// The time derivative as a function of coordinates, quasi-velocities, other coefficients and the time.
    pub rate_is: Sym,
}

/// Expressions with more operations get a symbol.
const MOST_WRITTEN: usize = 6;

/// Replaces long expressions by symbols, equal ones by one symbol. Returns the symbols with their definitions.
pub(super) fn named(rows: &mut [Vec<Sym>], from: usize, forms: &mut ShortForms<'_, '_>) -> Vec<Coefficient> {
    let name = forms.free_name(&["k", "kappa", "K", "coefficient"]);
    let mut all: Vec<Coefficient> = Vec::new();
    for entry in rows.iter_mut().flat_map(|row| &mut row[from..]) {
        let is = forms.read(*entry);
        if forms.size(is) <= MOST_WRITTEN {
            continue;
        }
        let turned = forms.read(-is);
        let known = |value: Sym| all.iter().find(|own| own.is == value).map(|own| own.letter);
        *entry = match (known(is), known(turned)) {
            (Some(letter), _) => letter,
            (_, Some(letter)) => -letter,
            _ => {
                let number = all.len() + 1;
                let letter = Sym::named(&format!("{name}{number}"), &format!("{name}_{{{number}}}"));
                let rate = Sym::named(&format!("{name}{number}'"), &format!(r"\dot{{{name}}}_{{{number}}}"));
                all.push(Coefficient { letter, is, rate, rate_is: Sym::ZERO });
                letter
            }
        };
    }
    all
}
