//! Names: conversion to LaTeX, and natural sort order.

/// The Greek letters with a LaTeX command.
const GREEK: &str = "alpha beta gamma delta epsilon varepsilon zeta eta theta vartheta iota kappa lambda mu nu xi pi \
    rho sigma tau upsilon phi varphi chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega";

/// Converts a name to LaTeX: `omega1` to \omega_1, `u_d` to u_d, `A12` to A_{12}. Other names of several letters are set upright.
pub(super) fn latex_name(name: &str) -> String {
    let (base, index) = match name.split_once('_') {
        Some(parts) => parts,
        None => name.split_at(name.trim_end_matches(|c: char| c.is_ascii_digit()).len()),
    };
    let letter = if GREEK.split_whitespace().any(|letter| letter == base) {
        format!("\\{base}")
    } else if base.chars().count() == 1 {
        base.to_string()
    } else {
        format!("\\mathrm{{{base}}}")
    };
    match index.chars().count() {
        // `lambda_` and `lambda` are different letters
        0 if name.ends_with('_') => format!("{letter}_{{\\_}}"),
        0 => letter,
        1 => format!("{letter}_{index}"),
        _ => format!("{letter}_{{{}}}", index.replace('_', ",")),
    }
}

/// Returns a sort key for natural order: digits are compared by their numerical value.
pub(crate) fn natural_key(name: &str) -> Vec<(u64, char)> {
    let mut key = Vec::with_capacity(name.len());
    let mut number = None;
    for letter in name.chars() {
        match letter.to_digit(10) {
            Some(digit) => number = Some(number.unwrap_or(0u64).saturating_mul(10).saturating_add(digit.into())),
            None => {
                key.extend(number.take().map(|n| (n.saturating_add(1), '\0')));
                key.push((0, letter));
            }
        }
    }
    key.extend(number.map(|n| (n.saturating_add(1), '\0')));
    key
}
