//! Every motor of the catalogue satisfies the conformance checks, and each check rejects a motor that violates it.

use claims::finding::{Finding, PropertyVerdict};
use dalembert_derivations::machines::asynchronous::Asynchronous;
use dalembert_derivations::studies::conformance::{conform, sample};
use dalembert_derivations::studies::scene::Scene;
use field::Scalar;
use motor::{Entry, Motor, catalogue};
use reader::{Allowed, Family, Quantity};
use symbolic::Sym;

#[test]
fn no_motor_of_the_list_fails_a_check() {
    for model in catalogue::entries().into_iter().map(|entry| entry.name).filter(|name| !name.starts_with("of_")) {
        let findings = conform(&sample(model).expect("it is in the catalogue"));
        assert_eq!(failed(&findings), [], "{model}");
        assert!(findings.iter().all(|finding| !matches!(finding.verdict, PropertyVerdict::Undecided(_))), "{model}");
    }
}

/// The scene of a text motor on a bench; its data may have any sign, since the checks test them.
fn text(machine: &str) -> Scene {
    let text = format!(
        "title = \"t\"\nsystem = \"bench\"\nallow = [\"zero resistance\", \"negative resistance\", \"negative friction\"]\n\
         [rotor]\naxial = \"0.01 kg m^2\"\n[machine]\nmodel = \"text\"\n\
         field_speed = \"30 rad/s\"\n{machine}\n[start]\nrotor_speed = \"1 rad/s\"\n[run]\nspan = \"1 s\"\n"
    );
    Scene::parse("scene.toml", &text).unwrap_or_else(|error| panic!("{error}"))
}

/// A magnet with one winding with these data; the parameters are k, l, r and u.
fn wound(inductance: &str, resistance: &str, more: &str) -> Scene {
    text(&format!(
        "field_energy = \"-k*cos(g)\"\ntorque_law = \"-f*phi'\"\n[machine.parameters]\nk = \"0.8 N m\"\n\
         f = \"0.004 N m s\"\na = \"60 mWb\"\nl = \"20 mH\"\nr = \"1.5 ohm\"\nu = \"12 V\"\n\
         [[machine.winding]]\nflux = \"-a*sin(g)\"\ninductance = \"{inductance}\"\nresistance = \"{resistance}\"\n{more}"
    ))
}

/// The checks that a motor fails, each with its reason.
fn failed(findings: &[Finding]) -> Vec<(&'static str, String)> {
    let fails = findings.iter().filter(|finding| matches!(finding.verdict, PropertyVerdict::Fails(_)));
    fails.map(|finding| (finding.check, finding.verdict.says().to_owned())).collect()
}

fn failed_by(scene: &Scene) -> Vec<(&'static str, String)> {
    failed(&conform(&scene.machine))
}

#[test]
fn a_sound_winding_fails_nothing() {
    assert_eq!(failed_by(&wound("l", "r", "")), []);
}

/// A denominator of degree 128 exceeds the limits of the normal form: the property remains undecided.
#[test]
fn what_the_prover_gives_up_is_undecided_and_does_not_fail() {
    let scene = text(
        "torque_law = \"-f*phi'/(1 + (tau*phi')^2)^64\"\n[machine.parameters]\nf = \"2e-5 N m s\"\ntau = \"25 ms\"",
    );
    let findings = conform(&scene.machine);
    assert_eq!(failed(&findings), []);
    let open = findings.iter().filter(|finding| matches!(finding.verdict, PropertyVerdict::Undecided(_)));
    let open: Vec<_> = open.map(|finding| (finding.check, finding.verdict.says())).collect();
    assert!(!open.is_empty() && open.iter().all(|(_, why)| !why.is_empty()), "{open:?}");
}

#[test]
fn a_torque_that_drives_away_from_step_is_not_passive() {
    let found =
        failed_by(&text("torque_law = \"mu*g' - f*phi'\"\n[machine.parameters]\nmu = \"2 N m s\"\nf = \"1 N m s\""));
    assert_eq!(found, [("passivity", "the torque m gives below synchronism: mu*g' - f*phi'".to_owned())]);
}

#[test]
fn a_negative_resistance_is_not_passive() {
    let found = failed_by(&wound("l", "-r", ""));
    assert!(found.contains(&("passivity", "winding x gives: its resistance is negative".to_owned())), "{found:?}");
}

#[test]
fn conductors_that_slide_under_a_turning_field_are_not_passive() {
    let found = failed_by(&wound("l", "r", "motional = \"a\"\nsupply = \"u\"\n"));
    let reason = "conductors that slide under a turning field give W sum c i".to_owned();
    assert_eq!(found, [("passivity", reason)]);
}

#[test]
fn a_supply_without_any_resistance_has_no_currents_that_rest() {
    let found: Vec<_> = failed_by(&wound("l", "0*r", "supply = \"u\"\n")).into_iter().map(|(check, _)| check).collect();
    assert_eq!(found, ["currents", "stationary", "stability", "stiffness"]);
}

#[test]
fn a_winding_almost_without_inductance_is_too_stiff_to_be_told() {
    let found = failed_by(&wound("1e-15*l", "r", ""));
    assert_eq!(found, [("stiffness", "the fastest motion hides the slowest in rounding".to_owned())]);
}

/// A motor whose friction coefficient does not have the declared unit.
static OF_ANOTHER_UNIT: Entry = Entry {
    name: "of_another_unit",
    summary: "deceives",
    data: &[Quantity::any("f", "N m", "friction")],
    counts: &[],
    write: |given| given.laws(&Asynchronous { field_speed: Sym::int(3), k: Sym::symbol("f"), f: Sym::ZERO }),
};

#[test]
fn a_unit_that_does_not_agree_is_found_out() {
    let laws = OF_ANOTHER_UNIT.laws(&[]).expect("they are short");
    let found: Vec<_> =
        failed(&conform(&Motor::new(laws, vec![0.5], Allowed::ALL))).into_iter().map(|(check, _)| check).collect();
    assert_eq!(found, ["dimensions"]);
}

static OWN: Entry = Entry { name: "of_ones_own", ..OF_ANOTHER_UNIT };
static ONE: Entry = Entry { name: "of_two", ..OF_ANOTHER_UNIT };

motor::submit! { motor::Catalogue { name: "own", motors: &[&OWN, &ONE, &ONE] } }

fn bench(model: &str) -> String {
    format!(
        "title = \"t\"\nsystem = \"bench\"\n[rotor]\naxial = \"0.01 kg m^2\"\n[machine]\nmodel = \"{model}\"\n\
         f = \"2 N m\"\n[start]\nrotor_speed = \"1 rad/s\"\n[run]\nspan = \"1 s\"\n"
    )
}

#[test]
fn a_motor_of_ones_own_is_found_by_its_name_where_its_crate_is_linked() {
    let scene = Scene::parse("scene.toml", &bench("of_ones_own")).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!((scene.machine.name(), scene.machine.datum("f")), ("of_ones_own", Some(2.0)));
}

#[test]
fn a_name_that_two_motors_have_is_refused() {
    let error = Scene::parse("scene.toml", &bench("of_two")).expect_err("which one is meant?").to_string();
    assert!(error.contains("several motors are called `of_two`"), "{error}");
}
