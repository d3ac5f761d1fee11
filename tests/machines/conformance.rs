//! Every motor of the list does what a motor must, and each check notices one that does not.

use dalembert_derivations::conformance::{Finding, Kit, Verdict, conform, sample};
use dalembert_derivations::machines::{
    AnyMachine, Catalogued, Datum, ForMachine, Machine, Quantity, RotorState, Source,
};
use dalembert_derivations::scene::{Family, MachineData, Scene};
use field::{Base, Circle, Over};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

#[test]
fn no_motor_of_the_list_fails_a_check() {
    for (model, _) in AnyMachine::LIST {
        let (machine, data) = sample(model).expect("it is in the list");
        let findings = conform(&machine, &data);
        assert_eq!(failed(&findings), [], "{model}");
        assert!(findings.iter().all(|finding| !matches!(finding.verdict, Verdict::Undecided(_))), "{model}");
    }
}

/// The table of a written motor on a bench; whatever its data, the checks are to judge them.
fn text(machine: &str) -> Scene {
    let text = format!(
        "title = \"t\"\nsystem = \"bench\"\nallow = [\"zero resistance\", \"negative resistance\", \"negative friction\"]\n\
         [rotor]\naxial = \"0.01 kg m^2\"\n[machine]\nmodel = \"text\"\n\
         field_speed = \"30 rad/s\"\n{machine}\n[start]\nrotor_speed = \"1 rad/s\"\n[run]\nspan = \"1 s\"\n"
    );
    Scene::parse("scene.toml", &text).unwrap_or_else(|error| panic!("{error}"))
}

/// A magnet with one winding of these data, in the parameters k, l, r and u.
fn wound(inductance: &str, resistance: &str, more: &str) -> Scene {
    text(&format!(
        "field_energy = \"-k*cos(g)\"\nmoment_law = \"-f*phi'\"\n[machine.parameters]\nk = \"0.8 N m\"\n\
         f = \"0.004 N m s\"\na = \"60 mWb\"\nl = \"20 mH\"\nr = \"1.5 ohm\"\nu = \"12 V\"\n\
         [[machine.winding]]\nflux = \"-a*sin(g)\"\ninductance = \"{inductance}\"\nresistance = \"{resistance}\"\n{more}"
    ))
}

/// The checks that a motor fails, each with its reason.
fn failed(findings: &[Finding]) -> Vec<(&'static str, String)> {
    let fails = findings.iter().filter(|finding| matches!(finding.verdict, Verdict::Fails(_)));
    fails.map(|finding| (finding.check, finding.verdict.says().to_owned())).collect()
}

fn failed_by(scene: &Scene) -> Vec<(&'static str, String)> {
    failed(&conform(&scene.machine, &scene.machine_data))
}

#[test]
fn a_sound_winding_fails_nothing() {
    assert_eq!(failed_by(&wound("l", "r", "")), []);
}

/// A denominator of degree 128, which no normal form holds: the motor may be sound for all that is known.
#[test]
fn what_the_prover_gives_up_is_undecided_and_does_not_fail() {
    let scene = text(
        "moment_law = \"-f*phi'/(1 + (tau*phi')^2)^64\"\n[machine.parameters]\nf = \"2e-5 N m s\"\ntau = \"25 ms\"",
    );
    let findings = conform(&scene.machine, &scene.machine_data);
    assert_eq!(failed(&findings), []);
    let open = findings.iter().filter(|finding| matches!(finding.verdict, Verdict::Undecided(_)));
    let open: Vec<_> = open.map(|finding| (finding.check, finding.verdict.says())).collect();
    assert!(!open.is_empty() && open.iter().all(|(_, why)| !why.is_empty()), "{open:?}");
}

#[test]
fn a_moment_that_drives_away_from_step_is_not_passive() {
    let found =
        failed_by(&text("moment_law = \"mu*g' - f*phi'\"\n[machine.parameters]\nmu = \"2 N m s\"\nf = \"1 N m s\""));
    assert_eq!(found, [("passivity", "the moment m gives below synchronism: mu*g' - f*phi'".to_owned())]);
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

#[test]
fn a_law_that_runs_with_other_data_does_not_rest_where_the_exact_one_does() {
    let (own, other) = (wound("l", "r", ""), wound("l", "r", "supply = \"u\"\n"));
    let found: Vec<_> =
        failed(&conform(&other.machine, &own.machine_data)).into_iter().map(|(check, _)| check).collect();
    assert_eq!(found, ["stationary", "stability"]);
}

/// How a law deceives.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Trick {
    /// Its fluxes differ from call to call.
    Fickle,
    /// It brakes for the first few calls, then it drives.
    Tired,
    /// Its friction is not of the unit that it says.
    Unit,
}

/// A motor that keeps count of its calls: what no text can say, and no law may.
#[derive(Clone, Debug)]
struct Deceiver<P> {
    trick: Trick,
    calls: Arc<AtomicUsize>,
    friction: P,
}

static FRICTION: Quantity = Quantity::any("f", "N m s", "friction");
static OF_ANOTHER_UNIT: Quantity = Quantity::any("f", "N m", "friction");

impl<P: Base> Deceiver<P> {
    fn call(&self) -> usize {
        self.calls.fetch_add(1, Ordering::Relaxed)
    }
}

/// Of a trick as a type, since a machine is read without a value.
macro_rules! deceivers {
    ($($name:ident: $trick:ident, $rotor:ident, $windings:literal;)*) => {$(
        #[derive(Clone, Debug)]
        struct $name<P>(Deceiver<P>);

        impl<P: Base> Machine<P> for $name<P> {
            const ROTOR: RotorState = RotorState::$rotor;

            fn frame_speed(&self) -> P {
                P::int(3)
            }

            fn windings(&self) -> usize {
                $windings
            }

            fn resistance(&self, _winding: usize) -> P {
                P::one()
            }

            fn linkage<S: Over<P>>(&self, winding: usize, angle: Circle<S>) -> S {
                let flux = if winding == 0 { angle.cos } else { angle.sin };
                S::int((self.0.call() % 7) as i64) * flux
            }

            fn moment_law<S: Over<P>>(&self, slip: S, _speed: S) -> S {
                let braking = -S::lift(self.0.friction) * slip;
                if self.0.trick == Trick::Tired && self.0.call() >= CALLS { -braking } else { braking }
            }
        }

        impl Catalogued for $name<f64> {
            const SUMMARY: &'static str = "deceives";
            type Over<P: Datum> = $name<P>;

            fn read<P: Datum, E>(source: &mut impl Source<P, Error = E>) -> Result<$name<P>, E> {
                let unit = Trick::$trick == Trick::Unit;
                let friction = source.quantity(if unit { &OF_ANOTHER_UNIT } else { &FRICTION })?;
                Ok($name(Deceiver { trick: Trick::$trick, calls: Arc::default(), friction }))
            }
        }
    )*};
}

/// After so many calls the tired motor's eigenvalues are known.
const CALLS: usize = 8;

deceivers! {
    Fickle: Fickle, AngleAndSpeed, 2;
    Tired: Tired, Speed, 0;
    OfAnotherUnit: Unit, Speed, 0;
}

/// What a deceiver fails.
fn found_out<M: Catalogued + Clone + Send + Sync + 'static>(machine: M) -> Vec<&'static str> {
    let mut data = MachineData::default();
    data.numbers.push((FRICTION.clone(), 0.5));
    failed(&Kit { name: "deceiver", data: &data }.apply(machine)).into_iter().map(|(check, _)| check).collect()
}

#[test]
fn a_law_that_is_no_function_of_the_state_is_found_out_by_every_identity() {
    let machine = Fickle(Deceiver { trick: Trick::Fickle, calls: Arc::default(), friction: 0.5 });
    let found = found_out(machine);
    for check in ["power", "frame", "windings", "housing", "bench", "jacobian"] {
        assert!(found.contains(&check), "{check} is not in {found:?}");
    }
}

#[test]
fn a_run_that_does_not_do_what_the_eigenvalues_say_is_found_out() {
    let machine = Tired(Deceiver { trick: Trick::Tired, calls: Arc::default(), friction: 0.5 });
    assert!(found_out(machine).contains(&"stability"));
}

#[test]
fn a_unit_that_does_not_agree_is_found_out() {
    let machine = OfAnotherUnit(Deceiver { trick: Trick::Unit, calls: Arc::default(), friction: 0.5 });
    assert_eq!(found_out(machine), ["dimensions"]);
}
