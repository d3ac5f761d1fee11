//! Letters for long derivatives of speeds by quasi-velocities: a definition stands once, and equations hold its letter.

use super::ShortForms;
use super::inverse::Reading as _;
use symbolic::Sym;

/// A derivative, or a part of a speed that no quasi-velocity moves.
#[derive(Clone, Copy, Debug)]
pub struct Coefficient {
    pub letter: Sym,
    /// The expression in coordinates and the time.
    pub is: Sym,
    /// The letter of its rate along the motion.
    pub rate: Sym,
    /// The rate in coordinates, quasi-velocities, other coefficients and the time.
    pub rate_is: Sym,
}

/// Expressions with more parts have letters.
const MOST_WRITTEN: usize = 6;

/// Puts letters into the place of long expressions, equal ones by one letter; returns the letters with their meanings.
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
