//! Real roots, compared with products of known factors, with Sturm's count, and with numbers known from the literature.

use dalembert_algebra::real::{Enclosure, Field, Number, Polynomial, subresultant};
use field::Rational;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use std::cmp::Ordering;

fn fixed(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, rng_seed: RngSeed::Fixed(1637), failure_persistence: None, ..ProptestConfig::default() }
}

fn poly(coefficients: &[i64]) -> Polynomial {
    Polynomial::from_integers(coefficients.iter().copied())
}

fn product(factors: impl IntoIterator<Item = Polynomial>) -> Polynomial {
    factors.into_iter().fold(poly(&[1]), |all, factor| &all * &factor)
}

#[test]
fn roots_that_nearly_touch_are_told_apart() {
    // x = 1/3 and x = 1/3 + 1e-15
    let near = Polynomial::from_rationals(&[Rational::new(-(1_000_000_000_000_000 + 3), 3), Rational::int_power()]);
    let two = &poly(&[-1, 3]) * &near.unwrap();
    let roots = two.real_roots();
    assert_eq!(roots.len(), 2);
    assert_eq!(roots[0].compare(&roots[1]), Ordering::Less);
}

trait Power {
    fn int_power() -> Rational;
}
impl Power for Rational {
    fn int_power() -> Rational {
        Rational::new(1_000_000_000_000_000, 1)
    }
}

#[test]
fn repeated_roots_are_found_once() {
    let p = product([
        poly(&[-1, 3]),
        poly(&[-1, 3]),
        poly(&[-2, 0, 1]),
        poly(&[-2, 0, 1]),
        poly(&[0, 0, 1]),
        poly(&[1, 0, 1]),
    ]);
    let roots = p.real_roots();
    assert_eq!((roots.len(), p.count_by_sturm()), (4, 4));
    let double = p.derivative();
    assert!(roots.iter().all(|root| root.sign_of(&double) == 0));
}

#[test]
fn a_sign_at_a_root_is_zero_only_where_a_common_factor_says_so() {
    let roots = poly(&[-2, 0, 1]).real_roots();
    // (x^2 - 2) (x - 5), and the same plus 2e-40
    let shared = product([poly(&[-2, 0, 1]), poly(&[-5, 1])]);
    assert_eq!(roots[1].sign_of(&shared), 0);
    let tiny = Polynomial::from_rationals(&[
        Rational::new(1, 1) / (0..40).fold(Rational::new(1, 1), |p, _| p * Rational::new(10, 1))
    ]);
    let shared = Polynomial::from_rationals(&[Rational::new(-2, 1), Rational::new(0, 1), Rational::new(1, 1)]).unwrap();
    let ten = (0..40).fold(Number::from(1), |p, _| &p * &Number::from(10));
    let nearly = &(&shared * &Polynomial::constant(ten)) + &tiny.unwrap();
    assert_eq!(roots[1].sign_of(&nearly), 1);
}

#[test]
fn a_field_knows_that_its_generator_is_a_root() {
    // t^3 - 2: (t^2)^2 = 2 t; t + t^2 is between 2 and 3
    let root = poly(&[-2, 0, 0, 1]).real_roots().pop().unwrap();
    let (t, lead) = Field::of(&root).unwrap();
    assert_eq!(lead.sign(), 1);
    let square = &t * &t;
    assert_eq!((&(&square * &square) - &(&t * &Number::from(2))).sign(), 0);
    let sum = &t + &square;
    assert_eq!(((&sum - &Number::from(2)).sign(), (&sum - &Number::from(3)).sign()), (1, -1));
    // x^2 - t has the roots -+ 2^(1/6)
    let p = Polynomial::new(vec![-&t, Number::from(0), Number::from(1)]);
    let roots = p.real_roots();
    assert_eq!((roots.len(), p.count_by_sturm()), (2, 2));
    assert_eq!(roots[1].to_f64(), 2f64.powf(1.0 / 6.0));
}

#[test]
fn a_field_of_a_polynomial_with_a_leading_coefficient_scales_its_generator() {
    // 3 x^2 - 5
    let root = poly(&[-5, 0, 3]).real_roots().pop().unwrap();
    let (t, lead) = Field::of(&root).unwrap();
    let residual = &(&t * &t) - &Number::from(15);
    assert_eq!((residual.sign(), lead.as_integer(), root.to_f64()), (0, Some(3.into()), (5f64 / 3.0).sqrt()));
}

#[test]
fn enclosures_hold_quotients_and_roots() {
    let third = Enclosure::integer(1, 80).over(&Enclosure::integer(3, 80)).unwrap();
    assert_eq!(third.to_f64(), 1.0 / 3.0);
    let back = &third * &Enclosure::integer(3, 80);
    assert_eq!((&back - &Enclosure::integer(1, 80)).sign(), None);
    let root = Enclosure::integer(2, 80).sqrt().unwrap();
    assert_eq!(root.to_f64(), 2f64.sqrt());
    assert_eq!((&(&root * &root) - &Enclosure::integer(2, 80)).sign(), None);
}

#[test]
fn a_resultant_vanishes_where_both_have_a_root_in_common() {
    // x^2 + y^2 - 5 and x y - 2 in x: y = -2, -1, 1, 2, and x = 2/y from the first subresultant
    let circle = [poly(&[-5, 0, 1]), poly(&[]), poly(&[1])];
    let hyperbola = [poly(&[-2]), poly(&[0, 1])];
    let resultant = &subresultant(&circle, &hyperbola, 0)[0];
    let found: Vec<f64> = resultant.real_roots().iter().map(|root| root.to_f64()).collect();
    assert_eq!(found, [-2.0, -1.0, 1.0, 2.0]);
    let first = subresultant(&circle, &hyperbola, 1);
    let residual = &(&first[0] * &poly(&[0, 1])) + &(&first[1] * &poly(&[2]));
    assert!(residual.is_zero());
}

proptest! {
    #![proptest_config(fixed(300))]

    /// Roots p/q with small p, q, some of them repeated, and pairs of non-real roots.
    #[test]
    fn products_of_known_factors_have_the_roots_of_the_factors(
        linear in prop::collection::vec((-30..30i64, 1..20i64, 1..3usize), 0..5),
        complex in prop::collection::vec((-9..9i64, 1..9i64), 0..3),
    ) {
        let mut known: Vec<(i64, i64)> = linear.iter().map(|&(p, q, _)| (p, q)).collect();
        known.sort_by(|a, b| (a.0 * b.1).cmp(&(b.0 * a.1)));
        known.dedup_by(|a, b| a.0 * b.1 == b.0 * a.1);
        let real = linear.iter().flat_map(|&(p, q, times)| std::iter::repeat_n(poly(&[-p, q]), times));
        let pairs = complex.iter().map(|&(a, b)| poly(&[a * a + b * b, -2 * a, 1]));
        let whole = product(real.chain(pairs));
        let roots = whole.real_roots();
        prop_assert_eq!(roots.len(), known.len());
        prop_assert_eq!(whole.count_by_sturm(), known.len());
        for (root, (p, q)) in roots.iter().zip(known) {
            prop_assert_eq!(root.sign_of(&poly(&[-p, q])), 0);
            prop_assert_eq!(root.to_f64(), p as f64 / q as f64);
        }
    }

    #[test]
    fn descartes_and_sturm_count_alike(coefficients in prop::collection::vec(-50..50i64, 1..12)) {
        let p = poly(&coefficients);
        let roots = p.real_roots();
        prop_assert_eq!(roots.len(), p.count_by_sturm());
        prop_assert!(roots.windows(2).all(|pair| pair[0].compare(&pair[1]) == Ordering::Less));
        prop_assert!(roots.iter().all(|root| root.sign_of(&p) == 0));
    }
}

/// Arithmetic with three bits, where almost every result must be rounded.
#[test]
fn every_operation_on_enclosures_rounds_outwards() {
    const COARSE: usize = 3;
    const FINE: usize = 32;
    let eighths = |n: i64, bits: usize| Enclosure::rational(Rational::new(n, 8), bits).unwrap();
    let holds = |all: &Enclosure, one: &Enclosure| !all.clone().finer(FINE).is_apart_from(one);
    let ranges: Vec<[i64; 2]> = (-5..=5).flat_map(|a| [0, 1, 4].map(|width| [a, a + width])).collect();
    for [a, b] in ranges.iter().copied() {
        let x = eighths(a, COARSE).hull(&eighths(b, COARSE));
        for p in [a, b].map(|p| eighths(p, FINE)) {
            assert!(holds(&-&x, &-&p), "-{x:?}");
            assert!(x.sqrt().is_none_or(|root| holds(&(&root.clone().finer(FINE) * &root.finer(FINE)), &p)), "{x:?}");
        }
        for [c, d] in ranges.iter().copied() {
            let y = eighths(c, COARSE).hull(&eighths(d, COARSE));
            for (p, q) in [(a, c), (a, d), (b, c), (b, d)].map(|(p, q)| (eighths(p, FINE), eighths(q, FINE))) {
                assert!(holds(&(&x + &y), &(&p + &q)) && holds(&(&x - &y), &(&p - &q)), "{x:?} {y:?}");
                assert!(holds(&(&x * &y), &(&p * &q)), "{x:?} * {y:?}");
                assert!(x.over(&y).is_none_or(|ratio| holds(&(&ratio.finer(FINE) * &q), &p)), "{x:?} / {y:?}");
            }
        }
    }
    let zero = Enclosure::integer(0, COARSE);
    for n in -9..=9 {
        let fine = Enclosure::rational(Rational::new(n, 64), FINE).unwrap();
        assert!(holds(&(&zero + &fine), &fine), "{n}/64");
    }
}
