//! Tests of piecewise and elementary functions of the language.

use crate::{Model, Source, Trace};
use symbolic::apart;

/// Evaluates an expression in x and y, with switches set by their conditions.
fn value(expression: &str, x: f64, y: f64) -> f64 {
    let one = |name: &str, value: &str| vec![(name, value).into()];
    let source = Source {
        coordinates: ["x", "y"].map(|name| (name, "m").into()).to_vec(),
        points: one("P", "O + x*N.x + y*N.y"),
        bodies: vec![crate::BodySource::particle("point", "P", "(1 kg)")],
        outputs: one("z", expression),
        ..Source::default()
    };
    let model = Model::of(&source).unwrap_or_else(|faults| panic!("{expression}: {faults:?}"));
    apart(|| {
        let trace = Trace::of(&model);
        let letters = |name: &str| match name {
            "x" => Some(x),
            "y" => Some(y),
            _ => None,
        };
        let known: Vec<(String, f64)> = (trace.switches.iter().zip(&model.switches))
            .map(|(letter, condition)| {
                let condition = trace.scalar(*condition).evaluate_analytic(&letters).expect("it has a value");
                (letter.to_string(), if condition > 0.0 { 1.0 } else { 0.0 })
            })
            .collect();
        let all = |name: &str| {
            letters(name).or_else(|| known.iter().find(|(known, _)| known == name).map(|(_, value)| *value))
        };
        trace.scalar(model.outputs[0].is).evaluate_analytic(&all).expect("every letter has a value")
    })
}

#[test]
fn the_least_the_greatest_the_sign_and_the_size_are_those_of_numbers() {
    for (x, y) in [(1.5_f64, -0.5_f64), (-2.0, 3.0), (-1.0, -4.0), (0.25, 0.75)] {
        let expected = [
            ("min(x, y)", f64::min(x, y)),
            ("max(x, y)", f64::max(x, y)),
            ("abs(x)", x.abs()),
            ("sign(y)", y.signum()),
            ("if(x < y, 2*x, y)", if x < y { 2.0 * x } else { y }),
            ("if(x > y, 2*x, y)", if x > y { 2.0 * x } else { y }),
        ];
        for (expression, expected) in expected {
            assert_eq!(value(expression, x, y), expected, "{expression} at x = {x}, y = {y}");
        }
    }
}

#[test]
fn a_table_goes_through_its_points_on_straight_lines_and_is_constant_outside() {
    let table = "table(x, (-1 m), 2, (1 m), 6, (2 m), 5)";
    let points = [(-3.0, 2.0), (-1.0, 2.0), (0.0, 4.0), (0.5, 5.0), (1.0, 6.0), (1.25, 5.75), (2.0, 5.0), (9.0, 5.0)];
    for (x, expected) in points {
        assert_eq!(value(table, x, 0.0), expected, "at x = {x}");
    }
}

/// Elementary functions equal those of the standard library.
#[test]
fn elementary_functions_are_those_of_numbers() {
    for (x, y) in [(0.3_f64, -0.8_f64), (-0.6, 0.2)] {
        let functions: [(&str, f64); 10] = [
            ("sinh(x/(1 m))", x.sinh()),
            ("cosh(x/(1 m))", x.cosh()),
            ("tanh(x/(1 m))", x.tanh()),
            ("exp(x/(1 m))", x.exp()),
            ("ln(((2 m) + x)/(1 m))", (2.0 + x).ln()),
            ("asin(x/(1 m))", x.asin()),
            ("acos(x/(1 m))", x.acos()),
            ("atan(x/(1 m))", x.atan()),
            ("atan2(x, y)", x.atan2(y)),
            ("tan(x/(1 m))", x.tan()),
        ];
        for (expression, expected) in functions {
            let found = value(expression, x, y);
            assert!((found - expected).abs() < 1e-14, "{expression} at x = {x}, y = {y}: {found} for {expected}");
        }
    }
}
