//! Laws with a jump or a kink at a condition that is linear in no letter or depends on positions.

use super::{asked, model};
use dalembert_scenes::steady_motions::{SteadyMotion, SteadyMotions, SteadyStability};

fn motions(force: &str, range: [f64; 2]) -> Vec<SteadyMotion> {
    let text = format!(
        "title = \"One\"\n[coordinates]\nx = \"rad\"\n[bodies]\np = {{ turns = \"x\", inertia = \"1 kg m^2\" }}\n[[force]]\nalong = \"x\"\n\
         is = \"(1 N m)*({force})\"\n"
    );
    let found = SteadyMotions::of_cases(&model(&text), &asked(&[("x", range[0], range[1])], 20_000), || true);
    let found = found.unwrap_or_else(|why| panic!("{why:?}"));
    assert!(found.iter().all(|(_, own)| own.is_complete() && own.families.is_empty()), "{found:?}");
    let mut all: Vec<SteadyMotion> = found.into_iter().flat_map(|(_, own)| own.motions).collect();
    all.sort_by(|a, b| a.state[0].total_cmp(&b.state[0]));
    all
}

#[test]
fn a_rest_at_the_zero_of_a_condition_without_a_solved_letter_is_told_once() {
    let found = motions("-abs(sin(x))", [-1.1, 4.3]);
    let places: Vec<f64> = found.iter().map(|motion| motion.state[0]).collect();
    assert!(
        places.len() == 2 && places[0].abs() < 1e-9 && (places[1] - std::f64::consts::PI).abs() < 1e-9,
        "{places:?}"
    );
    // V = 1 - cos x on one side, cos x - 1 on the other, where it decreases
    assert!(found.iter().all(|motion| matches!(motion.stability, SteadyStability::FallsOnSide(1))), "{found:?}");
    let found = motions("-abs(sin(x))*sin(x) - x/10", [-1.1, 1.2]);
    let [motion] = &found[..] else { panic!("{found:?}") };
    assert!(matches!(motion.stability, SteadyStability::Minimum), "{motion:?}");
}

#[test]
fn a_jump_towards_its_edge_holds_and_one_away_drives_off() {
    for (force, is_stable) in [
        ("0.3 - sign(x - 0.5)", true),
        ("0.3 + sign(x - 0.5)", false),
        ("0.3 - if(x^2 > 0.25, 1, -1)*sign(x)", true),
        ("if(sin(x) > 0.2, 1, -0.5)", false),
    ] {
        let found = motions(force, [0.1, 1.2]);
        let [motion] = &found[..] else { panic!("{force}: {found:?}") };
        match is_stable {
            true => assert!(matches!(motion.stability, SteadyStability::MinimumOnSides), "{force}: {motion:?}"),
            false => assert!(matches!(motion.stability, SteadyStability::FallsOnSide(1)), "{force}: {motion:?}"),
        }
    }
    // a negative damper supplies energy to motions of any amplitude
    let text = "title = \"Fed\"\n[coordinates]\nx = \"m\"\n[bodies]\np = { centre = \"O + x*N.x\", mass = \"1 kg\" }\n[[force]]\nalong = \"x\"\n\
                is = \"-(1 N)*sign(x) + (1 N s/m)*x'\"\n";
    let found =
        SteadyMotions::of_cases(&model(text), &asked(&[("x", -1.0, 1.0)], 2_000), || true).expect("it is searched");
    let all: Vec<&SteadyMotion> = found.iter().flat_map(|(_, own)| &own.motions).collect();
    assert!(matches!(all[..], [SteadyMotion { stability: SteadyStability::AtCondition(None), .. }]), "{all:?}");
}

/// A potential with an edge in a plane: the force along x jumps at x = 0, and a spring acts along y.
#[test]
fn an_edge_of_the_energy_in_a_plane_holds_where_the_energy_has_a_minimum_on_it() {
    for (k, is_stable) in [("2", true), ("-2", false)] {
        let text = format!(
            "title = \"Edge\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n[bodies]\np = {{ centre = \"O + x*N.x + y*N.y\", mass = \"1 kg\" }}\n\
             [energies]\npotential = \"(1 N)*abs(x) + ({k} N/m)*y^2/2 - (0.5 N)*x\"\n"
        );
        let found =
            SteadyMotions::of_cases(&model(&text), &asked(&[("x", -1.0, 1.2), ("y", -1.0, 1.2)], 2_000), || true);
        let found = found.expect("it is searched");
        let all: Vec<&SteadyMotion> = found.iter().flat_map(|(_, own)| &own.motions).collect();
        let [motion] = all[..] else { panic!("{all:?}") };
        match is_stable {
            true => assert!(matches!(motion.stability, SteadyStability::MinimumOnSides), "{motion:?}"),
            false => assert!(matches!(motion.stability, SteadyStability::AtCondition(None)), "{motion:?}"),
        }
    }
}
