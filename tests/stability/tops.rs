//! Degenerate gyrostats with a motor, whose steady motions form families: the verdict on each arc is compared with
//! eigenvalues of the compiled equations.

use crate::running::{Law, eigenvalues, state};
use algebra::real::{Enclosure, Root};
use dalembert_derivations::machines::asynchronous::Asynchronous;
use dalembert_derivations::machines::synchronous::Synchronous;
use dalembert_derivations::studies::stationary::energies::{Energies, Kept};
use dalembert_derivations::studies::stationary::motor::{Angle, MotorStates, Slip};
use dalembert_derivations::studies::stationary::stability::Approximation;
use dalembert_derivations::studies::stationary::stability::along::{Along, Known};
use dalembert_derivations::studies::stationary::stability::judge::{Given, Judge};
use dalembert_derivations::systems::gyrostat::forms::SecondForm;
use field::{Rational, Scalar};
use mechanics::steady_rotations::{Body, Shape};
use motor::ConstantSpeed;
use motor::FreeRotor;
use motor::Machine;
use nalgebra::{Matrix3, Vector3};
use symbolic::Sym;

pub fn r(n: i64, d: i64) -> Rational {
    Rational::new(n, d)
}

/// A gyrostat in the principal axes of A*, with A' = 1/2.
#[derive(Clone, Copy)]
pub struct Top {
    pub moments: [i64; 3],
    pub axis: [Rational; 3],
    pub weight: [Rational; 3],
}

/// A rotor's machine, in symbolic and in compiled form, and its steady states.
pub struct Driven<E, M> {
    exact: E,
    running: M,
    motor: MotorStates,
    kept: Kept,
    value: Rational,
}

fn constant(value: Rational) -> Sym {
    Sym::constant(value)
}

pub fn at_constant_speed(speed: Rational) -> Driven<ConstantSpeed<Sym>, ConstantSpeed<f64>> {
    Driven {
        exact: ConstantSpeed { speed: constant(speed) },
        running: ConstantSpeed { speed: speed.to_f64() },
        motor: MotorStates::Kept { speed: Root::rational(speed).unwrap() },
        kept: Kept::RelativeSpeed,
        value: speed,
    }
}

pub fn free(momentum: Rational) -> Driven<FreeRotor<Sym>, FreeRotor<f64>> {
    let (exact, running) = (FreeRotor::default(), FreeRotor::default());
    Driven { exact, running, motor: MotorStates::Free, kept: Kept::Momentum, value: momentum }
}

pub fn by_slip(speed: Rational) -> Driven<Asynchronous<Sym>, Asynchronous<f64>> {
    let slip = Slip { speed: Root::rational(speed).unwrap(), slope: -1, currents: Vec::new() };
    Driven {
        exact: Asynchronous { field_speed: constant(speed), k: Sym::ratio(3, 4), f: Sym::int(0) },
        running: Asynchronous { field_speed: speed.to_f64(), k: 0.75, f: 0.0 },
        motor: MotorStates::Slipping { speeds: vec![slip], extremes: Vec::new() },
        kept: Kept::RelativeSpeed,
        value: speed,
    }
}

/// A synchronous motor with b0 = 1 and sin g = -3/5, cos g = 4/5 at the stable angle.
pub fn in_step(speed: Rational) -> Driven<Synchronous<Sym>, Synchronous<f64>> {
    let f = r(3, 5) / speed;
    let angle = |t: Rational, slope: i32| Angle { half_tangent: Root::rational(t), slope, currents: Vec::new() };
    Driven {
        exact: Synchronous { field_speed: constant(speed), b0: Sym::int(1), f: constant(f) },
        running: Synchronous { field_speed: speed.to_f64(), b0: 1.0, f: f.to_f64() },
        motor: MotorStates::InStep {
            speed: Root::rational(speed).unwrap(),
            angles: vec![angle(r(-1, 3), -1), angle(r(-3, 1), 1)],
            bears: None,
            fed: false,
        },
        kept: Kept::RelativeSpeed,
        value: speed,
    }
}

/// A synchronous motor without friction, stable at g = 0 and unstable at g = pi.
pub fn without_friction(speed: Rational, b0: Rational) -> Driven<Synchronous<Sym>, Synchronous<f64>> {
    let held = Angle { half_tangent: Root::rational(r(0, 1)), slope: -1, currents: Vec::new() };
    let driven_away = Angle { half_tangent: None, slope: 1, currents: Vec::new() };
    Driven {
        exact: Synchronous { field_speed: constant(speed), b0: constant(b0), f: Sym::int(0) },
        running: Synchronous { field_speed: speed.to_f64(), b0: b0.to_f64(), f: 0.0 },
        motor: MotorStates::InStep {
            speed: Root::rational(speed).unwrap(),
            angles: vec![held, driven_away],
            bears: None,
            fed: false,
        },
        kept: Kept::RelativeSpeed,
        value: speed,
    }
}

const AXIAL: (i64, i64) = (1, 2);

impl Top {
    pub fn energies(&self) -> Energies<Rational> {
        let axial = r(AXIAL.0, AXIAL.1);
        Energies {
            tensor: Matrix3::from_diagonal(&Vector3::from(self.moments).map(Rational::int)),
            mixed: Vector3::from(self.axis) * axial,
            axial,
            weight: self.weight.into(),
        }
    }

    /// The families with one angular velocity; every arc and every boundary point is compared with the eigenvalues.
    pub fn families<E: Machine<Sym>, M: Machine<f64>>(
        &self,
        driven: Driven<E, M>,
        w: Rational,
    ) -> Vec<(Shape, Vec<Along>)> {
        let energies = self.energies();
        let (tensor, share) = energies.quadratic(driven.kept);
        let value = Root::rational(driven.value).unwrap();
        let body = Body::new(&tensor, &share, &value, &energies.weight).unwrap();
        let approximation = Approximation::with(&energies, &driven.exact).unwrap();
        let judge = Judge {
            approximation: &approximation,
            energies: &energies,
            motor: &driven.motor,
            kept: driven.kept,
            value: &value,
            given: Given::Speed(w),
        };
        let floats = |v: [Rational; 3]| Vector3::from(v).map(Rational::to_f64);
        let moments = Vector3::from(self.moments).map(|n| n as f64);
        let form = SecondForm::new(moments, floats(self.axis), 0.5, floats(self.weight));
        let law = Law::new(form, driven.running);
        let all = body.rotations(w).unwrap();
        let families = all.motions.iter().filter(|one| matches!(one.shape, Shape::Circle { .. } | Shape::Sphere));
        let each = families.map(|family| {
            let enclosed = |bits| Some((family.direction(bits)?, Enclosure::rational(w, bits)?));
            let axis = |bits| family.axis(bits);
            let along = judge.along(&Known { shape: family.shape, enclosed: &enclosed, axis: &axis });
            for (place, one) in along.iter().enumerate() {
                let angle = match &driven.motor {
                    MotorStates::InStep { angles, .. } => angles[place].radians(),
                    _ => 0.0,
                };
                for arc in &one.arcs {
                    let v = Vector3::from(arc.member.each_ref().map(Enclosure::to_f64));
                    let rotor_speed = match driven.kept {
                        Kept::RelativeSpeed => driven.value.to_f64(),
                        Kept::Momentum => {
                            let carried = energies.mixed.map(Rational::to_f64).dot(&v) * w.to_f64();
                            (driven.value.to_f64() - carried) / 0.5
                        }
                    };
                    let state = state(&law, v, w.to_f64(), rotor_speed, angle);
                    let found = eigenvalues(&law, &state);
                    let roots = arc.judged.roots.unwrap();
                    // a double zero eigenvalue is computed with this accuracy only
                    let count = |side: f64| found.iter().filter(|(re, _)| side * re > 1e-6).count();
                    assert_eq!((count(-1.0), count(1.0)), (roots.left, roots.right), "{:?} {found:?}", arc.judged);
                }
            }
            (family.shape, along)
        });
        each.collect()
    }
}

pub fn along(axis: [i64; 3]) -> [Rational; 3] {
    axis.map(|n| r(n, 1))
}

/// Rotor and weight along the axis of symmetry; the circle has 2 w^2 cos = w A'W + 1.
pub fn lagrange() -> Top {
    Top { moments: [4, 4, 2], axis: along([0, 0, 1]), weight: along([0, 0, 1]) }
}

/// The rotor oblique to the axis of symmetry, with the weight for which the circle with this v3 is steady at w and A'W.
pub fn circling(moments: [i64; 3], axis: [Rational; 3], v3: Rational, [w, spin]: [Rational; 2]) -> Top {
    // w^2 (A3 - A1) v3 + w A'W l3 + G3 = 0
    let along = w * w * Rational::int(moments[0] - moments[2]) * v3 - w * spin * axis[2];
    Top { moments, axis, weight: [-w * spin * axis[0], r(0, 1), along] }
}

/// A top with w = 2 and A'W = 5/2 on the circle v3 = 3/5.
pub fn oblique(moments: [i64; 3]) -> Top {
    circling(moments, [r(3, 5), r(0, 1), r(4, 5)], r(3, 5), [r(2, 1), r(5, 2)])
}
