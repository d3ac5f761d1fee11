//! Polynomials in sines and cosines in forms whose terms show their signs: `1 - sin^2` is a square, and `1 - sin` a half of two squares.

use crate::signs::is_written_as_positive;
use claims::Condition;
use symbolic::{Hypotheses, Node, Sym, coefficients, normal};

/// The largest number of angles in one polynomial.
const MOST_ANGLES: usize = 3;

/// A polynomial with the squares of cosines, or of sines, of each angle replaced by those of the other, where every term then shows that it is not
/// negative.
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

/// `A + B x` with a sine or cosine x as `A - B + B (1 + x)`, or as `A + B - B (1 - x)`, where `shown` gives forms of these parts that show their signs.
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
                // 2 (1 + x) is (1 + x)^2 + y^2
                let beside = half * ((Sym::ONE + sign * own).powi(2) + other.powi(2));
                Some(shown(plain - sign * slope)? + shown(sign * slope)? * beside)
            })
        })
    })
}

/// The cosine and the sine of one angle.
struct Circle {
    cos: Sym,
    sin: Sym,
}

/// The angles of an expression, each by its cosine and sine.
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
    /// Letters without a relation in the place of both.
    fn free(&self, place: usize) -> [(Sym, Sym); 2] {
        [
            (self.cos, Sym::symbol(&format!("free cosine {place}"))),
            (self.sin, Sym::symbol(&format!("free sine {place}"))),
        ]
    }

    /// A polynomial in which squares of the cosine are told by the sine, over letters without a relation.
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

/// A polynomial as its largest factor of even powers of sines and cosines, times the rest: the rest, and the factor.
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
