//! Steady motions of laws with conditions and in rotating frames, as `stationary` prints them.

use super::{printed, refused};
use crate::{run, temporary};

/// A file that is deleted with this value.
struct Scene(std::path::PathBuf);

impl Scene {
    fn of(name: &str, text: &str) -> Self {
        let path = temporary(name);
        std::fs::write(&path, text).expect("it can be written");
        Scene(path)
    }

    fn path(&self) -> String {
        self.0.to_string_lossy().into_owned()
    }
}

impl Drop for Scene {
    fn drop(&mut self) {
        let _ = std::fs::remove_file(&self.0);
    }
}

#[test]
fn a_play_is_told_by_the_functions_of_its_file() {
    let scene = Scene::of(
        "play.toml",
        "title = \"Play\"\n[parameters]\nm = \"1 kg\"\nk = \"50 N/m\"\ne = \"0.1 m\"\n[coordinates]\nx = \"m\"\n\
         [bodies]\nb = { centre = \"O + x*N.x\", mass = \"m\" }\n[energies]\npotential = \"k*max(abs(x) - e, 0)^2/2\"\n[run]\nspan = \"1 s\"\n",
    );
    let told = printed(&["stationary", &scene.path(), "--range", "x=-1..1.2"]);
    assert!(
        told.contains("where abs(x) - e < 0\n") && told.contains("a family, a curve: x from -0.1 to 0.1 m"),
        "{told}"
    );
    let object: serde_json::Value =
        serde_json::from_str(&printed(&["stationary", &scene.path(), "--range", "x=-1..1.2", "--format", "json"]))
            .expect("it is JSON");
    let family = &object["cases"][0]["families"][0];
    let end = |of: &str, side: usize| family[of][0][side].as_f64().expect("a number");
    assert!((end("hull", 1) - 0.1).abs() < 1e-8 && (end("reached", 0) + 0.1).abs() < 1e-8, "{family}");
}

#[test]
fn the_ends_of_sticking_friction_are_told_to_the_digits_that_are_printed() {
    let scene = Scene::of(
        "rough_joint.toml",
        "title = \"Rough joint\"\ngravity = \"-(10 m/s^2)*N.y\"\n[coordinates]\na = \"rad\"\n\
         [bodies]\nb = { centre = \"O + (0.1 m)*(sin(a)*N.x - cos(a)*N.y)\", mass = \"1 kg\" }\n\
         [[force]]\nalong = \"a\"\nis = \"-(0.2 N m)*sign(a')\"\n[run]\nspan = \"1 s\"\n",
    );
    // arcsin(0.2) = 0.201358
    let told = printed(&["stationary", &scene.path()]);
    assert!(told.contains("a within -0.20136 to 0.20136 rad"), "{told}");
}

#[test]
fn a_turning_hoop_is_judged_by_jacobis_integral() {
    let scene = Scene::of(
        "hoop.toml",
        "title = \"Hoop\"\ngravity = \"-g*N.z\"\n[parameters]\nR = \"0.25 m\"\ng = \"9 m/s^2\"\nw = \"6 rad/s\"\nspare = \"1 m\"\n[coordinates]\ntheta = \"rad\"\n\
         [frames]\nH = \"N turned w*t about z\"\n\
         [bodies]\nbead = { centre = \"O + R*(sin(theta)*H.x - cos(theta)*H.z)\", mass = \"1 kg\" }\n[run]\nspan = \"1 s\"\n",
    );
    let output = run(&["stationary", &scene.path()]);
    let (told, warned) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(told.contains("2 steady motions, each alone in its box; there are no others"), "{told}");
    assert!(told.contains("(Jacobi's integral) has a strict minimum"), "{told}");
    // the file is read once, so that the warning is printed once
    assert_eq!(warned.matches("the parameter `spare` is not used").count(), 1, "{warned}");
}

#[test]
fn eigenvalues_along_a_parameter_speak_of_zeros_where_there_are_some() {
    let text = |coordinates: &str, more: &str| {
        format!(
            "title = \"Damped\"\n[parameters]\nk = \"2 N/m\"\n[coordinates]\n{coordinates}\n[energies]\nkinetic = \"(1 kg)*x'^2/2{more}\"\npotential = \"k*x^2/2\"\n\
             [[force]]\nalong = \"x\"\nis = \"-(1 N s/m)*x'\"\n[run]\nspan = \"1 s\"\n"
        )
    };
    let plain = Scene::of("plain.toml", &text("x = \"m\"", ""));
    let told = printed(&["linearise", &plain.path(), "--along", "k=1..3"]);
    assert!(told.contains("every eigenvalue left of the imaginary axis") && !told.contains("zero"), "{told}");
    let cyclic = Scene::of("cyclic.toml", &text("x = \"m\"\ny = \"m\"", " + (1 kg)*y'^2/2"));
    let told = printed(&["linearise", &cyclic.path(), "--along", "k=1..3"]);
    assert!(told.contains("every eigenvalue but 2 zeros with reasons left of the imaginary axis"), "{told}");
}

/// The stiffnesses 0.1 + 0.2 - 0.3 cancel: both eigenvalues are zero, and one verdict is printed.
#[test]
fn linear_equations_have_one_verdict() {
    let text = |force: &str| {
        format!(
            "title = \"One\"\n[parameters]\nk1 = \"0.1 N/m\"\nk2 = \"0.2 N/m\"\nk3 = \"0.3 N/m\"\n[coordinates]\nx = \"m\"\n\
             [bodies]\nb = {{ centre = \"O + x*N.x\", mass = \"1 kg\" }}\n[[force]]\nalong = \"x\"\nis = \"{force}\"\n[run]\nspan = \"1 s\"\n"
        )
    };
    let cancelling = Scene::of("cancelling.toml", &text("(k1 + k2 - k3)*x - (1 N/m^3)*x^3"));
    let told = printed(&["linearise", &cancelling.path()]);
    assert!(told.contains("not decided by linear equations: zeros without a known reason"), "{told}");
    assert!(!told.contains("positive real part") && told.contains("  0.0 within"), "{told}");
    let drag = Scene::of("drag.toml", &text("-k1*x - (1 N s^2/m^2)*x'*abs(x') - (1 N s/m)*x'"));
    let told = printed(&["linearise", &drag.path()]);
    assert!(told.contains("asymptotically stable, by Routh's criterion") && !told.contains("numerical"), "{told}");
    let told = printed(&["stationary", &drag.path(), "--range", "x=-1..1"]);
    assert!(told.contains("asymptotically stable, by Routh's criterion"), "{told}");
}

#[test]
fn changes_that_the_table_shows_are_not_denied_and_a_cubic_force_decides_nothing() {
    let text = |is: &str, unit: &str| {
        format!(
            "title = \"One\"\n[parameters]\np = \"3 {unit}\"\n[coordinates]\nx = \"m\"\n[bodies]\nb = {{ centre = \"O + x*N.x\", mass = \"1 kg\" }}\n\
             [[force]]\nalong = \"x\"\nis = \"{is}\"\n[run]\nspan = \"1 s\"\n"
        )
    };
    let rough = Scene::of("rough.toml", &text("-(4 N/m)*x - p*sign(x')", "N"));
    let told = printed(&["stationary", &rough.path(), "--range", "x=-1..1", "--along", "p=-3..3", "--values", "7"]);
    assert!(told.contains("p = 0 N: one motion") && !told.contains("no change is seen"), "{told}");
    // x = 0 is unstable, and its linear equations do not contain x
    let cubic = Scene::of("cubic.toml", &text("p*x^3/(1 m^2) - (1 N s/m)*x'", "N/m"));
    let told = printed(&["stationary", &cubic.path(), "--range", "x=-2..2"]);
    assert!(told.contains("not decided by linear equations") && !told.contains("asymptotically stable"), "{told}");
}

/// A pendulum whose joint has the torque `friction`.
fn rough_joint(name: &str, friction: &str) -> Scene {
    Scene::of(
        name,
        &format!(
            "title = \"Rough joint\"\ngravity = \"-(10 m/s^2)*N.y\"\n[coordinates]\na = \"rad\"\n\
             [bodies]\nb = {{ centre = \"O + (0.1 m)*(sin(a)*N.x - cos(a)*N.y)\", mass = \"1 kg\" }}\n\
             [[force]]\nalong = \"a\"\nis = \"{friction}*sign(a')\"\n[run]\nspan = \"1 s\"\n"
        ),
    )
}

#[test]
fn rest_that_friction_holds_is_stable_and_may_be_at_every_angle() {
    let told = printed(&["stationary", &rough_joint("held.toml", "-(0.2 N m)").path()]);
    assert!(told.contains("stable, by enclosures: dry friction resists every motion"), "{told}");
    let told = printed(&["stationary", &rough_joint("fed.toml", "(0.2 N m)").path()]);
    assert!(told.contains("the coefficient of dry friction is negative"), "{told}");
    let told = printed(&["stationary", &rough_joint("everywhere.toml", "-(2 N m)").path()]);
    assert!(told.contains("a family, a curve: every angle a, [a' > 0] within 0.25 to 0.75"), "{told}");
    let told = printed(&["stationary", &rough_joint("smooth.toml", "-(0 N m)").path()]);
    assert!(told.contains("stable, by enclosures: the potential energy has a strict minimum"), "{told}");
}

#[test]
fn methods_are_not_judged_on_families_and_this_is_printed() {
    let told = printed(&["numerical-stability", &rough_joint("steps.toml", "-(0.2 N m)").path()]);
    assert!(told.contains("2 families of connected steady motions, left out"), "{told}");
}

#[test]
fn methods_are_judged_on_motions_in_touch_with_a_smooth_contact() {
    let scene = Scene::of(
        "parabola.toml",
        "title = \"Parabola\"\ngravity = \"-(10 m/s^2)*N.y\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n\
         [bodies]\np = { centre = \"O + x*N.x + y*N.y\", mass = \"1 kg\" }\n[[contact]]\nof = \"p\"\n\
         gap = \"y - (0.2 1/m)*x^2\"\nnormal = \"N.y - (0.4 1/m)*x*N.x\"\n[run]\nspan = \"1 s\"\n",
    );
    let told = printed(&["numerical-stability", &scene.path(), "--range", "x=-1..1.1", "--range", "y=-1..1"]);
    // x'' = -2 m g a x/m: the eigenvalues are ±2i rad/s
    assert!(told.contains("eigenvalues, 1/s: ±2.0000000000i") && !told.contains("not known"), "{told}");
}

#[test]
fn a_place_that_coordinates_do_not_describe_gets_no_verdict() {
    let scene = Scene::of(
        "spherical.toml",
        "title = \"Spherical\"\ngravity = \"-(9.81 m/s^2)*N.z\"\n[coordinates]\nph = \"rad\"\nth = \"rad\"\n\
         [frames]\nA = \"N turned ph about z\"\nB = \"A turned -th about y\"\n\
         [bodies]\nb = { centre = \"O - (0.5 m)*B.z\", mass = \"2 kg\" }\n[start]\nth = \"40 deg\"\n\"ph'\" = \"6 rad/s\"\n[run]\nspan = \"1 s\"\n",
    );
    let told = printed(&["stationary", &scene.path()]);
    assert!(
        told.contains("2 steady motions, each alone in its box, and 2 places at which the coordinates are singular"),
        "{told}"
    );
    assert!(
        told.contains("no verdict: the mass matrix is singular there, since the coordinate `ph` has no inertia"),
        "{told}"
    );
    refused(&["linearise", &scene.path(), "--set", "th=0"], "these coordinates do not describe the position");
}

#[test]
fn the_time_is_refused_where_it_enters() {
    let scene = Scene::of(
        "swept.toml",
        "title = \"Swept\"\ngravity = \"-(10 m/s^2)*N.y\"\n[coordinates]\nth = \"rad\"\n[frames]\nH = \"N turned (2 rad/s^2)*t^2 about y\"\n\
         [bodies]\nb = { centre = \"O + (0.4 m)*(sin(th)*H.x - cos(th)*N.y)\", mass = \"1 kg\" }\n[run]\nspan = \"1 s\"\n",
    );
    refused(&["stationary", &scene.path()], "6 | H = \"N turned (2 rad/s^2)*t^2 about y\"");
}
