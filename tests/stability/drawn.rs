//! Verdicts for two hundred gyrostats composed of mass points with five motors each, compared with eigenvalues of the
//! compiled equations.

use crate::physical::{gyrostat, rounded};
use crate::running::{Law, eigenvalues, state};
use algebra::real::{Enclosure, Ordered, Root};
use dalembert_derivations::machines::asynchronous::Asynchronous;
use dalembert_derivations::machines::multi_current::{MultiCurrent, Windings};
use dalembert_derivations::machines::synchronous::Synchronous;
use dalembert_derivations::studies::stationary::energies::{Energies, Kept};
use dalembert_derivations::studies::stationary::motor::{Angle, MotorStates, Slip};
use dalembert_derivations::studies::stationary::stability::judge::{Given, Judge};
use dalembert_derivations::studies::stationary::stability::{Approximation, Judged, Reason, StabilityVerdict};
use dalembert_derivations::systems::gyrostat::Gyrostat;
use field::{Circle, Rational, Scalar};
use mechanics::steady_rotations::{Body, Shape};
use motor::ConstantSpeed;
use motor::FreeRotor;
use motor::{Datum, Machine};
use nalgebra::Vector3;
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::{Config, RngSeed, TestRunner};
use std::collections::BTreeMap;
use std::fmt::Write;
use symbolic::Sym;

const GYROSTATS: usize = 200;

/// An eigenvalue this close to the imaginary axis, relative to the largest one, cannot be distinguished in
/// floating-point numbers from one on the axis: for a conservative system, where pairs may be close, and for a damped
/// one.
const NEAR: [f64; 2] = [1e-6, 1e-10];

/// The common data of the five motors of a gyrostat; a motor with an angle has tan(g/2) = -1/10.
#[derive(Clone, Copy)]
struct Data {
    speed: i64,
    stiffness: Rational,
    friction: Rational,
}

const HALF_TANGENT: (i64, i64) = (-1, 10);

impl Data {
    fn angle() -> Rational {
        Rational::new(HALF_TANGENT.0, HALF_TANGENT.1)
    }

    fn synchronous<P: Scalar>(self, number: impl Fn(Rational) -> P) -> Synchronous<P> {
        // -b0 sin g = f W
        let sine = Circle::from_half_tangent(Data::angle()).sin;
        let f = -self.stiffness * sine / Rational::int(self.speed);
        Synchronous { field_speed: number(Rational::int(self.speed)), b0: number(self.stiffness), f: number(f) }
    }

    fn asynchronous<P: Scalar>(self, number: impl Fn(Rational) -> P) -> Asynchronous<P> {
        let field_speed = number(Rational::int(self.speed));
        Asynchronous { field_speed, k: number(self.friction), f: number(Rational::int(0)) }
    }

    fn wound<P: Datum>(self, number: impl Fn(Rational) -> P) -> MultiCurrent<P> {
        let Synchronous { field_speed, b0, f } = self.synchronous(&number);
        let of = |n: i64, d: i64| number(Rational::new(n, d));
        let windings = Windings {
            field_speed,
            b0,
            a1: of(3, 10),
            l1: of(1, 20),
            r1: of(7, 5),
            a2: of(1, 5),
            l2: of(1, 30),
            r2: of(2, 1),
            mu: number(Rational::int(0)),
            f,
        };
        let bar = Circle::from_half_tangent(Rational::new(1, 3));
        MultiCurrent { windings, bars: vec![bar.map(&number)] }
    }

    fn in_step(self) -> MotorStates {
        let angle = |t: Rational, slope: i32| Angle { half_tangent: Root::rational(t), slope, currents: vec![] };
        let speed = Root::rational(Rational::int(self.speed)).unwrap();
        let one = Rational::int(1);
        MotorStates::InStep {
            speed,
            angles: vec![angle(Data::angle(), -1), angle(one / Data::angle(), 1)],
            bears: None,
            fed: false,
        }
    }

    fn by_slip(self) -> MotorStates {
        let speed = Root::rational(Rational::int(self.speed)).unwrap();
        MotorStates::Slipping { speeds: vec![Slip { speed, slope: -1, currents: vec![] }], extremes: vec![] }
    }
}

/// A gyrostat that rotates at w, with a value of the rotor's constant quantity.
struct Turning<'a> {
    bodies: &'a Gyrostat<Rational>,
    kept: Kept,
    value: Rational,
    w: Rational,
}

/// The number of occurrences of each verdict, and of cases that floating-point numbers cannot decide.
#[derive(Default)]
struct Counts {
    verdicts: BTreeMap<String, usize>,
    open: usize,
}

impl Turning<'_> {
    /// The verdicts for each motion and each angle, compared with the eigenvalues.
    fn verdicts<M: Machine<f64>>(
        &self,
        motor: &MotorStates,
        exact: &impl Machine<Sym>,
        running: M,
        counts: &mut Counts,
    ) -> Vec<Vec<Judged>> {
        let energies = Energies::of(self.bodies);
        let (tensor, share) = energies.quadratic(self.kept);
        let value = Root::rational(self.value).unwrap();
        let body = Body::new(&tensor, &share, &value, &energies.weight).unwrap();
        let approximation = Approximation::with(&energies, exact).unwrap();
        let judge = Judge {
            approximation: &approximation,
            energies: &energies,
            motor,
            kept: self.kept,
            value: &value,
            given: Given::Speed(self.w),
        };
        let all = body.rotations(self.w).unwrap();
        let floats = rounded(self.bodies);
        let (form, axes) = floats.second_form();
        let law = Law::new(form, running);
        let isolated = all.motions.iter().filter(|one| matches!(one.shape, Shape::Point | Shape::Pair { .. }));
        let each = isolated.map(|motion| {
            let speed = |bits| Enclosure::integer(1, bits).fraction(self.w);
            let judged = judge.verdicts(&|bits| Some((motion.direction(bits)?, speed(bits)?)));
            let v = Vector3::from(motion.direction(80).unwrap().each_ref().map(Enclosure::to_f64));
            let w0 = self.w.to_f64();
            let rotor_speed = match self.kept {
                Kept::RelativeSpeed => self.value.to_f64(),
                Kept::Momentum => {
                    let carried = energies.mixed.map(Rational::to_f64).dot(&v) * w0;
                    (self.value.to_f64() - carried) / energies.axial.to_f64()
                }
            };
            for (place, one) in judged.iter().enumerate() {
                let angle = match motor {
                    MotorStates::InStep { angles, .. } => angles[place].radians(),
                    _ => 0.0,
                };
                let state = state(&law, axes.transpose() * v, w0, rotor_speed, angle);
                compare(one, &eigenvalues(&law, &state), counts);
            }
            judged
        });
        each.collect()
    }
}

fn compare(judged: &Judged, eigenvalues: &[(f64, f64)], counts: &mut Counts) {
    assert!(judged.is_consistent(), "{judged:?}");
    assert_ne!(judged.verdict, StabilityVerdict::CannotTell(Reason::NotStationary), "{judged:?}");
    *counts.verdicts.entry(named(judged.verdict)).or_default() += 1;
    let Some(roots) = judged.roots else { return };
    let size = eigenvalues.iter().map(|(re, im)| re.hypot(*im)).fold(0.0, f64::max);
    let near = size * if judged.conservative { NEAR[0] } else { NEAR[1] };
    let right = eigenvalues.iter().filter(|(re, _)| *re > near).count();
    let left = eigenvalues.iter().filter(|(re, _)| *re < -near).count();
    let sure = if judged.conservative {
        right == roots.right
    } else {
        left + right + judged.integrals.len() + roots.axis == eigenvalues.len()
    };
    if !sure {
        counts.open += 1;
        assert!(right <= roots.right && left <= roots.left, "{judged:?} {eigenvalues:?}");
        return;
    }
    assert_eq!((left, right), (roots.left, roots.right), "{judged:?} {eigenvalues:?}");
}

fn named(verdict: StabilityVerdict) -> String {
    match verdict {
        StabilityVerdict::Stable => "stable".into(),
        StabilityVerdict::AsymptoticallyStableModuloIntegrals => "asymptotically stable".into(),
        StabilityVerdict::Unstable { right } => format!("unstable, {right} to the right"),
        StabilityVerdict::CannotTell(Reason::Gyroscopic { negative }) => {
            format!("on the axis, {negative} negative squares")
        }
        StabilityVerdict::CannotTell(reason) => format!("{reason:?}"),
    }
}

#[test]
fn every_count_is_that_of_floats_and_a_motor_leaves_what_the_energy_holds() {
    let mut runner = TestRunner::new(Config { rng_seed: RngSeed::Fixed(1877), ..Config::default() });
    let drawn = (gyrostat(), -80..=80i64, 5..=90i64, 1..40i64, 1..40i64);
    let names = ["constant speed", "free rotor", "asynchronous", "synchronous", "with two currents"];
    let mut all: Vec<Counts> = names.iter().map(|_| Counts::default()).collect();
    for k in 0..GYROSTATS {
        let (bodies, w, speed, stiffness, friction) = drawn.new_tree(&mut runner).unwrap().current();
        let data = Data { speed, stiffness: Rational::new(stiffness, 4), friction: Rational::new(friction, 20) };
        let (constant, float) = (|x: Rational| Sym::constant(x), |x: Rational| x.to_f64());
        let turning = Turning {
            bodies: &bodies,
            kept: Kept::RelativeSpeed,
            value: Rational::int(speed),
            w: Rational::new(w, 10),
        };
        let root = Root::rational(Rational::int(speed)).unwrap();
        let exact = ConstantSpeed { speed: constant(Rational::int(speed)) };
        let running = ConstantSpeed { speed: speed as f64 };
        let kept = turning.verdicts(&MotorStates::Kept { speed: root }, &exact, running, &mut all[0]);
        let spin = Energies::of(&bodies).axial * Rational::int(speed);
        let own = Turning { kept: Kept::Momentum, value: spin, ..turning };
        own.verdicts(&MotorStates::Free, &FreeRotor::<Sym>::default(), FreeRotor::<f64>::default(), &mut all[1]);
        let (exact, running) = (data.asynchronous(constant), data.asynchronous(float));
        let slipping = turning.verdicts(&data.by_slip(), &exact, running, &mut all[2]);
        let (exact, running) = (data.synchronous(constant), data.synchronous(float));
        let in_step = turning.verdicts(&data.in_step(), &exact, running, &mut all[3]);
        let wound = (k % 4 == 0).then(|| {
            let (exact, running) = (data.wound(constant), data.wound(float));
            turning.verdicts(&data.in_step(), &exact, running, &mut all[4])
        });
        for (place, kept) in kept.iter().enumerate() {
            let [one] = &kept[..] else { panic!("one verdict at constant speed") };
            let motors =
                [&slipping[place][0], &in_step[place][0]].into_iter().chain(wound.iter().map(|w| &w[place][0]));
            for with_motor in motors {
                agrees(one, with_motor.verdict, bodies.gravity == Rational::int(0));
            }
        }
    }
    let mut page = format!("{GYROSTATS} gyrostats; every motion with one angular velocity, every angle of the rotor\n");
    for (name, counts) in names.iter().zip(&all) {
        let number: usize = counts.verdicts.values().sum();
        assert!(counts.open * 20 <= number, "floats could not count {} of {number} with {name}", counts.open);
        let _ = writeln!(page, "\n{name}");
        for (verdict, count) in &counts.verdicts {
            let _ = writeln!(page, "  {verdict:<34} {count:>5}");
        }
    }
    insta::with_settings!({ snapshot_path => "../../snapshots/stability", prepend_module_to_snapshot => false, omit_expression => true },
        { insta::assert_snapshot!("drawn", page) });
}

/// Stability by energy at constant speed becomes asymptotic with a motor; stability by gyroscopic forces only is lost
/// with a motor. Without weight no motor responds to a tilt in space, so that it does not decay; a maximum of the
/// energy is unstable with a motor.
fn agrees(kept: &Judged, with_motor: StabilityVerdict, balanced: bool) {
    let negative = kept.energy.map_or(0, |energy| energy.negative);
    let expected = match kept.verdict {
        StabilityVerdict::Stable if balanced && negative > 0 => StabilityVerdict::Unstable { right: negative },
        StabilityVerdict::Stable if balanced => StabilityVerdict::Stable,
        StabilityVerdict::CannotTell(Reason::Gyroscopic { .. }) if balanced => {
            assert!(!matches!(
                with_motor,
                StabilityVerdict::AsymptoticallyStableModuloIntegrals | StabilityVerdict::Stable
            ));
            return;
        }
        StabilityVerdict::Stable => StabilityVerdict::AsymptoticallyStableModuloIntegrals,
        StabilityVerdict::CannotTell(Reason::Gyroscopic { negative }) => StabilityVerdict::Unstable { right: negative },
        StabilityVerdict::Unstable { .. } => {
            assert!(matches!(with_motor, StabilityVerdict::Unstable { .. }), "{with_motor:?}");
            return;
        }
        other => panic!("{other:?} in general position"),
    };
    assert_eq!(with_motor, expected, "at constant speed {kept:?}");
}
