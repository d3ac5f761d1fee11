//! Singular positions of coordinates: neither equilibrium nor stability follows from the equations there.

use super::{all, model};
use dalembert_scenes::linearisation::{NotLinear, VariedEquations};
use dalembert_scenes::steady_motions::{Along, NoSteadyMotions, Range, SteadyMotion, SteadySearch, SteadyStability};

/// A spherical pendulum in two angles with poles below and above its centre.
const SPHERICAL: &str = "title = \"Spherical\"\ngravity = \"-(9.81 m/s^2)*N.z\"\n[coordinates]\nph = \"rad\"\nth = \"rad\"\n\
    [frames]\nA = \"N turned ph about z\"\nB = \"A turned -th about y\"\n[bodies]\nb = { centre = \"O - (0.5 m)*B.z\", mass = \"2 kg\" }\n\
    [run]\nspan = \"1 s\"\n";

fn is_singular(motion: &SteadyMotion) -> bool {
    matches!(&motion.stability, SteadyStability::Singular(names) if names[..] == ["ph"])
}

#[test]
fn at_the_pole_of_spherical_angles_there_is_no_verdict() {
    for rate in [0.0, 2.0, 6.0] {
        let found = all(SPHERICAL, &[("ph'", rate, rate)]);
        let (poles, others): (Vec<_>, Vec<_>) = found.motions.iter().partition(|motion| is_singular(motion));
        assert_eq!(poles.len(), 2, "{found:?}");
        assert!(poles.iter().all(|pole| pole.state[1].sin().abs() < 1e-9), "{poles:?}");
        assert!(others.iter().all(|own| matches!(own.stability, SteadyStability::Minimum)), "{others:?}");
        assert_eq!(others.len(), if rate > 4.5 { 2 } else { 0 });
    }
}

/// A constant force accelerates every point of a plane; in polar coordinates the equations of equilibrium hold at the centre for two angles.
#[test]
fn no_equilibrium_is_claimed_where_polar_coordinates_have_their_pole() {
    let text = "title = \"Polar\"\n[coordinates]\nr = \"m\"\nph = \"rad\"\n[frames]\nA = \"N turned ph about z\"\n\
        [bodies]\nb = { centre = \"O + r*A.x\", mass = \"1 kg\" }\n[[force]]\non = \"b\"\nis = \"(1 N)*N.x\"\n[run]\nspan = \"1 s\"\n";
    let found = all(text, &[("r", -0.7, 1.0)]);
    assert_eq!(found.motions.len(), 2, "{found:?}");
    assert!(found.motions.iter().all(is_singular), "{found:?}");
}

#[test]
fn linear_equations_are_refused_at_a_pole_and_next_to_it_by_rounding() {
    let model = model(SPHERICAL);
    let equations = VariedEquations::of(&model, &[]).expect("it has equations");
    for angle in [0.0, std::f64::consts::PI, 1e-15] {
        let at = equations.about(0.0, &[0.3, angle, 0.0, 0.0]).expect_err("a pole");
        assert_eq!(at, NotLinear::SingularCoordinates { speeds: vec![0] }, "{angle}");
    }
    assert!(equations.about(0.0, &[0.3, 1e-3, 0.0, 0.0]).is_ok());
}

/// Three angles of a body of revolution at their pole: the first and the last are one rotation, and no entry of the mass matrix is small.
#[test]
fn two_angles_that_are_one_rotation_are_singular_together() {
    let text = "title = \"Top\"\ngravity = \"-(9.81 m/s^2)*N.z\"\n[coordinates]\na = \"rad\"\nb = \"rad\"\nc = \"rad\"\n\
        [frames]\nA = \"N turned a about z\"\nB = \"A turned b about x\"\nC = \"B turned c about z\"\n\
        [bodies]\ntop = { frame = \"C\", centre = \"O + (0.1 m)*C.z\", mass = \"1 kg\", inertia = { axes = \"C\", principal = [\"2 g m^2\", \"2 g m^2\", \"1 g m^2\"] } }\n\
        [run]\nspan = \"1 s\"\n";
    let found = all(text, &[("a'", 0.0, 0.0), ("c'", 0.0, 0.0)]);
    let together = |motion: &SteadyMotion| matches!(&motion.stability, SteadyStability::Singular(names) if names[..] == ["a", "c"]);
    assert!(!found.motions.is_empty() && found.motions.iter().all(together), "{found:?}");
}

#[test]
fn a_parameter_that_takes_the_inertia_of_a_coordinate_away_is_told() {
    let text = "title = \"Hoop\"\ngravity = \"-(10 m/s^2)*N.y\"\n[parameters]\nR = \"0.4 m\"\n[coordinates]\nth = \"rad\"\n\
        [bodies]\nb = { centre = \"O + R*sin(th)*N.x - R*cos(th)*N.y\", mass = \"1 kg\" }\n[run]\nspan = \"1 s\"\n";
    let along = Along::of(
        &model(text),
        &SteadySearch { boxes: 1_000, ..SteadySearch::default() },
        ("R", Range { from: 0.0, to: 1.0 }),
        3,
        || true,
    );
    let along = along.unwrap_or_else(|why| panic!("{why:?}"));
    let [(0.0, NoSteadyMotions::At { values, why })] = &along.left_out[..] else { panic!("{along:?}") };
    assert_eq!(values[..], [("R".to_owned(), 0.0)]);
    assert_eq!(**why, NoSteadyMotions::Empty { coordinate: "th".to_owned() });
    assert_eq!(along.samples.iter().map(|sample| sample.value).collect::<Vec<_>>(), [0.5, 1.0]);
}

#[test]
fn poles_count_as_no_motions_along_a_speed() {
    let asked = SteadySearch { boxes: 1_000, ..SteadySearch::default() };
    let along = Along::of(&model(SPHERICAL), &asked, ("ph'", Range { from: 3.0, to: 6.0 }), 4, || true);
    let along = along.unwrap_or_else(|why| panic!("{why:?}"));
    for sample in &along.samples {
        let moves = sample.value > (9.81_f64 / 0.5).sqrt();
        assert_eq!(
            (sample.found.motions.len(), sample.found.singular_places.len()),
            (if moves { 2 } else { 0 }, 2),
            "{sample:?}"
        );
    }
    let [one] = &along.bifurcations[..] else { panic!("{:?}", along.bifurcations) };
    assert!(one.before.value < 4.43 && one.after.value > 4.42 && one.after.value < 4.46, "{one:?}");
}

/// A bead on a rod that turns at the frequency of its spring: its position is cyclic for this stiffness only.
#[test]
fn a_coordinate_that_is_cyclic_at_some_values_of_parameters_is_told_apart() {
    let rod = |stiffness: &str| {
        format!(
            "title = \"Rod\"\n[parameters]\nk = \"{stiffness} N/m\"\n[coordinates]\nx = \"m\"\n[frames]\nA = \"N turned (2 rad/s)*t about z\"\n\
             [bodies]\nb = {{ centre = \"O + x*A.x\", mass = \"1 kg\" }}\n[energies]\npotential = \"k*x^2/2\"\n[run]\nspan = \"1 s\"\n"
        )
    };
    let found = all(&rod("4"), &[]);
    assert_eq!((&found.cyclic[..], &found.cyclic_by_values[..]), (&["x".to_owned()][..], &["x".to_owned()][..]));
    assert!(all(&rod("5"), &[("x", -1.0, 1.0)]).cyclic.is_empty());
    let found = all(SPHERICAL, &[("ph'", 1.0, 1.0)]);
    assert_eq!((found.cyclic.len(), found.cyclic_by_values.len()), (1, 0));
}
