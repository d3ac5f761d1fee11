//! Changes of steady motions as functions of one and of two parameters.

use super::{DRIVEN, SHAFT, SIDES, asked, model, plane};
use dalembert_scenes::steady_motions::{
    Along, Change, Crossings, EnclosedSpectrum, NoSteadyMotions, NotEnclosed, PlaneCell, Range, middles,
};

fn along(text: &str, ranges: &[(&str, f64, f64)], (name, from, to): (&str, f64, f64)) -> Along {
    let found = Along::of(&model(text), &asked(ranges, 200_000), (name, Range { from, to }), 21, || true);
    found.unwrap_or_else(|why| panic!("{why:?}"))
}

fn assert_changes(found: &Along, wanted: &[(f64, Change)]) {
    let told: Vec<(f64, f64, Change)> =
        found.bifurcations.iter().map(|one| (one.before.value, one.after.value, one.change)).collect();
    assert_eq!(told.len(), wanted.len(), "{told:?}");
    for (&(from, to, change), &(at, kind)) in told.iter().zip(wanted) {
        assert!(from < at && at < to && to - from < 1e-3 && change == kind, "{told:?} for {at}");
    }
}

#[test]
fn a_pendulum_on_a_turning_shaft_leaves_the_axis_at_a_pitchfork() {
    let critical = (9.81_f64 / 0.5).sqrt();
    assert_changes(&along(SHAFT, &[], ("phi'", 1.0, 8.03)), &[(critical, Change::Pitchfork)]);
    // the length as the parameter at constant speed: l = g/w^2
    let by_length = along(SHAFT, &[("phi'", 5.0, 5.0)], ("l", 0.1, 0.93));
    assert_changes(&by_length, &[(9.81 / 25.0, Change::Pitchfork)]);
}

/// A snapping beam: V = x^4/4 - x^2/2 + p x has three equilibria for |p| < 2/sqrt(27).
#[test]
fn a_beam_that_snaps_has_folds_at_the_ends_of_its_two_shapes() {
    let text =
        plane("k*(x^4/a^4/4 - x^2/a^2/2 + p*x/a + y^2/a^2/2)").replace("[coordinates]", "p = \"0\"\n[coordinates]");
    let fold = 2.0 / 27f64.sqrt();
    assert_changes(&along(&text, &SIDES, ("p", -0.9, 0.87)), &[(-fold, Change::Fold), (fold, Change::Fold)]);
}

#[test]
fn two_motions_that_leave_their_range_together_are_no_fold() {
    let found = along(DRIVEN, &[("phi'", 1.0, 30.0)], ("T", 0.0, 0.193));
    assert_changes(&found, &[(0.01, Change::LeaveTogether)]);
}

/// The pendulum leaves the vertical where l w^2 exceeds g.
#[test]
fn over_two_parameters_motions_change_where_the_closed_form_says() {
    let (model, asked) = (model(SHAFT), asked(&[], 20_000));
    let directions = [("l", Range { from: 0.25, to: 1.25 }), ("phi'", Range { from: 2.0, to: 7.0 })];
    let columns: Vec<Vec<PlaneCell>> = middles(directions[0].1, 4)
        .into_iter()
        .map(|value| PlaneCell::column(&model, &asked, directions, (value, 5), || true))
        .collect();
    for cell in columns.iter().flatten() {
        let [l, w] = cell.values;
        let wanted = if l * w * w > 9.81 { 4 } else { 2 };
        assert!(cell.found.is_complete() && cell.found.motions.len() == wanted, "{:?}", cell.values);
    }
    let mut borders = 0;
    for pair in columns.iter().flat_map(|column| column.windows(2)).filter(|pair| !pair[0].is_like(&pair[1])) {
        let [[l, below], [_, above]] = pair[0].border(&pair[1], &model, &asked, ["l", "phi'"], || true);
        let w = (9.81 / l).sqrt();
        assert!((below..=above).contains(&w) && above - below <= 1.0 / 32.0 + 1e-12, "{below} to {above} beside {w}");
        borders += 1;
    }
    assert_eq!(borders, 4);
}

/// One coordinate with a force, and a damper.
fn pushed(force: &str, damping: &str) -> String {
    format!(
        "title = \"One\"\n[parameters]\np = \"0.1\"\n[coordinates]\nx = \"m\"\n[energies]\nkinetic = \"(0.5 kg)*x'^2\"\n\
         dissipation = \"({damping} N s/m)*x'^2\"\n[[force]]\nalong = \"x\"\nis = \"{force}\"\n"
    )
}

/// x (p - p0 - x) = 0: the branches x = 0 and x = p - p0 cross, and the upper one is stable on both sides.
#[test]
fn two_motions_that_pass_through_each_other_exchange_their_stability() {
    for (place, damping) in [("0.137", "0"), ("0.137", "0.3"), ("0", "0.3")] {
        let text = pushed(&format!("(1 N/m^2)*x*((1 m)*(p - {place}) - x)"), damping);
        let found = along(&text, &[("x", -2.0, 2.0)], ("p", -1.0, 1.0));
        assert_changes(&found, &[(place.parse().expect("a number"), Change::Transcritical)]);
    }
    // the branches avoid each other
    let text = pushed("(1 N/m^2)*x*((1 m)*(p - 0.137) - x) + (1e-4 N)", "0.3");
    assert_changes(&along(&text, &[("x", -2.0, 2.0)], ("p", -1.0, 1.0)), &[]);
}

/// x^2 = (p - 0.137)^2 - 0.01^2: between 0.127 and 0.147 there is no motion, and no value of the search lies there.
#[test]
fn two_folds_between_neighbouring_values_are_found_where_motions_approach_each_other() {
    let text = pushed("(1 N)*((p - 0.137)^2 - 1e-4) - (1 N/m^2)*x^2", "0.3");
    let found = along(&text, &[("x", -2.0, 2.0)], ("p", -1.0, 1.0));
    assert_changes(&found, &[(0.127, Change::Fold), (0.147, Change::Fold)]);
}

/// x^3 - 0.1 x = p - 0.13: three motions for |p - 0.13| < 2 (0.1/3)^(3/2), and no value of the search lies there.
#[test]
fn two_folds_between_neighbouring_values_are_found_where_a_motion_jumps() {
    let text = pushed("(1 N)*(p - 0.13) + (0.1 N/m)*x - (1 N/m^3)*x^3", "0.3");
    let found = along(&text, &[("x", -2.0, 2.0)], ("p", -1.0, 1.0));
    let half = 2.0 * (0.1_f64 / 3.0).powf(1.5);
    assert_changes(&found, &[(0.13 - half, Change::Fold), (0.13 + half, Change::Fold)]);
}

/// J x'' + d x' + k x = 0: where J changes its sign, decay becomes growth, and no eigenvalue crosses the imaginary axis.
#[test]
fn eigenvalues_become_infinite_where_the_inertia_vanishes() {
    for (damping, values) in [("0.1 N s/m", 6), ("0 N s/m", 7)] {
        let text = format!(
            "title = \"Inertia\"\n[parameters]\nJ = \"1 kg\"\nk = \"5 N/m\"\nd = \"{damping}\"\n[coordinates]\nx = \"m\"\n[energies]\n\
             kinetic = \"J*x'^2/2\"\npotential = \"k*x^2/2\"\n[[force]]\nalong = \"x\"\nis = \"-d*x'\"\n"
        );
        let range = Range { from: -1.1, to: 1.37 };
        let found = Along::of(&model(&text), &asked(&[("x", -1.0, 1.0)], 1_000), ("J", range), values, || true);
        let found = found.unwrap_or_else(|why| panic!("{why:?}"));
        assert_changes(&found, &[(0.0, Change::Infinite)]);
    }
}

/// Ziegler's double pendulum with a follower force P flutters for P > (7/2 - sqrt 2) k/l.
#[test]
fn a_follower_force_makes_a_pair_cross_the_imaginary_axis() {
    let text = "title = \"Ziegler\"\n[parameters]\nP = \"1 N\"\n[coordinates]\na = \"rad\"\nb = \"rad\"\n[frames]\nA = \"N turned a about z\"\nB = \"N turned b about z\"\n\
        [points]\nM = \"O + (1 m)*A.x\"\n[bodies]\nmid = { centre = \"M\", mass = \"2 kg\" }\nend = { centre = \"M + (1 m)*B.x\", mass = \"1 kg\" }\n\
        [energies]\npotential = \"(1 N m)*a^2/2 + (1 N m)*(b - a)^2/2\"\n[[force]]\non = \"end\"\nis = \"-P*B.x\"\n";
    let found = along(text, &[("a", -0.1, 0.1), ("b", -0.1, 0.1)], ("P", 1.0, 2.9));
    assert_changes(&found, &[(3.5 - 2f64.sqrt(), Change::Pair)]);
}

/// A block on a spring and a belt: only for a belt at rest does it stay at rest in an interval of positions.
#[test]
fn motions_that_differ_at_one_value_alone_are_told_with_it() {
    let text = "title = \"Belt\"\n[parameters]\nm = \"1 kg\"\nk = \"50 N/m\"\nv = \"0.5 m/s\"\nF = \"3 N\"\n[coordinates]\nx = \"m\"\n\
        [bodies]\nb = { centre = \"O + x*N.x\", mass = \"m\" }\n[energies]\npotential = \"k*x^2/2\"\n\
        [[force]]\non = \"b\"\nis = \"-F*sign(x' - v)*N.x\"\n";
    let range = Range { from: -1.0, to: 1.0 };
    let found = Along::of(&model(text), &asked(&[("x", -1.0, 1.0)], 1_000), ("v", range), 5, || true);
    let found = found.unwrap_or_else(|why| panic!("{why:?}"));
    assert_changes(&found, &[(0.0, Change::AtValue)]);
    let at = found.bifurcations[0].at.as_ref().expect("it is known there");
    assert_eq!((at.value, at.found.motions.len(), at.found.families.len()), (0.0, 0, 1));
}

#[test]
fn values_without_a_system_are_left_out_and_the_others_are_searched() {
    let text = "title = \"Mass\"\n[parameters]\nm = \"1 kg\"\nk = \"5 N/m\"\n[coordinates]\nx = \"m\"\n[bodies]\nb = { centre = \"O + x*N.x\", mass = \"m\" }\n\
        [[force]]\non = \"b\"\nis = \"-k*x*N.x\"\n";
    let at = |from: f64, to: f64| {
        Along::of(&model(text), &asked(&[("x", -1.0, 1.0)], 1_000), ("m", Range { from, to }), 5, || true)
    };
    let found = at(-1.0, 1.0).unwrap_or_else(|why| panic!("{why:?}"));
    assert_eq!(found.left_out.iter().map(|(value, _)| *value).collect::<Vec<_>>(), [-1.0, -0.5, 0.0]);
    assert!(found.samples.len() == 2 && found.bifurcations.is_empty(), "{found:?}");
    assert!(at(-2.0, -1.0).is_err());
    // the root of a negative number, and a division by zero
    let rooted = text
        .replace("-k*x*N.x", "(-k*x*(1 kg)/(m - (1 kg)) + k*sqrt(m/(1 kg))*x)*N.x")
        .replace("mass = \"m\"", "mass = \"1 kg\"");
    let range = Range { from: -1.0, to: 2.0 };
    let found = Along::of(&model(&rooted), &asked(&[("x", -1.0, 1.0)], 1_000), ("m", range), 4, || true);
    let found = found.unwrap_or_else(|why| panic!("{why:?}"));
    let [(-1.0, why), (1.0, also)] = &found.left_out[..] else { panic!("{:?}", found.left_out) };
    for why in [why, also] {
        let NoSteadyMotions::At { why, .. } = why else { panic!("{why:?}") };
        assert!(matches!(&**why, NoSteadyMotions::Undefined { .. }), "{why:?}");
    }
}

#[test]
fn a_search_whose_time_is_over_keeps_the_values_that_were_examined() {
    let mut left = 40;
    let goes_on = || {
        left -= 1;
        left > 0
    };
    let found = Along::of(&model(SHAFT), &asked(&[], 20_000), ("phi'", Range { from: 3.0, to: 6.0 }), 30, goes_on);
    let found = found.unwrap_or_else(|why| panic!("{why:?}"));
    assert!(!found.samples.is_empty() && found.samples.len() < 30, "{}", found.samples.len());
}

#[test]
fn values_on_the_way_to_a_change_are_kept() {
    let along = Along::of(&model(SHAFT), &asked(&[], 20_000), ("phi'", Range { from: 3.0, to: 6.0 }), 4, || true)
        .expect("sought");
    let critical = (9.81_f64 / 0.5).sqrt();
    let near = along.visited.iter().map(|sample| (sample.value - critical).abs()).fold(f64::INFINITY, f64::min);
    assert!(near < 1e-3 && along.visited.len() > along.samples.len() + 5, "{near}");
    assert!(along.visited.windows(2).all(|pair| pair[0].value <= pair[1].value));
}

/// A bead in the bowl z = a r^2/2 + n r^4 moves in circles with w^2 = g (a + 4 n r^2). At w^2 = g a the circles shrink to the axis, where polar
/// coordinates are singular.
#[test]
fn motions_that_shrink_to_a_singular_place_are_no_fold() {
    let text = "title = \"Bowl\"\ngravity = \"-(9.81 m/s^2)*N.z\"\n[parameters]\na = \"2 1/m\"\nn = \"1 1/m^3\"\n[coordinates]\nr = \"m\"\nf = \"rad\"\n\
                [bodies]\np = { centre = \"O + r*cos(f)*N.x + r*sin(f)*N.y + (a*r^2/2 + n*r^4)*N.z\", mass = \"1 kg\" }\n";
    let critical = (9.81 * 2.0_f64).sqrt();
    for range in [("r", -0.5, 0.51), ("r", 0.0, 0.51)] {
        assert_changes(&along(text, &[range], ("f'", 3.0, 5.03)), &[(critical, Change::AtSingularPlace)]);
    }
}

/// x'' = f - k x has no equilibrium at k = 0, the middle of the range; the change is bracketed nevertheless.
#[test]
fn a_crossing_at_a_value_without_a_motion_is_bracketed_closely() {
    let text = "title = \"Spring\"\n[parameters]\nk = \"1 N/m\"\nf = \"3 N\"\n[coordinates]\nx = \"m\"\n[bodies]\np = { centre = \"O + x*N.x\", mass = \"1 kg\" }\n\
                [[force]]\nalong = \"x\"\nis = \"f - k*x\"\n";
    let spectrum = |value: f64| {
        let mut model = model(text);
        dalembert_scenes::set_values(&mut model, &[("k".to_owned(), value)]).map_err(|_| NotEnclosed::NoMotion)?;
        EnclosedSpectrum::following(&model, &[0.0, 0.0], || true)
    };
    let found = Crossings::of([-1.0, 1.0], spectrum, || true);
    let [[before, after]] = &found.changes[..] else { panic!("{found:?}") };
    assert!(before.value < 0.0 && 0.0 < after.value && after.value - before.value < 1e-6, "{before:?} {after:?}");
}
