//! Steady rotations of random gyrostats: the polynomial of the gyrostat and the box search for text models agree.

use crate::physical::gyrostat;
use crate::physical::steady::compared;
use field::Rational;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, RngSeed, TestRunner};

const GYROSTATS: usize = 20;

#[test]
fn the_search_over_boxes_finds_the_rotations_of_the_polynomial() {
    let mut runner = TestRunner::new(Config { rng_seed: RngSeed::Fixed(1834), ..Config::default() });
    let drawn = (gyrostat(), -400..=400i64, -900..=900i64);
    let mut motions = 0;
    for k in 0..GYROSTATS {
        let (bodies, w, speed) = drawn.new_tree(&mut runner).expect("data are drawn").current();
        let Some(both) = compared(&bodies, Rational::new(w, 10), Rational::new(speed, 10)) else { continue };
        assert!(both.is_complete, "gyrostat {k}");
        let distance = both.distance();
        assert!(
            distance.is_some_and(|distance| distance < 1e-9),
            "gyrostat {k}: {distance:?}, {:?}, {:?}",
            both.by_polynomial,
            both.by_boxes
        );
        motions += both.by_boxes.len();
    }
    assert!(motions >= 2 * GYROSTATS, "{motions}");
}
