//! Stability in closed form with exact data, including the stability boundaries.

use dalembert_derivations::machines::asynchronous::Asynchronous;
use dalembert_derivations::studies::scene::Scene;
use dalembert_derivations::studies::stationary::energies::Energies;
use dalembert_derivations::studies::stationary::motions::{Found, Stationary};
use dalembert_derivations::studies::stationary::stability::map::OneAxis;
use dalembert_derivations::studies::stationary::stability::reduced::{Fate, Reduced};
use dalembert_derivations::studies::stationary::stability::{Approximation, Judged, Reason, StabilityVerdict};
use field::{Rational, Scalar};
use motor::ConstantSpeed;
use motor::Machine;
use nalgebra::{Matrix3, Vector3};
use reader::Family;
use std::path::Path;
use symbolic::Sym;

fn r(n: i64, d: i64) -> Rational {
    Rational::new(n, d)
}

/// The data A* = (4, 9, 6), A' = 1/2, the rotor along a coordinate axis, the weight along the third one: 1 hanging, -1
/// upright.
struct Axes {
    rotor: [i64; 3],
    weight: i64,
}

const MOMENTS: [i64; 3] = [4, 9, 6];

impl Axes {
    fn energies(&self) -> Energies<Rational> {
        let axial = r(1, 2);
        Energies {
            tensor: Matrix3::from_diagonal(&Vector3::from(MOMENTS).map(Rational::int)),
            mixed: Vector3::from(self.rotor).map(Rational::int) * axial,
            axial,
            weight: Vector3::new(0, 0, self.weight).map(Rational::int),
        }
    }

    fn judged(&self, machine: &impl Machine<Sym>, w0: Rational, speed: Rational) -> Judged {
        let approximation = Approximation::with(&self.energies(), machine).unwrap();
        let (zero, one) = (r(0, 1), r(1, 1));
        Judged::at(&approximation, &[w0, zero, zero, one, speed, one, zero], &one, |x| x.to_f64())
    }

    /// A rotor with constant relative speed such that A' W = h.
    fn kept(&self, w0: Rational, h: Rational) -> Judged {
        let speed = h * r(2, 1);
        self.judged(&ConstantSpeed { speed: Sym::constant(speed) }, w0, speed)
    }

    /// An asynchronous motor with this steady speed.
    fn driven(&self, w0: Rational, h: Rational) -> Judged {
        let speed = h * r(2, 1);
        let field_speed = Sym::constant(speed);
        self.judged(&Asynchronous { field_speed, k: Sym::ratio(1, 9), f: Sym::int(0) }, w0, speed)
    }
}

const UPRIGHT: Axes = Axes { rotor: [0, 0, 1], weight: -1 };
const HANGING: Axes = Axes { rotor: [0, 0, 1], weight: 1 };

fn rest() -> Rational {
    r(0, 1)
}

#[test]
fn a_hanging_rest_is_stable_at_every_speed_of_the_rotor() {
    for h in [r(0, 1), r(1, 7), r(-40, 1)] {
        assert_eq!(HANGING.kept(rest(), h).verdict, StabilityVerdict::Stable);
        // a rotor along the vertical does not respond to a tilt: stable, but tilts do not decay
        assert_eq!(HANGING.driven(rest(), h).verdict, StabilityVerdict::Stable);
        let across = Axes { rotor: [1, 0, 0], weight: 1 };
        assert_eq!(across.kept(rest(), h).verdict, StabilityVerdict::Stable);
    }
}

#[test]
fn a_rotor_along_the_vertical_holds_it_upright_from_the_known_speed_on() {
    // (A' W)^2 = Gamma (2 + 3)^2
    let at = |h: Rational| UPRIGHT.kept(rest(), h);
    let fast = at(r(5_000_001, 1_000_000));
    assert_eq!(fast.verdict, StabilityVerdict::CannotTell(Reason::Gyroscopic { negative: 2 }));
    assert_eq!(fast.roots.map(|roots| (roots.axis, roots.distinct)), Some((4, 4)));
    assert_eq!(at(r(4_999_999, 1_000_000)).verdict, StabilityVerdict::Unstable { right: 2 });
    // exactly at this value the two pairs of eigenvalues coincide
    let edge = at(r(5, 1)).roots.unwrap();
    assert_eq!((edge.axis, edge.distinct), (4, 2));
}

#[test]
fn a_motor_along_the_vertical_does_not_feel_the_tilt_and_leaves_the_count_as_it_is() {
    let driven = UPRIGHT.driven(rest(), r(6, 1));
    assert_eq!(driven.verdict, StabilityVerdict::CannotTell(Reason::Gyroscopic { negative: 2 }));
    assert_eq!(driven.roots.map(|roots| (roots.left, roots.axis)), Some((1, 4)));
    assert_eq!(UPRIGHT.driven(rest(), r(4, 1)).verdict, StabilityVerdict::Unstable { right: 2 });
}

#[test]
fn a_rotor_across_the_vertical_never_holds_it() {
    let across = Axes { rotor: [1, 0, 0], weight: -1 };
    for h in [0, 1, 3, 40, 1000] {
        assert!(matches!(across.kept(rest(), r(h, 1)).verdict, StabilityVerdict::Unstable { .. }), "{h}");
    }
}

#[test]
fn where_a_tilt_costs_nothing_a_further_root_is_zero_and_nothing_is_said() {
    // H1 = w^2 (A3 - A1) + w h - Gamma = 2 - 1 - 1
    let judged = UPRIGHT.kept(r(1, 1), r(-1, 1));
    assert_eq!(judged.verdict, StabilityVerdict::CannotTell(Reason::Neutral));
    assert_eq!(judged.energy.map(|energy| energy.zero), Some(1));
}

#[test]
fn the_reduced_signs_are_those_of_the_whole() {
    let energies = UPRIGHT.energies();
    for (w, h) in [(0, 4), (0, 5), (0, 6), (1, -1), (1, 1), (1, 9), (2, 3), (-3, 8), (-1, 30), (3, -14)] {
        let (w0, h) = (r(w, 1), r(h, 1));
        let vertical = Vector3::new(r(0, 1), r(0, 1), r(1, 1));
        let multiplier = w0 * (w0 * Rational::int(MOMENTS[2]) + h) + r(UPRIGHT.weight, 1);
        let motion = Reduced { tensor: energies.tensor, spin: vertical * h, speed: w0, vertical, multiplier };
        let fate = Fate::of(&motion, |x: Rational| x.sign().unwrap());
        let expected = match UPRIGHT.kept(w0, h) {
            Judged { verdict: StabilityVerdict::Stable, .. } => Fate::ByEnergy,
            Judged { verdict: StabilityVerdict::Unstable { .. }, .. } => Fate::Unstable,
            Judged { roots: Some(roots), .. } if roots.distinct == 4 => Fate::ByGyroscopes,
            _ => Fate::Edge,
        };
        assert_eq!(fate, expected, "{w} {h}");
    }
}

#[test]
fn a_scene_with_an_irrational_angle_is_judged_exactly_where_motors_feel_nothing() {
    let scene = Scene::open(Path::new("scenes/closed_forms/upright_rotation.toml")).unwrap();
    let all = Stationary::of(&scene).unwrap().at_speed(2.0).unwrap();
    let upright: Vec<&Found> = all[0].found.iter().filter(|found| found.direction.z.abs() == 1.0).collect();
    assert_eq!(upright.len(), 2);
    for found in upright {
        for judged in &found.stability {
            assert_ne!(judged.verdict, StabilityVerdict::CannotTell(Reason::TooFine), "{judged:?}");
            assert!(judged.roots.is_some());
        }
    }
}

#[test]
fn a_motion_that_is_none_is_refused() {
    let tilted = Axes { rotor: [1, 0, 0], weight: -1 };
    let judged = tilted.kept(r(1, 1), r(2, 1));
    assert_eq!(judged.verdict, StabilityVerdict::CannotTell(Reason::NotStationary));
}

#[test]
fn the_map_of_one_axis_has_its_edges_where_the_closed_forms_say() {
    // at rest: pairs of eigenvalues merge at A' W = +-5, and separate again at +-1: (h^2 - 25)(h^2 - 1) = 0
    let axis = OneAxis::of(&UPRIGHT.energies(), false).unwrap();
    let column = axis.column(rest());
    let edges: Vec<f64> = column.edges.iter().map(|edge| edge.at).collect();
    assert_eq!(edges, [-10.0, -2.0, 2.0, 10.0]);
    let all = [Fate::ByGyroscopes, Fate::Unstable, Fate::Unstable, Fate::Unstable, Fate::ByGyroscopes];
    assert_eq!(column.fates, all);
    // rotating at w0 = 1: H1 = 1 + h, H2 = h - 4, and stable by energy beyond both zeros
    let column = axis.column(r(1, 1));
    let neutral: Vec<f64> = column.edges.iter().filter(|edge| edge.neutral).map(|edge| edge.at).collect();
    assert_eq!(neutral, [-2.0, 8.0]);
    assert_eq!((column.at(8.1), column.at(0.0)), (Fate::ByEnergy, Fate::Unstable));
    assert!(OneAxis::of(&Axes { rotor: [1, 0, 0], weight: 1 }.energies(), true).is_none());
}
