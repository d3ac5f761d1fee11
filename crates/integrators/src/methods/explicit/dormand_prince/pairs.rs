//! The coefficients of the pairs, and the parameters of their step size control.

/// Coefficients a_j of the slopes k_j, as pairs (stage, a_j) without zeros.
type Row = &'static [(usize, f64)];

/// A pair of explicit Runge-Kutta formulas.
pub(crate) struct Pair {
    pub order: u32,
    /// c_i with the row a_i1, a_i2, ... of each stage after the first.
    pub stages: &'static [(f64, Row)],
    /// b_i of the step.
    pub weights: Row,
    /// e_i of the error estimate.
    pub error: Row,
    /// d_i of the second estimate, if there is one.
    pub second_error: Row,
    /// Whether the error estimate uses the slope at the end of the step, which is otherwise needed after accepted steps
    /// only.
    pub error_needs_end: bool,
    /// The step size is proportional to error^-exponent and to the previous error^`damping` (Gustafsson's control).
    pub exponent: f64,
    pub damping: f64,
    /// Whether the predictive control is used instead of `damping`: the error is expected to grow as over the last step
    /// (Gustafsson 1994).
    pub predicts: bool,
    /// The smallest and the largest ratio of successive step sizes.
    pub shortest: f64,
    pub longest: f64,
    /// The product of step size and Lipschitz number above which stability, not accuracy, limits the step size.
    pub stretching: f64,
}

/// Dormand and Prince (1980): order 5 with an error estimate of order 4.
pub(crate) static FIVE: Pair = Pair {
    order: 5,
    stages: &[
        (1.0 / 5.0, &[(0, 1.0 / 5.0)]),
        (3.0 / 10.0, &[(0, 3.0 / 40.0), (1, 9.0 / 40.0)]),
        (4.0 / 5.0, &[(0, 44.0 / 45.0), (1, -56.0 / 15.0), (2, 32.0 / 9.0)]),
        (8.0 / 9.0, &[(0, 19372.0 / 6561.0), (1, -25360.0 / 2187.0), (2, 64448.0 / 6561.0), (3, -212.0 / 729.0)]),
        (
            1.0,
            &[
                (0, 9017.0 / 3168.0),
                (1, -355.0 / 33.0),
                (2, 46732.0 / 5247.0),
                (3, 49.0 / 176.0),
                (4, -5103.0 / 18656.0),
            ],
        ),
    ],
    weights: &[(0, 35.0 / 384.0), (2, 500.0 / 1113.0), (3, 125.0 / 192.0), (4, -2187.0 / 6784.0), (5, 11.0 / 84.0)],
    error: &[
        (0, 71.0 / 57600.0),
        (2, -71.0 / 16695.0),
        (3, 71.0 / 1920.0),
        (4, -17253.0 / 339200.0),
        (5, 22.0 / 525.0),
        (6, -1.0 / 40.0),
    ],
    second_error: &[],
    error_needs_end: true,
    exponent: 0.17,
    damping: 0.04,
    predicts: false,
    shortest: 0.2,
    longest: 10.0,
    stretching: 3.25,
};

/// Prince and Dormand (1981), with Hairer's error estimates of orders 5 and 3.
pub(crate) static EIGHT: Pair = Pair {
    order: 8,
    stages: &[
        (0.05260015195876773, &[(0, 0.05260015195876773)]),
        (0.0789002279381516, &[(0, 0.0197250569845379), (1, 0.0591751709536137)]),
        (0.1183503419072274, &[(0, 0.02958758547680685), (2, 0.08876275643042054)]),
        (0.2816496580927726, &[(0, 0.2413651341592667), (2, -0.8845494793282861), (3, 0.924834003261792)]),
        (1.0 / 3.0, &[(0, 1.0 / 27.0), (3, 0.17082860872947386), (4, 0.12546768756682242)]),
        (0.25, &[(0, 0.037109375), (3, 0.17025221101954405), (4, 0.06021653898045596), (5, -0.017578125)]),
        (
            4.0 / 13.0,
            &[
                (0, 0.03709200011850479),
                (3, 0.17038392571223998),
                (4, 0.10726203044637328),
                (5, -0.015319437748624402),
                (6, 0.008273789163814023),
            ],
        ),
        (
            0.6512820512820513,
            &[
                (0, 0.6241109587160757),
                (3, -3.3608926294469414),
                (4, -0.868219346841726),
                (5, 27.59209969944671),
                (6, 20.154067550477894),
                (7, -43.48988418106996),
            ],
        ),
        (
            0.6,
            &[
                (0, 0.47766253643826434),
                (3, -2.4881146199716677),
                (4, -0.590290826836843),
                (5, 21.230051448181193),
                (6, 15.279233632882423),
                (7, -33.28821096898486),
                (8, -0.020331201708508627),
            ],
        ),
        (
            6.0 / 7.0,
            &[
                (0, -0.9371424300859873),
                (3, 5.186372428844064),
                (4, 1.0914373489967295),
                (5, -8.149787010746927),
                (6, -18.52006565999696),
                (7, 22.739487099350505),
                (8, 2.4936055526796523),
                (9, -3.0467644718982196),
            ],
        ),
        (
            1.0,
            &[
                (0, 2.273310147516538),
                (3, -10.53449546673725),
                (4, -2.0008720582248625),
                (5, -17.9589318631188),
                (6, 27.94888452941996),
                (7, -2.8589982771350235),
                (8, -8.87285693353063),
                (9, 12.360567175794303),
                (10, 0.6433927460157636),
            ],
        ),
    ],
    weights: &[
        (0, 0.054293734116568765),
        (5, 4.450312892752409),
        (6, 1.8915178993145003),
        (7, -5.801203960010585),
        (8, 0.3111643669578199),
        (9, -0.1521609496625161),
        (10, 0.20136540080403034),
        (11, 0.04471061572777259),
    ],
    error: &[
        (0, 0.01312004499419488),
        (5, -1.2251564463762044),
        (6, -0.4957589496572502),
        (7, 1.6643771824549864),
        (8, -0.35032884874997366),
        (9, 0.3341791187130175),
        (10, 0.08192320648511571),
        (11, -0.022355307863886294),
    ],
    second_error: &[
        (0, -0.18980075407240762),
        (5, 4.450312892752409),
        (6, 1.8915178993145003),
        (7, -5.801203960010585),
        (8, -0.42268232132379197),
        (9, -0.1521609496625161),
        (10, 0.20136540080403034),
        (11, 0.022651792198360825),
    ],
    error_needs_end: false,
    exponent: 0.125,
    damping: 0.0,
    predicts: true,
    shortest: 0.333,
    longest: 6.0,
    stretching: 6.1,
};

#[cfg(test)]
mod tests {
    use super::*;

    /// The nodes c_i of all slopes, including that at the end of the step.
    fn nodes(pair: &Pair) -> Vec<f64> {
        [0.0].into_iter().chain(pair.stages.iter().map(|(node, _)| *node)).chain([1.0]).collect()
    }

    /// Sum of b_i c_i^power.
    fn moment(row: Row, nodes: &[f64], power: u32) -> f64 {
        row.iter().map(|(stage, share)| share * nodes[*stage].powi(power as i32)).sum()
    }

    /// Every coefficient enters one of these sums with a factor that is not small.
    #[test]
    fn rows_sum_to_their_nodes_and_weights_integrate_powers() {
        for pair in [&FIVE, &EIGHT] {
            let nodes = nodes(pair);
            for (node, row) in pair.stages {
                assert!((moment(row, &nodes, 0) - node).abs() < 2e-14, "node {node}");
            }
            for power in 0..pair.order {
                let exact = 1.0 / f64::from(power + 1);
                assert!((moment(pair.weights, &nodes, power) - exact).abs() < 2e-15, "{power} of order {}", pair.order);
            }
        }
    }

    /// The conditions sum b_i c_i^p a_ij c_j^q = 1 / ((q + 1) (p + q + 2)) hold up to the order, and some fail beyond.
    #[test]
    fn two_stages_in_a_row_integrate_products_of_powers() {
        for pair in [&FIVE, &EIGHT] {
            let nodes = nodes(pair);
            let error = |p: u32, q: u32| {
                let inner = |stage: usize| stage.checked_sub(1).map_or(0.0, |i| moment(pair.stages[i].1, &nodes, q));
                let outer = |&(stage, weight): &(usize, f64)| weight * nodes[stage].powi(p as i32) * inner(stage);
                pair.weights.iter().map(outer).sum::<f64>() - 1.0 / f64::from((q + 1) * (p + q + 2))
            };
            for (p, q) in (0..pair.order).flat_map(|p| (0..pair.order).map(move |q| (p, q))) {
                let holds = error(p, q).abs() < 1e-14;
                assert!(holds || p + q + 2 > pair.order, "{p} {q} of order {}: {:e}", pair.order, error(p, q));
            }
            assert!((0..pair.order).any(|p| error(p, pair.order - 1 - p).abs() > 1e-6), "order {}", pair.order);
        }
    }

    /// Error estimates vanish for the powers that the formula of lower order integrates exactly, and for no higher
    /// power.
    #[test]
    fn error_estimates_have_their_orders() {
        for (pair, row, order) in [(&FIVE, FIVE.error, 4), (&EIGHT, EIGHT.error, 5), (&EIGHT, EIGHT.second_error, 3)] {
            let nodes = nodes(pair);
            for power in 0..=order {
                let sum = moment(row, &nodes, power);
                assert_eq!(sum.abs() < 2e-15, power < order, "{power} of {order}: {sum:e}");
            }
        }
    }
}
