//! Notation of SymPy, which is also valid Python with functions of these names: `l2*omega3 - Rational(1, 2)*l3**2`.

use super::{Bond, Name, Notation, Printed};
use field::{Elementary, Rational};

pub(super) struct SymPy;

/// Pairs of a Greek letter and its identifier. `lambda` is a keyword of Python, hence `lamda`.
const GREEK: &str = "α alpha β beta γ gamma δ delta ε epsilon ζ zeta η eta θ theta ϑ vartheta ι iota κ kappa λ lamda μ mu ν nu \
    ξ xi π pi_ ρ rho σ sigma τ tau υ upsilon φ phi ϕ varphi χ chi ψ psi ω omega Γ Gamma Δ Delta Θ Theta Λ Lambda Ξ Xi Π Pi \
    Σ Sigma Υ Upsilon Φ Phi Ψ Psi Ω Omega";
/// Accents and superscript marks, with the text that replaces them.
const MARKS: [(char, &str); 6] =
    [('\u{307}', "dot"), ('\u{308}', "ddot"), ('′', "prime"), ('\'', "prime"), ('*', "star"), ('°', "_0")];

/// Converts a name to a Python identifier: `γ̇` to gammadot, `φ′` to phiprime. SymPy prints these identifiers with their marks.
pub(super) fn identifier(name: &str) -> String {
    let mut text = String::with_capacity(name.len());
    for letter in name.chars() {
        let mut greek = GREEK.split_whitespace();
        let mark = MARKS.iter().find(|(mark, _)| *mark == letter);
        if let Some((_, said)) = mark {
            text += said;
        } else if greek.by_ref().any(|word| word.chars().eq([letter])) {
            text += greek.next().unwrap_or_default();
        } else {
            text.push(if letter.is_alphanumeric() { letter } else { '_' });
        }
    }
    if text.starts_with(|first: char| first.is_ascii_digit()) { format!("_{text}") } else { text }
}

impl Notation for SymPy {
    fn symbol(&self, name: Name) -> String {
        identifier(&name.text())
    }

    fn number(&self, size: Rational) -> Printed {
        let text = match size.to_string().split_once('/') {
            Some((above, below)) => format!("Rational({above}, {below})"),
            None => size.to_string(),
        };
        Printed { text, bond: Bond::Atom }
    }

    fn power(&self, base: Printed, exponent: u32) -> Printed {
        Printed { text: format!("{}**{exponent}", self.held(base, Bond::Atom)), bond: Bond::Power }
    }

    fn elementary(&self, function: Elementary, arguments: &str) -> String {
        let name = if function == Elementary::Ln { "log" } else { function.name() };
        format!("{name}({arguments})")
    }

    fn derivative(&self, name: Name, order: u32, argument: String) -> String {
        let function = format!("Function('{}')", identifier(&name.text()));
        match order {
            0 => format!("{function}({argument})"),
            // the derivative is taken with respect to a dummy symbol, at which the argument is then substituted
            _ => format!("Subs(Derivative({function}(_x), (_x, {order})), _x, {argument})"),
        }
    }
}
