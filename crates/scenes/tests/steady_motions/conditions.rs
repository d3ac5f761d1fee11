//! Equilibria and steady motions of laws with conditions, dry friction and contacts.

use super::{asked, model};
use dalembert_scenes::steady_motions::{
    Along, Case, Change, EnclosedVerdict, Near, Range, SteadyMotions, SteadyStability,
};

/// k x = F s with a fraction s of friction between -1 and 1: a block stays at rest for |x| <= F/k.
#[test]
fn dry_friction_holds_a_block_over_an_interval() {
    const BLOCK: &str = include_str!("../../../../scenes/models/dry_friction.toml");
    let found = SteadyMotions::of_cases(&model(BLOCK), &asked(&[("x", -3.0, 3.0)], 1_000), || true);
    let found = found.unwrap_or_else(|why| panic!("{why:?}"));
    let [(cases, own)] = &found[..] else { panic!("{found:?}") };
    assert_eq!(cases, &[Case::Between]);
    assert!(own.is_complete() && own.motions.is_empty());
    let [(rest, _)] = &own.families[..] else { panic!("{own:?}") };
    let [low, high] = rest.hull[0];
    assert!((low + 1.0).abs() < 1e-2 && (high - 1.0).abs() < 1e-2, "{low} {high}");
}

/// Springs of different stiffness on both sides and a constant force: the equilibrium is on the side to which the force points.
#[test]
fn springs_on_two_sides_have_the_equilibrium_of_the_side_that_is_pushed() {
    let text = "title = \"Two sides\"\n[parameters]\nm = \"1 kg\"\n[coordinates]\nx = \"m\"\n[bodies]\nb = { centre = \"O + x*N.x\", mass = \"m\" }\n\
        [[force]]\nalong = \"x\"\nis = \"(1 N) - if(x > (0 m), (4 N/m)*x, (1 N/m)*x)\"\n[run]\nspan = \"1 s\"\n";
    let found = SteadyMotions::of_cases(&model(text), &asked(&[("x", -3.0, 3.0)], 1_000), || true);
    let found = found.unwrap_or_else(|why| panic!("{why:?}"));
    let motions: Vec<f64> =
        found.iter().flat_map(|(_, own)| own.motions.iter().map(|motion| motion.state[0])).collect();
    assert_eq!(motions.len(), 1, "{found:?}");
    assert!((motions[0] - 0.25).abs() < 1e-12 && found.iter().all(|(_, own)| own.is_complete()));
    let stable =
        found.iter().flat_map(|(_, own)| &own.motions).all(|own| matches!(own.stability, SteadyStability::Minimum));
    assert!(stable, "{found:?}");
}

/// A block rests everywhere on a slope whose tangent is below the coefficient of friction, and nowhere on a steeper one.
#[test]
fn a_block_rests_on_a_slope_below_the_friction() {
    let slope = |angle: f64| {
        let text = format!(
            "title = \"Slope\"\ngravity = \"-(9.81 m/s^2)*N.y\"\n[parameters]\nm = \"20 kg\"\nf = \"0.3\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n\
             [points]\nP = \"O + x*N.x + y*N.y\"\n[bodies]\nblock = {{ centre = \"P\", mass = \"m\" }}\n\
             [[contact]]\nname = \"floor\"\nof = \"block at P\"\nthrough = \"O\"\nnormal = \"cos({angle})*N.y - sin({angle})*N.x\"\n\
             friction = \"f\"\ntouching = true\n[run]\nspan = \"1 s\"\n"
        );
        let ranges = asked(&[("x", -1.0, 1.0), ("y", -2.0, 2.0)], 2_000);
        SteadyMotions::of_cases(&model(&text), &ranges, || true).unwrap_or_else(|why| panic!("{why:?}"))
    };
    // atan(0.3) = 0.29146
    for (angle, rests) in [(0.2_f64, true), (0.29, true), (0.3, false)] {
        let found = slope(angle);
        assert!(found.iter().all(|(_, own)| own.is_complete()), "{found:?}");
        let all: Vec<&(Vec<Case>, SteadyMotions)> =
            found.iter().filter(|(_, own)| !own.families.is_empty() || !own.motions.is_empty()).collect();
        assert_eq!(all.len(), usize::from(rests), "{angle} {all:?}");
        if let [(cases, own)] = &all[..] {
            assert_eq!((cases.as_slice(), own.families.len()), (&[Case::Between][..], 1));
            let share =
                own.unknowns.iter().position(|unknown| unknown.name.contains("mu")).expect("friction is sought");
            let [low, high] = own.families[0].0.hull[share];
            assert!(((0.5 * (low + high)).abs() - angle.tan() / 0.3).abs() < 1e-6, "{low} {high}");
        }
    }
}

/// A block pulled over a floor with viscous drag: c v = F - mu m g where this is positive; otherwise it is at rest.
#[test]
fn a_pulled_block_slides_at_the_speed_at_which_drag_takes_the_rest_of_the_pull() {
    for (pull, speed) in [(10.0, Some((10.0 - 0.3 * 2.0 * 9.81) / 2.0)), (5.0, None)] {
        let text = format!(
            "title = \"Pulled\"\ngravity = \"-(9.81 m/s^2)*N.y\"\n[parameters]\nm = \"2 kg\"\nf = \"0.3\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n\
             [points]\nP = \"O + x*N.x + y*N.y\"\n[bodies]\nblock = {{ centre = \"P\", mass = \"m\" }}\n\
             [[force]]\non = \"block\"\nis = \"(({pull:?} N) - (2 N s/m)*x')*N.x\"\n\
             [[contact]]\nname = \"floor\"\nof = \"block at P\"\nthrough = \"O\"\nnormal = \"N.y\"\nfriction = \"f\"\ntouching = true\n\
             [run]\nspan = \"1 s\"\n"
        );
        let ranges = asked(&[("x'", -9.0, 10.0), ("y", -2.0, 2.0)], 2_000);
        let found = SteadyMotions::of_cases(&model(&text), &ranges, || true).unwrap_or_else(|why| panic!("{why:?}"));
        assert!(found.iter().all(|(_, own)| own.is_complete() && own.families.is_empty()), "{found:?}");
        let speeds: Vec<f64> = found.iter().flat_map(|(_, own)| own.motions.iter().map(|one| one.state[2])).collect();
        let [found] = speeds[..] else { panic!("{speeds:?}") };
        assert!((found - speed.unwrap_or(0.0)).abs() < 1e-9, "{found}");
    }
}

/// A force pushes a mass exactly to the position at which a second spring begins to act: the equilibrium belongs to both sides and is reported once.
/// The potential energy k x^2/2 - F x, with k2 (x - d)^2/2 beyond d, has its minimum there.
#[test]
fn an_equilibrium_at_a_kink_is_one_and_a_minimum_of_both_sides() {
    let found = |second: &str| {
        let text = format!(
            "title = \"Kink\"\n[parameters]\nm = \"1 kg\"\n[coordinates]\nx = \"m\"\n[bodies]\nb = {{ centre = \"O + x*N.x\", mass = \"m\" }}\n\
             [[force]]\nalong = \"x\"\nis = \"(0.4 N) - (4 N/m)*x - if(x > (0.1 m), {second}, 0)\"\n[run]\nspan = \"1 s\"\n"
        );
        let all = SteadyMotions::of_cases(&model(&text), &asked(&[("x", -1.0, 1.0)], 1_000), || true);
        let all = all.unwrap_or_else(|why| panic!("{why:?}"));
        assert!(all.iter().all(|(_, own)| own.is_complete() && own.families.is_empty()), "{all:?}");
        all.into_iter()
            .flat_map(|(cases, own)| own.motions.into_iter().map(move |motion| (cases.clone(), motion)))
            .collect::<Vec<_>>()
    };
    let [(cases, motion)] = &found("(100 N/m)*(x - (0.1 m))")[..] else { panic!("not one") };
    assert_eq!(cases, &[Case::Meeting]);
    assert!((motion.state[0] - 0.1).abs() < 1e-12);
    assert!(matches!(motion.stability, SteadyStability::MinimumOnSides), "{motion:?}");
    // a repelling spring beyond this position: a minimum on one side, decreasing energy on the other
    let [(_, motion)] = &found("(-100 N/m)*(x - (0.1 m))")[..] else { panic!("not one") };
    assert!(matches!(motion.stability, SteadyStability::FallsOnSide(1)), "{motion:?}");
    // a force that jumps takes an intermediate value
    let [(cases, _)] = &found("(1 N)")[..] else { panic!("not one") };
    assert_eq!(cases, &[Case::Between]);
}

/// A pendulum with dry friction in its joint is at rest where the torque of gravity is smaller: |sin a| <= F/(m g l), on two arcs.
#[test]
fn friction_holds_a_pendulum_where_gravity_is_weaker_and_nowhere_else() {
    for (friction, half) in
        [(2.4, (2.4_f64 / 4.905).asin()), (3.0, (3.0_f64 / 4.905).asin()), (4.8, (4.8_f64 / 4.905).asin())]
    {
        let text = format!(
            "title = \"Rough joint\"\ngravity = \"-(9.81 m/s^2)*N.y\"\n[parameters]\nm = \"1 kg\"\nF = \"{friction:?} N m\"\n[coordinates]\na = \"rad\"\n\
             [bodies]\nb = {{ centre = \"O + (0.5 m)*(sin(a)*N.x - cos(a)*N.y)\", mass = \"m\" }}\n\
             [[force]]\nalong = \"a\"\nis = \"-F*sign(a')\"\n[run]\nspan = \"1 s\"\n"
        );
        let found = SteadyMotions::of_cases(&model(&text), &asked(&[], 5_000), || true);
        let found = found.unwrap_or_else(|why| panic!("{why:?}"));
        assert!(found.iter().all(|(_, own)| own.is_complete() && own.motions.is_empty()), "{found:?}");
        let families: Vec<[f64; 2]> =
            found.iter().flat_map(|(_, own)| own.families.iter().map(|(family, _)| family.hull[0])).collect();
        assert_eq!(families.len(), 2, "{friction}: {families:?}");
        for [low, high] in families {
            let middle = 0.5 * (low + high);
            assert!((high - low - 2.0 * half).abs() < 1e-6 && middle.sin().abs() < 1e-6, "{friction}: {low} {high}");
        }
    }
}

/// Springs act beyond a backlash of width d on each side: a mass is at rest everywhere between -d and d, and no box is undecided.
#[test]
fn a_play_is_an_interval_of_equilibria_that_ends_where_the_springs_begin() {
    let text = "title = \"Play\"\n[parameters]\nm = \"1 kg\"\nd = \"0.1 m\"\n[coordinates]\nx = \"m\"\n[bodies]\nb = { centre = \"O + x*N.x\", mass = \"m\" }\n\
        [[force]]\nalong = \"x\"\nis = \"-if(x > d, (4 N/m)*(x - d), 0) - if(x < -d, (4 N/m)*(x + d), 0)\"\n[run]\nspan = \"1 s\"\n";
    let found = SteadyMotions::of_cases(&model(text), &asked(&[("x", -1.3, 1.0)], 2_000), || true);
    let found = found.unwrap_or_else(|why| panic!("{why:?}"));
    assert!(found.iter().all(|(_, own)| own.is_complete() && own.motions.is_empty()), "{found:?}");
    let families: Vec<_> = found.iter().flat_map(|(_, own)| &own.families).collect();
    let [(rest, _)] = families[..] else { panic!("{families:?}") };
    let [low, high] = rest.hull[0];
    assert!((low + 0.1).abs() < 1e-8 && (high - 0.1).abs() < 1e-8, "{low} {high}");
}

/// A pendulum in the middle of a backlash `max(abs(a) - e, 0)`, where the sign of the angle is zero and no spring acts: one minimum.
#[test]
fn an_equilibrium_in_the_middle_of_a_play_is_one_motion() {
    let text = "title = \"Pendulum in a play\"\ngravity = \"-(9.81 m/s^2)*N.y\"\n[parameters]\nm = \"1 kg\"\nk = \"50 N m\"\ne = \"0.1 rad\"\n[coordinates]\n\
        a = \"rad\"\n[bodies]\nb = { centre = \"O + (0.5 m)*(sin(a)*N.x - cos(a)*N.y)\", mass = \"m\" }\n\
        [energies]\npotential = \"k*max(abs(a) - e, 0)^2/2\"\n[run]\nspan = \"1 s\"\n";
    let found = SteadyMotions::of_cases(&model(text), &asked(&[("a", -3.0, 2.9)], 2_000), || true);
    let found = found.unwrap_or_else(|why| panic!("{why:?}"));
    assert!(found.iter().all(|(_, own)| own.is_complete() && own.families.is_empty()), "{found:?}");
    let motions: Vec<_> = found.iter().flat_map(|(_, own)| &own.motions).collect();
    let [motion] = motions[..] else { panic!("{motions:?}") };
    assert!(matches!(motion.stability, SteadyStability::Minimum), "{motion:?}");
}

/// Springs on both sides by `max(x, 0)` and `max(-x, 0)`: the conditions are opposite, and x = 0 is the only equilibrium.
#[test]
fn opposite_conditions_do_not_hold_together() {
    let text = "title = \"Two springs\"\n[parameters]\nm = \"1 kg\"\n[coordinates]\nx = \"m\"\n[bodies]\nb = { centre = \"O + x*N.x\", mass = \"m\" }\n\
        [energies]\npotential = \"(10 N/m)*max(x, 0)^2 + (7 N/m)*max(-x, 0)^2\"\n[run]\nspan = \"1 s\"\n";
    let found = SteadyMotions::of_cases(&model(text), &asked(&[("x", -1.0, 1.0)], 2_000), || true);
    let found = found.unwrap_or_else(|why| panic!("{why:?}"));
    assert!(found.iter().all(|(_, own)| own.is_complete() && own.families.is_empty()), "{found:?}");
    let motions: Vec<_> = found.iter().flat_map(|(_, own)| &own.motions).collect();
    let [motion] = motions[..] else { panic!("{motions:?}") };
    assert!(matches!(motion.stability, SteadyStability::MinimumOnSides), "{motion:?}");
}

/// Springs that are stiffer on one side, along two axes: two conditions are zero at the equilibrium, a minimum of all four combinations.
#[test]
fn an_equilibrium_at_two_kinks_is_a_minimum_of_all_sides() {
    let text = "title = \"Two kinks\"\n[parameters]\nm = \"1 kg\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n\
        [bodies]\nb = { centre = \"O + x*N.x + y*N.y\", mass = \"m\" }\n\
        [[force]]\nalong = \"x\"\nis = \"-if(x > (0 m), (4 N/m)*x, (1 N/m)*x)\"\n\
        [[force]]\nalong = \"y\"\nis = \"-if(y > (0 m), (2 N/m)*y, (9 N/m)*y)\"\n[run]\nspan = \"1 s\"\n";
    let found = SteadyMotions::of_cases(&model(text), &asked(&[("x", -1.3, 1.0), ("y", -1.0, 1.2)], 2_000), || true);
    let found = found.unwrap_or_else(|why| panic!("{why:?}"));
    assert!(found.iter().all(|(_, own)| own.is_complete() && own.families.is_empty()), "{found:?}");
    let motions: Vec<_> = found.iter().flat_map(|(_, own)| &own.motions).collect();
    let [motion] = motions[..] else { panic!("{motions:?}") };
    assert!(matches!(motion.stability, SteadyStability::MinimumOnSides), "{motion:?}");
}

/// A damping coefficient that depends on the direction of motion is multiplied by zero at rest: there is one equilibrium, without an interval of
/// coefficients.
#[test]
fn a_condition_that_no_equation_asks_for_is_no_unknown() {
    let text = "title = \"Damped\"\n[parameters]\nm = \"1 kg\"\n[coordinates]\nx = \"m\"\n[bodies]\nb = { centre = \"O + x*N.x\", mass = \"m\" }\n\
        [[force]]\nalong = \"x\"\nis = \"-(4 N/m)*x - if(x' > (0 m/s), (1 N s/m), (3 N s/m))*x'\"\n[run]\nspan = \"1 s\"\n";
    let found = SteadyMotions::of_cases(&model(text), &asked(&[("x", -1.0, 1.0)], 1_000), || true);
    let found = found.unwrap_or_else(|why| panic!("{why:?}"));
    let [(_, own)] = &found[..] else { panic!("{found:?}") };
    assert!(own.is_complete() && own.families.is_empty() && own.motions.len() == 1, "{own:?}");
}

/// At zero length the direction of a spring's force is undefined; the region is reported as such.
#[test]
fn a_distance_of_zero_is_told_as_a_place_without_values() {
    let text = "title = \"Distance\"\n[parameters]\nm = \"1 kg\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n[points]\nP = \"O + x*N.x + y*N.y\"\n\
        [bodies]\nb = { centre = \"P\", mass = \"m\" }\n[energies]\npotential = \"(10 N/m)*(distance(O, P) - (0.5 m))^2 + (9.81 N)*y\"\n\
        [run]\nspan = \"1 s\"\n";
    let found = SteadyMotions::of(&model(text), &asked(&[("x", -1.2, 1.1), ("y", -1.1, 1.2)], 2_000), || true);
    let found = found.unwrap_or_else(|why| panic!("{why:?}"));
    assert!(!found.is_complete() && found.motions.len() == 2, "{found:?}");
    assert!(found.regions.iter().all(|region| region.near == Near::Undefined), "{:?}", found.regions);
}

/// A spring and a force F push a block towards a wall: it touches the wall for F > k d and is free at x = F/k otherwise. There is one equilibrium for
/// every F, and no bifurcation.
#[test]
fn a_block_comes_to_a_wall_along_a_parameter() {
    let text = "title = \"Wall\"\n[parameters]\nm = \"1 kg\"\nF = \"1 N\"\n[coordinates]\nx = \"m\"\n[bodies]\nb = { centre = \"O + x*N.x\", mass = \"m\" }\n\
        [[force]]\nalong = \"x\"\nis = \"F - (10 N/m)*x\"\n\
        [[contact]]\nname = \"wall\"\nof = \"b\"\nthrough = \"O + (0.15 m)*N.x\"\nnormal = \"-N.x\"\n[run]\nspan = \"1 s\"\n";
    let range = Range { from: 0.5, to: 2.5 };
    let found = Along::of(&model(text), &asked(&[("x", -1.0, 1.0)], 1_000), ("F", range), 9, || true);
    let found = found.unwrap_or_else(|why| panic!("{why:?}"));
    for sample in &found.samples {
        let [motion] = &sample.found.motions[..] else { panic!("{sample:?}") };
        let expected = (sample.value / 10.0).min(0.15);
        assert!((motion.state[0] - expected).abs() < 1e-9, "{} {:?}", sample.value, motion.state);
        assert_eq!(sample.found.unknowns.len(), 1);
    }
    assert!(found.bifurcations.is_empty(), "{:?}", found.bifurcations);
}

/// Dry friction below the force F does not hold a block: the family of positions of rest disappears where the coefficient passes F.
#[test]
fn places_at_which_friction_holds_vanish_along_its_coefficient() {
    let text = "title = \"Pull\"\n[parameters]\nm = \"1 kg\"\nF = \"2 N\"\nc = \"5 N\"\n[coordinates]\nx = \"m\"\n[bodies]\nb = { centre = \"O + x*N.x\", mass = \"m\" }\n\
        [[force]]\nalong = \"x\"\nis = \"F - c*sign(x')\"\n[run]\nspan = \"1 s\"\n";
    let range = Range { from: 1.0, to: 4.0 };
    let found = Along::of(&model(text), &asked(&[], 1_000), ("c", range), 6, || true);
    let found = found.unwrap_or_else(|why| panic!("{why:?}"));
    assert!(found.samples.iter().all(|sample| sample.found.is_complete()), "{found:?}");
    let counts: Vec<usize> =
        found.samples.iter().map(|sample| sample.found.motions.len() + sample.found.families.len()).collect();
    assert_eq!(counts, [0, 0, 1, 1, 1, 1], "{found:?}");
    assert!(found.samples.iter().all(|sample| sample.found.unknowns.is_empty()), "{found:?}");
    let [bifurcation] = &found.bifurcations[..] else { panic!("{found:?}") };
    assert_eq!(bifurcation.change, Change::Ends);
    assert!((bifurcation.before.value - 2.0).abs() < 1e-6 && (bifurcation.after.value - 2.0).abs() < 1e-6);
}

/// Drag c w |w| balances a torque M at w = sqrt(M/c): stability follows from the derivative -2 c w on this side of the condition.
#[test]
fn stability_beside_a_condition_is_that_of_its_own_side() {
    for (drag, speed) in [
        ("(1 N m s^2)*theta'*abs(theta')", 2.0),
        ("if(theta' < (0 rad/s), -(1 N m s^2)*theta'^2, (1 N m s^2)*theta'^2)", 2.0),
    ] {
        let text = format!(
            "title = \"Fan\"\n[parameters]\nJ = \"1 kg m^2\"\n[coordinates]\ntheta = \"rad\"\n[bodies.fan]\nturns = \"theta\"\ninertia = \"J\"\n\
             [[force]]\nalong = \"theta\"\nis = \"(4 N m) - {drag}\"\n[run]\nspan = \"1 s\"\n"
        );
        let found = SteadyMotions::of_cases(&model(&text), &asked(&[("theta'", -10.0, 10.0)], 1_000), || true);
        let found = found.unwrap_or_else(|why| panic!("{why:?}"));
        let motions: Vec<_> = found.iter().flat_map(|(_, own)| &own.motions).collect();
        let [motion] = motions[..] else { panic!("{motions:?}") };
        assert!((motion.state[1] - speed).abs() < 1e-12);
        let SteadyStability::Linear(eigenvalues) = &motion.stability else { panic!("{motion:?}") };
        let enclosed = eigenvalues.enclosed.as_ref().expect("they are enclosed");
        assert_eq!(enclosed.verdict(), EnclosedVerdict::Asymptotic, "{enclosed:?}");
        assert!(enclosed.discs.iter().all(|disc| (disc.centre[0] + 4.0).abs() < 1e-6), "{enclosed:?}");
        let exact = enclosed.exact.expect("its data are fractions");
        assert_eq!((exact.left, exact.right), (1, 0));
    }
}

/// Dry friction F holds a block on a spring where |p - k x| < F: this family leaves the range of x at p = k x + F.
#[test]
fn a_family_that_leaves_the_range_is_a_change() {
    let text = "title = \"Held\"\n[parameters]\nm = \"1 kg\"\np = \"0 N\"\n[coordinates]\nx = \"m\"\n[bodies]\nb = { centre = \"O + x*N.x\", mass = \"m\" }\n\
        [[force]]\nalong = \"x\"\nis = \"p - (1 N/m)*x - (0.3 N)*sign(x')\"\n[run]\nspan = \"1 s\"\n";
    let range = Range { from: 0.13, to: 2.0 };
    let found = Along::of(&model(text), &asked(&[("x", -1.0, 1.0)], 1_000), ("p", range), 5, || true);
    let found = found.unwrap_or_else(|why| panic!("{why:?}"));
    let families: Vec<usize> = found.samples.iter().map(|sample| sample.found.families.len()).collect();
    assert_eq!(families, [1, 1, 1, 0, 0], "{found:?}");
    // the fraction of friction is not listed among the unknowns
    assert!(found.samples.iter().all(|sample| sample.found.unknowns.len() == 1), "{found:?}");
    let [bifurcation] = &found.bifurcations[..] else { panic!("{:?}", found.bifurcations) };
    assert_eq!(bifurcation.change, Change::Families);
    assert!((0.5 * (bifurcation.before.value + bifurcation.after.value) - 1.3).abs() < 1e-2, "{bifurcation:?}");
}
