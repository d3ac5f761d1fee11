//! Identities of the linearisation for random exact steady motions.

use crate::physical::{axes, fixed, gyrostat};
use dalembert_derivations::machines::synchronous::Synchronous;
use dalembert_derivations::studies::stationary::energies::Energies;
use dalembert_derivations::studies::stationary::stability::reduced::Reduced;
use dalembert_derivations::studies::stationary::stability::{Linear, StationaryState};
use field::{Circle, Rational, Scalar};
use mechanics::linear_stability::characteristic;
use mechanics::rotation::determinant;
use motor::FreeRotor;
use motor::Machine;
use nalgebra::{Matrix3, Vector3};
use proptest::prelude::*;

fn int(n: i64) -> Rational {
    Rational::int(n)
}

/// A gyrostat, a direction, and the weight for which the rotation about this direction is steady.
#[derive(Clone, Debug)]
struct Drawn {
    energies: Energies<Rational>,
    place: StationaryState<Rational>,
    multiplier: Rational,
}

fn drawn() -> impl Strategy<Value = Drawn> {
    (gyrostat(), axes(), -20..20i64, 1..60i64, -30..30i64, -9..10i64).prop_map(|(bodies, axes, w, spin, lambda, t)| {
        let mut energies = Energies::of(&bodies);
        let (speed, rotor_speed, multiplier) = (Rational::new(w, 3), int(spin), Rational::new(lambda, 2));
        let vertical: Vector3<Rational> = axes.column(1).into();
        let (all, _) = energies.momenta::<Rational>(vertical * speed, rotor_speed);
        energies.weight = vertical * multiplier - all * speed;
        let angle = Circle::from_half_tangent(Rational::new(t, 7));
        Drawn { energies, place: StationaryState { speed, vertical, rotor_speed, angle }, multiplier }
    })
}

fn synchronous(drawn: &Drawn) -> Synchronous<Rational> {
    Synchronous { field_speed: drawn.place.rotor_speed, b0: Rational::new(7, 3), f: Rational::new(2, 5) }
}

impl Drawn {
    /// The coefficients, highest power first, of det T (z^4 + a z^2 + b) at constant speed, and for a free rotor.
    fn classical(&self) -> [[Rational; 3]; 2] {
        let Energies { tensor, mixed, axial, .. } = self.energies;
        let StationaryState { speed, vertical, rotor_speed, .. } = self.place;
        let kept = Reduced { tensor, spin: mixed * rotor_speed, speed, vertical, multiplier: self.multiplier };
        let share = mixed / axial;
        let own = mixed.dot(&vertical) * speed + axial * rotor_speed;
        let reduced: Matrix3<Rational> = tensor - share * mixed.transpose();
        [kept.polynomial(), Reduced { tensor: reduced, spin: share * own, ..kept }.polynomial()]
    }

    fn polynomial(&self, machine: &impl Machine<Rational>, free: bool) -> Vec<Rational> {
        characteristic(&Linear::at(&self.energies, machine, &self.place, free).rates, &int(1))
    }
}

proptest! {
    #![proptest_config(fixed(40))]

    /// The rate of the energy's second variation equals the dissipation: G'' A + A^T G'' = -2 diag, exactly.
    #[test]
    fn the_energy_loses_what_the_damping_takes(drawn in drawn()) {
        let machine = synchronous(&drawn);
        let linear = Linear::at(&drawn.energies, &machine, &drawn.place, false);
        let size = linear.rates.len();
        for i in 0..size {
            for j in 0..size {
                let both = (0..size).fold(int(0), |sum, k| {
                    sum + linear.energy[i][k] * linear.rates[k][j] + linear.rates[k][i] * linear.energy[k][j]
                });
                let expected = if (i, j) == (7, 7) { -(machine.f + machine.f) } else { int(0) };
                prop_assert_eq!(both, expected, "at {} {}", i, j);
            }
        }
    }

    /// The differentials of the integrals are left null vectors of the linearisation's matrix.
    #[test]
    fn every_integral_gives_a_zero_root(drawn in drawn()) {
        let linear = Linear::at(&drawn.energies, &FreeRotor::default(), &drawn.place, true);
        prop_assert_eq!(linear.integrals.len(), 3);
        for integral in &linear.integrals {
            for j in 0..linear.rates.len() {
                let image = integral.iter().zip(&linear.rates).fold(int(0), |sum, (c, row)| sum + *c * row[j]);
                prop_assert_eq!(image, int(0));
            }
        }
        let polynomial = drawn.polynomial(&FreeRotor::default(), true);
        prop_assert!(polynomial[5..].iter().all(|c| *c == int(0)) && polynomial[1] == int(0) && polynomial[3] == int(0));
        let [_, [det, a, b]] = drawn.classical();
        prop_assert_eq!((polynomial[2] * det, polynomial[4] * det), (a, b));
    }

    /// The motor's polynomial is a combination of those of the two classical gyrostats.
    #[test]
    fn a_motor_combines_the_two_classical_polynomials(drawn in drawn()) {
        let machine = synchronous(&drawn);
        let found = drawn.polynomial(&machine, false);
        let [[det, ac, bc], [of_free, af, bf]] = drawn.classical();
        let axial = drawn.energies.axial;
        prop_assert_eq!(of_free, determinant(&(drawn.energies.tensor
            - drawn.energies.mixed * drawn.energies.mixed.transpose() / axial)));
        // A' z^2 (free) + (K + d z) (constant speed), times z^2 for the two integrals
        let (k, d) = (machine.b0 * drawn.place.angle.cos, machine.f);
        let sum = [axial * of_free, d * det, axial * af + k * det, d * ac, axial * bf + k * ac, d * bc, k * bc];
        for (place, c) in sum.iter().enumerate() {
            prop_assert_eq!(found[place] * axial * of_free, *c, "power {}", 6 - place);
        }
        prop_assert!(found[7..].iter().all(|c| *c == int(0)));
    }
}
