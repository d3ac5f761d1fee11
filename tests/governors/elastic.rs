//! The governor with an elastic rim: Hurwitz beside eigenvalues, energy, the maps.

use super::*;

fn elastic(load: f64, across: f64) -> ElasticGovernor<f64> {
    let rim = Rim {
        across: -across,
        twist: -2.0,
        drill: 0.0,
        curved_by_displacement: 5.0,
        curved_by_angle: 8.0,
        masses: [0.0; 2],
    };
    ElasticGovernor {
        inertia: [1.0, 1.0, 0.1],
        drum: 0.5,
        wheel: 0.2,
        offset: 0.1,
        sleeve: 1.0,
        ball: 1.0,
        link: 0.5,
        moments: [0.0, load],
        stiffness: [30.0, 20.0],
        tension: [0.1, 0.0],
        rest: 0.6,
        rim,
    }
    .stationary_at(SPEED)
}

#[test]
fn hurwitz_and_the_eigenvalues_agree_on_the_elastic_governor() {
    let (mut stable, mut unstable) = (0, 0);
    for load in [-40.0, -20.0, -5.0, -1.0, 0.5, 5.0] {
        for across in [0.5, 5.0, 50.0, 500.0] {
            let matrix = elastic(load, across).first_approximation(SPEED).expect("real masses");
            let by_minors = hurwitz(characteristic(matrix)).iter().all(|minor| *minor > 0.0);
            let flat = SMatrix::<f64, 5, 5>::from_fn(|i, j| matrix[i][j]);
            let schur = flat.try_schur(f64::EPSILON, 1000).expect("a matrix of numbers");
            let largest = schur.complex_eigenvalues().iter().map(|root| root.re).fold(f64::MIN, f64::max);
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
        // the work of the shafts and of the rim's moment on the disc
        let [first, second] = self.0.moments.map(S::lift);
        let disc = S::lift(self.0.drum) * y[0] / (y[1] - S::lift(self.0.offset));
        dy[5] = first * y[0] + (second + S::lift(self.0.rim.drill) * y[4]) * disc;
    }
}

impl System for Elastic {}

#[test]
fn the_energy_of_the_elastic_governor_is_the_work_of_the_shafts() {
    for drill in [0.0, 2.0] {
        let mut data = elastic(-5.0, 50.0);
        data.rim.drill = drill;
        let start = [2.3, 0.62, 0.1, 0.01, 0.05];
        let mut state = start.to_vec();
        state.push(0.0);
        let end = run(&Elastic(data), &Span::new(0.0, 2.0, &state));
        let gained = data.energy([end[0], end[1], end[2], end[3], end[4]]) - data.energy(start);
        assert!((gained - end[5]).abs() < 1e-10, "{gained} and {}", end[5]);
        assert!((end[0] - 2.3).abs() > 1e-3, "the motion is one");
    }
}

#[test]
fn the_map_of_stability_is_bounded_by_hurwitz_curve() {
    for map in derivations::governors::stability() {
        assert!(map.distance < 1e-6, "{}: {}", map.title, map.distance);
        let stable = map.rows.iter().flatten().filter(|stable| **stable).count();
        for (r, row) in map.rows.iter().enumerate() {
            let load = map.y.1[1] * (r as f64 + 0.5) / map.rows.len() as f64;
            // the curve has four points a column
            let agrees =
                row.iter().zip(map.curve.iter().skip(1).step_by(4)).all(|(stable, at)| *stable == (load < at.1));
            assert!(agrees, "{}: row {r}", map.title);
        }
        let all = map.rows.iter().map(Vec::len).sum::<usize>();
        assert!(stable > all / 20 && stable < all - all / 20, "{}: {stable} of {all}", map.title);
    }
}
