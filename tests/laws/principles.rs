//! Tests of the principles beyond their proofs: larger systems with random exact data, and the proved laws in
//! floating-point numbers.

use dalembert_derivations::systems::disc::Disc;
use dalembert_derivations::systems::knife_edge::KnifeEdge;
use dalembert_derivations::systems::moving_pivot_pendulum::MovingPivotPendulum;
use dalembert_derivations::systems::rod::{GuidedRod, Rod};
use field::{Over, Rational, Scalar};
use mechanics::constrained::combining::{extended, painleve};
use mechanics::constrained::contacts::{Closed, Sides};
use mechanics::constrained::gauss::{constraint, least};
use mechanics::constrained::motion::Motion;
use mechanics::constrained::multipliers::multipliers;
use mechanics::constrained::newton::{Reactions, newton};
use mechanics::constrained::programmed::{Linear, programmed, violation};
use mechanics::constrained::rates::rates;
use mechanics::constrained::redundant::{Redundant, Split, accelerations};
use mechanics::constrained::{Charted, Constrained, Constraint, PointSystem, State, appell, quasi, second_kind};
use num_traits::Zero;
use proptest::array::{uniform3, uniform6};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

fn config(seed: u64) -> ProptestConfig {
    ProptestConfig { cases: 64, rng_seed: RngSeed::Fixed(seed), ..Default::default() }
}

type Vector = [Rational; 6];

/// Six masses under three constraints J x'' + beta = 0.
#[derive(Clone, Copy, Debug)]
struct Rows {
    masses: Vector,
    rows: [Vector; 3],
    rest: [Rational; 3],
}

impl PointSystem<6> for Rows {
    type Given = Rational;

    fn masses<S: Over<Rational>>(&self) -> [S; 6] {
        self.masses.map(S::lift)
    }

    fn force<S: Over<Rational>>(&self, _at: &State<S, 6>) -> [S; 6] {
        [S::zero(); 6]
    }
}

impl Constrained<6, 3> for Rows {
    fn constraints<S: Over<Rational>>(&self, at: &State<S, 6>) -> [Constraint<S>; 3] {
        std::array::from_fn(|k| {
            let moved = (0..6).fold(S::zero(), |sum, i| sum + S::lift(self.rows[k][i]) * at.velocity[i]);
            Constraint::Kinematic(moved + S::lift(self.rest[k]) * at.time)
        })
    }
}

impl Rows {
    fn at_rest() -> State<Rational, 6> {
        State { time: Rational::zero(), place: [Rational::zero(); 6], velocity: [Rational::zero(); 6] }
    }

    fn along_rows(&self, v: Vector) -> [Rational; 3] {
        self.rows.map(|row| (0..6).fold(Rational::zero(), |sum, i| sum + row[i] * v[i]))
    }

    fn per_mass(&self, v: Vector) -> Vector {
        std::array::from_fn(|i| v[i] / self.masses[i])
    }
}

fn number(from: i64, to: i64) -> impl Strategy<Value = Rational> {
    (from..=to, 1..=3i64).prop_map(|(n, d)| Rational::new(n, d))
}

prop_compose! {
    fn any_rows()(
        masses in uniform6(number(1, 9)),
        rows in uniform3(uniform6(number(-4, 4))),
        rest in uniform3(number(-4, 4)),
    ) -> Rows {
        Rows { masses, rows, rest }
    }
}

fn nothing() -> [Rational; 3] {
    [Rational::zero(); 3]
}

fn sum(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|i| a[i] + b[i])
}

proptest! {
    #![proptest_config(config(11))]

    #[test]
    fn a_reaction_splits_and_its_friction_leaves_the_multipliers_alone(
        any in any_rows(), reaction in uniform6(number(-9, 9)), force in uniform6(number(-9, 9)),
    ) {
        let Ok(split) = extended(any.masses, any.rows, reaction) else { return Ok(()) };
        prop_assert_eq!(sum(split.of_constraints, split.of_friction), reaction);
        prop_assert_eq!(any.along_rows(any.per_mass(split.of_friction)), nothing());
        let under = |force| multipliers::<_, _, 6, 3>(&any, &Rows::at_rest(), force).expect("the rows are independent");
        let (free, rubbed) = (under(force), under(sum(force, split.of_friction)));
        prop_assert_eq!(rubbed.multipliers, free.multipliers);
        prop_assert_eq!(rubbed.acceleration, sum(free.acceleration, any.per_mass(split.of_friction)));
        prop_assert_eq!(under(sum(force, reaction)).acceleration, rubbed.acceleration);
    }

    #[test]
    fn painleves_choice_moves_the_multipliers_unless_the_masses_are_equal(
        any in any_rows(), reaction in uniform6(number(-9, 9)),
    ) {
        let Ok(split) = painleve(any.rows, reaction) else { return Ok(()) };
        prop_assert_eq!(any.along_rows(split.of_friction), nothing());
        let change = |any: &Rows| {
            let under = |force| multipliers::<_, _, 6, 3>(any, &Rows::at_rest(), force).map(|r| r.multipliers);
            (under(split.of_friction), under([Rational::zero(); 6]))
        };
        let (rubbed, free) = change(&any);
        let moves = any.along_rows(any.per_mass(split.of_friction)) != nothing();
        prop_assert_eq!(rubbed != free, moves);
        let (rubbed, free) = change(&Rows { masses: [any.masses[0]; 6], ..any });
        prop_assert_eq!(rubbed, free);
    }

    #[test]
    fn the_least_constraint_is_lagranges_motion(
        any in any_rows(), force in uniform6(number(-9, 9)), other in uniform3(number(-9, 9)),
    ) {
        let split = Split::<6, 3, 3>::new([0, 1, 2]).expect("three of six");
        let Ok(admissible) = accelerations(&any, &split, &Rows::at_rest()) else { return Ok(()) };
        let found = least(any.masses, force, &admissible).expect("masses are positive");
        let expected = multipliers::<_, _, 6, 3>(&any, &Rows::at_rest(), force).expect("the rows are independent");
        prop_assert_eq!(found, expected.acceleration);
        let elsewhere = admissible.vector(other);
        let more = constraint(any.masses, force, elsewhere) - constraint(any.masses, force, found);
        prop_assert_eq!(more.sign(), Some(i32::from(elsewhere != found)));
    }
}

#[test]
fn a_row_that_depends_on_another_is_named() {
    let one = Rational::int(1);
    let row: Vector = std::array::from_fn(|i| Rational::int(i as i64));
    let twice = row.map(|entry| entry + entry);
    let refused = extended([one; 6], [row, twice, [one; 6]], [one; 6]).expect_err("the second row is twice the first");
    assert_eq!(refused.to_string(), "row 2 of the matrix depends on those before it");
}

#[test]
fn coordinates_that_are_no_split_are_refused() {
    assert_eq!(Split::<4, 2, 2>::new([1, 1]), None);
    assert_eq!(Split::<4, 2, 2>::new([1, 4]), None);
    assert!(Split::<4, 2, 2>::new([3, 1]).is_some());
}

/// The reaction acts upwards at the lowest point; the rigid body transmits it to the centre.
#[test]
fn the_plane_carries_the_weight_of_a_disc_that_stands() {
    let [mass, second_moment, radius, gravity] = [3, 1, 2, 10].map(Rational::int);
    let disc = Disc { mass, second_moment, radius, gravity };
    let place = [0, 0, 2, 1, 0, 0, 0, 0, 1].map(Rational::int);
    let at = State { time: Rational::zero(), place, velocity: [Rational::zero(); 9] };
    let stands = newton::<_, _, 9, 6>(&disc, &at, disc.force(&at)).expect("the disc is inclined");
    assert_eq!(stands.acceleration, [Rational::zero(); 9]);
    assert_eq!(stands.reactions, [0, 60, 0, 30, 0, 0].map(Rational::int));
}

/// The greatest difference between the accelerations by the different principles, relative to their magnitude.
fn spread<Q, const N: usize, const C: usize, const K: usize, const R: usize>(
    system: &Q,
    (time, q, p): (f64, [f64; K], [f64; R]),
    dependent: [usize; C],
) -> f64
where
    Q: Charted<N, K, R, Given = f64> + Constrained<N, C> + Reactions<N, C>,
{
    let motion = Motion::at(system, time, q, p);
    let state = motion.state;
    let force = system.force(&state);
    let expected = multipliers::<_, _, N, C>(system, &state, force).expect("independent").acceleration;
    let split = Split::<N, C, R>::new(dependent).expect("a split");
    let chart = Redundant::about(system, split, time, state.place).expect("determined");
    let free = chart.free(state.velocity);
    let in_all = quasi::rates(&chart, (time, state.place, free), force).expect("definite");
    let found = [
        newton(system, &state, force).expect("independent").acceleration,
        motion.acceleration(appell::rates(system, &motion, force).expect("definite")),
        motion.acceleration(second_kind::rates(system, (time, q, p), force).expect("definite")),
        motion.acceleration(quasi::rates(system, (time, q, p), force).expect("definite")),
        least(system.masses(), force, &accelerations(system, &split, &state).expect("determined")).expect("definite"),
        Motion::at(&chart, time, state.place, free).acceleration(in_all),
    ];
    let size = expected.iter().fold(1.0, |size: f64, a| size.max(a.abs()));
    found.iter().flat_map(|x| x.iter().zip(&expected)).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs() / size))
}

proptest! {
    #![proptest_config(config(12))]

    #[test]
    fn what_was_proved_is_what_runs(
        data in uniform6(0.5..2.0f64), [psi, phi] in proptest::array::uniform2(-3.0..3.0f64), theta in 0.3..1.2f64,
        speeds in uniform3(-2.0..2.0f64),
    ) {
        let [m, m1, l, g, d, t] = data;
        let [u, v, w] = speeds;
        let disc = Disc { mass: m, second_moment: m1, radius: l, gravity: g };
        let sleigh = KnifeEdge { mass: m, inertia: m1, offset: d, slope: g };
        let rod: GuidedRod<f64> =
            Closed(Rod { guided: m, free: m1, length: l, gravity: g, friction: 0.0, sides: Sides::Two });
        let swing = MovingPivotPendulum { mass: m, length: l, gravity: g, speed: u, acceleration: v };
        let spreads = [
            // the pivots of the redundant coordinates vanish on a surface; this range of the angular velocity avoids it
            spread(&disc, (t, [u, v, psi, theta, 0.3 + phi.abs() / 4.0], speeds), [3, 8, 6, 2, 0, 1]),
            spread(&sleigh, (t, [u, v, theta], [u, w]), [3, 1]),
            spread(&rod, (t, [u, theta], [v, w]), [3, 1]),
            spread(&swing, (t, [theta], [w]), [1]),
        ];
        for spread in spreads {
            prop_assert!(spread < 1e-8, "{spreads:?}");
        }
    }
}

proptest! {
    #![proptest_config(config(17))]

    #[test]
    fn a_disc_off_its_constraints_is_led_back_as_the_law_says(
        place in prop::array::uniform9(number(-4, 4)), velocity in prop::array::uniform9(number(-4, 4)),
        alpha in number(1, 4), beta in number(1, 4),
    ) {
        let [mass, second_moment, radius, gravity] = [3, 1, 2, 10].map(|n| Rational::new(n, 1));
        let disc = Disc { mass, second_moment, radius, gravity };
        let at = State { time: Rational::zero(), place, velocity };
        let law: Linear<Rational, 6> = Linear::baumgarte(alpha, beta);
        let Ok(led) = programmed(&disc, &law, &at, disc.force(&at)) else { return Ok(()) };
        let (found, y) = (rates(&disc, &at, led.acceleration), violation(&disc, &at));
        let led_back = std::array::from_fn(|k| -(alpha + alpha) * y.rate[k] - beta * beta * y.value[k]);
        prop_assert_eq!(found, led_back);
    }
}
