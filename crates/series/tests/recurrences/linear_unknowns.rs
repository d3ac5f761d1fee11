//! Series of laws whose rates contain the unknowns of linear equations, compared with the same laws without such
//! unknowns.

use dalembert_series::{Equations, Fused, Recurrence};
use field::{Analytic, Batch, DoubleDouble, Scalar, Tangent};
use symbolic::linear::Solve;
use symbolic::{Sym, Untapeable, symbols};

/// Two links with their accelerations as unknowns, or by Cramer's rule; a third state is driven by both.
fn links(is_written: bool) -> Recurrence {
    let state = symbols(["a", "b", "u", "w", "s"]);
    let ([a, b, u, w, _], [t, m]) = (state, symbols(["t", "m"]));
    let between = (a - b).circle();
    let [first, second, third] = [Sym::int(2) + m, between.cos, Sym::int(1)];
    let right =
        [t - w * w * between.sin - a.circle().sin * m, u * u * between.sin / (Sym::int(3) + u * u) - b.circle().sin];
    let determinant = first * third - second * second;
    let written =
        [(right[0] * third - right[1] * second) / determinant, (right[1] * first - right[0] * second) / determinant];
    let solve = Solve::new(
        symbols(["z0", "z1"]).to_vec(),
        2,
        |row, column| [[first, second], [second, third]][row][column],
        right.to_vec(),
    );
    let [p, q] = if is_written { written } else { symbols(["z0", "z1"]) };
    let rates = [u, w, p, q + m, p * u - q];
    let solve = (!is_written).then_some(&solve);
    Recurrence::record(&Equations { state: &state, time: Some(t), parameters: &[m], rates: &rates, solve }).unwrap()
}

const START: [f64; 5] = [0.9, -0.4, 1.3, 0.2, 0.0];

fn same_series<S: Fused, const W: usize>(within: f64, size: impl Fn(S) -> f64) {
    let (order, start) = (17, START.map(S::from));
    let series = [false, true].map(|is_written| {
        let mut expansion = links(is_written).expansion::<S, W, 1024>(&[S::ratio(5, 4)], order).unwrap();
        // a first expansion must not affect the next one
        expansion.expand(&START.map(|x| S::from(x + 1.0)), S::zero());
        expansion.expand(&start, S::ratio(1, 8));
        expansion
    });
    for k in 0..=order {
        let [solved, written] = series.each_ref().map(|expansion| expansion.coefficients(k));
        for (&solved, &written) in solved.iter().zip(written) {
            let off = size(solved - written);
            assert!(off <= within * size(written).max(1.0), "order {k}: {solved:?} is not {written:?}");
        }
    }
}

#[test]
fn unknowns_have_the_series_of_their_elimination_in_every_field_and_width() {
    same_series::<f64, 8>(1e-11, f64::abs);
    same_series::<f64, 1>(1e-11, f64::abs);
    same_series::<DoubleDouble, 8>(1e-27, |x| x.hi().abs());
    same_series::<Tangent<Batch<2>>, 1>(1e-11, |x| x.value.0[0].abs());
}

#[test]
fn slopes_of_unknowns_are_those_of_their_elimination() {
    let order = 9;
    let [solved, written] = [false, true].map(|is_written| {
        let mut expansion =
            links(is_written).expansion::<Tangent<Batch<2>>, 1, 256>(&[Tangent::from(1.25)], order).unwrap();
        let mut start = START.map(Tangent::<Batch<2>>::from);
        start[0].slope.0[0] = 1.0;
        start[3].slope.0[1] = 1.0;
        expansion.expand(&start, Tangent::from(0.125));
        expansion.coefficients(order).iter().flat_map(|number| number.slope.0).collect::<Vec<f64>>()
    });
    assert!(written.iter().any(|slope| slope.abs() > 1e-3));
    for (solved, written) in solved.iter().zip(&written) {
        assert!((solved - written).abs() <= 1e-10 * written.abs().max(1.0), "{solved} is not {written}");
    }
}

#[test]
fn from_any_order_on_the_digits_of_f64_do() {
    let order = 14;
    let start = START.map(DoubleDouble::from);
    let mut fine = links(false).expansion::<DoubleDouble, 8, 1024>(&[DoubleDouble::from(1.25)], order).unwrap();
    let mut rounded = fine.clone();
    fine.expand(&start, DoubleDouble::from(0.125));
    for from in [1, 4, 9, 13] {
        assert_eq!(rounded.expand_rounding(&start, DoubleDouble::from(0.125), from), from);
        for k in 0..=order {
            for (a, b) in fine.coefficients(k).iter().zip(rounded.coefficients(k)) {
                let within = if k <= from { 0.0 } else { 1e-12 * a.hi().abs().max(1.0) };
                assert!((*a - *b).hi().abs() <= within, "order {k}, in full up to {from}");
            }
        }
    }
}

#[test]
fn every_lane_solves_for_its_own_unknowns() {
    let (order, recurrence) = (14, links(false));
    let mut side_by_side = recurrence.batch_expansion::<2, 256>(order).unwrap();
    let masses = [1.25, 0.5];
    masses.iter().enumerate().for_each(|(lane, mass)| side_by_side.set(lane, &[*mass]));
    let other = [-0.3, 0.8, 0.1, -0.9, 0.0];
    let starts: Vec<Batch<2>> = (0..5).map(|i| Batch([START[i], other[i]])).collect();
    side_by_side.expand(&starts, Batch([0.125, 0.5]));
    for (lane, (start, time)) in [(START, 0.125), (other, 0.5)].into_iter().enumerate() {
        let mut alone = recurrence.expansion::<f64, 8, 256>(&[masses[lane]], order).unwrap();
        alone.expand(&start, time);
        for (own, alone) in side_by_side.coefficients(order).iter().zip(alone.coefficients(order)) {
            assert!((own.0[lane] - alone).abs() <= 1e-11 * alone.abs().max(1.0), "{own:?} is not {alone}");
        }
    }
}

#[test]
fn unknowns_that_nothing_determines_are_no_numbers() {
    let [x, y, z] = symbols(["x", "y", "z"]);
    let solve = Solve::new(vec![z], 1, |_, _| x - y, vec![Sym::ONE]);
    let equations =
        Equations { state: &[x, y], time: None, parameters: &[], rates: &[z, Sym::ONE], solve: Some(&solve) };
    let mut series = Recurrence::record(&equations).unwrap().expansion::<f64, 8, 256>(&[], 4).unwrap();
    series.expand(&[1.0, 1.0], 0.0);
    assert!(series.coefficients(1)[0].is_nan());
    series.expand(&[2.0, 1.0], 0.0);
    assert_eq!(series.coefficients(1), [1.0, 1.0]);
}

#[test]
fn functions_of_unknowns_have_no_series() {
    let [x, z] = symbols(["x", "z"]);
    let solve = Solve::new(vec![z], 1, |_, _| Sym::int(2), vec![x]);
    let rates = [z.circle().sin];
    let equations = Equations { state: &[x], time: None, parameters: &[], rates: &rates, solve: Some(&solve) };
    assert!(matches!(Recurrence::record(&equations), Err(Untapeable::Function(_))));
}
