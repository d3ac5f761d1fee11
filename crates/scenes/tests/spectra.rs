//! Enclosed eigenvalues at steady motions, and Routh's criterion in exact arithmetic, compared with closed forms and published values.

use dalembert_scenes::ModelScene;
use dalembert_scenes::steady_motions::{EnclosedSpectrum, EnclosedVerdict, ExactAlong, NotEnclosed, Side, ZeroReason};

fn near(text: &str) -> Result<EnclosedSpectrum, NotEnclosed> {
    let scene = ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"));
    EnclosedSpectrum::near(&scene.model, &scene.start, || true)
}

fn spectrum(text: &str) -> EnclosedSpectrum {
    near(text).unwrap_or_else(|why| panic!("{why}"))
}

const BICYCLE: &str = include_str!("../../../scenes/foreign/bicycle.toml");

/// The eigenvalues of the upright bicycle at a speed in m/s.
fn bicycle(speed: f64) -> EnclosedSpectrum {
    let upright = BICYCLE.replace("lean = \"0.05 rad\"", "lean = \"0 rad\"");
    spectrum(&upright.replace("\"-16.6 rad/s\"", &format!("\"{:?} rad/s\"", -speed / 0.3)))
}

fn cyclic(names: &[&str]) -> Vec<ZeroReason> {
    names.iter().map(|name| ZeroReason::Cyclic((*name).to_owned())).collect()
}

/// Meijaard et al. 2007: weave becomes stable at 4.29238253634111 m/s, capsize unstable at 6.02426201538837 m/s.
#[test]
fn whipples_bicycle_weaves_and_capsizes_at_the_published_speeds() {
    let verdicts = [4.29238253634110, 4.29238253634112, 6.02426201538834, 6.02426201538840].map(|speed| {
        let found = bicycle(speed);
        assert_eq!(found.zeros, [cyclic(&["x", "y", "yaw", "rear", "front"]), vec![ZeroReason::Energy]].concat());
        found.verdict()
    });
    use EnclosedVerdict::{Asymptotic, Unstable};
    assert_eq!(verdicts, [Unstable(2), Asymptotic, Asymptotic, Unstable(1)]);
}

#[test]
fn published_eigenvalues_of_the_bicycle_lie_in_their_discs() {
    let found = bicycle(5.0);
    let known = [[-0.322866429004087, 0.0], [-0.775341882195842, 4.46486771378823], [-14.0783896927982, 0.0]];
    for [re, im] in known {
        let is_near = |disc: &[f64; 2]| (disc[0] - re).hypot(disc[1] - im) < 5e-14 * (1.0 + re.abs());
        assert!(found.discs.iter().any(|disc| is_near(&disc.centre) && disc.radius < 1e-13), "{:?}", found.discs);
    }
}

fn plane(energies: &str, forces: &str) -> String {
    format!(
        "title = \"Plane\"\n[parameters]\nm = \"1 kg\"\nk = \"1 N/m\"\nd = \"0.1 N s/m\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n\
         [energies]\n{energies}\n{forces}[run]\nspan = \"1 s\"\n"
    )
}

/// A damped plane oscillator with a circulatory force (s y, -s x): stable for s < d sqrt(c/m).
#[test]
fn a_circulatory_force_is_judged_exactly_beside_its_closed_form() {
    // m x'' = -c x - d x' + s y, m y'' = -c y - d y' - s x: unstable for s > d sqrt(c/m), here with c = 1, d = 1/10
    let verdict = |s: &str| {
        let force = |along: &str, is: &str| format!("[[force]]\nalong = \"{along}\"\nis = \"{is}\"\n");
        let forces = force("x", &format!("-d*x' + ({s} N/m)*y")) + &force("y", &format!("-d*y' - ({s} N/m)*x"));
        let found = spectrum(&plane("kinetic = \"m/2*(x'^2 + y'^2)\"\npotential = \"k/2*(x^2 + y^2)\"", &forces));
        let exact = found.exact.expect("its numbers are decimals");
        ([exact.left, exact.axis, exact.right], found.verdict())
    };
    assert_eq!(verdict("0.0999999999999999"), ([4, 0, 0], EnclosedVerdict::Asymptotic));
    assert_eq!(verdict("0.1"), ([2, 2, 0], EnclosedVerdict::Undecided { on_axis: 2, touching: 0 }));
    assert_eq!(verdict("0.1000000000000001"), ([2, 0, 2], EnclosedVerdict::Unstable(2)));
}

/// An inverted pendulum with a torque -p theta - d theta': stable for p > m g l.
#[test]
fn an_inverted_pendulum_stands_by_a_torque_above_its_weight() {
    let verdict = |p: &str, d: &str| {
        let found = spectrum(&format!(
            "title = \"Upright\"\n[parameters]\nm = \"2 kg\"\nl = \"0.3 m\"\ng = \"9.81 m/s^2\"\n[coordinates]\ntheta = \"rad\"\n\
             [energies]\nkinetic = \"m/2*l^2*theta'^2\"\npotential = \"m*g*l*cos(theta)\"\n\
             [[force]]\nalong = \"theta\"\nis = \"-({p} N m)*theta - ({d} N m s)*theta'\"\n[run]\nspan = \"1 s\"\n"
        ));
        assert!(found.exact.is_some());
        found.verdict()
    };
    assert_eq!(verdict("5.8860001", "0.1"), EnclosedVerdict::Asymptotic);
    assert_eq!(verdict("5.8859999", "0.1"), EnclosedVerdict::Unstable(1));
    assert_eq!(verdict("7", "0"), EnclosedVerdict::Undecided { on_axis: 2, touching: 0 });
    // m g l = 5.886: a zero eigenvalue without a known reason
    assert_eq!(verdict("5.886", "0.1"), EnclosedVerdict::Undecided { on_axis: 0, touching: 1 });
}

/// A cyclic coordinate y beside an oscillator x: its momentum is conserved without a brake and not with one.
#[test]
fn zeros_of_cyclic_coordinates_have_their_reasons() {
    let with = |brake: &str| {
        spectrum(&plane(
            "kinetic = \"m/2*(x'^2 + y'^2)\"\npotential = \"k/2*x^2\"",
            &format!("{brake}[[force]]\nalong = \"x\"\nis = \"-d*x'\"\n"),
        ))
    };
    let free = with("");
    assert_eq!(free.zeros, [cyclic(&["y"]), vec![ZeroReason::Momentum("y".to_owned())]].concat());
    assert_eq!((free.discs.len(), free.verdict()), (2, EnclosedVerdict::Asymptotic));
    let braked = with("[[force]]\nalong = \"y\"\nis = \"-d*y'\"\n");
    assert_eq!((braked.zeros, braked.discs.len()), (cyclic(&["y"]), 3));
}

/// Positions of rest of a knife edge form a family: one zero eigenvalue for each nonintegrable constraint, and more by symmetry.
#[test]
fn constraints_of_speeds_leave_zeros_where_a_system_rests() {
    let sledge = "title = \"Edge\"\n[parameters]\nm = \"1 kg\"\nI = \"1 kg m^2\"\nk = \"1 N/m\"\nd = \"1 N s/m\"\nb = \"1 N m s\"\n\
        [coordinates]\nx = \"m\"\ny = \"m\"\na = \"rad\"\n[energies]\nkinetic = \"m/2*(x'^2 + y'^2) + I/2*a'^2\"\npotential = \"k/2*(x^2 + y^2)\"\n\
        [[force]]\nalong = \"x\"\nis = \"-d*x'\"\n[[force]]\nalong = \"a\"\nis = \"-b*a' - (1 N m)*a\"\n\
        [[constraint]]\nname = \"edge\"\nzero = \"y'*cos(a) - x'*sin(a)\"\n[run]\nspan = \"1 s\"\n";
    // the position at rest may change along the normal of the edge
    match near(sledge) {
        Ok(found) => {
            assert_eq!(found.zeros, [ZeroReason::SpeedConstraints], "{found:?}");
            assert_eq!(found.verdict(), EnclosedVerdict::Asymptotic);
        }
        Err(why) => panic!("{why}"),
    }
}

/// A conical pendulum has only imaginary pairs besides its zero eigenvalues.
#[test]
fn conservative_systems_have_pairs_on_the_axis() {
    let text = "title = \"Cone\"\n[parameters]\nm = \"1 kg\"\nl = \"1 m\"\ng = \"9.81 m/s^2\"\n[coordinates]\nphi = \"rad\"\ntheta = \"rad\"\n\
        [energies]\nkinetic = \"m/2*l^2*(theta'^2 + sin(theta)^2*phi'^2)\"\npotential = \"-m*g*l*cos(theta)\"\n\
        [start]\ntheta = \"1 rad\"\n\"phi'\" = \"4.261044729928317 rad/s\"\n[run]\nspan = \"1 s\"\n";
    let found = spectrum(text);
    assert_eq!(found.zeros, [cyclic(&["phi"]), vec![ZeroReason::Momentum("phi".to_owned())]].concat());
    assert!(found.discs.len() == 2 && found.discs.iter().all(|disc| disc.side == Side::Axis), "{found:?}");
    // omega^2 (1 + 3 cos^2 theta)
    let cos = 9.81 / 4.261044729928317_f64.powi(2);
    let frequency = 4.261044729928317 * (1.0 + 3.0 * cos * cos).sqrt();
    assert!((found.discs[0].centre[1] - frequency).abs() < 1e-12, "{found:?}");
}

fn along(text: &str, parameter: &str) -> ExactAlong {
    let scene = ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"));
    ExactAlong::of(&scene.model, &scene.start, parameter).unwrap_or_else(|why| panic!("{why}"))
}

fn right(along: &ExactAlong) -> Vec<usize> {
    along.counts.iter().map(|count| count.right).collect()
}

/// Watt's governor to first order, x'' = -b x' - k x + s w, w' = -r x: stable for b k > s r (Vyshnegradsky 1877).
#[test]
fn a_governor_is_stable_by_vyshnegradskys_condition() {
    let text = "title = \"Governor\"\n[parameters]\nb = \"1 N s/m\"\nk = \"4 N/m\"\ns = \"2 N s\"\nr = \"3 N\"\n[coordinates]\nx = \"m\"\nphi = \"rad\"\n\
        [energies]\nkinetic = \"(1 kg)/2*x'^2 + (1 kg m^2)/2*phi'^2\"\n[[force]]\nalong = \"x\"\nis = \"-b*x' - k*x + s*phi'\"\n\
        [[force]]\nalong = \"phi\"\nis = \"-r*x\"\n[run]\nspan = \"1 s\"\n";
    let found = along(text, "b");
    let last = found.boundaries.last().expect("a boundary");
    assert_eq!((last.exact.as_deref(), last.degree), (Some("3/2"), 1));
    assert_eq!(right(&found).last(), Some(&0));
    assert_eq!(right(&found)[right(&found).len() - 2], 2);
    assert_eq!(spectrum(text).verdict(), EnclosedVerdict::Unstable(2));
}

/// A damped plane oscillator with the stiffness 2 N/m and a circulatory force: unstable beyond d sqrt(c/m), which is irrational.
#[test]
fn boundaries_that_are_no_fractions_are_roots_of_polynomials() {
    let force = |along: &str, is: &str| format!("[[force]]\nalong = \"{along}\"\nis = \"{is}\"\n");
    let forces = force("x", "-d*x' + k*y") + &force("y", "-d*y' - k*x");
    let found = along(&plane("kinetic = \"m/2*(x'^2 + y'^2)\"\npotential = \"(1 N/m)*(x^2 + y^2)\"", &forces), "k");
    let values: Vec<f64> = found.boundaries.iter().map(|one| one.value).collect();
    let critical = 0.02_f64.sqrt();
    assert!(
        values.len() == 2 && (values[1] - critical).abs() < 1e-15 && (values[0] + critical).abs() < 1e-15,
        "{found:?}"
    );
    assert!(found.boundaries.iter().all(|one| one.degree == 2 && one.exact.is_none()));
    assert_eq!(right(&found), [2, 0, 2]);
}

#[test]
fn a_speed_at_which_no_motion_is_steady_has_no_spectrum() {
    let swing = |speed: &str| {
        let text = plane("kinetic = \"m/2*(x'^2 + y'^2)\"\npotential = \"k/2*(x^2 + y^2)\"", "");
        near(&text.replace("[run]", &format!("[start]\n\"x'\" = \"{speed} m/s\"\n[run]")))
    };
    assert!(swing("0").is_ok());
    assert_eq!(swing("-1").err(), Some(NotEnclosed::NoMotion));
}
