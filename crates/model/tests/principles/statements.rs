//! Statements about energy, momenta and constraints, and the terms that common mistakes in a derivation lose.

use crate::systems::{chain, disc, double_pendulum, entries, held, rolling_disc, sleigh, slider_crank, two_bodies};
use dalembert_model::{Agreement, Mistake, Model, Source, Statement, Trace, mistaken, statements};
use symbolic::{Decision, Hypotheses, Sym, apart};

fn stated(source: &Source) -> Vec<Statement> {
    let model = Model::of(source).unwrap_or_else(|faults| panic!("{faults:?}"));
    apart(|| statements(&Trace::of(&model)))
}

fn says(statements: &[Statement]) -> Vec<String> {
    statements.iter().map(|one| format!("{}: {}", one.subject, one.says)).collect()
}

/// Returns all statements about a system as text and asserts that all are proved.
pub fn says_of(source: &Source) -> Vec<String> {
    let all = stated(source);
    for Statement { subject, agreement, .. } in &all {
        assert!(matches!(agreement, Agreement::Proved { .. }), "{subject}: {agreement}");
    }
    says(&all)
}

#[test]
fn every_statement_of_every_system_is_proved() {
    let all = [double_pendulum(true), disc(), rolling_disc(), sleigh(), slider_crank(), two_bodies(), chain(3)];
    for source in all {
        for Statement { subject, says, agreement } in stated(&source) {
            assert!(matches!(agreement, Agreement::Proved { .. }), "{subject}: {says}: {agreement}");
        }
    }
}

#[test]
fn what_is_kept_is_told() {
    assert_eq!(
        says(&stated(&rolling_disc())),
        [
            "energy: (T + V)' is zero",
            "constraint 1 `rolling`: J u' + c is its rate; its reaction does no work",
            "constraint 2 `rolling`: J u' + c is its rate; its reaction does no work",
        ]
    );
    assert_eq!(
        says(&stated(&two_bodies())),
        ["energy: (T + V)' is the power of the forces", "momentum of p: (dT/dp')' is zero"]
    );
}

/// A double pendulum on a hoop that rotates at a prescribed speed: the balance concerns Jacobi's function T2 - T0 + V, not T + V.
#[test]
fn what_is_driven_takes_in_energy() {
    let mut hoop = double_pendulum(true);
    hoop.parameters.push(("w", "3 rad/s").into());
    hoop.frames = entries(&[("H", "N turned w*t about y"), ("A", "H turned a about z"), ("B", "A turned b about z")]);
    let [energy, ..] = &stated(&hoop)[..] else { panic!("it has an energy") };
    assert_eq!(energy.says, "(H = sum u dT/du - T + V)' is the power of the forces");
    assert!(matches!(energy.agreement, Agreement::Proved { .. }), "{}", energy.agreement);
    // a force on a body that the drive moves too: its power at u = 0 is supplied by the drive
    let drag =
        dalembert_model::LoadSource { on: Some("P".into()), is: "-(1 kg/s)*velocity(P)".into(), ..Default::default() };
    hoop.forces = vec![drag];
    let [energy, ..] = &stated(&hoop)[..] else { panic!("it has an energy") };
    assert!(matches!(energy.agreement, Agreement::Proved { .. }), "{}", energy.agreement);
    // an accelerated pivot: T depends on time explicitly
    let mut pivot = double_pendulum(true);
    pivot.points = entries(&[("P", "O + (1 m/s^2)*t^2*N.x - l1*A.y"), ("Q", "P - l2*B.y")]);
    let [energy, ..] = &stated(&pivot)[..] else { panic!("it has an energy") };
    assert!(energy.says.ends_with(" plus the partial rate of V - T by t"), "{}", energy.says);
    assert!(matches!(energy.agreement, Agreement::Proved { .. }), "{}", energy.agreement);
    let mut led = double_pendulum(true);
    led.parameters.push(("w", "3 rad/s").into());
    led.constraints = vec![held("led", &["a - w*t^2/(1 s)"])];
    let all = stated(&led);
    let last = all.last().expect("there is a constraint");
    assert_eq!(last.says, "J u' + c is its second rate; the power of its reaction is 2*w*t*lambda1");
    assert!(matches!(last.agreement, Agreement::Proved { .. }), "{}", last.agreement);
}

/// Reactions of constraints that are homogeneous in the speeds do no work (Appell-Hamel: of second degree); at a prescribed speed they do.
#[test]
fn homogeneous_constraints_do_no_work() {
    let work = |zero: &str| {
        let mut source = sleigh();
        source.constraints = vec![held("held", &[zero])];
        stated(&source).pop().expect("there is a constraint").says
    };
    assert_eq!(work("x'^2 - y'^2"), "J u' + c is its rate; its reaction does no work");
    assert_eq!(work("x'^2 + y'^2 - (1 m/s)^2"), "J u' + c is its rate; the power of its reaction is 2*lambda1");
    assert_eq!(work("x'/y' - x/(1 m)"), "J u' + c is its rate; its reaction does no work");
    assert_eq!(work("x'^3 - y'^2*x'"), "J u' + c is its rate; its reaction does no work");
}

/// The energy balance contains the power of the reaction of a rheonomic constraint: energy is not conserved.
#[test]
fn the_reaction_of_a_drive_feeds_the_energy() {
    let driven = |zero: &str| {
        let mut source = Source { torques: Vec::new(), ..double_pendulum(true) };
        source.parameters.push(("w", "3 rad/s").into());
        source.constraints = vec![held("drive", &[zero])];
        says(&stated(&source))
    };
    assert_eq!(
        driven("a' - w"),
        [
            "energy: (T + V)' is the power of the reactions (lambda1*w)",
            "constraint 1 `drive`: J u' + c is its rate; the power of its reaction is lambda1*w",
        ]
    );
    assert_eq!(driven("a' - 2*b'")[0], "energy: (T + V)' is zero");
    // a parameter called `lambda1` must not be confused with the first multiplier
    let mut source = Source { torques: Vec::new(), ..double_pendulum(true) };
    source.parameters.push(("lambda1", "3 rad/s").into());
    source.constraints = vec![held("drive", &["a' - lambda1"])];
    assert_eq!(says(&stated(&source))[0], "energy: (T + V)' is the power of the reactions (multiplier1*lambda1)");
}

/// A stabilised constraint is not exactly satisfied: its reaction does work, and the statement gives its equation with the gains.
#[test]
fn a_programmed_constraint_works_with_its_gains() {
    let mut source = Source { torques: Vec::new(), ..double_pendulum(true) };
    let mut lead = held("lead", &["a - 2*b"]);
    lead.gains = Some(vec!["(3 1/s)".into(), "(2 1/s^2)".into()]);
    source.constraints = vec![lead];
    let all = stated(&source);
    assert_eq!(
        says(&all),
        [
            "energy: (T + V)' is the power of the reactions (lambda1*(a' - 2*b'))",
            "constraint 1 `lead`: J u' + c is f'' + g1 f' + g2 f; the power of its reaction is lambda1*(a' - 2*b')",
        ]
    );
    for Statement { subject, agreement, .. } in all {
        assert!(matches!(agreement, Agreement::Proved { .. }), "{subject}: {agreement}");
    }
}

/// The energy balance of a variable mass contains the rate of the mass; the auxiliary symbols of the derivation are not printed.
#[test]
fn the_energy_of_a_mass_that_varies_is_balanced() {
    let mut source = sleigh();
    source.bodies[0].mass = Some("m + (1 kg/m)*x - (0.1 kg/s)*t".into());
    let [energy, edge] = &stated(&source)[..] else { panic!("it has an energy and a constraint") };
    assert_eq!(
        energy.says,
        "(T + V)' is the power of the forces plus sum m' d(T + V)/dm over the masses and moments of inertia m that vary"
    );
    assert!(matches!(energy.agreement, Agreement::Proved { .. }), "{}", energy.agreement);
    assert_eq!(edge.says, "J u' + c is its rate; its reaction does no work");
    let model = Model::of(&source).unwrap_or_else(|faults| panic!("{faults:?}"));
    apart(|| {
        let found = mistaken(&Trace::of(&model), Mistake::ConstraintsInEnergy).expect("it can be made");
        let printed = format!("{found:?}");
        assert!(!found.lost.is_empty() && !printed.contains("solidified"), "{printed}");
    });
}

/// A stabilised constraint is nonzero while it converges: its reaction has power during this time.
#[test]
fn a_programmed_constraint_is_led_by_its_gains() {
    let led = |zero: &str, gains: &[&str]| dalembert_model::ConstraintSource {
        gains: Some(gains.iter().map(|&gain| gain.into()).collect()),
        ..held("led", &[zero])
    };
    let mut source = double_pendulum(true);
    source.constraints = vec![
        led("sin(a) - b", &["(8 1/s)", "(16 1/s^2)"]),
        led("a' - b*(2 1/s)", &["(3 1/s)"]),
        held("kept", &["Q - P - l2*N.x"]),
    ];
    let told = says_of(&source);
    assert_eq!(
        told[1..],
        [
            "constraint 1 `led`: J u' + c is f'' + g1 f' + g2 f; the power of its reaction is lambda1*(a'*cos(a) - b')",
            "constraint 2 `led`: J u' + c is f' + g1 f; the power of its reaction is lambda2*a'",
            "constraint 3 `kept`: J u' + c is its second rate; its reaction does no work",
            "constraint 4 `kept`: J u' + c is its second rate; its reaction does no work",
        ]
    );
}

/// The rolling constraints substituted into T: Lagrange's equations for heading, lean and spin lose the term m r^2 cos(lean) lean' times
/// the rate of spin or heading.
#[test]
fn a_rolling_disc_by_angles_alone_is_refuted_with_the_lost_terms() {
    let model = Model::of(&rolling_disc()).unwrap_or_else(|faults| panic!("{faults:?}"));
    apart(|| {
        let trace = Trace::of(&model);
        let found = mistaken(&trace, Mistake::ConstraintsInEnergy).expect("it can be made");
        assert!(matches!(found.agreement, Agreement::Refuted { .. }), "{}", found.agreement);
        let [m, r, heading, lean, spin] = ["m", "r", "heading'", "lean'", "spin'"].map(Sym::symbol);
        let lever = m * r * r * symbolic_cosine("lean") * lean;
        let expected = [("heading", lever * spin), ("spin", -(lever * heading))];
        assert_eq!(found.lost.len(), expected.len(), "{:?}", found.lost);
        for ((name, lost), (known, term)) in found.lost.iter().zip(expected) {
            assert_eq!(name, known);
            let decided = Hypotheses::none().equal(*lost, term);
            assert!(matches!(decided, Decision::Zero(_)), "{name}: {lost}: {decided}");
        }
    });
}

fn symbolic_cosine(name: &str) -> Sym {
    use field::Analytic;
    Sym::symbol(name).circle().cos
}

/// Integrable constraints of speeds can be substituted into T without loss.
#[test]
fn an_integrable_constraint_loses_nothing() {
    let mut gear = double_pendulum(true);
    gear.constraints = vec![held("gear", &["a' - 2*b'"])];
    let model = Model::of(&gear).unwrap_or_else(|faults| panic!("{faults:?}"));
    apart(|| {
        let found = mistaken(&Trace::of(&model), Mistake::ConstraintsInEnergy).expect("it can be made");
        assert!(matches!(found.agreement, Agreement::Proved { .. }) && found.lost.is_empty(), "{found:?}");
        assert_eq!(
            found.says,
            "Lagrange's equations with the constraints put into T lose no term in this system, since its constraints of speeds are integrable"
        );
    });
}

/// A point in polar coordinates: S formed like T, with accelerations in place of speeds, lacks the centrifugal and the Coriolis term.
#[test]
fn accelerations_in_the_kinetic_energy_lose_what_speeds_bring() {
    let source = Source {
        parameters: entries(&[("m", "1 kg")]),
        coordinates: entries(&[("r", "m"), ("q", "rad")]),
        frames: entries(&[("A", "N turned q about z")]),
        points: entries(&[("P", "O + r*A.x")]),
        bodies: vec![dalembert_model::BodySource::particle("point", "P", "m")],
        ..Source::default()
    };
    let model = Model::of(&source).unwrap_or_else(|faults| panic!("{faults:?}"));
    apart(|| {
        let trace = Trace::of(&model);
        let found = mistaken(&trace, Mistake::AccelerationsInEnergy).expect("it can be made");
        assert!(matches!(found.agreement, Agreement::Refuted { .. }), "{}", found.agreement);
        let lost = found.lost.iter().map(|(name, term)| format!("{name}: {}", dalembert_model::shorter(&trace, *term)));
        let lost: Vec<String> = lost.collect();
        assert_eq!(lost, ["r: -m*q'^2*r", "q: 2*m*q'*r*r'"]);
    });
}

#[test]
fn a_mistake_that_cannot_be_made_says_why() {
    let model = Model::of(&slider_crank()).unwrap_or_else(|faults| panic!("{faults:?}"));
    apart(|| {
        let why = mistaken(&Trace::of(&model), Mistake::ConstraintsInEnergy).expect_err("positions alone");
        assert!(why.to_string().contains("the system has no constraint that contains speeds"), "{why}");
    });
}
