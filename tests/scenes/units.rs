//! Units and quantities: a table of accepted texts with their SI values, and of rejected ones.

use std::f64::consts::{PI, TAU};
use units::quantity::{NoQuantity, parse};
use units::{Dimension, NoUnit, Unit};

#[test]
fn units_mean_what_the_si_says() {
    let table: &[(&str, f64, &str)] = &[
        ("2 kg m^2", 2.0, "kg m^2"),
        ("2 N m s", 2.0, "kg m^2 s^-1"),
        ("2 N*m*s", 2.0, "J s"),
        ("2 N\u{b7}m", 2.0, "J"),
        ("60 rad/s", 60.0, "1/s"),
        ("50 mm", 0.05, "m"),
        ("3 cm", 0.03, "m"),
        ("60 rpm", TAU, "rad/s"),
        ("1 rev/s", TAU, "rad/s"),
        ("180 deg", PI, "rad"),
        ("90 deg/s", PI / 2.0, "rad/s"),
        ("47 ohm", 47.0, "V/A"),
        ("47 \u{3a9}", 47.0, "ohm"),
        ("1.5 mH", 0.0015, "V s/A"),
        ("80 mWb", 0.08, "V s"),
        ("50 mF", 0.05, "A s/V"),
        ("3 mC", 0.003, "A s"),
        ("2 kPa", 2000.0, "N/m^2"),
        ("7 ms", 0.007, "s"),
        ("2 min", 120.0, "s"),
        ("3 kN m", 3000.0, "N m"),
        ("9.81 m/s^2", 9.81, "m s^-2"),
        ("12 g cm^2", 12e-7, "kg m^2"),
        ("5 kg/m/s", 5.0, "kg m^-1 s^-1"),
        ("1_000 A", 1000.0, "A"),
        ("0.25", 0.25, "1"),
        ("2 W/V", 2.0, "A"),
        ("2 T m^2", 2.0, "Wb"),
    ];
    for (text, value, unit) in table {
        let found = parse(text, 1, 1, Dimension::of(unit)).unwrap_or_else(|error| panic!("{text}: {error}"));
        // pi is rounded; a power of ten must be exact
        let allowed = if text.contains(['r', 'd']) { f64::EPSILON * value } else { 0.0 };
        assert!((found[0] - value).abs() <= allowed, "{text}: {found:?}");
    }
}

#[test]
fn every_unit_of_a_machine_is_a_unit() {
    use dalembert_derivations::machines::{kloss, multi_current, synchronous};
    let quantities = [
        kloss::Kloss::<f64>::QUANTITIES,
        multi_current::Windings::<f64>::QUANTITIES,
        synchronous::Synchronous::<f64>::QUANTITIES,
    ];
    for quantity in quantities.concat() {
        Unit::parse(&quantity.unit).unwrap_or_else(|error| panic!("{}: {error}", quantity.name));
    }
}

#[test]
fn what_is_no_unit_is_told_apart() {
    let unknown = |nearest| move |error: &NoUnit| matches!(error, NoUnit::Unknown { nearest: n, .. } if *n == nearest);
    assert!(Unit::parse("meter").is_err_and(|e| matches!(e, NoUnit::Unknown { .. })));
    assert!(Unit::parse("ohn").is_err_and(|e| unknown(Some("ohm"))(&e)));
    assert_eq!(Unit::parse("kHz"), Err(NoUnit::Hertz));
    assert!(Unit::parse("m^99").is_err_and(|e| matches!(e, NoUnit::Malformed { .. })));
    assert!(Unit::parse("m//s").is_err_and(|e| matches!(e, NoUnit::Malformed { .. })));
    assert!(Unit::parse("kg/m s").is_err_and(|e| matches!(e, NoUnit::AmbiguousSlash { .. })));
}

#[test]
fn vectors_and_matrices_have_their_shape() {
    let length = Dimension::of("m");
    assert_eq!(parse("1 2 3 mm", 1, 3, length), Ok(vec![0.001, 0.002, 0.003]));
    assert_eq!(parse("1 2; 3 4 m", 2, 2, length), Ok(vec![1.0, 2.0, 3.0, 4.0]));
    assert!(matches!(parse("1 2; 3 m", 2, 2, length), Err(NoQuantity::Shape { .. })));
    assert!(matches!(parse("1 2 3 4 m", 1, 3, length), Err(NoQuantity::Shape { .. })));
    assert!(matches!(parse("m", 1, 1, length), Err(NoQuantity::NoNumber)));
    assert!(matches!(parse("1 x 2 m", 1, 2, length), Err(NoQuantity::Unit(_))));
}
