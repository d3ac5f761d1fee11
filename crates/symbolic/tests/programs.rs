//! Tapes: straight-line programs.

use field::{Analytic, Scalar, Tangent};
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
