//! The governor with an elastic rim: Hurwitz' conditions compared with eigenvalues, the energy, the maps.

use super::*;
use dalembert_derivations::studies::governors::{SPEED, governor as of_the_maps, growth, has_positive_minors};
use mechanics::constrained::motion::velocity;
use mechanics::constrained::programmed::violation;
use mechanics::constrained::{Charted, PointSystem as _, State, massless};
use symbolic::Sym;

/// The governor of the maps, with a rim that is elastic with respect to twisting too.
fn elastic(load: f64, across: f64) -> ElasticGovernor<f64> {
    ElasticGovernor { twist: -2.0, ..of_the_maps(across, -load) }
}

#[test]
fn hurwitz_and_the_eigenvalues_agree_on_the_elastic_governor() {
    let (mut stable, mut unstable) = (0, 0);
    for load in [-40.0, -20.0, -5.0, -1.0, 0.5, 5.0] {
        for across in [0.5, 5.0, 50.0, 500.0] {
            let data = elastic(load, across);
            let by_minors = has_positive_minors(&data, SPEED);
            let largest = growth(&data, SPEED).expect("a matrix of numbers");
            assert_eq!(by_minors, largest < 0.0, "M2 = {load}, a = -{across}: {largest}");
            if by_minors { stable += 1 } else { unstable += 1 }
        }
    }
    assert!(stable > 2 && unstable > 2, "{stable} stable, {unstable} not");
}

struct Elastic(ElasticGovernor<f64>);

impl<S: Over<f64> + Analytic> Ode<S> for Elastic {
    fn dimension(&self) -> usize {
        6
    }

    fn rates(&self, _t: S, y: &[S], dy: &mut [S]) {
        let state = [y[0], y[1], y[2], y[3], y[4]];
        let rates = self.0.rates_of_state(state).unwrap_or([S::zero() / S::zero(); 5]);
        dy[..5].copy_from_slice(&rates);
        dy[5] = self.0.power(state);
    }
}

impl System for Elastic {}

#[test]
fn the_energy_of_the_elastic_governor_is_the_work_of_the_shafts() {
    for drill in [0.0, 2.0] {
        let mut data = elastic(-5.0, 50.0);
        data.drill = drill;
        let start = [2.3, 0.62, 0.1, 0.01, 0.05];
        let mut state = start.to_vec();
        state.push(0.0);
        let end = run(&Elastic(data), Span::new(0.0, 2.0, &state));
        let gained = data.energy([end[0], end[1], end[2], end[3], end[4]]) - data.energy(start);
        assert!((gained - end[5]).abs() < 1e-10, "{gained} and {}", end[5]);
        assert!((end[0] - 2.3).abs() > 1e-3, "the motion is one");
    }
}

#[test]
fn the_map_of_stability_is_bounded_by_hurwitz_curve() {
    for map in dalembert_derivations::studies::governors::stability() {
        assert!(map.distance < 1e-6, "{}: {}", map.title, map.distance);
        let stable = map.rows.iter().flatten().filter(|stable| **stable).count();
        for (r, row) in map.rows.iter().enumerate() {
            let load = map.y.1[1] * (r as f64 + 0.5) / map.rows.len() as f64;
            // the curve has four points per column
            let agrees =
                row.iter().zip(map.curve.iter().skip(1).step_by(4)).all(|(stable, at)| *stable == (load < at.1));
            assert!(agrees, "{}: row {r}", map.title);
        }
        let all = map.rows.iter().map(Vec::len).sum::<usize>();
        assert!(stable > all / 20 && stable < all - all / 20, "{}: {stable} of {all}", map.title);
    }
}

/// For l = 1/2, x = 3/5 the balls are at the distance 2/5 from the axis, so that all numbers are rational.
#[test]
fn the_multipliers_of_the_elastic_governor_give_the_accelerations_of_appells_equations() {
    let data = |name: &str| match name {
        "ball" | "wheel" | "beta" => Sym::ratio(2, 3),
        "link" => Sym::ratio(1, 2),
        "offset" => Sym::ratio(1, 10),
        "across" | "twist" => Sym::ratio(-7, 4),
        "rim_mass" | "rim_inertia" => Sym::int(0),
        _ => Sym::ratio(5, 3),
    };
    let given =
        ElasticGovernor::<Sym>::read(|quantity| Ok::<Sym, ()>(data(&quantity.name))).expect("every datum is given");
    let [speed, x, drift, lambda, psi] = [(2, 1), (3, 5), (1, 3), (1, 5), (-1, 4)].map(|(n, d)| Sym::ratio(n, d));
    let zero = Sym::int(0);
    for rim in [zero, Sym::ratio(1, 9)] {
        let data = ElasticGovernor { rim_mass: rim, rim_inertia: rim, ..given };
        let (q, p) = ([zero, zero, zero, x, lambda, psi], [speed, drift]);
        let at = State { time: zero, place: data.place(zero, q), velocity: velocity(&data, zero, q, p) };
        let kept = violation::<_, Sym, 12, 10>(&data, &at);
        assert_eq!((kept.value, kept.rate), ([zero; 10], [zero; 10]), "the chart keeps the constraints");
        let found = massless::leading_to(&data, &at, data.force(&at), [zero; 10]).expect("every coordinate is held");
        let [spin, _, push, across, turn] = data.rates_of_state([speed, x, drift, lambda, psi]).expect("it has masses");
        assert_eq!([found.acceleration[0], found.acceleration[3]], [spin, push]);
        assert_eq!([at.velocity[10], at.velocity[11]], [across, turn]);
    }
}
