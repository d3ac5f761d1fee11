//! The prover's decisions on identities, on mutated identities, and under hypotheses.

use dalembert_symbolic::{Decision, Hypotheses, Sym, decide, decide_modulo, normal, symbols};
use field::{Analytic, Elementary, Scalar};
use nalgebra::{Matrix3, Matrix4};

fn det3(m: Matrix3<Sym>) -> Sym {
    m[(0, 0)] * (m[(1, 1)] * m[(2, 2)] - m[(1, 2)] * m[(2, 1)])
        - m[(0, 1)] * (m[(1, 0)] * m[(2, 2)] - m[(1, 2)] * m[(2, 0)])
        + m[(0, 2)] * (m[(1, 0)] * m[(2, 1)] - m[(1, 1)] * m[(2, 0)])
}

fn det4(m: Matrix4<Sym>) -> Sym {
    (0..4).fold(Sym::int(0), |sum, j| {
        let minor = m.remove_row(0).remove_column(j);
        let term = m[(0, j)] * det3(minor);
        if j % 2 == 0 { sum + term } else { sum - term }
    })
}

fn gyrostat(swap: bool) -> Sym {
    let [a1, a2, a3, a, l1, l2, l3] = symbols(["A1s", "A2s", "A3s", "Ap", "l1", "l2", "l3"]);
    let (diagonal, l) = ([a1, a2, a3], [l1, l2, l3]);
    let matrix = Matrix3::from_fn(|i, j| if i == j { diagonal[i] - a * l[i] * l[i] } else { -(a * l[i] * l[j]) });
    let d = Sym::int(1) - a * l1 * l1 / a1 - a * l2 * l2 / a2 - a * l3 * l3 / if swap { a2 } else { a3 };
    det3(matrix) - a1 * a2 * a3 * d
}

#[test]
fn the_determinant_of_the_reduced_inertia_is_the_product_with_d() {
    let decision = decide(gyrostat(false), &Hypotheses::none());
    let Decision::Zero(proof) = decision else { panic!("{decision}") };
    assert_eq!(format!("{:?}", proof.requires), "[A1s, A2s, A3s]");
}

#[test]
fn a_mutated_identity_is_refuted_by_a_point_that_really_refutes_it() {
    let mutated = gyrostat(true);
    let Decision::NonZero(witness) = decide(mutated, &Hypotheses::none()) else { panic!("not refuted") };
    let value = mutated.substitute(&witness.point);
    assert_eq!(value, witness.value);
    assert_ne!(value, Sym::int(0));
}

#[test]
fn the_determinant_of_a_product_is_the_product_of_the_determinants() {
    let entry = |name: &str| {
        let name = name.to_string();
        Matrix4::from_fn(|i, j| Sym::symbol(&format!("{name}{}{}", i + 1, j + 1)))
    };
    let (a, b) = (entry("a"), entry("b"));
    assert!(decide(det4(a * b) - det4(a) * det4(b), &Hypotheses::none()).is_zero());
    assert!(decide(det4(a * b) - det4(a) * det4(b) + a[(0, 0)], &Hypotheses::none()).is_nonzero());
}

#[test]
fn a_unit_vector_is_rewritten_by_its_last_component() {
    let [l1, l2, l3] = symbols(["l1", "l2", "l3"]);
    let unit = Hypotheses::none().unit_vector([l1, l2, l3]);
    let square = l1 * l1 + l2 * l2 + l3 * l3;
    assert!(unit.equal(square, Sym::int(1)).is_zero());
    assert!(unit.equal(square.sqrt(), Sym::int(1)).is_zero());
    assert!(Hypotheses::none().equal(square, Sym::int(1)).is_nonzero());
    let Decision::NonZero(witness) = unit.equal(l3, l1 * l2) else { panic!("not refuted") };
    assert_eq!(square.substitute(&witness.point), Sym::int(1));
    let [(left, right)] = unit.statements() else { unreachable!() };
    assert_eq!(format!("{left} = {right}"), "l1^2 + l2^2 + l3^2 = 1");
}

#[test]
fn angles_obey_the_addition_theorems() {
    let [x, y] = symbols(["x", "y"]);
    let (p, q, sum) = (x.circle(), y.circle(), (x + y).circle());
    let none = Hypotheses::none();
    assert!(none.equal(sum.cos, p.cos * q.cos - p.sin * q.sin).is_zero());
    assert!(none.equal(sum.cos.squared() + sum.sin.squared(), Sym::int(1)).is_zero());
    assert!(none.equal((Sym::int(3) * x).circle().sin, Sym::int(3) * p.sin - Sym::int(4) * p.sin.powi(3)).is_zero());
    assert!(none.equal((x * y).circle().cos, (y * x).circle().cos).is_zero());
    assert!(none.equal(((x + y) * y).circle().sin, (y * y + y * x).circle().sin).is_zero());
    assert!(none.equal(p.sin, p.cos).is_nonzero());
    let (half, third) = ((x / Sym::int(2)).circle(), (x / Sym::int(3)).circle());
    assert!(none.equal(p.cos, Sym::int(2) * half.cos.squared() - Sym::int(1)).is_zero());
    assert!(
        none.equal(half.sin * half.cos, (Sym::int(3) * third.sin - Sym::int(4) * third.sin.powi(3)).half()).is_zero()
    );
    assert!(none.equal(half.cos, third.cos).is_nonzero());
    // angles without a common part, and the cosine of a number, have dependences that the decision does not use
    assert!(matches!(none.equal((Sym::int(100) * x).circle().cos, p.cos), Decision::GaveUp(_)));
    assert!(matches!(none.equal(Sym::int(1).circle().cos, Sym::ratio(1, 2)), Decision::GaveUp(_)));
}

#[test]
fn a_sum_over_denominators_with_angles_is_rewritten_again() {
    let point = Sym::symbol("x").circle();
    let one = Sym::int(1);
    let none = Hypotheses::none();
    assert!(none.equal(point.sin / (one + point.cos), (one - point.cos) / point.sin).is_zero());
    assert!(none.equal(one / (one + point.sin) + one / (one - point.sin), Sym::int(2) / point.cos.squared()).is_zero());
}

#[test]
fn roots_of_rational_numbers_are_canonical() {
    let root = |n, d| Sym::ratio(n, d).sqrt();
    let none = Hypotheses::none();
    assert_eq!(root(9, 4), Sym::ratio(3, 2));
    assert_eq!(root(1, 2), root(2, 1) / Sym::int(2));
    assert!(none.equal(root(6, 1), root(2, 1) * root(3, 1)).is_zero());
    assert!(none.equal(Sym::int(1) / root(2, 1), root(1, 2)).is_zero());
    let Decision::NonZero(witness) = none.equal(root(2, 1), Sym::ratio(3, 2)) else { panic!("not refuted") };
    assert_eq!(witness.value.to_string(), "(2*sqrt(2) - 3)/2");
}

#[test]
fn roots_of_expressions_have_the_expression_as_their_square() {
    let [a, b] = symbols(["a", "b"]);
    let none = Hypotheses::none();
    let root = (a / b).sqrt();
    assert!(none.equal(root * root, a / b).is_zero());
    assert!(none.equal((a * a + b).sqrt(), (b + a * a).sqrt()).is_zero());
    assert!(none.equal((Sym::int(4) * a).sqrt(), Sym::int(2) * a.sqrt()).is_zero());
    // true for positive numbers, but no consequence of the squares: neither proved nor refuted
    assert!(matches!(none.equal((a * b).sqrt(), a.sqrt() * b.sqrt()), Decision::GaveUp(_)));
    let Decision::NonZero(witness) = none.equal((a * a).sqrt(), a) else { panic!("not refuted") };
    assert!(witness.value.as_constant().is_some_and(|value| value.sign() == Some(1)));
}

#[test]
fn rules_that_are_not_coprime_are_refused() {
    let [x, y, z] = symbols(["x", "y", "z"]);
    let twice = Hypotheses::none().unit_vector([x, y, z]).rule(z, 2, x * y);
    assert!(twice.check().is_err());
    assert!(matches!(decide(x, &twice), Decision::GaveUp(_)));
    let circle = Hypotheses::none().rule(x, 2, y * y).rule(y, 2, x);
    assert!(circle.check().is_err_and(|refused| refused.to_string().contains("in a circle")));
    assert!(Hypotheses::none().unit_vector([x, y]).rule(z, 3, x).check().is_ok());
}

#[test]
fn a_witness_satisfies_every_rule() {
    let [x, y, z, u] = symbols(["x", "y", "z", "u"]);
    let both = Hypotheses::none().unit_vector([x, y]).unit_vector([x, z]).rule(u, 2, x + Sym::int(2));
    let Decision::NonZero(witness) = both.equal(u * y, z) else { panic!("not refuted") };
    let none = Hypotheses::none();
    for (a, b) in [(x * x + y * y, Sym::int(1)), (x * x + z * z, Sym::int(1)), (u * u, x + Sym::int(2))] {
        assert!(none.equal((a - b).substitute(&witness.point), Sym::int(0)).is_zero());
    }
    assert!(none.equal((u * y - z).substitute(&witness.point), witness.value).is_zero());
}

#[test]
fn a_symbol_may_be_given_by_an_expression() {
    let [a, b, c] = symbols(["a", "b", "c"]);
    let given = Hypotheses::none().given(c, a / b).given(b, a + Sym::int(1));
    assert!(given.equal(c * b, a).is_zero());
    assert!(given.equal(b, a).is_nonzero());
    assert!(Hypotheses::none().given(c, a + c).check().is_err());
    assert!(Hypotheses::none().unit_vector([a, b]).given(b, c).check().is_err());
    assert!(Hypotheses::none().given(b, c).unit_vector([a, b]).check().is_err());
    let within = Hypotheses::none().given(a, c * c).unit_vector([a, b]);
    assert!(within.equal(b * b + c.powi(4), Sym::int(1)).is_zero());
    let Decision::NonZero(witness) = within.equal(b, c) else { panic!("not refuted") };
    assert!(Hypotheses::none().equal((a * a + b * b).substitute(&witness.point), Sym::int(1)).is_zero());
}

#[test]
fn cofactors_certify_a_consequence() {
    let [x, y] = symbols(["x", "y"]);
    let (h, k) = (x + y - Sym::int(3), x - y - Sym::int(1));
    let none = Hypotheses::none();
    assert!(decide_modulo(x - Sym::int(2), &[(Sym::ratio(1, 2), h), (Sym::ratio(1, 2), k)], &none).is_zero());
    assert!(decide_modulo(x - Sym::int(2), &[(Sym::int(1), h)], &none).is_nonzero());
}

#[test]
fn a_denominator_that_vanishes_is_named() {
    let [x, y] = symbols(["x", "y"]);
    let none = Hypotheses::none();
    assert!(matches!(
        decide(x / ((x + y).powi(2) - x * x - y * y - Sym::int(2) * x * y), &none),
        Decision::Undefined(_)
    ));
    assert!(matches!(decide(x / Sym::int(0), &none), Decision::Undefined(_)));
}

#[test]
fn equal_rational_functions_print_equally() {
    let [x, y] = symbols(["x", "y"]);
    let form = |e| normal(e, &Hypotheses::none()).unwrap().to_string();
    let one = Sym::int(1);
    assert_eq!(form((x * x - y * y) / (x - y).powi(2)), form((x + y) / (x - y)));
    assert_eq!(form((x * x - y * y) / (x - y).powi(2)), "(x + y)/(x - y)");
    assert_eq!(form(one / (x * x - one)), form(one / (x - one) / (x + one)));
    assert_eq!(form(x / Sym::int(2) + y / Sym::int(3)), "(3*x + 2*y)/6");
    assert_eq!(form((x + y).powi(3) / (x * y + y * y) - (x + y).powi(2) / y), "0");
}

#[test]
fn angles_and_roots_in_denominators_print_equally_too() {
    let [x, y] = symbols(["x", "y"]);
    let form = |e| normal(e, &Hypotheses::none()).unwrap().to_string();
    let (one, point) = (Sym::int(1), x.circle());
    assert_eq!(form(point.sin / (one - point.cos)), form((one + point.cos) / point.sin));
    assert_eq!(form(y / point.sin), "y/sin(x)");
    assert_eq!(form(y * point.sin / (one - point.cos.squared())), "y/sin(x)");
    assert_eq!(
        form((y + point.sin) / point.sin.powi(3)),
        form((point.sin + y) / point.sin / (one - point.cos.powi(2)))
    );
    assert_eq!(form(one / (one + Sym::int(2).sqrt())), "sqrt(2) - 1");
    assert_eq!(form(one / x.sqrt()), "1/sqrt(x)");
    assert_eq!(form(x / (x * y).sqrt()), form((x * y).sqrt() / y));
    assert_eq!(form(x / (one / y).sqrt()), form(x * y * (one / y).sqrt()));
    assert_eq!(form(one / (x.sqrt() + y.sqrt())), form((x.sqrt() - y.sqrt()) / (x - y)));
}

#[test]
fn common_divisors_of_written_out_polynomials_are_found() {
    let [x, y, z, t] = symbols(["x", "y", "z", "t"]);
    let none = Hypotheses::none();
    let written_out = |e: Sym| normal(e, &none).unwrap().to_sym();
    let common = (x * y - z * t + Sym::int(3)).powi(2) * (x + y + z + t);
    let (p, q) = ((x + y * z).powi(3) + t, (y - t * x).powi(2) + z * Sym::int(6));
    let fraction = written_out(common * p * Sym::int(4)) / written_out(common * q * Sym::int(6));
    assert_eq!(
        normal(fraction, &none).unwrap().to_string(),
        normal(p / q * Sym::ratio(2, 3), &none).unwrap().to_string()
    );
}

#[test]
fn a_divisor_that_all_coefficients_share_is_divided_out_too() {
    let [x, y] = symbols(["x", "y"]);
    let one = Sym::int(1);
    let common = (x + one) * (y + one);
    let (p, q) = (x + y * Sym::int(2) + Sym::int(3), x + y * Sym::int(5) + Sym::int(7));
    let form = |e: Sym| normal(e, &Hypotheses::none()).unwrap();
    let written_out = |e: Sym| form(e).to_sym();
    assert_eq!(form(written_out(common * p) / written_out(common * q)).to_string(), form(p / q).to_string());
}

#[test]
fn a_power_is_rewritten_by_its_rule_as_often_as_it_holds_that() {
    let [x, y] = symbols(["x", "y"]);
    let square = (y + Sym::int(3)).half();
    let rule = Hypotheses::none().rule(x, 2, square);
    let form = |e: Sym, hypotheses: &Hypotheses| normal(e, hypotheses).unwrap().to_string();
    let even = square.powi(2) + square * y.powi(2) * Sym::int(6) + y.powi(4);
    let odd = (square * y + y.powi(3)) * x * Sym::int(4);
    assert_eq!(form((x + y).powi(4), &rule), form(even + odd, &Hypotheses::none()));
}

#[test]
fn a_function_is_a_generator_for_every_argument() {
    let [s, t] = symbols(["s", "t"]);
    let moment = Sym::function("M2", s * t);
    let none = Hypotheses::none();
    assert!(none.equal(moment, Sym::function("M2", t * s)).is_zero());
    assert_eq!(moment.diff(s).to_string(), "M2'(s*t)*t");
    let Decision::NonZero(witness) = none.equal(Sym::function("M2", s), Sym::function("M2", t) * (s - t)) else {
        panic!("not refuted")
    };
    assert!(witness.point.iter().all(|(_, value)| value.as_constant().is_some()));
}

#[test]
fn a_computation_without_end_is_given_up() {
    let names: Vec<Sym> = (0..30).map(|i| Sym::symbol(&format!("x{i}"))).collect();
    let sum = names.iter().fold(Sym::int(1), |sum, &x| sum + x);
    assert!(matches!(decide(sum.powi(20) - sum, &Hypotheses::none()), Decision::GaveUp(_)));
    assert!(matches!(decide(names[0].powi(1000) - names[1], &Hypotheses::none()), Decision::GaveUp(_)));
}

#[test]
fn the_sine_and_cosine_of_a_direction_are_algebraic() {
    let [x, y, l] = symbols(["x", "y", "l"]);
    let angle = y.elementary(Elementary::Atan2, x);
    let point = angle.circle();
    let length = (x * x + y * y).sqrt();
    let none = Hypotheses::none();
    for zero in [
        point.cos * length - x,
        point.sin * length - y,
        (angle + angle).circle().sin - (x * y + x * y) / (x * x + y * y),
    ] {
        assert!(decide(zero, &none).is_zero(), "{zero}: {}", decide(zero, &none));
    }
    assert!(decide(point.sin - y / (x + length), &none).is_nonzero());
    // the constraint makes the point stay on a circle of radius l
    let circle = Hypotheses::none().rule(y, 2, l * l - x * x);
    assert!(decide(point.sin * point.sin - y * y / (l * l), &circle).is_zero());
    // on this curve half of the angle is not determined by x and y: a point where it is chosen wrongly must not refute anything
    let half = (angle * Sym::ratio(1, 2)).circle();
    assert!(!decide(half.cos * half.cos + half.cos * half.cos - Sym::ONE - x / length, &none).is_nonzero());
}
