//! Plain text: `l2*omega3 - l3*omega2`.

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

    fn parentheses(&self, inside: &str) -> String {
        format!("({inside})")
    }

    fn product(&self, factors: &[String]) -> String {
        factors.join("*")
    }

    fn quotient(&self, above: Printed, below: Printed) -> Printed {
        let text = format!("{}/{}", self.held(above, Bond::Product), self.held(below, Bond::Power));
        Printed { text, bond: Bond::Product }
    }

    fn power(&self, base: Printed, exponent: u32) -> Printed {
        Printed { text: format!("{}^{exponent}", self.held(base, Bond::Atom)), bond: Bond::Power }
    }

    fn root(&self, square: String) -> String {
        format!("sqrt({square})")
    }

    fn circle(&self, function: &str, angle: Printed, exponent: u32) -> Printed {
        let base = Printed { text: format!("{function}({})", angle.text), bond: Bond::Atom };
        if exponent == 1 { base } else { self.power(base, exponent) }
    }

    fn derivative(&self, name: Name, order: u32, argument: String) -> String {
        format!("{}{}({argument})", name.text(), "'".repeat(order as usize))
    }
}
