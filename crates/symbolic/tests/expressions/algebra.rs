//! Coefficients, degrees and linear systems.

use dalembert_symbolic::linear::{Unsolved, solve};
use dalembert_symbolic::{Hypotheses, Sym, coefficients, degree, symbols};
use field::{Analytic, Elementary, Scalar};

#[test]
fn coefficients_are_read_off_as_they_are_written() {
    let [a, b, x, y] = symbols(["a", "b", "x", "y"]);
    let terms = coefficients((a * x + y / b).powi(2) - x, &[x, y]).unwrap();
    let shown: Vec<String> = terms.iter().map(|(exponents, value)| format!("{exponents:?} {value}")).collect();
    assert_eq!(shown, ["[2, 0] a^2", "[1, 1] a*1/b + 1/b*a", "[1, 0] -1", "[0, 2] (1/b)^2"]);
    assert!(coefficients(a / x, &[x]).is_err());
    assert!(coefficients(x.circle().cos, &[x]).is_err());
    assert!(coefficients(x.circle().cos * y, &[y]).is_ok());
}

#[test]
fn a_degree_sees_what_cancels() {
    let [a, x, y] = symbols(["a", "x", "y"]);
    let none = Hypotheses::none();
    assert_eq!(degree((x + a * y).powi(2) - x * x - a * a * y * y, &[x, y], &none), Ok(Some(2)));
    assert_eq!(degree((x + y) * (x - y) - x * x + y * y + a * x, &[x, y], &none), Ok(Some(1)));
    assert_eq!(degree(x - x, &[x], &none), Ok(None));
    let unit = Hypotheses::none().unit_vector([a, y]);
    assert_eq!(degree((a * a + y * y - Sym::int(1)) * x * x + x, &[x], &unit), Ok(Some(1)));
}

#[test]
fn a_linear_system_is_solved_exactly() {
    let entry = |i: usize, j: usize| Sym::symbol(&format!("m{i}{j}"));
    let matrix: Vec<Vec<Sym>> = (0..4).map(|i| (0..4).map(|j| entry(i, j)).collect()).collect();
    let right: Vec<Sym> = (0..4).map(|i| Sym::symbol(&format!("r{i}"))).collect();
    let none = Hypotheses::none();
    let values = solve(&matrix, &right, &none).unwrap().values();
    for (row, right) in matrix.iter().zip(&right) {
        let left = row.iter().zip(&values).fold(Sym::int(0), |sum, (&m, &x)| sum + m * x);
        assert!(none.equal(left, *right).is_zero());
    }
}

#[test]
fn a_singular_matrix_and_a_wrong_shape_are_refused() {
    let [a, b, c] = symbols(["a", "b", "c"]);
    let none = Hypotheses::none();
    assert_eq!(solve(&[[a, b], [a * c, b * c]], &[a, b], &none), Err(Unsolved::Singular));
    assert!(matches!(solve(&[[a, b], [b, c]], &[a], &none), Err(Unsolved::Shape { .. })));
    let point = a.circle();
    assert_eq!(
        solve(&[[point.cos, point.sin], [-point.sin, point.cos]], &[b, c], &none).map(|s| s.determinant.to_string()),
        Ok("cos(a)*cos(a) + sin(a)*sin(a)"
            .to_string()
            .replace("cos(a)*cos(a)", "cos(a)^2")
            .replace("sin(a)*sin(a)", "sin(a)^2"))
    );
}

#[test]
fn a_determinant_of_exponentials_is_shown_not_to_vanish_by_an_enclosure() {
    let [a, b] = symbols(["a", "b"]);
    let exp = |x: Sym| x.elementary(Elementary::Exp, x);
    let none = Hypotheses::none();
    let solution = solve(&[[exp(a) * b]], &[a], &none).map(|solution| solution.values()[0]);
    assert!(solution.is_ok_and(|x| none.equal(x * exp(a) * b, a).is_zero()));
    let vanishing = solve(&[[exp(a) - exp(a)]], &[b], &none);
    assert_eq!(vanishing, Err(Unsolved::Singular));
}
