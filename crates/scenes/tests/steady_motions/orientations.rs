//! Steady motions of free bodies, compared with the roots of one polynomial.

use super::asked;
use algebra::real::Root;
use dalembert_scenes::steady_motions::{
    Along, Change, EnclosedSpectrum, EnclosedVerdict, Orientation, Range, SteadyMotion, SteadyMotions, SteadySearch,
    SteadyStability,
};
use dalembert_scenes::{Task, parse_with_source};
use field::Rational;
use mechanics::steady_rotations::Body;
use nalgebra::{Matrix3, Vector3};
use std::sync::Arc;

/// The steady motions for all sets of angles.
fn found(text: &str, ranges: &[(&str, f64, f64)]) -> Vec<(Orientation, SteadyMotions)> {
    let (_, model, source) =
        parse_with_source("scene.toml", text, Task::Vary).unwrap_or_else(|error| panic!("{error}"));
    let all = Orientation::all(&source, &model, &asked(ranges, 50_000)).unwrap_or_else(|why| panic!("{why:?}"));
    let all = SteadyMotions::of_orientations(all, || true).unwrap_or_else(|why| panic!("{why:?}"));
    all.into_iter().flat_map(|(own, cases)| cases.into_iter().map(move |(_, found)| (own.clone(), found))).collect()
}

/// A gyrostat about a fixed point, in integers: centre of mass in cm, moments of inertia in g m^2, speed of the wheel in rad/s.
struct Gyrostat {
    centre: [i64; 3],
    moments: [i64; 6],
    speed: i64,
}

impl Gyrostat {
    fn text(&self) -> String {
        let Gyrostat { centre: [a, b, c], moments: [xx, yy, zz, xy, xz, yz], .. } = self;
        format!(
            "title = \"Gyrostat\"\ngravity = \"-g*N.z\"\n[parameters]\ng = \"10 m/s^2\"\n[coordinates]\nphi = \"rad\"\n[frames]\nF = \"N free\"\n\
             R = \"F turned phi about z\"\n[points]\nG = \"O + ({a} cm)*F.x + ({b} cm)*F.y + ({c} cm)*F.z\"\n\
             [bodies.carrier]\nframe = \"F\"\ncentre = \"G\"\nmass = \"2 kg\"\n\
             inertia = {{ xx = \"{xx} g m^2\", yy = \"{yy} g m^2\", zz = \"{zz} g m^2\", xy = \"{xy} g m^2\", xz = \"{xz} g m^2\", yz = \"{yz} g m^2\" }}\n\
             [bodies.wheel]\nframe = \"R\"\ncentre = \"O\"\nmass = \"1 kg\"\ninertia = {{ principal = [\"3 g m^2\", \"3 g m^2\", \"5 g m^2\"] }}\n\
             [run]\nspan = \"1 s\"\n"
        )
    }

    /// The directions of the vertical in the body in all steady motions, from the polynomial of the multiplier.
    fn directions(&self, turning: i64) -> Vec<Vector3<f64>> {
        let milli = |number: i64| Rational::new(number, 1_000);
        let [xx, yy, zz, xy, xz, yz] = self.moments;
        // m (c.c - c c^T) for 2 kg and centimetres: 2 kg cm^2 = 0.2 g m^2
        let own = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        let c = self.centre;
        let square: i64 = c.iter().map(|part| part * part).sum();
        let wheel = [3, 3, 5];
        let tensor = Matrix3::from_fn(|i, j| {
            let unit = i64::from(i == j);
            let steiner = Rational::new(2 * (square * unit - c[i] * c[j]), 10_000);
            milli(own[i][j] + unit * wheel[i]) + steiner
        });
        // 2 kg times 10 m/s^2 times centimetres, downwards
        let weight = Vector3::from_fn(|i, _| Rational::new(-20 * c[i], 100));
        let momentum = Vector3::new(milli(0), milli(0), milli(5));
        let speed = Root::rational(Rational::new(self.speed, 1)).expect("a number");
        let body = Body::new(&tensor, &momentum, &speed, &weight).expect("all are numbers");
        let rotations = body.rotations(Rational::new(turning, 1)).expect("a number");
        let boxes = rotations.boxes(60).expect("they are told apart");
        boxes.into_iter().map(|own| Vector3::from_fn(|i, _| own[i].to_f64())).collect()
    }
}

/// Random gyrostats, at rest and rotating: the search and the polynomial give equal numbers of motions in equal directions. `GYROSTATS=1000` tests
/// more than twelve.
#[test]
fn a_free_gyrostat_has_the_motions_of_its_polynomial() {
    let mut seed = 7_u64;
    let mut next = |most: i64| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((seed >> 33) % (2 * most as u64 + 1)) as i64 - most
    };
    let count = std::env::var("GYROSTATS").map_or(12, |count| count.parse().expect("GYROSTATS is a number"));
    for _ in 0..count {
        let own = Gyrostat {
            centre: std::array::from_fn(|_| next(12)),
            moments: [60 + next(15), 60 + next(15), 60 + next(15), next(6), next(6), next(6)],
            speed: next(90),
        };
        let turning = next(12);
        let expected = own.directions(turning);
        let (w, speed) = (turning as f64, own.speed as f64);
        let all = found(&own.text(), &[("F.precession'", w, w), ("phi'", speed, speed)]);
        assert!(all.iter().all(|(_, found)| found.is_complete() && found.families.is_empty()), "{}", own.text());
        let mut directions: Vec<Vector3<f64>> = all
            .iter()
            .flat_map(|(orientation, found)| found.motions.iter().map(|motion| orientation.vertical(motion)))
            .collect();
        assert_eq!(directions.len(), expected.len(), "{} {turning}: {directions:?} {expected:?}", own.text());
        for one in expected {
            let (place, off) = directions
                .iter()
                .map(|own| (own - one).norm())
                .enumerate()
                .min_by(|a, b| a.1.total_cmp(&b.1))
                .expect("one is left");
            assert!(off < 1e-9, "{} {turning}: {off}", own.text());
            directions.remove(place);
        }
    }
}

/// A heavy body is at rest with its centre of mass below the fixed point, stable, and above it, unstable, for any axes of the body.
#[test]
fn a_heavy_body_rests_hanging_and_upright() {
    for centre in ["(3 cm)*F.x + (4 cm)*F.y", "(5 cm)*F.z", "(-2 cm)*F.y + (5 cm)*F.z"] {
        let text = format!(
            "title = \"Body\"\ngravity = \"-(9.81 m/s^2)*N.y\"\n[frames]\nF = \"N free\"\n[points]\nG = \"O + {centre}\"\n\
             [bodies.b]\nframe = \"F\"\ncentre = \"G\"\nmass = \"1 kg\"\ninertia = {{ principal = [\"2 g m^2\", \"3 g m^2\", \"4 g m^2\"] }}\n[run]\nspan = \"1 s\"\n"
        );
        let all = found(&text, &[]);
        assert!(all.iter().all(|(_, found)| found.is_complete()), "{centre}");
        let motions: Vec<_> = all.iter().flat_map(|(_, found)| &found.motions).collect();
        assert_eq!(motions.len(), 2, "{centre}: {motions:?}");
        let stable = motions.iter().filter(|own| matches!(own.stability, SteadyStability::Minimum)).count();
        assert_eq!(stable, 1, "{centre}: {motions:?}");
    }
}

/// A body rotates with its pivot about the vertical. Besides the vertical positions, inclined ones exist for w^2 > m g l/(B - C), and in a further plane
/// for w^2 > m g l/(A - C).
#[test]
fn a_turning_body_leaves_the_vertical_along_its_speed() {
    let text = "title = \"Body\"\ngravity = \"-(10 m/s^2)*N.z\"\n[frames]\nF = \"N free\"\n[points]\nG = \"O + (10 cm)*F.z\"\n\
        [bodies.b]\nframe = \"F\"\ncentre = \"G\"\nmass = \"1 kg\"\ninertia = { principal = [\"20 g m^2\", \"25 g m^2\", \"15 g m^2\"] }\n[run]\nspan = \"1 s\"\n";
    let (_, model, source) =
        parse_with_source("scene.toml", text, Task::Vary).unwrap_or_else(|error| panic!("{error}"));
    let asked = SteadySearch { text: Some(Arc::new(source)), ..asked(&[], 50_000) };
    let range = Range { from: 4.0, to: 9.0 };
    let along = Along::of(&model, &asked, ("F.precession'", range), 6, || true).unwrap_or_else(|why| panic!("{why:?}"));
    // about the pivot 0.03, 0.035 and 0.015 kg m^2: inclined motions appear at w^2 = m g l/(B - C) and m g l/(A - C)
    let thresholds = [(1.0_f64 / 0.02).sqrt(), (1.0_f64 / 0.015).sqrt()];
    let found: Vec<f64> = along.bifurcations.iter().map(|one| 0.5 * (one.before.value + one.after.value)).collect();
    assert!(along.bifurcations.iter().all(|one| one.change == Change::Pitchfork), "{found:?}");
    assert_eq!(found.len(), 2, "{found:?}");
    assert!(found.iter().zip(thresholds).all(|(own, known)| (own - known).abs() < 1e-4), "{found:?}");
    let counts: Vec<usize> = along.samples.iter().map(|sample| sample.found.motions.len()).collect();
    assert_eq!(counts, [2, 2, 2, 2, 4, 6]);
}

/// Without a range, the speed about the vertical is that component of the angular velocity at the start.
#[test]
fn the_speed_about_the_vertical_is_that_of_the_start() {
    let text = "title = \"Body\"\ngravity = \"-(10 m/s^2)*N.z\"\n[frames]\nF = \"N free\"\n[points]\nG = \"O + (10 cm)*F.x\"\n\
        [bodies.b]\nframe = \"F\"\ncentre = \"G\"\nmass = \"1 kg\"\ninertia = { principal = [\"20 g m^2\", \"25 g m^2\", \"15 g m^2\"] }\n\
        [start]\nF = \"60 deg about x\"\n\"F.wz\" = \"3 rad/s\"\n[run]\nspan = \"1 s\"\n";
    for (orientation, own) in found(text, &[]) {
        let given = own.given.iter().find(|(name, _)| name.ends_with(".precession'") || name.ends_with(".yaw'"));
        let speed = given.expect("it is given").1;
        assert!((speed - 1.5).abs() < 1e-14, "{speed} {:?}", orientation.in_words());
    }
}

/// Fast and slow precession of a top at a nutation of 60 degrees, cos n A p^2 - C r p + m g l = 0 with r = spin' + p cos n; the upright top sleeps at any
/// spin. The results do not depend on the axis of gravity.
#[test]
fn a_top_precesses_and_sleeps_however_space_is_turned() {
    let (moment, axial, weight) = (0.03_f64, 0.004, 1.0);
    for vertical in ["x", "y", "z"] {
        let text = format!(
            "title = \"Top\"\ngravity = \"-(10 m/s^2)*N.{vertical}\"\n[frames]\nF = \"N free\"\n[points]\nG = \"O + (10 cm)*F.z\"\n\
             [bodies.b]\nframe = \"F\"\ncentre = \"G\"\nmass = \"1 kg\"\ninertia = {{ principal = [\"20 g m^2\", \"20 g m^2\", \"4 g m^2\"] }}\n[run]\nspan = \"1 s\"\n"
        );
        // 60 degrees from the vertical is an elevation of 30 degrees, with a sign that depends on the order of the axes
        let (angle, from, to) = if vertical == "z" {
            ("F.nutation", 1.0471975511965976, 1.0471975511965976)
        } else {
            ("F.elevation", 0.0, 1.2)
        };
        let spin = 200.0;
        let ranges = [(angle, from, to), ("F.spin'", spin, spin), ("F.precession'", 0.01, 80.0)];
        let speeds: Vec<f64> = found(&text, &ranges)
            .iter()
            .flat_map(|(_, own)| own.motions.iter().map(|motion| motion.state[3]).collect::<Vec<_>>())
            .collect();
        if vertical == "z" {
            // (A - C) cos n p^2 - C spin' p + m g l = 0
            let (a, b) = ((moment - axial) * 0.5, axial * spin);
            let root = (b * b - 4.0 * a * weight).sqrt();
            let known = [(b - root) / (2.0 * a), (b + root) / (2.0 * a)];
            assert_eq!(speeds.len(), 2, "{speeds:?}");
            let is_there = |known: &f64| speeds.iter().any(|own| (own - known).abs() < 1e-6 * known);
            assert!(known.iter().all(is_there), "{speeds:?} {known:?}");
        }
        let asleep = found(&text, &[("F.spin'", spin, spin), ("F.precession'", 0.0, 0.0)]);
        let upright: Vec<Vector3<f64>> = asleep
            .iter()
            .flat_map(|(orientation, own)| {
                own.motions.iter().map(|motion| orientation.vertical(motion)).collect::<Vec<_>>()
            })
            .collect();
        assert_eq!(upright.len(), 2, "{vertical}: {upright:?}");
        assert!(upright.iter().all(|own| (own.z.abs() - 1.0).abs() < 1e-12), "{vertical}: {upright:?}");
    }
}

/// At a singular position of a set of angles the equations lose a torque balance; no false equilibrium is reported there.
#[test]
fn poles_of_the_angles_are_no_motions() {
    let text = "title = \"Body\"\ngravity = \"-(10 m/s^2)*N.z\"\n[frames]\nF = \"N free\"\n[points]\nG = \"O + (10 cm)*F.x + (5 cm)*F.y + (2 cm)*F.z\"\n\
        [bodies.b]\nframe = \"F\"\ncentre = \"G\"\nmass = \"1 kg\"\ninertia = { principal = [\"20 g m^2\", \"25 g m^2\", \"15 g m^2\"] }\n[run]\nspan = \"1 s\"\n";
    for range in [("F.nutation", 0.0, 3.2), ("F.pitch", -1.6, 1.6)] {
        let all = found(text, &[range]);
        let count: usize = all.iter().map(|(_, own)| own.motions.len()).sum();
        assert_eq!(count, 2, "{range:?}");
    }
}

/// A ball about its centre is at rest in every orientation: a family, bounded by the ranges of each set of angles.
#[test]
fn a_ball_rests_in_every_orientation() {
    let text = "title = \"Ball\"\n[frames]\nF = \"N free\"\n[bodies.b]\nframe = \"F\"\ncentre = \"O\"\nmass = \"1 kg\"\n\
        inertia = { principal = [\"20 g m^2\", \"20 g m^2\", \"20 g m^2\"] }\n[run]\nspan = \"1 s\"\n";
    let all = found(text, &[]);
    assert!(all.iter().any(|(_, own)| !own.families.is_empty()) && all.iter().all(|(_, own)| own.motions.is_empty()));
}

/// A ball that spins on a plane, with its centre of mass below or above its geometric centre. Its height is a coordinate, and the vertical component of
/// rolling follows from the contact.
const ROLLING: &str = r#"
title = "A ball that rolls"
gravity = "-(9.81 m/s^2)*N.z"
[coordinates]
x = "m"
y = "m"
z = "m"
[frames]
F = "N free"
[points]
E = "O + x*N.x + y*N.y + z*N.z"
K = "E - (10 cm)*N.z"
G = "E - (1 cm)*F.z"
[bodies.ball]
frame = "F"
centre = "G"
mass = "1 kg"
inertia = { principal = ["(3 g m^2)", "(4 g m^2)", "(5 g m^2)"] }
[[constraint]]
name = "rolling"
zero = "velocity(ball at K)"
[[constraint]]
name = "touching"
zero = "(K - O) . N.z"
[start]
z = "guess 0.1 m"
F = "10 deg about x"
"F.wz" = "2 rad/s"
[run]
span = "1 s"
"#;

#[test]
fn a_ball_that_rolls_spins_steadily_with_its_centre_of_mass_below_and_above() {
    let stability = |motion: &SteadyMotion| match &motion.stability {
        SteadyStability::Linear(found) => found.enclosed.as_ref().map(EnclosedSpectrum::verdict).ok(),
        _ => None,
    };
    let verdict_at = |from: f64, to: f64| {
        let all = found(ROLLING, &[("z", 0.05, 0.2), ("F.pitch", -0.5, 0.5), ("F.roll", from, to)]);
        let [(_, spins)] = &all[..] else { panic!("one set of angles is asked for: {}", all.len()) };
        let [motion] = &spins.motions[..] else { panic!("{:?}", spins.motions) };
        assert!(spins.is_complete());
        stability(motion)
    };
    assert_eq!(verdict_at(-0.5, 0.5), Some(EnclosedVerdict::Undecided { on_axis: 4, touching: 0 }));
    assert_eq!(verdict_at(2.6, 3.6), Some(EnclosedVerdict::Unstable(2)));
}

/// A sleeping top with a spin in its file: a given value is that of the whole rate about the vertical, to which the spin is not added.
#[test]
fn the_turn_about_the_common_axis_has_the_value_that_is_asked_for() {
    let text = "title = \"Top\"\ngravity = \"-(10 m/s^2)*N.z\"\n[frames]\nF = \"N free\"\n[points]\nG = \"O + (10 cm)*F.z\"\n\
                [bodies.top]\nframe = \"F\"\ncentre = \"G\"\nmass = \"1 kg\"\ninertia = { principal = [\"10 g m^2\", \"10 g m^2\", \"8 g m^2\"] }\n\
                [start]\n\"F.wz\" = \"40 rad/s\"\n[run]\nspan = \"1 s\"\n";
    // the centre of mass moves about O: A = 20 g m^2, stable for C w > sqrt(4 A m g h), w > 35.36 rad/s
    for (turn, unstable) in [(35.0, 2), (36.0, 0)] {
        let all = found(text, &[("F.yaw'", turn, turn)]);
        let right = |motion: &SteadyMotion| match &motion.stability {
            SteadyStability::Linear(own) => match own.enclosed.as_ref().map(EnclosedSpectrum::verdict) {
                Ok(EnclosedVerdict::Unstable(count)) => count,
                _ => 0,
            },
            _ => 0,
        };
        let counts: usize = all.iter().flat_map(|(_, found)| &found.motions).map(right).sum();
        assert_eq!(counts, unstable, "{turn}");
    }
}
