//! Test that expressions keep their values in the form for reading.

use super::Reading;
use field::{Analytic, Scalar};
use symbolic::{Sym, apart};

/// Reproducible pseudorandom numbers.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, most: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % most
    }
}

const LETTERS: [(&str, f64); 6] =
    [("m", 1.7), ("l", 0.6), ("x", 0.9), ("y", -0.4), ("u", 2.3), ("pi", std::f64::consts::PI)];

fn letter(place: u64) -> Sym {
    Sym::symbol(LETTERS[place as usize].0)
}

fn angle(numbers: &mut Numbers) -> Sym {
    let term = |numbers: &mut Numbers| {
        let letter = letter([2, 3, 5][numbers.below(3) as usize]);
        letter * Sym::ratio(numbers.below(7) as i64 - 3, 1 + numbers.below(3) as i64)
    };
    let first = term(numbers);
    match numbers.below(3) {
        0 => first,
        1 => first + term(numbers),
        _ => first - term(numbers) + Sym::ratio(numbers.below(3) as i64, 2),
    }
}

fn expression(numbers: &mut Numbers, depth: usize) -> Sym {
    if depth == 0 {
        return match numbers.below(5) {
            0 => Sym::ratio(numbers.below(9) as i64 - 4, 1 + numbers.below(6) as i64),
            1 => angle(numbers).circle().cos,
            2 => angle(numbers).circle().sin,
            _ => letter(numbers.below(5)),
        };
    }
    let mut part = || expression(numbers, depth - 1);
    let (a, b) = (part(), part());
    let two = Sym::int(2);
    match numbers.below(9) {
        0 | 1 => a + b,
        2 => a - b,
        3 | 4 => a * b,
        5 => a.powi(2),
        6 => a / (b * b + two),
        7 => a / letter(numbers.below(2)),
        _ => a * (b * b + Sym::ONE).sqrt() * (letter(1) * letter(1)).sqrt(),
    }
}

fn value(expression: Sym) -> f64 {
    let known = |name: &str| LETTERS.iter().find(|(known, _)| *known == name).map(|(_, value)| *value);
    expression.evaluate_analytic(&known).expect("every letter has a value")
}

#[test]
fn values_stay_what_they_are() {
    let mut numbers = Numbers(1743);
    for round in 0..600 {
        apart(|| {
            let original = expression(&mut numbers, 1 + round % 4);
            let parameters = [(letter(0), true), (letter(1), true), (letter(5), true)];
            let read = Reading::new(parameters, [letter(2), letter(3), letter(4)]).of(original);
            let (before, after) = (value(original), value(read));
            assert!((before - after).abs() <= 1e-9 * (1.0 + before.abs()), "{original}\n{read}\n{before} {after}");
        });
    }
}

#[test]
fn the_shorter_form_is_taken() {
    let [x, y, r] = ["x", "y", "r"].map(Sym::symbol);
    let read = |expression: Sym| Reading::new([(r, true)], [x, y]).of(expression).decimal_text();
    let (a, b) = (x.circle(), y.circle());
    assert_eq!(read(a.cos * b.cos + a.sin * b.sin), "cos(x - y)");
    assert_eq!(read(a.cos * b.cos), "cos(x)*cos(y)");
    assert_eq!(read(r * (Sym::ONE - a.cos * a.cos)), "r*sin(x)^2");
    assert_eq!(read((r * r).sqrt() * x), "r*x");
    assert_eq!(read((x * x).sqrt()), "sqrt(x^2)");
    assert_eq!(read(r * x / (r * r)), "x/r");
    assert_eq!(read(x - x), "0");
    assert_eq!(read(a.sin * a.cos * Sym::int(2)), "sin(2*x)");
    // factors of a divisor are collected
    let two = Sym::int(2);
    assert_eq!(read(x / (two * a.cos * b.cos) / two), "x/(4*cos(x)*cos(y))");
    assert_eq!(read(x / (r * a.cos * b.cos).powi(2)), "x/(r^2*cos(x)^2*cos(y)^2)");
    assert_eq!(read(x / (two * r * (r - a.cos)) / r), "x/(2*r^2*(r - cos(x)))");
    assert_eq!(read(-x / (Sym::int(-3) * a.cos * b.cos)), "x/(3*cos(x)*cos(y))");
    assert_eq!(read(x / Sym::int(32) + y / Sym::int(50)), "x/32 + 0.02*y");
    assert_eq!(read(Sym::ratio(7, 20) * x + Sym::ratio(1, 3) * y), "0.35*x + y/3");
}
