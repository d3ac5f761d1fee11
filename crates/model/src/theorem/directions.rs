//! Three test directions of motion, and symbols for all quantities that depend on them.
//!
//! With the displacements X_k along three directions, the speeds u_k along them, and X_others for all other directions, the time derivative along a motion is
//!
//!   ' = sum u_k X_k + X_others + sum u_k' d/du_k + ... ,    [X_k, X_(k+1)] = e X_(k+2) .
//!
//! The symbol e is 0 for coordinates, and 1 for rotations about the axes of a free frame, so that one proof covers both cases.

use super::Equations;
use crate::FrameId;
use crate::trace::Vector;
use symbolic::{Derivation, Sym};

/// The three directions, with the derivatives of every symbol.
pub(super) struct TestDirections {
    pub speeds: [Sym; 3],
    pub accelerations: [Sym; 3],
    bracket: Sym,
    rates: Vec<(Sym, Sym)>,
    by_place: [Vec<(Sym, Sym)>; 3],
    by_speed: [Vec<(Sym, Sym)>; 3],
    by_acceleration: [Vec<(Sym, Sym)>; 3],
}

/// Returns the two directions that follow cyclically.
fn behind(k: usize) -> [usize; 2] {
    [(k + 1) % 3, (k + 2) % 3]
}

fn three(name: &str) -> [Sym; 3] {
    std::array::from_fn(|k| Sym::symbol(&format!("{name} {}", k + 1)))
}

impl TestDirections {
    /// Creates directions of coordinates or of rotations, with the symbol e.
    pub fn any() -> Self {
        TestDirections::along(three("u"), three("u'"), Sym::symbol("e"))
    }

    /// Creates directions with the given speeds, whose displacements have the bracket e.
    pub fn along(speeds: [Sym; 3], accelerations: [Sym; 3], bracket: Sym) -> Self {
        let alone = |letters: [Sym; 3]| letters.map(|letter| vec![(letter, Sym::ONE)]);
        TestDirections {
            speeds,
            accelerations,
            bracket,
            rates: speeds.into_iter().zip(accelerations).collect(),
            by_place: Default::default(),
            by_speed: alone(speeds),
            by_acceleration: alone(accelerations),
        }
    }

    /// Defines the time derivative of a symbol, and its derivatives along the directions.
    pub fn changes(&mut self, letter: Sym, rate: Sym, by_place: [Sym; 3]) {
        self.rates.push((letter, rate));
        for (known, slope) in self.by_place.iter_mut().zip(by_place) {
            known.push((letter, slope));
        }
    }

    /// Defines the derivatives of a symbol with respect to the speeds.
    pub fn changes_with_speeds(&mut self, letter: Sym, slopes: [Sym; 3]) {
        for (known, slope) in self.by_speed.iter_mut().zip(slopes) {
            known.push((letter, slope));
        }
    }

    /// Defines the derivatives of a symbol by the accelerations.
    pub fn changes_with_accelerations(&mut self, letter: Sym, slopes: [Sym; 3]) {
        for (known, slope) in self.by_acceleration.iter_mut().zip(slopes) {
            known.push((letter, slope));
        }
    }

    /// Creates a symbol that varies arbitrarily with position and time.
    pub fn free(&mut self, name: &str) -> Sym {
        let letter = Sym::symbol(name);
        self.changes(letter, Sym::symbol(&format!("{name}'")), three(&format!("{name} by place")));
        letter
    }

    /// Creates a function of positions and time, with the properties proved in [`super::functions`].
    pub fn function(&mut self, name: &str) -> Sym {
        let [letter, rate, second] = ["", "'", "''"].map(|primes| Sym::symbol(&format!("{name}{primes}")));
        let (slopes, slope_rates) = (three(&format!("{name} by")), three(&format!("{name}' by")));
        self.changes(letter, rate, slopes);
        self.rates.extend(slopes.into_iter().zip(slope_rates));
        let rate_by_place = std::array::from_fn(|k| slope_rates[k] + self.transposed(k, |j| slopes[j]));
        self.changes(rate, second, rate_by_place);
        self.changes_with_speeds(rate, slopes);
        self.changes_with_accelerations(second, slopes);
        letter
    }

    /// Creates the velocity of an arbitrary point along the axes of the ground, with the properties proved in [`super::points`]; returns it with its rate.
    pub fn velocity(&mut self, name: &str) -> (Vector, Vector) {
        let components: [(Sym, Sym); 3] = std::array::from_fn(|part| {
            let [letter, rate] = ["", "'"].map(|prime| Sym::symbol(&format!("{name}{prime} part {}", part + 1)));
            let (slopes, slope_rates) = self.slopes(&format!("{name} part {}", part + 1));
            let by_place = std::array::from_fn(|k| slope_rates[k] + self.transposed(k, |j| slopes[j]));
            self.changes(letter, rate, by_place);
            self.changes_with_speeds(letter, slopes);
            self.changes_with_accelerations(rate, slopes);
            (letter, rate)
        });
        (in_axes(components.map(|(letter, _)| letter)), in_axes(components.map(|(_, rate)| rate)))
    }

    /// Creates the angular velocity of an arbitrary frame along its own axes, with the properties proved in [`super::frames`]:
    ///
    ///   dw/dq = (dw/du)' + w x dw/du ,    plus the transposition term of a free frame.
    pub fn turning(&mut self, name: &str) -> Vector {
        let letters = three(name);
        let slopes: [([Sym; 3], [Sym; 3]); 3] =
            std::array::from_fn(|part| self.slopes(&format!("{name} {}", part + 1)));
        for (part, letter) in letters.into_iter().enumerate() {
            let (of_part, rates) = slopes[part];
            let by_place = std::array::from_fn(|k| {
                let [next, last] = behind(part);
                let across = letters[next] * slopes[last].0[k] - letters[last] * slopes[next].0[k];
                rates[k] + self.transposed(k, |j| of_part[j]) + across
            });
            let rate = Sym::symbol(&format!("{name}' {}", part + 1));
            self.changes(letter, rate, by_place);
            self.changes_with_speeds(letter, of_part);
            self.changes_with_accelerations(rate, of_part);
        }
        in_axes(letters)
    }

    /// Creates symbols for the derivatives with respect to the speeds, and for their rates.
    fn slopes(&mut self, name: &str) -> ([Sym; 3], [Sym; 3]) {
        let (slopes, rates) = (three(&format!("{name} by")), three(&format!("{name}' by")));
        self.rates.extend(slopes.into_iter().zip(rates));
        (slopes, rates)
    }

    /// Returns the time derivative along a motion.
    pub fn rate(&self, of: Sym) -> Sym {
        Derivation::new(self.rates.iter().copied()).of(of)
    }

    /// Returns the derivative by a displacement along a direction.
    pub fn by_place(&self, of: Sym, k: usize) -> Sym {
        Derivation::new(self.by_place[k].iter().copied()).of(of)
    }

    pub fn by_speed(&self, of: Sym, k: usize) -> Sym {
        Derivation::new(self.by_speed[k].iter().copied()).of(of)
    }

    pub fn by_acceleration(&self, of: Sym, k: usize) -> Sym {
        Derivation::new(self.by_acceleration[k].iter().copied()).of(of)
    }

    pub fn vector_by_speed(&self, of: Vector, k: usize) -> Vector {
        of.map(|component| self.by_speed(component, k))
    }

    /// Returns the transposition term (w x p)_k for rotations; zero for coordinates.
    pub fn transposed(&self, k: usize, of: impl Fn(usize) -> Sym) -> Sym {
        let [next, last] = behind(k);
        self.bracket * (self.speeds[next] * of(last) - self.speeds[last] * of(next))
    }

    /// Applies Lagrange's operator (dT/du)' - dT/dq.
    pub fn lagrange(&self, kinetic: Sym, k: usize) -> Sym {
        let momentum = |j: usize| self.by_speed(kinetic, j);
        self.rate(momentum(k)) + self.transposed(k, momentum) - self.by_place(kinetic, k)
    }

    /// Returns both sides of X_k f' = (X_k f)', with the transposition term of a free frame: derivatives by position and time commute.
    pub fn commute(&self, f: Sym) -> Equations {
        let of = |k: usize| {
            let by_place = |j: usize| self.by_place(f, j);
            (self.by_place(self.rate(f), k), self.rate(by_place(k)) + self.transposed(k, by_place))
        };
        (0..3).map(of).collect()
    }
}

/// Returns a vector with the given components along the first frame's axes.
pub(super) fn in_axes(components: [Sym; 3]) -> Vector {
    Vector { frame: FrameId::GROUND, components }
}

/// Returns the pairs of components of two vectors.
pub(super) fn equal(one: Vector, other: Vector) -> Equations {
    one.components.into_iter().zip(other.components).collect()
}
