//! Linear equations: determinants, and elimination compared with exact solutions.

use dalembert_algebra::linear::{Factors, Magnitude, NotSolved, Pattern, determinant, nonnegative_combination};
use dalembert_algebra::real::Ball;
use field::{Rational, Scalar};

#[test]
fn determinants_run_over_any_field() {
    let hilbert: Vec<Vec<Rational>> = (0..5).map(|i| (0..5).map(|j| Rational::new(1, i + j + 1)).collect()).collect();
    assert_eq!(determinant(&hilbert), Some(Rational::new(1, 266_716_800_000)));
    assert_eq!(determinant(&[[1.0, 2.0], [3.0, 4.0]]), Some(-2.0));
    assert_eq!(determinant(&[vec![1.0], vec![3.0, 4.0]]), None);
}

/// Integers from a fixed seed.
struct Draws(u64);

impl Draws {
    fn below(&mut self, bound: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % bound
    }
}

/// A mass matrix of a few bodies, some coordinates without inertia, and constraints between them. Repeated and massless
/// rows occur at random, so that there are systems with and without a solution.
fn drawn(draws: &mut Draws) -> (Pattern, Vec<i64>, Vec<i64>) {
    let (n, m) = (1 + draws.below(6) as usize, draws.below(4) as usize);
    let mut dense = vec![vec![0_i64; n + m]; n + m];
    for _ in 0..1 + draws.below(8) {
        // one more body, along a direction of its own
        let along: Vec<i64> = (0..n).map(|_| draws.below(3) as i64 - 1).collect();
        for (row, &a) in dense.iter_mut().zip(&along) {
            row.iter_mut().zip(&along).for_each(|(entry, &b)| *entry += a * b);
        }
    }
    for k in n..n + m {
        let (first, repeats) = (dense[n][..n].to_vec(), k > n && draws.below(4) == 0);
        for (j, &before) in first.iter().enumerate() {
            let slope = if repeats { before } else { draws.below(5) as i64 - 2 };
            (dense[k][j], dense[j][k]) = (slope, slope);
        }
    }
    let places: Vec<(usize, usize)> = (0..n + m)
        .flat_map(|row| (0..n + m).map(move |column| (row, column)))
        .filter(|&(row, column)| dense[row][column] != 0)
        .collect();
    let entries = places.iter().map(|&(row, column)| dense[row][column]).collect();
    // a right-hand side for which a solution exists
    let solution: Vec<i64> = (0..n + m).map(|_| draws.below(7) as i64 - 3).collect();
    let right = dense.iter().map(|row| row.iter().zip(&solution).map(|(a, z)| a * z).sum()).collect();
    (Pattern::new(n + m, n, places), entries, right)
}

fn solved<S: Magnitude>(pattern: &Pattern, entries: &[i64], right: &[i64]) -> Result<Vec<S>, NotSolved> {
    let in_field = |numbers: &[i64]| numbers.iter().map(|&number| S::int(number)).collect::<Vec<S>>();
    let (mut factors, mut z) = (Factors::new(pattern), in_field(right));
    factors.factor(&in_field(entries))?;
    factors.solve(&mut z);
    Ok(z)
}

#[test]
fn two_thousand_systems_are_solved_or_refused_alike_in_rationals_and_in_f64() {
    let mut draws = Draws(20_261_126);
    let (mut found, mut refused) = (0, 0);
    for _ in 0..2_000 {
        let (pattern, entries, right) = drawn(&mut draws);
        match (solved::<Rational>(&pattern, &entries, &right), solved::<f64>(&pattern, &entries, &right)) {
            (Ok(exact), Ok(rounded)) => {
                found += 1;
                let mut rest: Vec<Rational> = right.iter().map(|&b| -Rational::int(b)).collect();
                for (&(row, column), &entry) in pattern.places().iter().zip(&entries) {
                    rest[row] += Rational::int(entry) * exact[column];
                }
                assert!(rest.iter().all(|rest| *rest == Rational::int(0)), "{rest:?}");
                // multipliers may differ if constraints repeat each other, accelerations may not
                for (exact, rounded) in exact.iter().zip(&rounded).take(pattern.determined()) {
                    assert!((exact.to_f64() - rounded).abs() < 1e-9, "{exact:?} is not {rounded}");
                }
            }
            (Err(NotSolved::Undetermined(_)), Err(NotSolved::Undetermined(_))) => refused += 1,
            (exact, rounded) => panic!("{exact:?} beside {rounded:?} of {pattern:?} {entries:?}"),
        }
    }
    assert!(found > 500 && refused > 100, "{found} {refused}");
}

#[test]
fn unknowns_of_enclosed_equations_enclose_those_of_each_of_them() {
    let width = |number: i64| Ball::over_range(number as f64 - WIDTH, number as f64 + WIDTH);
    const WIDTH: f64 = 1.0 / 1_048_576.0;
    let mut draws = Draws(20_261_127);
    let (mut found, mut refused) = (0, 0);
    for _ in 0..1_000 {
        let (pattern, entries, right) = drawn(&mut draws);
        let mut factors = Factors::<Ball>::new(&pattern);
        let mut z: Vec<Ball> = right.iter().copied().map(width).collect();
        // an entry that may be zero cannot be a pivot
        if factors.factor(&entries.iter().copied().map(width).collect::<Vec<_>>()).is_err() {
            refused += 1;
            continue;
        }
        factors.solve(&mut z);
        // the enclosure contains the solution for every matrix within the entries, symmetric or not
        for _ in 0..3 {
            let off = Rational::exactly(WIDTH);
            let mut within = |number: i64| {
                let part = Rational::new(draws.below(201) as i64 - 100, 100);
                Rational::int(number) + part * off
            };
            let entries: Vec<Rational> = entries.iter().map(|&entry| within(entry)).collect();
            let mut exact: Vec<Rational> = right.iter().map(|&b| within(b)).collect();
            let mut factors = Factors::<Rational>::new(&pattern);
            factors.factor(&entries).expect("what is enclosed is regular");
            factors.solve(&mut exact);
            for (z, exact) in z.iter().zip(&exact) {
                let off = (z.at(0.0) - exact.to_f64()).abs();
                assert!(off <= z.left() * (1.0 + 1e-9), "{exact:?} is not in {z:?}");
            }
        }
        found += z.iter().filter(|z| z.left() < 1e-3).count();
    }
    assert!(found > 500 && refused > 100, "{found} {refused}");
}

/// Two rows are equal up to rounding, hence it is not known which unknown is then free.
#[test]
fn of_enclosed_equations_no_unknown_is_left_free() {
    let pattern = Pattern::new(2, 1, (0..4).map(|k| (k / 2, k % 2)).collect());
    let rounded = Factors::<f64>::new(&pattern).factor(&[3.0; 4]);
    let enclosed = Factors::<Ball>::new(&pattern).factor(&[Ball::constant(3.0); 4]);
    assert_eq!(rounded, Ok(()));
    assert!(matches!(enclosed, Err(NotSolved::Undetermined(_))));
}

fn rationals(numbers: &[i64]) -> Vec<Rational> {
    numbers.iter().map(|&number| Rational::new(number, 1)).collect()
}

#[test]
fn a_combination_with_factors_that_are_not_negative_is_found_or_there_is_none() {
    let columns: Vec<Vec<Rational>> =
        [[1, 0, 2], [0, 1, 1], [-1, 2, 0], [3, -1, 5]].iter().map(|column| rationals(column)).collect();
    let target = rationals(&[3, 4, 10]);
    let found =
        nonnegative_combination(&columns, &target).expect("three times the first and four times the second are one");
    assert!(found.iter().all(|factor| factor.sign() != Some(-1)), "{found:?}");
    for row in 0..3 {
        let sum = columns.iter().zip(&found).fold(Rational::new(0, 1), |sum, (column, &by)| sum + column[row] * by);
        assert_eq!(sum, target[row]);
    }
    // the sum of the first two entries is never negative
    let columns = vec![rationals(&[1, 0]), rationals(&[2, -1]), rationals(&[-1, 3])];
    assert_eq!(nonnegative_combination(&columns, &rationals(&[-1, 0])), None);
    // tableaux for which other pivot rules may cycle (E. M. L. Beale)
    let columns =
        vec![rationals(&[1, 2, 0]), rationals(&[-60, -90, 0]), rationals(&[-1, -1, 25]), rationals(&[9, 3, 0])];
    assert!(nonnegative_combination(&columns, &rationals(&[0, 0, 25])).is_some());
}

#[test]
fn columns_of_other_lengths_have_no_combination() {
    assert_eq!(nonnegative_combination(&[rationals(&[1])], &rationals(&[1, 2])), None);
}
