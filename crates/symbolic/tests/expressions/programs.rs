//! Tapes: straight-line programs recorded from expressions.

use dalembert_symbolic::{Sym, Tape, Untapeable, apart, symbols};
use field::{Analytic, Scalar, Tangent};

#[test]
fn common_parts_are_computed_once_and_dead_ones_not_at_all() {
    let [x, y, z] = symbols(["x", "y", "z"]);
    let (a, b) = (x * y, y * x);
    let point = (x + y).circle();
    let tape = Tape::record(&[x, y, z], &[a + b - z, point.cos * point.cos, z.powi(5)]).unwrap();
    // 3: x*y, 2*x*y, 2*x*y - z; 2: cosine and sine of x, of y; 4: the expanded cos(x + y) and its square; 3: z^5.
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
    // An unknown function can be recorded if it is itself an input.
    assert!(Tape::record(&[x, law], &[law * x]).is_ok());
}

/// Records a tape of two products. The order of their factors depends on the products that the expression graph contains already.
fn recorded() -> Tape {
    let [x, y, z] = symbols(["x", "y", "z"]);
    let outputs = [(x * y + z) * (y * z), (z * x) * (x * y)];
    Tape::record(&[x, y, z], &outputs).expect("it has values")
}

#[test]
fn what_is_recorded_apart_is_the_same_whatever_was_written_before() {
    let alone = std::thread::spawn(recorded).join().expect("it is recorded");
    let [x, y, z] = symbols(["x", "y", "z"]);
    let before = [z * x, y * z];
    assert_ne!(recorded(), alone, "the order of a graph shows");
    assert_eq!(apart(recorded), alone);
    assert_eq!(before, [z * x, y * z], "what was written before is still there");
    assert_eq!(apart(|| symbols(["u"])[0].to_string()), "u");
    assert_eq!((x * y).to_string(), "x*y");
}

#[test]
fn a_panic_apart_leaves_the_graph_as_it_was() {
    let [x, y] = symbols(["x", "y"]);
    let sum = x + y;
    let caught = std::panic::catch_unwind(|| apart(|| assert_eq!(symbols(["a"])[0], Sym::ZERO)));
    assert!(caught.is_err());
    assert_eq!((sum.to_string(), x + y), ("x + y".to_owned(), sum));
}
