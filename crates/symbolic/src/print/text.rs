//! Plain text notation: `l2*omega3 - l3*omega2`.

use super::{Bond, Name, Notation, Printed};
use field::Rational;

pub(super) struct Text;

impl Notation for Text {
    fn symbol(&self, name: Name) -> String {
        name.text().to_string()
    }

    fn number(&self, size: Rational) -> Printed {
        let text = size.to_string();
        let bond = if text.contains('/') { Bond::Product } else { Bond::Atom };
        Printed { text, bond }
    }

    fn power(&self, base: Printed, exponent: u32) -> Printed {
        Printed { text: format!("{}^{exponent}", self.held(base, Bond::Atom)), bond: Bond::Power }
    }

    fn derivative(&self, name: Name, order: u32, argument: String) -> String {
        format!("{}{}({argument})", name.text(), "'".repeat(order as usize))
    }
}
