//! Round trip: an expression printed as LaTeX is read back as an equal expression.

use crate::Plain;
use field::Analytic;
use num_traits::Zero;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed, TestRunner};
use symbolic::{Decision, Hypotheses, Sym, apart, decide};

const LETTERS: [(&str, &str); 5] =
    [("m", "m"), (r"\theta", "theta"), ("l_1", "l1"), ("x_{12}", "x12"), (r"\varphi", "varphi")];

/// The construction of a random expression, as data that proptest can shrink.
#[derive(Clone, Debug)]
enum Made {
    Letter(usize),
    Rate(usize, bool),
    Number(i64, i64),
    Sum(Box<Made>, Box<Made>),
    Difference(Box<Made>, Box<Made>),
    Product(Box<Made>, Box<Made>),
    Quotient(Box<Made>, Box<Made>),
    Power(Box<Made>, u32),
    Negation(Box<Made>),
    Cos(Box<Made>, bool),
    Root(Box<Made>),
}

fn made() -> impl Strategy<Value = Made> {
    let leaf = prop_oneof![
        4 => (0..LETTERS.len()).prop_map(Made::Letter),
        2 => (0..LETTERS.len(), any::<bool>()).prop_map(|(letter, twice)| Made::Rate(letter, twice)),
        2 => (-12..13_i64, 1..13_i64).prop_map(|(above, below)| Made::Number(above, below)),
    ];
    leaf.prop_recursive(5, 32, 2, |inner| {
        let pair = || (inner.clone(), inner.clone());
        prop_oneof![
            pair().prop_map(|(a, b)| Made::Sum(a.into(), b.into())),
            pair().prop_map(|(a, b)| Made::Difference(a.into(), b.into())),
            pair().prop_map(|(a, b)| Made::Product(a.into(), b.into())),
            pair().prop_map(|(a, b)| Made::Product(a.into(), b.into())),
            pair().prop_map(|(a, b)| Made::Quotient(a.into(), b.into())),
            (inner.clone(), 2..12_u32).prop_map(|(a, n)| Made::Power(a.into(), n)),
            inner.clone().prop_map(|a| Made::Negation(a.into())),
            (inner.clone(), any::<bool>()).prop_map(|(a, cos)| Made::Cos(a.into(), cos)),
            inner.prop_map(|a| Made::Root(a.into())),
        ]
    })
}

impl Made {
    fn sym(&self) -> Sym {
        match self {
            Made::Letter(place) => Sym::named(LETTERS[*place].1, LETTERS[*place].0),
            Made::Rate(place, twice) => {
                let (latex, name) = LETTERS[*place];
                match twice {
                    false => Sym::named(&format!("{name}'"), &format!(r"\dot{{{latex}}}")),
                    true => Sym::named(&format!("{name}''"), &format!(r"\ddot{{{latex}}}")),
                }
            }
            Made::Number(above, below) => Sym::constant(field::Rational::new(*above, *below)),
            Made::Sum(a, b) => a.sym() + b.sym(),
            Made::Difference(a, b) => a.sym() - b.sym(),
            Made::Product(a, b) => a.sym() * b.sym(),
            Made::Quotient(a, b) => a.sym() / b.sym(),
            Made::Power(a, n) => a.sym().powi(*n as i32),
            Made::Negation(a) => -a.sym(),
            Made::Cos(a, true) => a.sym().circle_as_written().cos,
            Made::Cos(a, false) => a.sym().circle_as_written().sin,
            Made::Root(a) => a.sym().sqrt(),
        }
    }
}

#[test]
fn an_expression_that_is_printed_is_read_back() {
    let config = Config { cases: 3000, rng_seed: RngSeed::Fixed(77), failure_persistence: None, ..Config::default() };
    let outcome = TestRunner::new(config).run(&made(), |made| {
        apart(|| {
            let expression = made.sym();
            if expression.is_zero() || expression.latex().contains("undefined") {
                return Ok(());
            }
            let printed = expression.latex();
            let read = Plain::of(&LETTERS).side(&printed);
            let read = read.map_err(|fault| TestCaseError::fail(format!("{printed}: {fault}")))?;
            prop_assert!(is_same(read, expression), "{} is read as {}", printed, read);
            Ok(())
        })
    });
    outcome.unwrap_or_else(|error| panic!("{error}"));
}

/// Returns whether two expressions are printed alike, are equal for all values, or are undefined everywhere.
fn is_same(read: Sym, expression: Sym) -> bool {
    read.latex() == expression.latex()
        || match decide(read - expression, &Hypotheses::none()) {
            Decision::Zero(_) | Decision::Undefined(_) => true,
            Decision::NonZero(_) => false,
            Decision::GaveUp(_) => values(read)
                .iter()
                .zip(values(expression))
                .all(|(a, b)| a.is_nan() && b.is_nan() || (a - b).abs() <= 1e-9 * (1.0 + b.abs())),
        }
}

/// Returns the values at three points.
fn values(expression: Sym) -> Vec<f64> {
    let at = |shift: f64| {
        let value = |name: &str| Some(shift + name.bytes().map(f64::from).sum::<f64>() / 500.0);
        expression.evaluate_analytic(&value).unwrap_or(f64::NAN)
    };
    [0.3, 0.7, 1.9].map(at).to_vec()
}

#[test]
fn what_is_read_back_is_equal() {
    apart(|| {
        let plain = Plain::of(&LETTERS);
        let [m, theta, l] = ["m", "theta", "l1"].map(Sym::symbol);
        let point = theta.circle();
        let expression = m * l * point.cos / (point.sin * point.sin + m) - (l - m) * point.sin * (m + l).sqrt();
        let read = plain.side(&expression.latex()).expect("it is read");
        assert!(decide(read - expression, &Hypotheses::none()).is_zero());
    });
}
