//! Taylor series of solutions, from recurrences of sums and products, for every law and every group width.

use dalembert_series::{Equations, Fused, Recurrence};
use field::{Analytic, Batch, DoubleDouble, Scalar};
use symbolic::{Sym, Untapeable, symbols};

fn record(state: &[Sym], time: Option<Sym>, parameters: &[Sym], rates: &[Sym]) -> Result<Recurrence, Untapeable> {
    Recurrence::record(&Equations { state, time, parameters, rates, solve: None })
}

/// The coefficients of the solution of y' = rate through (t, y).
fn solution<S: Fused>(rate: impl Fn(Sym, Sym) -> Sym, y: S, t: S, order: usize) -> Vec<S> {
    let [state, time] = symbols(["y", "t"]);
    let recurrence = record(&[state], Some(time), &[], &[rate(state, time)]).unwrap();
    let mut expansion = recurrence.expansion::<S, 8, 256>(&[], order).unwrap();
    expansion.expand(&[y], t);
    (0..=order).map(|k| expansion.coefficients(k)[0]).collect()
}

#[test]
fn series_of_known_solutions_have_their_known_coefficients() {
    let near = |found: &[f64], known: &[f64]| {
        assert!(found.iter().zip(known).all(|(a, b)| (a - b).abs() < 1e-14), "{found:?} is not {known:?}");
    };
    near(&solution(|y, _| y, 1.0, 0.0, 4), &[1.0, 1.0, 0.5, 1.0 / 6.0, 1.0 / 24.0]);
    near(&solution(|y, _| y * y, 1.0, 0.0, 4), &[1.0; 5]);
    near(&solution(|y, _| Sym::int(1) + y * y, 0.0, 0.0, 5), &[0.0, 1.0, 0.0, 1.0 / 3.0, 0.0, 2.0 / 15.0]);
    near(&solution(|_, t| t.circle().cos, 0.0, 0.0, 5), &[0.0, 1.0, 0.0, -1.0 / 6.0, 0.0, 1.0 / 120.0]);
    near(&solution(|y, _| Sym::ratio(1, 2) / y, 1.0, 0.0, 4), &[1.0, 0.5, -0.125, 0.0625, -5.0 / 128.0]);
    near(&solution(|_, t| (Sym::int(1) + t).sqrt(), 0.0, 0.0, 4), &[0.0, 1.0, 0.25, -1.0 / 24.0, 1.0 / 64.0]);
}

#[test]
fn a_series_in_double_double_sums_to_the_solution() {
    let order = 30;
    let coefficients = solution(|y, t| -(y * t.circle().sin), DoubleDouble::from(1.0), DoubleDouble::from(0.0), order);
    let h = DoubleDouble::ratio(1, 8);
    let sum = coefficients.iter().rev().fold(DoubleDouble::from(0.0), |sum, &c| sum * h + c);
    // y = exp(cos t - 1).
    let exact = num_traits::Float::exp(h.circle().cos - DoubleDouble::from(1.0));
    assert!(f64::from(sum - exact).abs() < 1e-29);
}

#[test]
fn more_rates_than_states_are_refused() {
    let x = Sym::symbol("x");
    let refused = record(&[x], None, &[], &[x, x]).unwrap_err();
    assert_eq!(refused, Untapeable::Shape { rates: 2, states: 1 });
}

/// A motor with many bars: the currents multiplied by the field at their own angles.
fn bars(count: usize) -> (Vec<Sym>, Vec<Sym>, Vec<Sym>) {
    let parameters = symbols(["a", "r", "l"]);
    let (state, rates) = bars_of(count, parameters);
    (state, parameters.to_vec(), rates)
}

fn bars_of(count: usize, [a, r, l]: [Sym; 3]) -> (Vec<Sym>, Vec<Sym>) {
    let mut state = symbols(["g", "u"]).to_vec();
    state.extend((0..count).map(|n| Sym::symbol(&format!("i{n}"))));
    let point = state[0].circle();
    let field = |n: i64| (point.cos * Sym::ratio(n + 1, 7) - point.sin * Sym::ratio(3, n + 2)) * a;
    let mut rates = vec![state[1], Sym::ZERO];
    for n in 0..count {
        let (current, field) = (state[2 + n], field(n as i64));
        rates[1] += current * field;
        rates.push(-(r * current + field * state[1]) / l);
    }
    (state, rates)
}

#[test]
fn any_number_of_currents_costs_two_products_with_their_sum_and_two_with_the_slip() {
    for count in [3, 6, 40] {
        let (state, parameters, rates) = bars(count);
        let (products, terms) = record(&state, None, &parameters, &rates).unwrap().size();
        assert_eq!(products, 4);
        assert!(terms <= 8 + 6 * count, "{terms} terms for {count} currents");
    }
}

#[test]
fn groups_of_any_width_and_both_fields_have_the_same_series_for_any_parameters() {
    let (state, parameters, rates) = bars(6);
    let recurrence = record(&state, None, &parameters, &rates).unwrap();
    let mut wide = recurrence.expansion::<f64, 8, 256>(&[1.0, 1.0, 1.0], 12).unwrap();
    let mut narrow = recurrence.expansion::<f64, 1, 64>(&[0.5, 2.0, 0.25], 12).unwrap();
    let exact = |values: &[f64]| -> Vec<DoubleDouble> { values.iter().map(|&x| DoubleDouble::from(x)).collect() };
    let mut precise = recurrence.expansion::<DoubleDouble, 4, 1024>(&exact(&[0.5, 2.0, 0.25]), 12).unwrap();
    wide.set_parameters(&[0.5, 2.0, 0.25]);
    // a first expansion must not affect the next one
    wide.expand(&[f64::NAN; 8], 0.0);
    let start = [0.3, -1.0, 0.1, 0.2, -0.3, 0.4, 0.5, -0.6];
    wide.expand(&start, 0.0);
    narrow.expand(&start, 0.0);
    precise.expand(&exact(&start), DoubleDouble::from(0.0));
    for k in 0..=12 {
        for i in 0..8 {
            let value = precise.coefficients(k)[i].hi();
            let near = |other: f64| (other - value).abs() <= 1e-13 * value.abs().max(1.0);
            assert!(near(wide.coefficients(k)[i]) && near(narrow.coefficients(k)[i]), "{k} {i}");
        }
    }
}

#[test]
fn more_quantities_than_columns_are_no_expansion() {
    let (state, parameters, rates) = bars(6);
    let recurrence = record(&state, None, &parameters, &rates).unwrap();
    assert!(recurrence.expansion::<f64, 8, 16>(&[1.0; 3], 5).is_none());
}

/// The term (1 - 1) y is dropped; symmetric bodies have such terms.
#[test]
fn what_cancels_is_no_coefficient() {
    let [x, y] = symbols(["x", "y"]);
    let (two, three) = (Sym::int(2), Sym::int(3));
    let vanishes = x * three * y - y * three * x;
    let rates = [vanishes * two + y, vanishes * vanishes - x];
    let recurrence = record(&[x, y], None, &[], &rates).unwrap();
    let mut series = recurrence.expansion::<f64, 8, 256>(&[], 4).unwrap();
    series.expand(&[1.0, 0.0], 0.0);
    // the cosine
    assert_eq!([0, 1, 2, 3].map(|k| series.coefficients(k)[0]), [1.0, 0.0, -0.5, 0.0]);
}

/// The law y_i' = c_i + l_i y_(i+1) + sum of w y_a y_b, with a given number of different products; one of them has a
/// sum as a factor.
fn second_degree(states: usize, products: usize) -> (Vec<Sym>, Vec<Sym>) {
    let state: Vec<Sym> = (0..states).map(|i| Sym::symbol(&format!("z{i}"))).collect();
    let number = |i: usize, j: usize| Sym::ratio((7 * i + 5 * j) as i64 % 11 - 5, 13);
    let mut rates: Vec<Sym> = (0..states).map(|i| number(i, 2) + number(i, 3) * state[(i + 1) % states]).collect();
    let pairs = (0..states).flat_map(|a| (a..states).map(move |b| (a, b)));
    for (place, (a, b)) in pairs.take(products - 1).enumerate() {
        for row in [place % states, (place + 1) % states] {
            rates[row] += number(place, row + 1) * (state[a] * state[b]);
        }
    }
    let [first, second, third] = [state[0], state[1], state[2]];
    let sum = first + second * Sym::ratio(3, 2) - third + Sym::ratio(1, 4);
    rates[0] += sum * (first - second * Sym::ratio(1, 2) + third * Sym::int(2));
    (state, rates)
}

/// The same law with one more term in each of four rates: a reciprocal of a square, a product with it, a quotient, and
/// the root of a product.
fn with_quotients(states: usize, products: usize) -> (Vec<Sym>, Vec<Sym>) {
    let (state, mut rates) = second_degree(states, products);
    let [first, second, third] = [state[0], state[1], state[2]];
    let divisor = Sym::ratio(5, 4) + first * first;
    rates[1] += Sym::ratio(3, 4) * second / divisor;
    rates[2] -= Sym::ratio(1, 3) / (Sym::int(2) + second - third);
    rates[0] += (Sym::int(2) + second * third).sqrt() * third;
    (state, rates)
}

#[test]
fn small_systems_have_the_series_of_their_stages_in_every_size() {
    for (states, products) in [(3, 5), (5, 13), (6, 20), (9, 6), (10, 14), (12, 21), (18, 10), (20, 22)] {
        same_series(second_degree(states, products));
    }
    for (states, products) in [(3, 2), (3, 5), (6, 8), (9, 10), (12, 14), (16, 6)] {
        same_series(with_quotients(states, products));
    }
}

#[test]
fn currents_that_decay_alike_have_the_series_of_their_stages() {
    for count in [3, 6, 12] {
        same_series(bars_of(count, [Sym::ratio(1, 2), Sym::int(2), Sym::ratio(3, 4)]));
    }
}

fn same_series(law: (Vec<Sym>, Vec<Sym>)) {
    same_series_over(&law, 1e-12, |x: f64| x);
    same_series_over(&law, 1e-28, DoubleDouble::hi);
}

fn same_series_over<S: Fused>((state, rates): &(Vec<Sym>, Vec<Sym>), within: f64, size: impl Fn(S) -> f64) {
    let states = state.len();
    let recurrence = record(state, None, &[], rates).unwrap();
    for order in [2, 3, 7, 30] {
        let mut small = recurrence.expansion::<S, 8, 256>(&[], order).unwrap();
        let mut stages = recurrence.expansion::<S, 4, 256>(&[], order).unwrap();
        for start in [f64::NAN, 0.3, -0.4] {
            let begin: Vec<S> = (0..states).map(|i| S::lift(start) / S::int(1 + i as i64)).collect();
            small.expand(&begin, S::zero());
            stages.expand(&begin, S::zero());
            for k in (0..=order).filter(|_| !start.is_nan()) {
                for (&a, &b) in small.coefficients(k).iter().zip(stages.coefficients(k)) {
                    let off = size(a - b).abs();
                    assert!(off <= within * size(b).abs().max(1e-3), "{states}: order {k}: {off:e} off {b:?}");
                }
            }
        }
    }
}

/// The test in double-double; the group width `W` determines the way of computation.
fn rounded_from_an_order_on<const W: usize>((state, rates): (Vec<Sym>, Vec<Sym>)) {
    let exact = DoubleDouble::from;
    let (order, h) = (30, exact(0.125));
    let begin: Vec<DoubleDouble> = (0..state.len()).map(|i| exact(0.3) / exact(1.0 + i as f64)).collect();
    let recurrence = record(&state, None, &[], &rates).unwrap();
    let [mut full, mut rounding] = [(); 2].map(|()| recurrence.expansion::<DoubleDouble, W, 256>(&[], order).unwrap());
    full.expand(&begin, exact(0.0));
    let [mut whole, mut sum] = [(); 2].map(|()| begin.clone());
    full.sum(h, &mut whole);
    // in descending order, since otherwise values of an earlier expansion could hide an error
    for fine in [order, order - 1, 16, 5, 2, 1, 0] {
        assert_eq!(rounding.expand_rounding(&begin, exact(0.0), fine), fine.max(1));
        rounding.sum(h, &mut sum);
        for k in 0..=order {
            for (&a, &b) in rounding.coefficients(k).iter().zip(full.coefficients(k)) {
                let within = if k <= fine.max(1) { 0.0 } else { 1e-12 * b.hi().abs().max(1e-3) };
                assert!((a - b).hi().abs() <= within, "{} states, {fine}: order {k}: {a:?} {b:?}", state.len());
            }
        }
        // the first rounded term is the largest one
        for (i, (&a, &b)) in sum.iter().zip(&whole).enumerate() {
            let terms =
                (fine.max(1) + 1..=order).map(|k| full.coefficients(k)[i].hi().abs().max(1e-3) * h.hi().powi(k as i32));
            assert!(
                (a - b).hi().abs() <= 1e-30 + 1e-12 * terms.sum::<f64>(),
                "{} states, {fine}: {a:?} {b:?}",
                state.len()
            );
        }
    }
}

#[test]
fn a_series_in_double_double_may_go_on_in_f64_from_any_order() {
    for (states, products) in [(3, 5), (5, 13), (9, 6), (12, 21), (20, 22)] {
        rounded_from_an_order_on::<8>(second_degree(states, products));
        rounded_from_an_order_on::<4>(second_degree(states, products));
    }
    for (states, products) in [(3, 2), (9, 10), (16, 6)] {
        rounded_from_an_order_on::<8>(with_quotients(states, products));
        rounded_from_an_order_on::<4>(with_quotients(states, products));
    }
}

#[test]
fn a_sum_is_that_of_horner_for_any_number_of_terms() {
    let (state, rates) = second_degree(9, 6);
    let recurrence = record(&state, None, &[], &rates).unwrap();
    for order in 4..=12 {
        let mut series = recurrence.expansion::<f64, 8, 256>(&[], order).unwrap();
        series.expand(&[0.3; 9], 0.0);
        let mut sum = [0.0; 9];
        series.sum(0.25, &mut sum);
        for (i, sum) in sum.into_iter().enumerate() {
            let horner = (0..=order).rev().fold(0.0, |sum, k| sum * 0.25 + series.coefficients(k)[i]);
            assert!((sum - horner).abs() <= 1e-15 * horner.abs().max(1.0), "order {order}: {sum} {horner}");
        }
    }
}

#[test]
fn time_moves_in_a_small_system_too() {
    // y' = t y: exp(t^2/2)
    let found = solution(|y, t| y * t, 1.0, 0.0, 6);
    assert_eq!(found, [1.0, 0.0, 0.5, 0.0, 0.125, 0.0, 1.0 / 48.0]);
}

/// Every kind of step, including squares and products with common factors.
fn mixed() -> Recurrence {
    let ([x, y, z], [a, b], time) = (symbols(["x", "y", "z"]), symbols(["a", "b"]), Sym::symbol("t"));
    let root = (Sym::int(3) + x * x * a).sqrt();
    let point = (y + time * b).circle();
    let rates = [
        x * y - y * z * a + point.cos * x - b,
        x * z + y * y - z * z * b + root * point.sin,
        (x - y * a + z) / root + x * x * y - point.cos * z,
    ];
    record(&[x, y, z], Some(time), &[a, b], &rates).unwrap()
}

#[test]
fn every_lane_has_the_last_terms_and_the_sum_of_its_own_series_at_any_order() {
    let recurrence = mixed();
    let lanes = |from: f64, by: f64| Batch::<3>([from, from + by, from - 2.0 * by]);
    let (states, times, h) =
        ([lanes(0.4, 0.1), lanes(-0.3, 0.2), lanes(0.2, -0.1)], lanes(0.5, 0.3), lanes(0.02, 0.005));
    let parameters = |lane: usize| [0.7 - 0.2 * lane as f64, 0.3 + 0.4 * lane as f64];
    for order in 2..=17 {
        let mut batch_expansion = recurrence.batch_expansion::<3, 64>(order).unwrap();
        (0..3).for_each(|lane| batch_expansion.set(lane, &parameters(lane)));
        // a first expansion must not affect the next one
        batch_expansion.expand(&[Batch::all(f64::NAN); 3], times);
        batch_expansion.expand(&states, times);
        let mut sums = [Batch::all(0.0); 3];
        batch_expansion.sum(h, &mut sums);
        for lane in 0..3 {
            let mut single = recurrence.expansion::<f64, 4, 256>(&parameters(lane), order).unwrap();
            single.expand(&states.map(|y| y.0[lane]), times.0[lane]);
            let mut sum = [0.0; 3];
            single.sum(h.0[lane], &mut sum);
            let near = |found: &[Batch<3>], known: &[f64]| {
                let size = known.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
                found.len() == 3 && found.iter().zip(known).all(|(a, b)| (a.0[lane] - b).abs() <= 1e-12 * size)
            };
            assert!(near(&sums, &sum), "order {order}: {sums:?} for {sum:?}");
            for k in [order - 1, order] {
                let (found, known) = (batch_expansion.coefficients(k), &single.coefficients(k)[..3]);
                assert!(near(found, known), "{k} of {order}: {found:?} for {known:?}");
            }
        }
    }
}

/// The law x_i' = c_i + sum_j c_ij x_j for the first states, hence that many long sums of the same quantities; the
/// other states rotate.
fn alike(sums: usize) -> (Vec<Sym>, Vec<Sym>) {
    let state: Vec<Sym> = (0..9).map(|i| Sym::symbol(&format!("x{i}"))).collect();
    let all = |i: usize| {
        let term = |j: usize| state[j] * Sym::ratio(1 + ((3 * i + 5 * j) % 7) as i64, 8 + j as i64);
        (0..8).fold(Sym::ratio(1 + i as i64, 5), |sum, j| sum + term(j))
    };
    let rate = |i: usize| if i < sums { all(i) } else { state[(i + 1) % 9] * Sym::ratio(1, 2) };
    (state.clone(), (0..9).map(rate).collect())
}

#[test]
fn long_sums_abreast_are_each_their_own_whether_one_stands_alone_or_five_are_alike() {
    let start: Vec<f64> = (0..9).map(|i| 0.3 + 0.1 * f64::from(i)).collect();
    for sums in 1..=5 {
        let (state, rates) = alike(sums);
        let equations = Equations { state: &state, time: None, parameters: &[], rates: &rates, solve: None };
        let recurrence = Recurrence::record(&equations).unwrap();
        let mut batch_expansion = recurrence.batch_expansion::<2, 64>(6).unwrap();
        (0..2).for_each(|lane| batch_expansion.set(lane, &[]));
        let mut single = recurrence.expansion::<f64, 4, 256>(&[], 6).unwrap();
        single.expand(&start, 0.0);
        let lanes: Vec<Batch<2>> = start.iter().map(|y| Batch([*y, 0.0])).collect();
        batch_expansion.expand(&lanes, Batch::all(0.0));
        for k in [5, 6] {
            for (number, (found, known)) in
                batch_expansion.coefficients(k).iter().zip(single.coefficients(k)).enumerate()
            {
                assert!((found.0[0] - known).abs() <= 1e-14, "{sums} sums, x{number}: {} for {known}", found.0[0]);
            }
        }
    }
}

#[test]
fn the_squares_of_a_circle_point_come_to_one_where_they_count_alike() {
    let [angle, speed, length] = symbols(["angle", "speed", "length"]);
    let point = angle.circle();
    let squares = |other: Sym| point.cos * point.cos * length + point.sin * point.sin * other;
    let products = |other: Sym| {
        let rates = [speed, -point.sin / (Sym::ONE + squares(other))];
        record(&[angle, speed], None, &[length], &rates).unwrap().size().0
    };
    // the length of the circle point itself needs two products; another one two squares and a quotient more
    assert_eq!([products(length), products(Sym::int(3))], [2, 5]);
}

#[test]
fn a_quotient_is_one_product_and_two_with_one_divisor_are_three() {
    let [x, y] = symbols(["x", "y"]);
    let products = |rates: [Sym; 2]| record(&[x, y], None, &[], &rates).unwrap().size().0;
    let divisor = x + y * Sym::int(2);
    assert_eq!(products([x, y / divisor]), 1);
    assert_eq!(products([x / divisor, y / divisor]), 3);
    let quotient = solution(|y, t| (Sym::ONE + t) / (y * Sym::int(2)), 1.0, 0.0, 4);
    // y = (1 + t + t^2/2)^(1/2)
    let known = [1.0, 0.5, 0.125, -1.0 / 16.0, 3.0 / 128.0];
    assert!(quotient.iter().zip(known).all(|(a, b)| (a - b).abs() < 1e-15), "{quotient:?}");
}
