//! Properties of expressions, tested on random ones (proptest).

use dalembert_symbolic::{Decision, Hypotheses, Sym, Tape, decide, normal, symbols};
use field::laws::{circle_laws, field_laws};
use field::{Analytic, Circle, DoubleDouble, Scalar, Tangent};
use num_dual::Dual;
use proptest::prelude::*;

/// The tree of a random expression; evaluated over any number type by [`Tree::over`].
#[derive(Clone, Debug)]
enum Tree {
    Variable(usize),
    Number(i64, i64),
    Sum(Box<Tree>, Box<Tree>),
    Difference(Box<Tree>, Box<Tree>),
    Product(Box<Tree>, Box<Tree>),
    Quotient(Box<Tree>, Box<Tree>),
    Negation(Box<Tree>),
    Cosine(Box<Tree>),
    Sine(Box<Tree>),
    Root(Box<Tree>),
}

impl Tree {
    fn over<S: Analytic>(&self, variables: &[S; 3]) -> S {
        let of = |tree: &Tree| tree.over(variables);
        match self {
            Tree::Variable(place) => variables[*place],
            Tree::Number(n, d) => S::ratio(*n, *d),
            Tree::Sum(a, b) => of(a) + of(b),
            Tree::Difference(a, b) => of(a) - of(b),
            Tree::Product(a, b) => of(a) * of(b),
            // The divisor 1 + b^2 and the radicand 1 + a^2 are positive: rounding cannot lead to a division by zero or a negative radicand.
            Tree::Quotient(a, b) => of(a) / (S::int(1) + of(b).squared()),
            Tree::Negation(a) => -of(a),
            Tree::Cosine(a) => of(a).circle().cos,
            Tree::Sine(a) => of(a).circle().sin,
            Tree::Root(a) => (S::int(1) + of(a).squared()).sqrt(),
        }
    }
}

fn tree(transcendental: bool) -> impl Strategy<Value = Tree> {
    let leaf = prop_oneof![
        3 => (0..3usize).prop_map(Tree::Variable),
        1 => (-5..6i64, 1..4i64).prop_map(|(n, d)| Tree::Number(n, d)),
    ];
    leaf.prop_recursive(4, 12, 2, move |inner| {
        let pair = || (inner.clone(), inner.clone()).prop_map(|(a, b)| (Box::new(a), Box::new(b)));
        let one = || inner.clone().prop_map(Box::new);
        let weight = u32::from(transcendental);
        prop_oneof![
            3 => pair().prop_map(|(a, b)| Tree::Sum(a, b)),
            2 => pair().prop_map(|(a, b)| Tree::Difference(a, b)),
            3 => pair().prop_map(|(a, b)| Tree::Product(a, b)),
            1 => pair().prop_map(|(a, b)| Tree::Quotient(a, b)),
            1 => one().prop_map(Tree::Negation),
            weight => one().prop_map(Tree::Cosine),
            weight => one().prop_map(Tree::Sine),
            weight => one().prop_map(Tree::Root),
        ]
    })
}

fn variables() -> [Sym; 3] {
    symbols(["x", "y", "z"])
}

/// Returns the value of the expression at a point, computed in double-double arithmetic: a normal form may have terms of 1e12 that
/// cancel to a sum below 1.
fn at(expression: Sym, point: [f64; 3]) -> f64 {
    let of = |place: usize| DoubleDouble::from(point[place]);
    let value = |name: &str| ["x", "y", "z"].iter().position(|known| *known == name).map(of);
    expression.evaluate_analytic(&value).unwrap().hi()
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-6 * (1.0 + a.abs().max(b.abs()))
}

fn point() -> impl Strategy<Value = [f64; 3]> {
    [-1.5..1.5f64, -1.5..1.5f64, -1.5..1.5f64]
}

#[test]
fn expressions_obey_the_laws_of_a_field_and_of_the_circle() {
    let [x, y, z] = variables();
    let none = Hypotheses::none();
    for (name, a, b) in field_laws(x * y, y + z, x / z).into_iter().chain(circle_laws(x, y)) {
        assert!(none.equal(a, b).is_zero(), "{name}: {a} and {b}");
    }
    let (p, q) = (x.circle(), (y + z).circle());
    assert!(none.equal((p + q).defect(), Sym::int(0)).is_zero());
    for part in 0..24 {
        let turn = Circle::<Sym>::exact_turn(part, 24).unwrap();
        assert!(none.equal(turn.defect(), Sym::int(0)).is_zero());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn a_normal_form_has_the_value_of_its_expression(tree in tree(true), point in point()) {
        let expression = tree.over(&variables());
        if let Ok(form) = normal(expression, &Hypotheses::none()) {
            prop_assert!(close(at(form.to_sym(), point), tree.over(&point)), "{} is not {}", form, expression);
        }
    }

    #[test]
    fn a_normal_form_is_its_own_normal_form(tree in tree(true)) {
        let none = Hypotheses::none();
        if let Ok(form) = normal(tree.over(&variables()), &none) {
            prop_assert_eq!(normal(form.to_sym(), &none).unwrap().to_string(), form.to_string());
        }
    }

    #[test]
    fn an_expression_and_a_variant_of_it_print_equally(tree in tree(true)) {
        let [x, y, z] = variables();
        let none = Hypotheses::none();
        let expression = tree.over(&[x, y, z]);
        let factor = x * y + z.circle().sin - (x + Sym::int(2)).sqrt();
        let variant = (expression * factor + factor * y) / factor - y;
        if let (Ok(a), Ok(b)) = (normal(expression, &none), normal(variant, &none)) {
            prop_assert_eq!(a.to_string(), b.to_string());
        }
    }

    #[test]
    fn three_derivatives_agree(tree in tree(true), point in point()) {
        let [x, y, z] = variables();
        let slope = tree.over(&[x, y, z]).diff(x);
        let tangent = tree.over(&[Tangent::variable(x), Tangent::fixed(y), Tangent::fixed(z)]).slope;
        let dual = tree.over(&[Dual::from(point[0]).derivative(), Dual::from(point[1]), Dual::from(point[2])]);
        prop_assert!(close(at(slope, point), dual.eps), "{} for {}", at(slope, point), dual.eps);
        prop_assert!(!decide(slope - tangent, &Hypotheses::none()).is_nonzero());
        prop_assert!(close(at(tangent, point), dual.eps));
    }

    #[test]
    fn substitution_commutes_with_evaluation(tree in tree(true), inner in tree(true), point in point()) {
        let [x, y, z] = variables();
        let composed = tree.over(&[x, y, z]).substitute(&[(x, inner.over(&[x, y, z]))]);
        let inside = inner.over(&point);
        prop_assert!(close(at(composed, point), tree.over(&[inside, point[1], point[2]])));
    }

    #[test]
    fn a_tape_computes_what_its_expressions_say(trees in [tree(true), tree(true)], point in point()) {
        let inputs = variables();
        let outputs = [trees[0].over(&inputs), trees[1].over(&inputs)];
        let tape = Tape::record(&inputs, &outputs).unwrap();
        let mut values = [0.0; 2];
        tape.over::<f64>().evaluate(&point, &mut values);
        prop_assert!(close(values[0], trees[0].over(&point)));
        prop_assert!(close(values[1], trees[1].over(&point)));
    }

    #[test]
    fn a_refutation_is_a_point_where_the_expression_is_not_zero(tree in tree(false), wrong in tree(false)) {
        let [x, y, z] = variables();
        let (right, wrong) = (tree.over(&[x, y, z]), wrong.over(&[x, y, z]));
        let sphere = Hypotheses::none().unit_vector([x, y, z]);
        match sphere.equal(right, wrong) {
            Decision::NonZero(witness) => {
                prop_assert_eq!((right - wrong).substitute(&witness.point), witness.value);
                prop_assert!(witness.value != Sym::int(0));
                prop_assert_eq!((x * x + y * y + z * z).substitute(&witness.point), Sym::int(1));
            }
            Decision::Zero(_) => {
                let (a, b, c) = (1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0);
                prop_assert!(close(at(right, [a, b, c]), at(wrong, [a, b, c])));
            }
            other => prop_assert!(false, "{}", other),
        }
    }
}
