//! Numbers enclosed to thirty digits, compared with exact numbers and known digits.

use dalembert_algebra::real::{Ball, FixedPoint, Ordered};
use dashu_ratio::RBig;
use field::{DoubleDouble, Rational, Scalar};

/// A fraction from digits such as `3/4` or `2718/1000`.
fn fraction(text: &str) -> Rational {
    text.parse::<RBig>().expect("it is a fraction").into()
}

/// A number with forty digits after the point.
fn digits(whole: &str, places: &str) -> Ball {
    assert_eq!(places.len(), 40);
    ball(fraction(&format!("{whole}{places}/1{}", "0".repeat(40))))
}

fn ball(value: Rational) -> Ball {
    Ball::constant(0.0).fraction(value).expect("it is a number")
}

/// Asserts that the enclosure contains the number, and that it is little wider than thirty digits allow.
fn holds(found: &Ball, exact: &Ball) {
    let off = found.minus(exact);
    assert!(off.sign().is_none_or(|sign| sign == 0), "{found:?} is beside {exact:?}");
    assert!(off.size() < 1e-27 * exact.size(), "{:e} of {:e}", off.size(), exact.size());
}

#[test]
fn functions_of_balls_have_thirty_known_digits() {
    let one = Ball::constant(1.0);
    holds(&one.exp().expect("it is small"), &digits("2", "7182818284590452353602874713526624977572"));
    let [cos, sin] = one.cos_sin().expect("it is small");
    holds(&cos, &digits("0", "5403023058681397174009366074429766037323"));
    holds(&sin, &digits("0", "8414709848078965066525023216302989996226"));
    holds(
        &Ball::constant(2.0).root().expect("it is positive"),
        &digits("1", "4142135623730950488016887242096980785697"),
    );
    // (1 - exp(-1))/1
    holds(&one.faded().expect("it is small"), &digits("0", "6321205588285576784044762298385391325542"));
}

/// Hundreds of operations, in exact arithmetic and with enclosures: the enclosure contains all rounding errors.
#[test]
fn long_sums_products_and_quotients_hold_the_exact_fraction() {
    let one = Rational::int(1);
    let (mut exact, mut enclosed) = (one, Ball::constant(1.0));
    for k in 1..60 {
        let (factor, part) = (Rational::new(k + 3, k + 1), Rational::new(1, 3 * k));
        exact = exact * factor - part;
        enclosed = enclosed.times(&ball(factor)).minus(&ball(part));
        holds(&enclosed, &ball(exact));
        holds(&Ball::constant(1.0).over(&enclosed).expect("it does not vanish"), &ball(one / exact));
    }
    assert!(enclosed.left() > 0.0);
}

/// Single sums, products and quotients of numbers with all bits used; their errors are known from exact residues.
#[test]
fn a_single_operation_is_off_by_no_more_than_it_says() {
    let exactly = |x: DoubleDouble| Rational::exactly(x.hi()) + Rational::exactly(x.lo());
    let apart = |found: Ball, exact: Rational| {
        let near = Ball::constant(found.at(0.0));
        // the exact difference between the number and its float
        let left = found.minus(&near).minus(&ball(exact - Rational::exactly(found.at(0.0))));
        assert!(left.sign().is_none_or(|sign| sign == 0), "{found:?} against {exact:?}");
    };
    let numbers = (1..60).map(|k| DoubleDouble::ratio(7 * k + 1, 3 * k + 2) - DoubleDouble::ratio(k, 11));
    let all: Vec<DoubleDouble> = numbers.collect();
    for (x, y) in all.iter().zip(all.iter().rev()) {
        let [a, b] = [*x, *y].map(|number| ball(exactly(number)));
        let [p, q] = [*x, *y].map(exactly);
        assert!(a.left() == 0.0 && b.left() == 0.0);
        apart(a.plus(&b), p + q);
        apart(a.times(&b), p * q);
        apart(a.over(&b).expect("it does not vanish"), p / q);
    }
}

#[test]
fn what_may_vanish_is_no_divisor_and_what_is_no_number_has_no_sign() {
    let wide = Ball::over_range(-1.0, 2.0);
    assert_eq!((Ball::constant(1.0).over(&wide), wide.root(), wide.sign()), (None, None, None));
    let none = Ball::constant(f64::NAN);
    assert!(none.sign().is_none() && !none.size().is_finite() && none.exp().is_none());
    assert_eq!(Ball::over_range(0.5, 2.0).sign(), Some(1));
}

/// Starting from the root in floats, the centre is first corrected to all digits, and a box that was chosen too wide is
/// then narrowed.
#[test]
fn a_fixed_point_is_held_to_all_digits_from_floats() {
    let (two, quarter) = (Ball::constant(2.0), Ball::constant(0.25));
    let value = |at: &[Ball]| Some(vec![at[0].minus(&at[0].times(&at[0]).minus(&two).times(&quarter))]);
    let derivative = |at: &[Ball]| {
        let slope = Ball::constant(1.0).minus(&at[0].times(&Ball::constant(0.5)));
        Some((value(at)?, vec![vec![slope]]))
    };
    let inverse = [vec![Ball::constant(2f64.sqrt())]];
    for least in [0.0, 1e-9] {
        let found = FixedPoint::near(&[Ball::constant(2f64.sqrt() + 1e-7)], &inverse, least, value, derivative);
        let place = found.expect("it is simple").place[0];
        holds(&place, &two.root().expect("it is positive"));
    }
}

/// With half of the inverse, an iteration covers half of the distance: the rest remains in the box, and also in the
/// narrowed one.
#[test]
fn a_poor_inverse_widens_the_place_of_a_fixed_point_and_does_not_lose_it() {
    let value = |at: &[Ball]| Some(vec![at[0].times(&Ball::constant(0.5))]);
    let derivative = |at: &[Ball]| Some((value(at)?, vec![vec![Ball::constant(0.5)]]));
    let found = FixedPoint::near(&[Ball::constant(1.0)], &[vec![Ball::constant(1.0)]], 1.0, value, derivative);
    let place = found.expect("it contracts").place[0];
    assert!(place.sign().is_none() && place.size() < 2.0, "zero is not in {place:?}");
}
