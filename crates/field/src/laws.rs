//! The field axioms as checks for every scalar type.

use crate::{Analytic, Circle, Scalar};

/// The field axioms at three numbers: pairs of sides that must be equal, each with its name.
///
/// `a`, `b`, `c` must not be zero. The caller compares the sides by the equality of the type (exact, normal form, or
/// within rounding).
#[expect(clippy::eq_op, reason = "a law may name the same number twice")]
pub fn field_laws<S: Scalar>(a: S, b: S, c: S) -> Vec<(&'static str, S, S)> {
    let (zero, one) = (S::zero(), S::one());
    let assigned = |assign: fn(&mut S, S)| {
        let mut left = a;
        assign(&mut left, b);
        left
    };
    vec![
        ("a + b = b + a", a + b, b + a),
        ("(a + b) + c = a + (b + c)", (a + b) + c, a + (b + c)),
        ("a + 0 = a", a + zero, a),
        ("a - a = 0", a - a, zero),
        ("a - b = a + (-b)", a - b, a + -b),
        ("-(-a) = a", -(-a), a),
        ("a b = b a", a * b, b * a),
        ("(a b) c = a (b c)", (a * b) * c, a * (b * c)),
        ("a 1 = a", a * one, a),
        ("a (b + c) = a b + a c", a * (b + c), a * b + a * c),
        ("a / a = 1", a / a, one),
        ("(a + b) / c = a / c + b / c", (a + b) / c, a / c + b / c),
        ("(a / b) b = a", (a / b) * b, a),
        ("a / (b / c) = a c / b", a / (b / c), a * c / b),
        ("2 = 1 + 1", S::int(2), one + one),
        ("3/7 * 7 = 3", S::ratio(3, 7) * S::int(7), S::int(3)),
        ("half + half = whole", a.half() + a.half(), a),
        ("and_product", a.and_product(b, c), a + b * c),
        ("less_product", a.less_product(b, c), a - b * c),
        ("square", a.squared(), a * a),
        ("a += b", assigned(|a, b| *a += b), a + b),
        ("a -= b", assigned(|a, b| *a -= b), a - b),
        ("a *= b", assigned(|a, b| *a *= b), a * b),
        ("a /= b", assigned(|a, b| *a /= b), a / b),
    ]
}

/// The laws of circle points at two points, given by their half tangents.
#[expect(clippy::eq_op, reason = "a law may name the same number twice")]
pub fn circle_laws<S: Scalar>(t: S, u: S) -> Vec<(&'static str, S, S)> {
    let (p, q) = (Circle::from_half_tangent(t), Circle::from_half_tangent(u));
    let sum = p + q;
    let back = sum - q;
    vec![
        ("on the circle", p.defect(), S::zero()),
        ("sum on the circle", sum.defect(), S::zero()),
        ("p + q = q + p (cos)", sum.cos, (q + p).cos),
        ("p + q = q + p (sin)", sum.sin, (q + p).sin),
        (
            "p + p has the half tangent 2 t / (1 - t^2)",
            (p + p).sin * (S::one() - t * t),
            (S::one() + (p + p).cos) * (t + t),
        ),
        ("p + q - q = p (cos)", back.cos, p.cos),
        ("p + q - q = p (sin)", back.sin, p.sin),
        ("p - p = 0", (p - p).cos, S::one()),
        ("d cos = -sin", p.moving(S::one()).cos.slope, -p.sin),
        ("d sin = cos", p.moving(S::one()).sin.slope, p.cos),
    ]
}

/// The laws of square roots and of circle points, at two positive numbers.
pub fn analytic_laws<S: Analytic>(a: S, b: S) -> Vec<(&'static str, S, S)> {
    let (p, q) = (a.circle(), b.circle());
    vec![
        ("sqrt(a)^2 = a", a.sqrt() * a.sqrt(), a),
        ("sqrt(a^2) = a", (a * a).sqrt(), a),
        ("sqrt(a b) = sqrt(a) sqrt(b)", (a * b).sqrt(), a.sqrt() * b.sqrt()),
        ("the point of an angle is on the circle", p.defect(), S::zero()),
        ("cos(a + b)", (a + b).circle().cos, (p + q).cos),
        ("sin(a + b)", (a + b).circle().sin, (p + q).sin),
        ("cos(-a) = cos(a)", (-a).circle().cos, p.cos),
        ("sin(-a) = -sin(a)", (-a).circle().sin, -p.sin),
        ("cos(0) = 1", S::zero().circle().cos, S::one()),
        ("sin(0) = 0", S::zero().circle().sin, S::zero()),
    ]
}
