//! Families of motions of degenerate gyrostats: their verdicts beside the eigenvalues of the equations that run.

use crate::running::{Law, eigenvalues, run, state};
use derivations::machines::Machine;
use derivations::machines::asynchronous::Asynchronous;
use derivations::machines::constant_speed::ConstantSpeed;
use derivations::machines::free_rotor::FreeRotor;
use derivations::machines::synchronous::Synchronous;
use derivations::stationary::energies::{Energies, Kept};
use derivations::stationary::motor::{Angle, Motor, Slip};
use derivations::stationary::stability::along::{Along, Known};
use derivations::stationary::stability::judge::{Given, Judge};
use derivations::stationary::stability::{Approximation, Reason, Verdict};
use derivations::systems::gyrostat::forms::SecondForm;
use field::{Rational, Scalar};
use mechanics::uniform::{Body, Shape};
use nalgebra::{Matrix3, Vector3};
use symbolic::Sym;
use symbolic::real::{Enclosure, Root};

fn r(n: i64, d: i64) -> Rational {
    Rational::new(n, d)
}

/// A gyrostat in the principal axes of A*, with A' = 1/2.
#[derive(Clone, Copy)]
struct Top {
    moments: [i64; 3],
    axis: [Rational; 3],
    weight: [Rational; 3],
}

/// A rotor's machine: as formulas, as it runs, and its stationary states.
struct Driven<E, M> {
    exact: E,
    running: M,
    motor: Motor,
    kept: Kept,
    value: Rational,
}

fn constant(value: Rational) -> Sym {
    Sym::constant(value)
}

fn at_constant_speed(speed: Rational) -> Driven<ConstantSpeed<Sym>, ConstantSpeed<f64>> {
    Driven {
        exact: ConstantSpeed { speed: constant(speed) },
        running: ConstantSpeed { speed: speed.to_f64() },
        motor: Motor::Kept { speed: Root::rational(speed).unwrap() },
        kept: Kept::RelativeSpeed,
        value: speed,
    }
}

fn free(momentum: Rational) -> Driven<FreeRotor<Sym>, FreeRotor<f64>> {
    let (exact, running) = (FreeRotor::default(), FreeRotor::default());
    Driven { exact, running, motor: Motor::Free, kept: Kept::Momentum, value: momentum }
}

fn by_slip(speed: Rational) -> Driven<Asynchronous<Sym>, Asynchronous<f64>> {
    let slip = Slip { speed: Root::rational(speed).unwrap(), slope: -1, currents: Vec::new() };
    Driven {
        exact: Asynchronous { field_speed: constant(speed), k: Sym::ratio(3, 4), f: Sym::int(0) },
        running: Asynchronous { field_speed: speed.to_f64(), k: 0.75, f: 0.0 },
        motor: Motor::Slipping { speeds: vec![slip], extremes: Vec::new() },
        kept: Kept::RelativeSpeed,
        value: speed,
    }
}

/// With b0 = 1 and sin g = -3/5 at the angle that holds, 4/5 its cosine.
fn in_step(speed: Rational) -> Driven<Synchronous<Sym>, Synchronous<f64>> {
    let f = r(3, 5) / speed;
    let angle = |t: Rational, slope: i32| Angle { half_tangent: Root::rational(t), slope, currents: Vec::new() };
    Driven {
        exact: Synchronous { field_speed: constant(speed), b0: Sym::int(1), f: constant(f) },
        running: Synchronous { field_speed: speed.to_f64(), b0: 1.0, f: f.to_f64() },
        motor: Motor::InStep {
            speed: Root::rational(speed).unwrap(),
            angles: vec![angle(r(-1, 3), -1), angle(r(-3, 1), 1)],
            bears: None,
        },
        kept: Kept::RelativeSpeed,
        value: speed,
    }
}

const AXIAL: (i64, i64) = (1, 2);

impl Top {
    fn energies(&self) -> Energies<Rational> {
        let axial = r(AXIAL.0, AXIAL.1);
        Energies {
            tensor: Matrix3::from_diagonal(&Vector3::from(self.moments).map(Rational::int)),
            mixed: Vector3::from(self.axis) * axial,
            axial,
            weight: self.weight.into(),
        }
    }

    /// The families with one angular velocity; every arc and every edge is compared with the eigenvalues.
    fn families<E: Machine<Sym>, M: Machine<f64>>(
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
                    Motor::InStep { angles, .. } => angles[place].radians(),
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
                    // a zero that is repeated is no better than this
                    let count = |side: f64| found.iter().filter(|(re, _)| side * re > 1e-6).count();
                    assert_eq!((count(-1.0), count(1.0)), (roots.left, roots.right), "{:?} {found:?}", arc.judged);
                }
            }
            (family.shape, along)
        });
        each.collect()
    }
}

fn along(axis: [i64; 3]) -> [Rational; 3] {
    axis.map(|n| r(n, 1))
}

/// Rotor and weight along the axis of symmetry: on a circle with 2 w^2 cos = w A'W + 1.
fn lagrange() -> Top {
    Top { moments: [4, 4, 2], axis: along([0, 0, 1]), weight: along([0, 0, 1]) }
}

/// The rotor oblique to the axis of symmetry, the weight such that w = 2 and A'W = 5/2 leave the circle v3 = 3/5.
fn oblique(moments: [i64; 3]) -> Top {
    // w^2 (A3 - A1) v3 + w A'W l3 + G3 = 0
    let along = r(4 * (moments[0] - moments[2]) * 3, 5) - r(4, 1);
    Top { moments, axis: [r(3, 5), r(0, 1), r(4, 5)], weight: [r(-3, 1), r(0, 1), along] }
}

/// The verdicts on all arcs with one angle, and the directions that are apart.
fn told(along: &Along) -> (Vec<Verdict>, Vec<([f64; 3], Verdict)>) {
    let rounded = |v: Vector3<f64>| [v.x, v.y, v.z].map(|x| (x * 1e12).round() / 1e12 + 0.0);
    let edges = along.edges.iter().map(|edge| (rounded(edge.direction), edge.judged.verdict));
    (along.arcs.iter().map(|arc| arc.judged.verdict).collect(), edges.collect())
}

const ASYMPTOTIC: Verdict = Verdict::AsymptoticallyStableModuloIntegrals;

#[test]
fn a_symmetric_top_that_precesses_is_stable_as_a_family_with_every_motor_that_holds_its_angle() {
    let top = lagrange();
    let whole = |all: Vec<(Shape, Vec<Along>)>| -> Vec<Verdict> {
        let [(Shape::Circle { .. }, along)] = &all[..] else { panic!("one circle: {all:?}") };
        // the tangent of the circle is one more zero root, and one more integral goes with it
        let one = |along: &Along| {
            assert!(along.edges.is_empty() && along.arcs[0].judged.along == 1, "{along:?}");
            along.arcs[0].judged.verdict
        };
        along.iter().map(one).collect()
    };
    assert_eq!(whole(top.families(at_constant_speed(r(2, 1)), r(2, 1))), [Verdict::Stable]);
    assert_eq!(whole(top.families(free(r(1, 1)), r(2, 1))), [Verdict::Stable]);
    assert_eq!(whole(top.families(by_slip(r(2, 1)), r(2, 1))), [Verdict::Stable]);
    let in_step = whole(top.families(in_step(r(2, 1)), r(2, 1)));
    assert_eq!(in_step, [Verdict::Stable, Verdict::Unstable { right: 1 }]);
}

#[test]
fn beside_an_oblique_rotor_a_circle_is_stable_where_its_axis_has_the_smaller_moment() {
    // but for where the momentum is greatest and least along the circle
    let open = Verdict::CannotTell(Reason::Edge);
    let ends = [([-0.8, 0.0, 0.6], open), ([0.8, 0.0, 0.6], open)];
    let verdicts = |all: Vec<(Shape, Vec<Along>)>, angle: usize| -> Vec<Verdict> {
        let (arcs, mut edges) = told(&all[0].1[angle]);
        edges.sort_by(|a, b| a.0[0].total_cmp(&b.0[0]));
        assert_eq!((all.len(), &edges[..]), (1, &ends[..]));
        arcs
    };
    let top = oblique([4, 4, 2]);
    assert_eq!(verdicts(top.families(at_constant_speed(r(5, 1)), r(2, 1)), 0), [Verdict::Stable; 2]);
    assert_eq!(verdicts(top.families(by_slip(r(5, 1)), r(2, 1)), 0), [ASYMPTOTIC; 2]);
    assert_eq!(told(&top.families(in_step(r(5, 1)), r(2, 1))[0].1[0]).0, [ASYMPTOTIC; 2]);
    let flat = oblique([4, 4, 7]).families(at_constant_speed(r(5, 1)), r(2, 1));
    assert!(told(&flat[0].1[0]).0.iter().all(|one| matches!(one, Verdict::Unstable { .. })), "{flat:?}");
}

#[test]
fn a_ball_turns_about_any_direction_with_its_rotor_and_weight_in_balance() {
    let ball = Top { moments: [3, 3, 3], axis: along([0, 0, 1]), weight: along([0, 0, -2]) };
    let all = ball.families(at_constant_speed(r(2, 1)), r(2, 1));
    let [(Shape::Sphere, belts)] = &all[..] else { panic!("a sphere: {all:?}") };
    assert_eq!(told(&belts[0]).0, [Verdict::Stable]);
    assert_eq!(belts[0].arcs[0].judged.along, 1, "along the parallels");
}

#[test]
fn without_weight_the_size_of_the_momentum_makes_a_family_stable() {
    let weightless = Top { moments: [3, 4, 5], axis: [r(3, 5), r(0, 1), r(4, 5)], weight: along([0, 0, 0]) };
    let rests = weightless.families(at_constant_speed(r(2, 1)), r(0, 1));
    let (arcs, poles) = told(&rests[0].1[0]);
    assert_eq!((rests[0].0, &arcs[..]), (Shape::Sphere, &[Verdict::Stable][..]));
    assert!(poles.iter().all(|pole| pole.1 == Verdict::Stable), "{poles:?}");
    // a symmetric body turns about a circle of axes across its own
    let symmetric = Top { moments: [4, 4, 2], axis: along([0, 0, 1]), weight: along([0, 0, 0]) };
    for speed in [0, 2] {
        let all = symmetric.families(at_constant_speed(r(speed, 1)), r(2, 1));
        assert_eq!(told(&all[0].1[0]), (vec![Verdict::Stable], vec![]), "{all:?}");
    }
}

#[test]
fn a_family_that_is_stable_stays_near_and_one_that_is_not_leaves() {
    /// From w = 2 v with this v3.
    fn off(state: &[f64], v3: f64) -> f64 {
        let apart = (0..3).map(|i| (state[i] - 2.0 * state[3 + i]).powi(2)).sum::<f64>().sqrt();
        apart + (state[5] - v3).abs()
    }
    let push = |mut state: Vec<f64>| {
        state[0] += 8e-7;
        state[1] -= 5e-7;
        state
    };
    let law = |top: Top, speed: f64| {
        let floats = |v: [Rational; 3]| Vector3::from(v).map(Rational::to_f64);
        let moments = Vector3::from(top.moments).map(|n| n as f64);
        Law::new(SecondForm::new(moments, floats(top.axis), 0.5, floats(top.weight)), ConstantSpeed { speed })
    };
    let stays = law(lagrange(), 2.0);
    let at = state(&stays, Vector3::new((1.0f64 - 0.140625).sqrt(), 0.0, 0.375), 2.0, 2.0, 0.0);
    let after = run(&stays, push(at), 0.01, 10_000);
    assert!(off(&after, 0.375) < 1e-5, "{:e}", off(&after, 0.375));
    let leaves = law(oblique([4, 4, 7]), 5.0);
    let at = state(&leaves, Vector3::new(0.0, 0.8, 0.6), 2.0, 5.0, 0.0);
    let rate = eigenvalues(&leaves, &at).iter().map(|one| one.0).fold(0.0, f64::max);
    let after = run(&leaves, push(at), 0.01, (100.0 * 1e4f64.ln() / rate) as usize);
    assert!(rate > 0.05 && off(&after, 0.6) > 1e-4, "{rate} {:e}", off(&after, 0.6));
}
