//! LaTeX notation: `l_2\omega_3 - l_3\omega_2`.

use super::names::latex_name;
use super::{Bond, Name, Notation, Printed};
use field::{Elementary, Rational};

pub(super) struct Latex;

impl Notation for Latex {
    fn symbol(&self, name: Name) -> String {
        match name.latex() {
            Some(latex) => latex.to_string(),
            None => latex_name(&name.text()),
        }
    }

    fn number(&self, size: Rational) -> Printed {
        let text = size.to_string();
        match text.split_once('/') {
            Some((above, below)) => Printed { text: format!("\\frac{{{above}}}{{{below}}}"), bond: Bond::Power },
            None if text == "undefined" => Printed { text: "\\text{undefined}".into(), bond: Bond::Atom },
            None => Printed { text, bond: Bond::Atom },
        }
    }

    fn decimal(&self, digits: String) -> Printed {
        match digits.split_once('e') {
            Some((digits, power)) => Printed { text: format!("{digits}\\cdot 10^{{{power}}}"), bond: Bond::Product },
            None => Printed { text: digits, bond: Bond::Atom },
        }
    }

    fn parentheses(&self, inside: &str) -> String {
        if inside.contains("\\frac") { format!("\\left({inside}\\right)") } else { format!("({inside})") }
    }

    /// Returns the factors side by side. A space separates a command from a letter. A thin space follows an argument without parentheses, surrounds a name
    /// of several letters, and precedes parentheses that would read as arguments. A dot separates numbers.
    fn product(&self, factors: &[String]) -> String {
        let mut product = String::new();
        let mut before = "";
        for factor in factors {
            let open_argument = ["\\cos", "\\sin"].iter().any(|f| before.starts_with(f)) && !before.ends_with(')');
            let command =
                before.rsplit_once('\\').is_some_and(|(_, last)| last.chars().all(|c| c.is_ascii_alphabetic()));
            if !before.is_empty() && factor.starts_with(|c: char| c.is_ascii_digit()) {
                product.push_str("\\cdot ");
            } else if open_argument
                || is_letter_before(before) && (is_like_arguments(factor) || is_word(before) || is_word(factor))
            {
                product.push_str("\\,");
            } else if command && factor.starts_with(|c: char| c.is_ascii_alphabetic()) {
                product.push(' ');
            }
            product.push_str(factor);
            before = factor;
        }
        product
    }

    fn quotient(&self, above: Printed, below: Printed) -> Printed {
        Printed { text: format!("\\frac{{{}}}{{{}}}", above.text, below.text), bond: Bond::Power }
    }

    fn power(&self, base: Printed, exponent: u32) -> Printed {
        let base = match base {
            Printed { text, bond: Bond::Atom } if text.contains('^') => self.parentheses(&text),
            Printed { text, bond: Bond::Atom } if text.ends_with('\'') => format!("{{{text}}}"),
            other => self.held(other, Bond::Atom),
        };
        Printed { text: format!("{base}^{}", braced(exponent)), bond: Bond::Power }
    }

    fn root(&self, square: String) -> String {
        format!("\\sqrt{{{square}}}")
    }

    fn elementary(&self, function: Elementary, arguments: &str) -> String {
        let name = match function {
            Elementary::Atan2 => r"\operatorname{atan2}".to_owned(),
            other => format!(r"\{}", other.name()),
        };
        format!("{name}{}", self.parentheses(arguments))
    }

    fn circle(&self, function: &str, angle: Printed, exponent: u32) -> Printed {
        let power = if exponent == 1 { String::new() } else { format!("^{}", braced(exponent)) };
        let argument = match angle {
            Printed { text, bond: Bond::Atom } => format!(" {text}"),
            other => self.parentheses(&other.text),
        };
        Printed { text: format!("\\{function}{power}{argument}"), bond: Bond::Power }
    }

    fn derivative(&self, name: Name, order: u32, argument: String) -> String {
        format!("{}{}({argument})", self.symbol(name), "'".repeat(order as usize))
    }
}

fn is_letter_before(before: &str) -> bool {
    !before.is_empty() && !before.ends_with(')')
}

/// Returns whether the factor is a name of several letters, or a rate or power of such a name.
fn is_word(factor: &str) -> bool {
    factor.contains("\\mathrm{") && !factor.starts_with('(')
}

/// Returns whether the factor is a group in parentheses without a sum, which would read as the argument of a preceding letter.
fn is_like_arguments(factor: &str) -> bool {
    let inside = factor.strip_prefix('(').and_then(|rest| rest.split_once(')')).map_or("", |(inside, _)| inside);
    !inside.is_empty() && !inside.contains(['+', '-'])
}

fn braced(exponent: u32) -> String {
    if exponent < 10 { exponent.to_string() } else { format!("{{{exponent}}}") }
}
