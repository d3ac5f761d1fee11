use super::super::{Factors, Magnitude, NotSolved, Pattern};
use field::{DoubleDouble, Rational, Scalar};

/// The entries of a mass matrix of three masses with two constraints.
const PLACES: [(usize, usize); 11] =
    [(0, 0), (0, 1), (1, 0), (1, 1), (2, 2), (0, 3), (3, 0), (1, 4), (4, 1), (2, 4), (4, 2)];
const ENTRIES: [i64; 11] = [4, 1, 1, 3, 5, 2, 2, 1, 1, -1, -1];

fn entries<S: Scalar>() -> Vec<S> {
    ENTRIES.iter().map(|&entry| S::int(entry)).collect()
}

/// The residual A z - b.
fn residual<S: Scalar>(z: &[S], right: &[S]) -> Vec<S> {
    let mut residual: Vec<S> = right.iter().map(|&b| -b).collect();
    for (&(row, column), entry) in PLACES.iter().zip(entries::<S>()) {
        residual[row] += entry * z[column];
    }
    residual
}

fn solved<S: Magnitude>(factors: &mut Factors<S>, entries: &[S], right: &[S]) -> Result<Vec<S>, NotSolved> {
    factors.factor(entries)?;
    let mut z = right.to_vec();
    factors.solve(&mut z);
    Ok(z)
}

#[test]
fn unknowns_satisfy_their_equations_in_every_field() {
    let pattern = Pattern::new(5, 3, PLACES.to_vec());
    let right = [1, 2, 3, 4, 5];
    let exact: Vec<Rational> = right.iter().map(|&b| Rational::int(b)).collect();
    let z = solved(&mut Factors::new(&pattern), &entries(), &exact).unwrap();
    assert!(residual(&z, &exact).iter().all(|rest| *rest == Rational::int(0)));
    let fine: Vec<DoubleDouble> = right.iter().map(|&b| DoubleDouble::int(b)).collect();
    let close = solved(&mut Factors::new(&pattern), &entries(), &fine).unwrap();
    assert!(residual(&close, &fine).iter().all(|rest| rest.magnitude() < 1e-29));
    let plain = right.map(|b| b as f64);
    let rounded = solved(&mut Factors::new(&pattern), &entries(), &plain).unwrap();
    for (rounded, exact) in rounded.iter().zip(&z) {
        assert!((rounded - exact.to_f64()).abs() < 1e-14);
    }
}

#[test]
fn a_constraint_that_another_implies_has_no_multiplier() {
    // both constraints depend on the first unknown
    let pattern = Pattern::new(3, 1, vec![(0, 0), (0, 1), (1, 0), (0, 2), (2, 0)]);
    let mut factors = Factors::new(&pattern);
    let z = solved(&mut factors, &[2.0, 1.0, 1.0, 3.0, 3.0], &[0.0, 5.0, 15.0]).unwrap();
    assert_eq!(z[0], 5.0);
    assert!((2.0 * z[0] + z[1] + 3.0 * z[2]).abs() < 1e-14, "{z:?}");
    assert!(z[1] == 0.0 || z[2] == 0.0, "{z:?}");
}

#[test]
fn an_unknown_that_nothing_determines_is_named() {
    let pattern = Pattern::new(2, 2, vec![(0, 0), (0, 1), (1, 0), (1, 1)]);
    let mut factors = Factors::new(&pattern);
    let error = factors.factor(&[1.0, 2.0, 2.0, 4.0]).unwrap_err();
    assert!(matches!(error, NotSolved::Undetermined(0 | 1)), "{error:?}");
    assert_eq!(factors.factor(&[1.0, f64::NAN, 2.0, 4.0]), Err(NotSolved::NotANumber));
}

#[test]
fn small_pivots_of_the_order_are_passed_over() {
    // the first pivot of the pattern's order is 1e-9, which would lose half of the digits
    let pattern = Pattern::new(2, 2, vec![(0, 0), (0, 1), (1, 0), (1, 1)]);
    let z = solved(&mut Factors::new(&pattern), &[1e-9, 1.0, 1.0, 1.0], &[1.0, 2.0]).unwrap();
    let exact = 1.0 / (1.0 - 1e-9);
    assert!((z[0] - exact).abs() < 1e-15 && (z[1] - (2.0 - exact)).abs() < 1e-15, "{z:?}");
}

#[test]
fn equal_entries_give_equal_bits_whatever_was_factored_before() {
    let pattern = Pattern::new(5, 3, PLACES.to_vec());
    let right = [1.0, 2.0, 3.0, 4.0, 5.0];
    let fresh = solved(&mut Factors::new(&pattern), &entries(), &right).unwrap();
    let mut used = Factors::new(&pattern);
    let zero = [0.0; ENTRIES.len()];
    assert!(used.factor(&zero).is_err());
    assert_eq!(solved(&mut used, &entries(), &right).unwrap(), fresh);
}
