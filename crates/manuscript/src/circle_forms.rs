//! Forms of polynomials in sines and cosines whose terms show their signs, by `1 - sin² = cos²` and `2 (1 - sin) = (1 - sin)² + cos²`.

use crate::signs::is_written_as_positive;
use claims::Condition;
use symbolic::{Hypotheses, Node, Sym, coefficients, normal};

/// The largest number of angles in one polynomial.
const MOST_ANGLES: usize = 3;

/// The polynomial with cos² replaced by 1 - sin², or sin² by 1 - cos², for each angle, such that the terms then show that it is not negative;
/// `None` if no choice of replacements has this effect.
pub(crate) fn by_squares_of_circles(polynomial: Sym, known: &[Condition]) -> Option<Sym> {
    let circles = circles(polynomial);
    if circles.is_empty() || circles.len() > MOST_ANGLES {
        return None;
    }
    let (rest, power) = without_even_powers(polynomial, &circles);
    (0..1_usize << circles.len()).find_map(|choice| {
        let mut form = rest;
        for (place, circle) in circles.iter().enumerate().filter(|(place, _)| choice >> place & 1 == 1) {
            form = circle.by_sines(form, place)?;
        }
        let back: Vec<(Sym, Sym)> = circles
            .iter()
            .enumerate()
            .flat_map(|(place, circle)| circle.free(place).map(|(own, free)| (free, own)))
            .collect();
        let form = normal(form, &Hypotheses::none()).ok()?.to_sym().substitute(&back) * power;
        is_written_as_positive(form, known).map(|_| form)
    })
}

/// `A + B x`, with x a sine or cosine, as `A - B + B (1 + x)` or `A + B - B (1 - x)`, if `shown` returns forms of these parts that show their signs.
pub(crate) fn by_bounds(polynomial: Sym, shown: impl Fn(Sym) -> Option<Sym>) -> Option<Sym> {
    circles(polynomial).into_iter().take(MOST_ANGLES).find_map(|Circle { cos, sin }| {
        [(cos, sin), (sin, cos)].into_iter().find_map(|(own, other)| {
            let terms = coefficients(polynomial, &[own, other]).ok()?;
            let of = |powers: [u32; 2]| {
                terms.iter().find(|(exponents, _)| exponents[..] == powers).map_or(Sym::ZERO, |(_, value)| *value)
            };
            let is_linear = terms.iter().all(|(exponents, _)| matches!(exponents[..], [0 | 1, 0]));
            let (plain, slope) = (of([0, 0]), of([1, 0]));
            if !is_linear || slope == Sym::ZERO {
                return None;
            }
            let half = Sym::ONE / (Sym::ONE + Sym::ONE);
            [Sym::ONE, -Sym::ONE].into_iter().find_map(|sign| {
                // 2 (1 + x) = (1 + x)² + y²
                let beside = half * ((Sym::ONE + sign * own).powi(2) + other.powi(2));
                Some(shown(plain - sign * slope)? + shown(sign * slope)? * beside)
            })
        })
    })
}

/// The cosine and the sine of an angle.
struct Circle {
    cos: Sym,
    sin: Sym,
}

/// The cosines and sines of all angles in an expression.
fn circles(expression: Sym) -> Vec<Circle> {
    let mut all: Vec<Circle> = Vec::new();
    for leaf in expression.leaves_of() {
        let (Node::Cos(angle) | Node::Sin(angle)) = leaf.node() else { continue };
        let [cos, sin] = [Node::Cos(angle), Node::Sin(angle)].map(Sym::from_node);
        if all.iter().all(|known| known.cos != cos) {
            all.push(Circle { cos, sin });
        }
    }
    all
}

impl Circle {
    /// Replacements of both by independent letters, between which no relation holds.
    fn free(&self, place: usize) -> [(Sym, Sym); 2] {
        [
            (self.cos, Sym::symbol(&format!("free cosine {place}"))),
            (self.sin, Sym::symbol(&format!("free sine {place}"))),
        ]
    }

    /// The polynomial with squares of the cosine expressed by the sine, in independent letters.
    fn by_sines(&self, polynomial: Sym, place: usize) -> Option<Sym> {
        let [(_, cos), (_, sin)] = self.free(place);
        let terms = coefficients(polynomial, &[self.cos, self.sin]).ok()?;
        let term = |(exponents, value): (Vec<u32>, Sym)| {
            let (pairs, single) = (exponents[0] / 2, exponents[0] % 2);
            value * (Sym::ONE - sin * sin).powi(pairs as i32) * cos.powi(single as i32) * sin.powi(exponents[1] as i32)
        };
        Some(terms.into_iter().map(term).fold(Sym::ZERO, |sum, term| sum + term))
    }
}

/// A polynomial divided by its largest factor of even powers of sines and cosines, and this factor.
fn without_even_powers(polynomial: Sym, circles: &[Circle]) -> (Sym, Sym) {
    let (mut rest, mut power) = (polynomial, Sym::ONE);
    for own in circles.iter().flat_map(|circle| [circle.cos, circle.sin]) {
        let Ok(terms) = coefficients(rest, &[own]) else { continue };
        let least = terms.iter().map(|(exponents, _)| exponents[0]).min().unwrap_or(0) / 2 * 2;
        if least > 0 {
            rest = terms
                .into_iter()
                .fold(Sym::ZERO, |sum, (exponents, value)| sum + value * own.powi((exponents[0] - least) as i32));
            power *= own.powi(least as i32);
        }
    }
    (rest, power)
}
