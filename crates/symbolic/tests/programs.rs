//! Tapes and Taylor series.

use field::{Analytic, DoubleDouble, Scalar, Tangent};
use symbolic::{Sym, Tape, Untapeable, symbols};

#[test]
fn common_parts_are_computed_once_and_dead_ones_not_at_all() {
    let [x, y, z] = symbols(["x", "y", "z"]);
    let (a, b) = (x * y, y * x);
    let point = (x + y).circle();
    let tape = Tape::record(&[x, y, z], &[a + b - z, point.cos * point.cos, z.powi(5)]).unwrap();
    // x*y, its double, the difference; two angles of the expanded sum with five operations; three products.
    assert_eq!(tape.operations(), 3 + 2 + 4 + 3);
    let mut out = [0.0; 3];
    tape.over::<f64>().evaluate(&[0.5, 0.25, 2.0], &mut out);
    assert_eq!((out[0], out[2]), (0.25 - 2.0, 32.0));
    assert!((out[1] - 0.75f64.cos().powi(2)).abs() < 1e-15);
}

#[test]
fn tangents_run_through_a_tape() {
    let x = Sym::symbol("x");
    let tape = Tape::record(&[x], &[x.circle().sin / x]).unwrap();
    let mut out = [Tangent::fixed(0.0)];
    tape.over().evaluate(&[Tangent::variable(2.0)], &mut out);
    assert!((out[0].slope - (2.0 * 2f64.cos() - 2f64.sin()) / 4.0).abs() < 1e-15);
}

#[test]
fn what_has_no_value_cannot_be_taped() {
    let [x, y] = symbols(["x", "y"]);
    let law = Sym::function("M2", x);
    assert_eq!(Tape::record(&[x], &[law]), Err(Untapeable::Function("M2(x)".into())));
    assert_eq!(Tape::record(&[x], &[x * y]), Err(Untapeable::Unbound("y".into())));
    assert_eq!(Tape::record(&[x], &[x / Sym::int(0)]), Err(Untapeable::Undefined));
    // Given as an input, a function's value is as good as any.
    assert!(Tape::record(&[x, law], &[law * x]).is_ok());
}

/// The coefficients of the solution of y' = rate through (t, y).
fn solution<S: Analytic>(rate: impl Fn(Sym, Sym) -> Sym, y: S, t: S, order: usize) -> Vec<S> {
    let inputs = symbols(["y", "t"]);
    let tape = Tape::record(&inputs, &[rate(inputs[0], inputs[1])]).unwrap();
    let mut out = vec![S::zero(); order + 1];
    tape.series(order).unwrap().expand(&[y], &[Tangent::variable(t)], &mut out);
    out
}

#[test]
fn series_of_known_solutions_have_their_known_coefficients() {
    let near = |found: &[f64], known: &[f64]| {
        assert!(found.iter().zip(known).all(|(a, b)| (a - b).abs() < 1e-14), "{found:?} is not {known:?}");
    };
    near(&solution(|y, _| y, 1.0, 0.0, 4), &[1.0, 1.0, 0.5, 1.0 / 6.0, 1.0 / 24.0]);
    near(&solution(|y, _| y * y, 1.0, 0.0, 4), &[1.0; 5]);
    near(&solution(|y, _| Sym::int(1) + y * y, 0.0, 0.0, 5), &[0.0, 1.0, 0.0, 1.0 / 3.0, 0.0, 2.0 / 15.0]);
    near(&solution(|_, t| t.circle().cos, 0.0, 0.0, 5), &[0.0, 1.0, 0.0, -1.0 / 6.0, 0.0, 1.0 / 120.0]);
    near(&solution(|y, _| Sym::ratio(1, 2) / y, 1.0, 0.0, 4), &[1.0, 0.5, -0.125, 0.0625, -5.0 / 128.0]);
    near(&solution(|_, t| (Sym::int(1) + t).sqrt(), 0.0, 0.0, 4), &[0.0, 1.0, 0.25, -1.0 / 24.0, 1.0 / 64.0]);
}

#[test]
fn a_series_in_double_double_sums_to_the_solution() {
    let order = 30;
    let coefficients = solution(|y, t| -(y * t.circle().sin), DoubleDouble::from(1.0), DoubleDouble::from(0.0), order);
    let h = DoubleDouble::ratio(1, 8);
    let sum = coefficients.iter().rev().fold(DoubleDouble::from(0.0), |sum, &c| sum * h + c);
    // y = exp(cos t - 1).
    let exact = num_traits::Float::exp(h.circle().cos - DoubleDouble::from(1.0));
    assert!(f64::from(sum - exact).abs() < 1e-29);
}

#[test]
fn more_rates_than_inputs_are_refused() {
    let x = Sym::symbol("x");
    assert!(Tape::record(&[x], &[x, x]).unwrap().series::<f64>(3).is_err());
}
