//! Motions at zeros of conditions: in the middle of a backlash, where conditions have no effect, and at kinks.

use super::{asked, model};
use dalembert_scenes::steady_motions::{
    Case, EnclosedVerdict, SteadyMotion, SteadyMotions, SteadyStability, conditions_of,
};

/// A system with one coordinate x in metres, and loads.
fn block(loads: &str) -> String {
    format!(
        "title = \"Block\"\n[parameters]\nm = \"1 kg\"\ne = \"0.1 m\"\n[coordinates]\nx = \"m\"\n\
         [bodies]\nb = {{ centre = \"O + x*N.x\", mass = \"m\" }}\n{loads}\n[run]\nspan = \"1 s\"\n"
    )
}

/// The combinations of cases with the result in each.
type Found = Vec<(Vec<Case>, SteadyMotions)>;

fn found(text: &str) -> Found {
    let all = SteadyMotions::of_cases(&model(text), &asked(&[("x", -1.3, 1.1)], 2_000), || true);
    let all = all.unwrap_or_else(|why| panic!("{why:?}"));
    assert!(all.iter().all(|(_, own)| own.is_complete()), "{all:?}");
    all
}

/// The only motion.
fn only(text: &str) -> SteadyMotion {
    let all = found(text);
    assert!(all.iter().all(|(_, own)| own.families.is_empty()), "{all:?}");
    let mut motions = all.into_iter().flat_map(|(_, own)| own.motions);
    let (first, second) = (motions.next(), motions.next());
    first.filter(|_| second.is_none()).unwrap_or_else(|| panic!("not one motion"))
}

const PLAY: &str = "[energies]\npotential = \"(50 N/m)*max(abs(x) - e, 0)^2/2";

#[test]
fn a_maximum_in_the_middle_of_a_play_is_unstable() {
    let all = found(&block(&format!("{PLAY} - (2 N/m)*x^2/2\"")));
    let middle: Vec<&SteadyMotion> =
        all.iter().flat_map(|(_, own)| &own.motions).filter(|own| own.state[0].abs() < 1e-9).collect();
    let [motion] = middle[..] else { panic!("{all:?}") };
    assert!(matches!(motion.stability, SteadyStability::Falls(1)), "{motion:?}");
}

#[test]
fn a_damped_motion_in_the_middle_of_a_play_is_judged_by_linear_equations() {
    for (slope, verdict) in [("+", EnclosedVerdict::Asymptotic), ("-", EnclosedVerdict::Unstable(1))] {
        let damper = "[[force]]\nalong = \"x\"\nis = \"-(0.3 N s/m)*x'\"";
        let all = found(&block(&format!("{PLAY} {slope} (2 N/m)*x^2/2\"\n{damper}")));
        let middle: Vec<&SteadyMotion> =
            all.iter().flat_map(|(_, own)| &own.motions).filter(|own| own.state[0].abs() < 1e-9).collect();
        let [motion] = middle[..] else { panic!("{all:?}") };
        let SteadyStability::Linear(own) = &motion.stability else { panic!("{motion:?}") };
        assert_eq!(own.enclosed.as_ref().map(|found| found.verdict()), Ok(verdict), "{own:?}");
    }
}

/// Without a load, a block is at rest throughout the backlash: one family, described without the sign of x.
#[test]
fn a_play_without_a_load_is_one_family() {
    let text = block(&format!("{PLAY}\""));
    let all = found(&text);
    let families: Vec<_> =
        all.iter().flat_map(|(cases, own)| own.families.iter().map(move |(family, _)| (cases, family))).collect();
    let [(cases, family)] = &families[..] else { panic!("{all:?}") };
    assert_eq!(cases[..], [Case::Either, Case::Fails]);
    assert!(family.hull[0].iter().zip([-0.1, 0.1]).all(|(end, wanted)| (end - wanted).abs() < 1e-8), "{family:?}");
    assert_eq!(conditions_of(&model(&text)), ["x", "abs(x) - e"]);
    // beyond the backlash on both sides, and within it
    assert_eq!(all.len(), 3, "{all:?}");
}

/// A force with an edge: repelling on one side and attracting on the other.
#[test]
fn a_potential_that_falls_on_one_side_of_a_kink_makes_a_motion_unstable() {
    let edge = |right: &str, left: &str| {
        only(&block(&format!("[[force]]\nalong = \"x\"\nis = \"if(x > (0 m), {right}*x, {left}*x)\""))).stability
    };
    for (right, left) in [("(4 N/m)", "-(1 N/m)"), ("-(1 N/m)", "(4 N/m)"), ("(1 N/m)", "(4 N/m)")] {
        let stability = edge(right, left);
        assert!(matches!(stability, SteadyStability::FallsOnSide(1)), "{right} {left}: {stability:?}");
    }
    assert!(matches!(edge("-(4 N/m)", "-(1 N/m)"), SteadyStability::MinimumOnSides));
    // a damper slows the growth and does not end it
    let damper = "[[force]]\nalong = \"x\"\nis = \"-(9 N s/m)*x'\"";
    let damped = |force: &str| {
        only(&block(&format!("[[force]]\nalong = \"x\"\nis = \"if(x > (0 m), {force}, -(1 N/m)*x)\"\n{damper}")))
            .stability
    };
    assert!(matches!(damped("(4 N/m)*x"), SteadyStability::FallsOnSide(1)));
    // with a damper a minimum is still stable; with a negative damper the energy decides nothing
    assert!(matches!(damped("-(4 N/m)*x"), SteadyStability::MinimumOnSides));
    let fed = block(&format!(
        "[[force]]\nalong = \"x\"\nis = \"if(x > (0 m), -(4 N/m)*x, -(1 N/m)*x)\"\n{}",
        damper.replace("-(9", "(9")
    ));
    assert!(matches!(only(&fed).stability, SteadyStability::AtCondition(None)));
}

/// A force proportional to the square of the distance: the linear equations vanish, and the order of the zero decides.
#[test]
fn a_spring_that_begins_softly_holds_a_motion_and_one_that_repels_does_not() {
    let soft = |force: &str| only(&block(&format!("[[force]]\nalong = \"x\"\nis = \"{force}\""))).stability;
    for force in ["-(50 N/m^2)*x*abs(x)", "-(50 N/m^3)*x^2*abs(x)*sign(x)", "-(3 N/m^5)*x^5"] {
        let stability = match force.contains("abs") {
            true => soft(force),
            false => only_smooth(force),
        };
        let is_minimum = matches!(stability, SteadyStability::MinimumOnSides | SteadyStability::Minimum);
        assert!(is_minimum, "{force}: {stability:?}");
    }
    assert!(matches!(soft("(50 N/m^2)*x*abs(x)"), SteadyStability::FallsOnSide(1)));
    for force in ["(3 N/m^5)*x^5", "-(3 N/m^2)*x^2"] {
        assert!(matches!(only_smooth(force), SteadyStability::Falls(1)), "{force}");
    }
}

/// The stability of the only motion under a force without conditions.
fn only_smooth(force: &str) -> SteadyStability {
    let text = block(&format!("[[force]]\nalong = \"x\"\nis = \"{force}\""));
    let all = SteadyMotions::of(&model(&text), &asked(&[("x", -1.3, 1.1)], 2_000), || true);
    let all = all.unwrap_or_else(|why| panic!("{why:?}"));
    let [motion] = &all.motions[..] else { panic!("{all:?}") };
    assert!(all.is_complete(), "{all:?}");
    motion.stability.clone()
}

#[test]
fn conditions_are_told_by_the_functions_that_were_written() {
    let of = |potential: &str| conditions_of(&model(&block(&format!("[energies]\npotential = \"{potential}\""))));
    assert_eq!(of("(1 N)*abs(abs(x) - e)"), ["x", "abs(x) - e"]);
    assert_eq!(of("(1 N)*min(max(x, e), 2*e)"), ["x - e", "2*e - max(x, e)"]);
    assert_eq!(of("(1 N)*max(x*sign(x - e), 0)"), ["x - e", "x*sign(x - e)"]);
}

/// Two coordinates at a kink where all derivatives vanish: no box is decided, and the region is reported once, not for each side.
#[test]
fn an_undecided_place_at_a_kink_is_told_once() {
    let text = "title = \"Soft\"\n[parameters]\nm = \"1 kg\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n\
        [bodies]\nb = { centre = \"O + x*N.x + y*N.y\", mass = \"m\" }\n\
        [[force]]\nalong = \"x\"\nis = \"-(5 N/m^2)*x*abs(x)\"\n[[force]]\nalong = \"y\"\nis = \"-(2 N/m)*y\"\n[run]\nspan = \"1 s\"\n";
    let all = SteadyMotions::of_cases(&model(text), &asked(&[("x", -1.3, 1.1), ("y", -1.0, 1.2)], 2_000), || true);
    let all = all.unwrap_or_else(|why| panic!("{why:?}"));
    let open: Vec<_> = all.iter().filter(|(_, own)| !own.is_complete()).collect();
    let [(cases, own)] = open[..] else { panic!("{all:?}") };
    assert_eq!((&cases[..], own.regions.len()), (&[Case::Either][..], 1), "{own:?}");
    assert!(own.regions[0].hull[0][0] <= 0.0 && own.regions[0].hull[0][1] >= 0.0, "{:?}", own.regions);
}

/// Two ropes carry a load. At each ring, where a distance is zero, the rope is slack; taut ropes have no motion there.
#[test]
fn places_without_values_on_an_excluded_side_are_not_told() {
    let text = "title = \"Ropes\"\ngravity = \"-(9.81 m/s^2)*N.y\"\n[parameters]\nm = \"1 kg\"\nl = \"0.5 m\"\nk = \"200 N/m\"\n\
        [coordinates]\nx = \"m\"\ny = \"m\"\n[points]\nP = \"O + x*N.x + y*N.y\"\nA = \"O + (0.6 m)*N.x\"\n[bodies]\nb = { centre = \"P\", mass = \"m\" }\n\
        [energies]\npotential = \"k*max(distance(O, P) - l, 0)^2/2 + k*max(distance(A, P) - l, 0)^2/2\"\n[run]\nspan = \"1 s\"\n";
    let all = SteadyMotions::of_cases(&model(text), &asked(&[("x", -1.0, 1.5), ("y", -1.0, 1.2)], 2_000), || true);
    let all = all.unwrap_or_else(|why| panic!("{why:?}"));
    let regions: Vec<_> = all.iter().flat_map(|(_, own)| &own.regions).collect();
    assert!(regions.is_empty(), "{regions:?}");
    assert_eq!(all.iter().map(|(_, own)| own.motions.len()).sum::<usize>(), 1, "{all:?}");
}

/// A backlash between two coordinates, with the sign of x - y: the middle is a maximum and is reported once.
#[test]
fn a_play_between_two_coordinates_is_smooth_in_its_middle() {
    let text = "title = \"Backlash\"\n[parameters]\nm = \"1 kg\"\ne = \"0.1 m\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n\
        [bodies]\nb = { centre = \"O + x*N.x + y*N.y\", mass = \"m\" }\n\
        [energies]\npotential = \"(50 N/m)*max(abs(x - y) - e, 0)^2/2 - (1 N/m)*(x^2 + y^2)/2\"\n[run]\nspan = \"1 s\"\n";
    let all = SteadyMotions::of_cases(&model(text), &asked(&[("x", -1.0, 1.2), ("y", -1.0, 1.1)], 5_000), || true);
    let all = all.unwrap_or_else(|why| panic!("{why:?}"));
    assert!(all.iter().all(|(_, own)| own.is_complete() && own.families.is_empty()), "{all:?}");
    let middle = |own: &&SteadyMotion| own.state[..2].iter().all(|value| value.abs() < 1e-9);
    let middle: Vec<&SteadyMotion> = all.iter().flat_map(|(_, own)| &own.motions).filter(middle).collect();
    let [motion] = middle[..] else { panic!("{all:?}") };
    assert!(matches!(motion.stability, SteadyStability::Falls(2)), "{motion:?}");
    assert_eq!(all.iter().map(|(_, own)| own.motions.len()).sum::<usize>(), 3, "{all:?}");
}

/// Two backlashes along x and y: a square of positions of rest, reported as one surface up to its edges.
#[test]
fn two_plays_are_one_surface_of_rest() {
    let text = "title = \"Square\"\n[parameters]\nm = \"1 kg\"\ne = \"0.2 m\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n\
        [bodies]\nb = { centre = \"O + x*N.x + y*N.y\", mass = \"m\" }\n\
        [energies]\npotential = \"(5 N/m)*max(abs(x) - e, 0)^2 + (5 N/m)*max(abs(y) - e, 0)^2\"\n[run]\nspan = \"1 s\"\n";
    let all = SteadyMotions::of_cases(&model(text), &asked(&[("x", -1.0, 1.0), ("y", -1.5, 1.0)], 5_000), || true);
    let all = all.unwrap_or_else(|why| panic!("{why:?}"));
    assert!(all.iter().all(|(_, own)| own.is_complete() && own.motions.is_empty()), "{all:?}");
    let families: Vec<_> = all.iter().flat_map(|(_, own)| &own.families).map(|(family, _)| family).collect();
    let [rest] = families[..] else { panic!("{all:?}") };
    assert_eq!((rest.dimension, rest.border), (2, 0), "{rest:?}");
    let ends = rest.hull.iter().chain(rest.reached.iter().flatten());
    assert!(
        ends.flat_map(|own| own.iter().zip([-0.2, 0.2])).all(|(end, wanted)| (end - wanted).abs() < 1e-8),
        "{rest:?}"
    );
}

/// A band of positions of rest that is not aligned with boxes: its border is reported, and its ends are reached.
#[test]
fn a_band_of_rest_is_a_surface_with_a_border() {
    let text = "title = \"Band\"\n[parameters]\nm = \"1 kg\"\ne = \"0.2 m\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n\
        [bodies]\nb = { centre = \"O + x*N.x + y*N.y\", mass = \"m\" }\n\
        [energies]\npotential = \"(5 N/m)*max(abs(x - y) - e, 0)^2\"\n[run]\nspan = \"1 s\"\n";
    let all = SteadyMotions::of_cases(&model(text), &asked(&[("x", -1.0, 1.0), ("y", -1.5, 1.0)], 20_000), || true);
    let all = all.unwrap_or_else(|why| panic!("{why:?}"));
    assert!(all.iter().all(|(_, own)| own.is_complete() && own.motions.is_empty()), "{all:?}");
    let families: Vec<_> = all.iter().flat_map(|(_, own)| &own.families).map(|(family, _)| family).collect();
    let [rest] = families[..] else { panic!("{} {all:?}", families.len()) };
    assert!(rest.dimension == 2 && rest.border > 0, "{rest:?}");
    let [low, high] = rest.reached[1].expect("its ends are reached");
    assert!((low + 1.2).abs() < 1e-6 && (high - 1.0).abs() < 1e-6, "{low} {high}");
}
