//! Equations of motion of another program, compared with those of a model.

use claims::Verdict;
use dalembert_manuscript::{PeerEquations, PeerFinding};
use scenes::SystemText;

const TWO_LINKS: &str = r#"
gravity = "-g*N.y"
[parameters]
m = "kg"
l = "m"
g = "m/s^2"
[coordinates]
a = "rad"
b = "rad"
[points]
P = "O + l*(sin(a)*N.x - cos(a)*N.y)"
Q = "P + l*(sin(b)*N.x - cos(b)*N.y)"
[bodies.first]
centre = "P"
mass = "m"
[bodies.second]
centre = "Q"
mass = "m"
"#;

fn pairs<const N: usize>(all: [[&str; 2]; N]) -> Vec<(String, String)> {
    all.into_iter().map(|[name, text]| (name.to_owned(), text.to_owned())).collect()
}

fn texts<const N: usize>(all: [&str; N]) -> Vec<String> {
    all.map(str::to_owned).to_vec()
}

/// Lagrange's equations of two links with absolute angles.
fn by_rates() -> PeerEquations {
    PeerEquations {
        letters: pairs([["m", "m"], ["l", "l"], ["g", "g"], ["p", "a"], ["q", "b"]]),
        accelerations: texts(["p''", "q''"]),
        abbreviations: pairs([["c", "cos(p - q)"], ["s", "sin(p - q)"]]),
        equations: pairs([
            ["first", "2*m*l^2*p'' + m*l^2*c*q'' + m*l^2*s*q'^2 + 2*m*g*l*sin(p)"],
            ["second", "m*l^2*c*p'' + m*l^2*q'' - m*l^2*s*p'^2 + m*g*l*sin(q)"],
        ]),
        ..PeerEquations::default()
    }
}

fn found(peer: &PeerEquations) -> PeerFinding {
    let system = SystemText { name: "two links".to_owned(), text: TWO_LINKS.to_owned(), values: Vec::new() };
    peer.compared(&system).expect("they are compared")
}

fn refusal(peer: &PeerEquations) -> String {
    let system = SystemText { name: "two links".to_owned(), text: TWO_LINKS.to_owned(), values: Vec::new() };
    peer.compared(&system).expect_err("they are refused").to_string()
}

#[test]
fn other_combinations_of_the_same_equations_are_the_same() {
    assert_eq!(found(&by_rates()).verdict, Verdict::Proved);
    let mut peer = by_rates();
    let [first, second] = [0, 1].map(|place| peer.equations[place].1.clone());
    peer.equations[0].1 = format!("({first})*cos(p)/l - 3*({second})");
    let found = found(&peer);
    assert_eq!(found.verdict, Verdict::Proved, "{found:?}");
}

#[test]
fn a_wrong_term_is_told_by_the_coefficient_in_which_it_stands() {
    for (from, to, of, difference) in
        [("2*m*g*l*sin(p)", "m*g*l*sin(p)", None, "-g*l*m*sin(a)"), ("2*m*l^2*p''", "m*l^2*p''", Some("a''"), "-l^2*m")]
    {
        let mut peer = by_rates();
        peer.equations[0].1 = peer.equations[0].1.replace(from, to);
        let found = found(&peer);
        assert_eq!(found.verdict, Verdict::Refuted);
        let [wrong, right] = &found.equations[..] else { unreachable!("there are two") };
        assert_eq!((wrong.verdict, right.verdict), (Verdict::Refuted, Verdict::Proved));
        let [term] = &wrong.terms[..] else { unreachable!("one term differs: {wrong:?}") };
        assert_eq!(term.of.as_deref(), of);
        assert_eq!(term.difference.as_ref().map(|(text, _)| text.as_str()), Some(difference));
    }
}

#[test]
fn speeds_are_what_the_kinematic_equations_say() {
    let mut peer = by_rates();
    // u is the relative speed, v the absolute speed
    (peer.speeds, peer.accelerations) = (texts(["u", "v"]), texts(["u'", "v'"]));
    peer.kinematics = texts(["p' + u - q'", "q' - v"]);
    for (_, text) in &mut peer.equations {
        *text = text.replace("p''", "(v' - u')").replace("q''", "v'").replace("p'^2", "(v - u)^2").replace("q'", "v");
    }
    assert_eq!(found(&peer).verdict, Verdict::Proved);
    peer.kinematics[0] = "p' + u + q'".to_owned();
    assert_eq!(found(&peer).verdict, Verdict::Refuted);
    peer.kinematics[0] = "p' + v + q'".to_owned();
    assert!(refusal(&peer).contains("determine 1 of 2 speeds"));
}

#[test]
fn equations_that_determine_too_little_are_not_the_same() {
    let mut peer = by_rates();
    peer.equations[1] = ("again".to_owned(), peer.equations[0].1.clone());
    let found = found(&peer);
    assert_eq!(found.verdict, Verdict::Undecided);
    assert!(found.sentence.contains("singular"), "{}", found.sentence);
    peer.letters[4].1 = "a".to_owned();
    assert!(refusal(&peer).contains("do not determine `b'`"));
}

#[test]
fn faults_are_told_at_their_place() {
    let mut peer = by_rates();
    peer.equations[0].1 = "p''^2 + z".to_owned();
    assert!(refusal(&peer).contains("`z` is not known"));
    peer.equations[0].1 = "p''^2".to_owned();
    assert!(refusal(&peer).contains("not linear in the accelerations"));
    peer.letters[4].1 = "bb".to_owned();
    assert!(refusal(&peer).contains("bb"));
}

/// A bead on a circle, whose constraint the other program has multiplied by a factor that does not vanish.
#[test]
fn a_constraint_times_a_factor_is_the_constraint() {
    let text = "gravity = \"-g*N.y\"\n[parameters]\nm = \"kg\"\nl = \"m\"\ng = \"m/s^2\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n\
                [bodies.bead]\ncentre = \"O + x*N.x + y*N.y\"\nmass = \"m\"\n[[constraint]]\nzero = \"x^2 + y^2 - l^2\"\n";
    // the factor with its first and second derivative by x
    for [factor, first, second] in [["exp(x/l)", "exp(x/l)/l", "exp(x/l)/l^2"], ["(1 + x^2/l^2)", "2*x/l^2", "2/l^2"]] {
        let rates = "f*2*(x'^2 + y'^2 + x*x'' + y*y'') + 4*f1*x'*(x*x' + y*y') + (f2*x'^2 + f1*x'')*c";
        let peer = PeerEquations {
            letters: pairs([["m", "m"], ["l", "l"], ["g", "g"], ["x", "x"], ["y", "y"]]),
            accelerations: texts(["x''", "y''"]),
            multipliers: texts(["z"]),
            abbreviations: pairs([["f", factor], ["f1", first], ["f2", second], ["c", "x^2 + y^2 - l^2"]]),
            constraints: texts(["f*c"]),
            equations: pairs([["x'", "m*x'' - z*(2*f*x + f1*c)"], ["y'", "m*y'' + m*g - 2*z*f*y"], ["z", rates]]),
            ..PeerEquations::default()
        };
        let system = SystemText { name: "a bead".to_owned(), text: text.to_owned(), values: Vec::new() };
        let found = peer.compared(&system).expect("they are compared");
        assert!(matches!(found.verdict, Verdict::Proved | Verdict::Identified), "{factor}: {found:?}");
    }
}
