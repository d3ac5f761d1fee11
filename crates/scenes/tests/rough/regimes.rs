//! All regimes at a start: those consistent with their own motion, their margins, and the number of motions.

use super::{rod, stored};
use dalembert_scenes::{Motions, Regimes, Task, parse_titled, regimes};

fn of(text: &str) -> Regimes {
    let (_, model) = parse_titled("scene.toml", text, Task::Run).unwrap_or_else(|error| panic!("{error}"));
    regimes(model).unwrap_or_else(|issue| panic!("{issue:?}"))
}

/// The names of the regimes, with rounded margins.
fn shown(found: &Regimes) -> Vec<String> {
    let margin = |margin: &dalembert_scenes::Margin| format!("{} {:.5} {}", margin.asks, margin.value, margin.unit);
    let of = |regime: &dalembert_scenes::Regime| {
        let margins: Vec<String> = regime.margins.iter().map(margin).collect();
        format!("{}: {}", regime.name, margins.join(", "))
    };
    found.regimes.iter().map(of).collect()
}

/// Painleve's rod with friction beyond (1 + 3 cos^2)/(3 sin cos) and an angular velocity that would lift it: it may separate or be pressed. The
/// numbers agree with the rod that is compiled into the program.
#[test]
fn painleves_rod_has_no_motion_one_or_several() {
    let none = of(&rod("63 deg", "0 rad/s", -3.0));
    assert_eq!((none.motions, shown(&none)), (Motions::None, Vec::new()));
    let several = of(&rod("63 deg", "4 rad/s", -4.0));
    assert_eq!(several.motions, Motions::Several);
    let known = [
        "contact `end` slides backwards: normal reaction |N| 5.49765 N",
        "contact `end` is apart: separation gap'' 4.44610 m/s^2",
    ];
    assert_eq!(shown(&several), known);
    assert_eq!(several.regimes.iter().map(|regime| regime.motion).collect::<Vec<_>>(), [0, 1]);
    let one = of(&rod("34 deg", "3 rad/s", -3.0));
    assert_eq!(one.motions, Motions::One);
    assert_eq!(shown(&one), ["contact `end` slides backwards: normal reaction |N| 17.03985 N"]);
}

/// f* = (1 + k c^2)/(k s c) with k = m l^2/I = 3, as in the claims on rods; a block on a plane has no critical friction.
#[test]
fn the_friction_at_which_reactions_are_not_determined_is_that_of_the_claims() {
    let found = of(&super::rod("1 rad", "0 rad/s", -1.0));
    let (s, c) = 1.0_f64.sin_cos();
    let critical = found.critical.expect("a rod has one");
    super::close(2.0 * critical.factor, (1.0 + 3.0 * c * c) / (3.0 * s * c), 1e-12);
    assert_eq!(critical.regime, "contact `end` slides backwards");
    // forward sliding is never critical
    assert_eq!(of(&super::rod("1 rad", "0 rad/s", 1.0)).critical, None);
}

/// Two masses on parallel guides, connected by a rod with tan of its angle 4/3, moving forwards (Painleve 1895, Klein 1909); with coordinates
/// across the guides (`across`), or with guides as contacts.
fn sliders(friction: &str, load: &str, across: bool) -> String {
    let guide = |name: &str, body: &str, friction: &str, through: &str| {
        let place = match across {
            true => format!("of = \"{body}\"\nnormal = \"N.y\"\nsides = \"both\""),
            false => format!("between = \"{body}, N along x\""),
        };
        format!("[[contact]]\nname = \"{name}\"\n{place}\nthrough = \"{through}\"\n{friction}\n")
    };
    let [coordinates, first, second] = match across {
        true => ["x1 = \"m\"\ny1 = \"m\"\nx2 = \"m\"\ny2 = \"m\"\n", " + y1*N.y", " + y2*N.y"],
        false => ["x1 = \"m\"\nx2 = \"m\"\n", "", " + (4 m)*N.y"],
    };
    let start = if across { "y2 = \"4 m\"\n" } else { "" };
    let first_guide = guide("rough", "one", &format!("friction = \"{friction}\""), "O");
    let second_guide = guide("smooth", "two", "", "O + (4 m)*N.y");
    format!(
        "title = \"sliders\"\n[coordinates]\n{coordinates}\
         [points]\nA = \"O + x1*N.x{first}\"\nB = \"O + x2*N.x{second}\"\n\
         [bodies.one]\ncentre = \"A\"\nmass = \"(1 kg)\"\n[bodies.two]\ncentre = \"B\"\nmass = \"(1 kg)\"\n\
         [[force]]\non = \"one\"\nis = \"({load} N)*N.x\"\n[[force]]\non = \"two\"\nis = \"(1 N)*N.x\"\n\
         [[constraint]]\nzero = \"distance(A, B) - (5 m)\"\n{first_guide}{second_guide}\
         [start]\nx2 = \"3 m\"\n{start}\"x1'\" = \"1 m/s\"\n[run]\nspan = \"1 s\"\n"
    )
}

/// (m1 + m2 - f m2 tan) x'' = P1 + P2 - f P2 tan: at the critical friction 2/tan this is 0 = 0 for P1 = P2, and 0 = -1 without P1.
#[test]
fn at_the_critical_friction_one_load_gives_motions_without_end() {
    for across in [true, false] {
        let motions = |friction: &str, load: &str| of(&sliders(friction, load, across)).motions;
        assert_eq!(motions("1.5", "1"), Motions::Continuum, "{across}");
        assert_eq!(motions("1.5", "0"), Motions::None, "{across}");
        assert_eq!(motions("2.25", "2"), Motions::Several, "{across}");
        assert_eq!(motions("2.25", "0"), Motions::None, "{across}");
        assert_eq!(motions("1.4", "3"), Motions::One, "{across}");
    }
    let run = super::runs(&sliders("1.5", "1", true), integrators::Method::DormandPrince8, 1e-9);
    assert!(run.stopped().is_some_and(|why| why.starts_with("does not begin: infinitely many motions")));
}

/// A block of 2 kg with the coefficient of friction 0.25 and a horizontal force F: at F = 5 N = f m g it is exactly at the limit of sticking.
#[test]
fn a_block_on_the_boundary_of_sticking_has_one_motion() {
    let block = |push: &str| {
        of(&format!(
            "title = \"block\"\ngravity = \"-(10 m/s^2)*N.y\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n\
             [points]\nP = \"O + x*N.x + y*N.y\"\n[bodies.block]\ncentre = \"P\"\nmass = \"(2 kg)\"\n\
             [[force]]\non = \"block\"\nis = \"({push} N)*N.x\"\n\
             [[contact]]\nname = \"floor\"\nof = \"block\"\nthrough = \"O\"\nnormal = \"N.y\"\nfriction = \"0.25\"\ntouching = true\n\
             [run]\nspan = \"1 s\"\n"
        ))
    };
    let sticks = block("3");
    assert_eq!(sticks.motions, Motions::One);
    let margins =
        "normal reaction |N| 20.00000 N, friction limit f|N| - T 8.00000 N, friction limit f|N| + T 2.00000 N";
    assert_eq!(shown(&sticks), [format!("contact `floor` sticks: {margins}")]);
    let bound = block("5");
    assert_eq!(bound.motions, Motions::OneOnItsBoundary, "{:?}", shown(&bound));
    let slides = block("7");
    assert_eq!(slides.motions, Motions::One);
    let margins = "normal reaction |N| 20.00000 N, acceleration of the slip 1.00000 m/s^2";
    assert_eq!(shown(&slides), [format!("contact `floor` slides forwards: {margins}")]);
}

/// A ladder at rest with large friction has more reactions than its motion determines: several regimes give the one motion.
#[test]
fn several_regimes_may_give_one_motion() {
    let found = of(&stored("models/leaning_ladder")
        .replace("\"-0.7 rad/s\"", "\"0 rad/s\"")
        .replace("f = \"0.3\"", "f = \"0.9\""));
    assert_eq!(found.motions, Motions::One);
    assert!(found.regimes.iter().any(|regime| regime.is_one_choice), "{:?}", shown(&found));
    assert!(found.regimes.iter().all(|regime| regime.motion == 0), "{:?}", shown(&found));
}

#[test]
fn conditions_and_diodes_have_regimes_too() {
    let dry = stored("models/dry_friction");
    let rest = dry.lines().map(|line| {
        if line.starts_with("\"x'\"") {
            "\"x'\" = \"0 m/s\""
        } else if line == "x = \"12 m\"" {
            "x = \"0.5 m\""
        } else {
            line
        }
    });
    let found = of(&rest.collect::<Vec<_>>().join("\n"));
    assert_eq!(found.regimes.len(), 1, "{:?}", shown(&found));
    assert!(shown(&found)[0].starts_with("x' stays at 0"), "{:?}", shown(&found));
    let rectifier = of(&stored("models/rectifier_drive"));
    assert!(shown(&rectifier)[0].starts_with("diode `A` blocks, diode `B` conducts"), "{:?}", shown(&rectifier));
}

/// A body at rest touches two planes that face almost alike. It may turn away from the first, or stay wedged: N0 = N1 = 13.8 N with the frictions
/// T0 = -18.2 N and T1 = 16.2 N keep it in balance, within the bounds 2.618 N0 and 2.547 N1.
#[test]
fn a_body_that_may_stay_wedged_or_leave_has_two_motions() {
    let contact = |name: &str, point: [&str; 2], normal: [&str; 2], friction: &str| {
        format!(
            "[[contact]]\nname = \"{name}\"\nof = \"b at {name}\"\nthrough = \"O + ({} m)*N.x + ({} m)*N.y\"\nnormal = \"({})*N.x + ({})*N.y\"\n\
             friction = \"{friction}\"\n",
            point[0], point[1], normal[0], normal[1]
        )
    };
    let of_friction = |first: &str| {
        let text = "title = \"Wedge\"\ngravity = \"-(9.81 m/s^2)*N.y\"\n[coordinates]\nx = \"m\"\ny = \"m\"\na = \"rad\"\n[frames]\n\
            A = \"N turned a about z\"\n[points]\nG = \"O + x*N.x + y*N.y\"\nP = \"G - (0.969 m)*A.x + (0.862 m)*A.y\"\n\
            Q = \"G - (0.39 m)*A.x - (0.053 m)*A.y\"\n[bodies.b]\nframe = \"A\"\ncentre = \"G\"\nmass = \"2.421 kg\"\ninertia = \"0.847 kg m^2\"\n"
            .to_owned();
        text + &contact("P", ["-0.969", "0.862"], ["-0.025736", "0.999669"], first)
            + &contact("Q", ["-0.39", "-0.053"], ["0.192883", "0.981222"], "2.547")
            + "[run]\nspan = \"1 s\"\n"
    };
    let found = of(&of_friction("2.618"));
    assert_eq!(found.motions, Motions::Several, "{:?}", shown(&found));
    assert_eq!(found.regimes[0].name, "contact `P` is apart, contact `Q` sticks");
    let wedged: Vec<_> = found.regimes.iter().skip(1).collect();
    assert!(!wedged.is_empty() && wedged.iter().all(|own| own.motion == 1 && own.is_one_choice), "{:?}", shown(&found));
    let smooth = of(&of_friction("0.1"));
    assert_eq!((smooth.motions, smooth.regimes.len()), (Motions::One, 1), "{:?}", shown(&smooth));
}

#[test]
fn a_system_without_contacts_and_conditions_is_refused() {
    let read = parse_titled("scene.toml", &stored("models/double_pendulum"), Task::Run);
    let (_, model) = read.unwrap_or_else(|error| panic!("{error}"));
    let issue = regimes(model).expect_err("it has one regime");
    assert!(issue.title.contains("one regime"), "{issue:?}");
}
