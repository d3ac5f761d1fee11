//! Test whether loads take power whatever the speeds are, as dampers and drag do.
//!
//! The power is a polynomial in the lengths r = sqrt(s) of velocities, none of which is negative. It is nowhere positive if no coefficient is. A
//! coefficient is a form of the speeds u, with constants, for which this is decided in two cases:
//!
//! * -c s with c >= 0 and the square s of one of the lengths, as of the drag -c |v| v;
//! * a quadratic form each of whose diagonal entries outweighs the others of its row, as of dampers of coordinates and between two of them, and
//!   monomials of higher degrees with even exponents and negative factors, as of the force -c u^3.

use super::conditions::constant;
use model::equations::vanishes;
use symbolic::{Node, Sym, coefficients};

/// Rounding of sums of decimals, relative to them.
const ROUNDING: f64 = 1e-13;

/// Whether the power of loads is nowhere positive.
pub(super) fn take_power(loads: &[Sym], speeds: &[Sym]) -> bool {
    let power = loads.iter().zip(speeds).fold(Sym::ZERO, |sum, (load, speed)| sum + *load * *speed);
    let moves = |own: &Sym| own.symbols_of().iter().any(|symbol| speeds.contains(symbol));
    let lengths: Vec<(Sym, Sym)> = Sym::reached(&[power], |_, _| true)
        .into_iter()
        .filter_map(|own| match own.node() {
            Node::Root(square) if moves(&square) => Some((own, square)),
            _ => None,
        })
        .collect();
    let (roots, squares): (Vec<Sym>, Vec<Sym>) = lengths.into_iter().unzip();
    let is_not_positive =
        |part: Sym| is_of_forms(part, speeds) || squares.iter().any(|&square| is_multiple(part, square, speeds));
    coefficients(power, &roots).is_ok_and(|parts| parts.into_iter().all(|(_, part)| is_not_positive(part)))
}

/// Whether a part of the power is -c s with c >= 0.
fn is_multiple(part: Sym, square: Sym, speeds: &[Sym]) -> bool {
    speeds.iter().any(|&speed| {
        let second = |own: Sym| own.diff(speed).diff(speed);
        let (of_part, of_square) = (second(part), second(square));
        !vanishes(of_square) && {
            let factor = of_part / of_square;
            constant(factor).is_some_and(|value| value <= 0.0) && vanishes(part - factor * square)
        }
    })
}

/// Whether a part of the power is a dominated quadratic form and even monomials with negative factors.
fn is_of_forms(part: Sym, speeds: &[Sym]) -> bool {
    let Ok(monomials) = coefficients(part, speeds) else { return false };
    let mut rows = vec![vec![0.0; speeds.len()]; speeds.len()];
    for (exponents, factor) in monomials {
        let Some(value) = constant(factor) else { return false };
        let places: Vec<usize> = (0..speeds.len()).filter(|&place| exponents[place] > 0).collect();
        match (exponents.iter().sum::<u32>(), &places[..]) {
            (2, [own]) => rows[*own][*own] = 2.0 * value,
            (2, [one, other]) => {
                rows[*one][*other] = value;
                rows[*other][*one] = value;
            }
            (4.., _) if value <= 0.0 && exponents.iter().all(|exponent| exponent % 2 == 0) => {}
            _ if value == 0.0 => {}
            _ => return false,
        }
    }
    (0..rows.len()).all(|i| {
        let others: f64 = (0..rows.len()).filter(|&j| j != i).map(|j| rows[i][j].abs()).sum();
        rows[i][i] <= 0.0 && -rows[i][i] >= others * (1.0 - ROUNDING)
    })
}
