//! The terms that a mistaken derivation loses, checked by difference quotients of the energy that the derivation uses.

use super::claims::{At, Fault, equal};
use super::numbers::{quadratic_slope, slope, solved, unit};
use super::system::State;
use dalembert_model::equations::Characteristics;
use dalembert_model::{Mistake, Mistaken};

/// Largest derivative of a dependent by an independent speed. Above it, the choice of independent speeds is nearly singular and
/// difference quotients are inaccurate.
const MOST_STEEP: f64 = 8.0;

/// Checks the printed lost terms: they must equal the inertial forces minus those of the mistaken derivation.
pub fn lost(
    at: &At<'_, '_, '_, '_>,
    characteristics: &Characteristics,
    mistake: Mistake,
    made: &Mistaken,
) -> Result<(), Fault> {
    let n = at.state.u.len();
    let inertia: Vec<f64> = (0..n).map(|i| inertia(at, i)).collect();
    let own: Vec<usize> = (0..n).collect();
    let (places, differences): (&[usize], Vec<f64>) = match mistake {
        Mistake::AccelerationsInEnergy => {
            // the momentum is affine in the speeds: differences of unit steps are exact
            let momentum =
                |i: usize, u: Vec<f64>| at.mechanics.momentum(&State { u, ..at.state.clone() }, i, &at.state);
            let naive = |i: usize| {
                let still = momentum(i, vec![0.0; n]);
                (0..n).fold(still, |sum, j| sum + at.solved[j] * (momentum(i, unit(n, j)) - still))
            };
            (&own, (0..n).map(|i| inertia[i] - naive(i)).collect())
        }
        Mistake::ConstraintsInEnergy => {
            let reduced = Reduced { at, characteristics };
            let places = &characteristics.independent;
            let steep = |place: usize| reduced.direction(place).iter().any(|along| along.abs() > MOST_STEEP);
            if (0..places.len()).any(steep) {
                return Ok(());
            }
            (places, (0..places.len()).map(|place| reduced.right(place, &inertia) - reduced.naive(place)).collect())
        }
    };
    let trace = at.mechanics.system.trace;
    for (&place, difference) in places.iter().zip(differences) {
        let name = trace.direction(place);
        let printed = made.lost.iter().find(|(known, _)| *known == name);
        let printed = printed.map_or(0.0, |&(_, term)| {
            at.mechanics.system.at(&at.mechanics.system.numbers(&[term]), &at.state, &at.solved)[0]
        });
        equal(&format!("lost in the equation of {name}"), printed, difference, inertia[place])?;
    }
    let says_nothing = made.says.contains("lose no term in this system");
    if says_nothing == made.lost.is_empty() { Ok(()) } else { Err("its sentence and its terms differ".to_owned()) }
}

/// Returns (w x p)_i if the speed is a component of a free frame's angular velocity (rotations about its axes do not commute), else zero.
fn turned(at: &At<'_, '_, '_, '_>, i: usize, momentum: impl Fn(usize) -> f64) -> f64 {
    let Some(turn) = i.checked_sub(at.mechanics.system.model().coordinates.len()) else { return 0.0 };
    let first = i - turn % 3;
    let [next, last] = [first + (turn + 1) % 3, first + (turn + 2) % 3];
    at.state.u[next] * momentum(last) - at.state.u[last] * momentum(next)
}

/// Returns d/dt dT/du - dT/dq along the motion, with the masses kept constant.
pub fn inertia(at: &At<'_, '_, '_, '_>, i: usize) -> f64 {
    let (mechanics, system, state) = (at.mechanics, at.mechanics.system, &at.state);
    let unit = unit(state.u.len(), i);
    let rate = slope(|length| mechanics.momentum(&system.later(state, length), i, state));
    let turned = turned(at, i, |j| mechanics.momentum(state, j, state));
    rate + turned - slope(|length| mechanics.kinetic(&system.displaced(state, &unit, length), &state.u, state))
}

/// The kinetic energy as a function of the independent speeds only.
struct Reduced<'a, 'b, 's, 't, 'm> {
    at: &'a At<'b, 's, 't, 'm>,
    characteristics: &'a Characteristics,
}

impl Reduced<'_, '_, '_, '_, '_> {
    /// Returns all speeds; the dependent ones follow from the independent ones by the constraints.
    fn speeds(&self, state: &State, independent: &[f64]) -> Vec<f64> {
        let mut u = vec![0.0; state.u.len()];
        for (&place, speed) in self.characteristics.independent.iter().zip(independent) {
            u[place] = *speed;
        }
        let dependent: Vec<usize> = self.characteristics.dependent.iter().map(|&(place, _)| place).collect();
        let (rows, rates) = self.at.mechanics.system.rates(&State { u: u.clone(), ..state.clone() });
        let rows: Vec<Vec<f64>> = rows.iter().map(|row| dependent.iter().map(|&place| row[place]).collect()).collect();
        let right: Vec<f64> = rates.iter().map(|rate| -rate).collect();
        for (&place, speed) in dependent.iter().zip(solved(&rows, &right).0) {
            u[place] = speed;
        }
        u
    }

    fn independent(&self, state: &State) -> Vec<f64> {
        self.characteristics.independent.iter().map(|&place| state.u[place]).collect()
    }

    fn energy(&self, state: &State, independent: &[f64]) -> f64 {
        self.at.mechanics.kinetic(state, &self.speeds(state, independent), &self.at.state)
    }

    /// Returns the column of N for one independent speed: the difference of two admissible sets of speeds.
    fn direction(&self, place: usize) -> Vec<f64> {
        let state = &self.at.state;
        let mut other = self.independent(state);
        let one = self.speeds(state, &other);
        other[place] += 1.0;
        self.speeds(state, &other).iter().zip(one).map(|(other, one)| other - one).collect()
    }

    /// Returns Lagrange's operator d/dt dT/du - dT/dq applied to the reduced energy.
    fn naive(&self, place: usize) -> f64 {
        let (system, state) = (self.at.mechanics.system, &self.at.state);
        let momentum = |at: &State, place: usize| {
            quadratic_slope(|length| {
                let mut speeds = self.independent(at);
                speeds[place] += length;
                self.energy(at, &speeds)
            })
        };
        let rate = slope(|length| momentum(&system.later(state, length), place));
        // the reduced energy does not depend on dependent speeds
        let places = &self.characteristics.independent;
        let of_speed = |j: usize| places.iter().position(|&own| own == j).map_or(0.0, |own| momentum(state, own));
        let turned = turned(self.at, places[place], of_speed);
        let direction = self.direction(place);
        let speeds = self.independent(state);
        rate + turned - slope(|length| self.energy(&system.displaced(state, &direction, length), &speeds))
    }

    fn right(&self, place: usize, inertia: &[f64]) -> f64 {
        self.direction(place).iter().zip(inertia).map(|(along, inertia)| along * inertia).sum()
    }
}
