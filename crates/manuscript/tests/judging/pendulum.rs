//! Every kind of claim on a pendulum.

use crate::{PENDULUM, judged, on_pendulum, verdict};

#[test]
fn an_equation_of_motion_holds_up_to_a_factor() {
    for formula in [
        r"m l^2 \ddot{\theta} + m g l \sin\theta = 0",
        r"\ddot{\theta} = -\frac{g}{l}\sin\theta",
        r"h \ddot\theta + 2 g \sin\theta = 0",
        r"\frac{d}{dt}\left(\frac{\partial T}{\partial \dot{\theta}}\right) - \frac{\partial T}{\partial \theta} + \frac{\partial V}{\partial \theta} = 0",
        r"\cos\theta\,\ddot\theta = -\frac{g}{l}\sin\theta\cos\theta",
    ] {
        let found = on_pendulum("equation of motion", formula, "");
        assert_eq!(verdict(&found), "proved", "{formula}: {}", found.text());
        assert!(found.allowed.contains("the claim may use the model's equations"), "{}", found.allowed);
    }
}

#[test]
fn the_combination_of_equations_is_told() {
    let found = on_pendulum("equation of motion", r"h \ddot\theta + 2 g \sin\theta = 0", "");
    assert!(found.allowed.ends_with("; here 2/(l*m) times the equation of theta"), "{}", found.allowed);
}

#[test]
fn a_slip_is_refuted_at_an_exact_point_with_the_terms_that_are_missing() {
    let found = on_pendulum("equation of motion", r"m l^2 \ddot{\theta} - m g l \sin\theta = 0", "");
    assert_eq!(verdict(&found), "refuted");
    assert_eq!(found.judged.difference.as_ref().map(|(text, _)| text.as_str()), Some("-2*g*l*m*sin(theta)"));
    let at: Vec<&str> = found.judged.counterexample.iter().map(|(name, _)| name.as_str()).collect();
    assert!(["m", "l", "g", "sin(theta)"].iter().all(|name| at.contains(name)), "{at:?}");
    assert!(found.sides.is_some());
    // a cosine for a sine, a factor 2, a lost factor, a lost sine
    for formula in [
        r"l \ddot{\theta} + g \cos\theta = 0",
        r"2 l \ddot{\theta} + g \sin\theta = 0",
        r"m l \ddot{\theta} + m g l \sin\theta = 0",
        r"l \ddot{\theta} + g \theta = 0",
    ] {
        assert_eq!(verdict(&on_pendulum("equation of motion", formula, "")), "refuted", "{formula}");
    }
}

#[test]
fn the_data_of_a_counterexample_are_those_of_the_paper() {
    let found = on_pendulum("equation of motion", r"h \ddot{\theta} + g \sin\theta = 0", "");
    let value = |name: &str| {
        let found = found.judged.counterexample.iter().find(|(known, _)| known == name);
        found.map(|(_, value)| value.clone()).unwrap_or_else(|| panic!("{name}: {:?}", found))
    };
    assert!(value("h").parse::<i64>().is_ok() && value("g").parse::<i64>().is_ok());
    assert!(value("theta''").contains('/'), "{}", value("theta''"));
}

#[test]
fn quantities_have_their_values() {
    for (formula, expected) in [
        (r"T = \frac12 m l^2 \dot\theta^2", "proved"),
        (r"T = \frac12 m \mathbf{v}\cdot\mathbf{v}", "proved"),
        (r"T = m l^2 \dot\theta^2", "refuted"),
        (r"\mathbf{v} = \begin{pmatrix} l\dot\theta\cos\theta \\ l\dot\theta\sin\theta \end{pmatrix}", "proved"),
        (r"\mathbf{v} = \begin{pmatrix} l\dot\theta\cos\theta \\ -l\dot\theta\sin\theta \end{pmatrix}", "refuted"),
        (r"\frac{d}{dt}(T) = -m g l \dot\theta\sin\theta", "proved"),
        (r"\dot{\mathbf{v}} = 0", "refuted"),
    ] {
        assert_eq!(verdict(&on_pendulum("formula", formula, "")), expected, "{formula}");
    }
    // a formula that needs the equations of motion is not an identity
    let rate = r"\frac{d}{dt}(T) = -m g l \dot\theta\sin\theta";
    assert_eq!(verdict(&on_pendulum("identity", rate, "")), "refuted");
}

#[test]
fn integrals_are_constant_along_every_motion() {
    for (formula, given, expected) in [
        (r"T + V = \mathrm{const}", "", "proved"),
        (r"\frac12 l \dot\theta^2 - g \cos\theta", "", "proved"),
        (r"T - V = \mathrm{const}", "", "refuted"),
        (r"\dot\theta = \mathrm{const}", "given = ['g = 0']", "proved"),
    ] {
        assert_eq!(verdict(&on_pendulum("integral of motion", formula, given)), expected, "{formula}");
    }
}

#[test]
fn inequalities_are_proved_by_signs_or_fail_at_a_point() {
    let positive = "given = ['m > 0', 'l > 0', 'g > 0']";
    for (formula, given, expected) in [
        (r"T \geq 0", positive, "proved"),
        (r"T > 0", positive, "refuted"),
        (r"m l^2 > 0", positive, "proved"),
        (r"\cos\theta > 0", "", "refuted"),
        (r"T \geq 0", "", "refuted"),
        (r"1 + \cos\theta \geq 0", "", "proved"),
    ] {
        assert_eq!(verdict(&on_pendulum("inequality", formula, given)), expected, "{formula}");
    }
}

#[test]
fn equivalent_conditions_follow_from_each_other() {
    let found = on_pendulum("equivalence", r"g \sin\theta = 0 \iff \ddot\theta = 0", "");
    assert_eq!(verdict(&found), "proved", "{}", found.text());
    let found = on_pendulum("equivalence", r"g = l \iff m = l", "");
    assert_eq!(verdict(&found), "refuted", "{}", found.text());
}

#[test]
fn an_expectation_that_is_not_met_is_told() {
    let found = on_pendulum("formula", r"T = 0", "expect = \"proved\"");
    assert!(found.as_expected().is_err_and(|why| why.contains("expected proved, got refuted")));
}

#[test]
fn mixed_dimensions_speak_against_a_formula() {
    let found = on_pendulum("equation of motion", r"m l \ddot{\theta} + m g l \sin\theta = 0", "");
    assert!(found.judged.evidence.contains("dimension"), "{}", found.judged.evidence);
    assert!(found.as_expected().is_err_and(|why| why.contains("dimension")), "{}", found.text());
    // an author who expects the refutation knows its reason
    let found = on_pendulum("equation of motion", r"m l \ddot{\theta} + m g l \sin\theta = 0", "expect = \"refuted\"");
    assert!(found.as_expected().is_ok(), "{}", found.text());
}

#[test]
fn stability_is_decided_by_the_roots_of_the_linear_equations() {
    let hanging = "resting = ['\\theta']\ngiven = ['\\theta = 0', 'm > 0', 'l > 0']";
    let found = on_pendulum("stability", r"g > 0", hanging);
    assert_eq!(verdict(&found), "proved", "{}", found.text());
    let found = on_pendulum("stability", r"g < 0", hanging);
    assert_eq!(verdict(&found), "refuted", "{}", found.text());
    // away from its equilibria the pendulum has no steady motion
    let found = on_pendulum("stability", r"g > 0", "resting = ['\\theta']\ngiven = ['\\theta = 1', 'm > 0', 'l > 0']");
    assert_eq!(verdict(&found), "undecided", "{}", found.text());
}

#[test]
fn a_counterexample_satisfies_every_hypothesis() {
    // false only where the sine vanishes
    let found = on_pendulum("identity", r"\frac{\sin\theta}{\sin\theta} = 1", r"given = ['\sin\theta \neq 0']");
    assert_eq!(verdict(&found), "proved", "{}", found.text());
    // letters that only hypotheses contain have values too
    let found = on_pendulum("formula", r"T = 0", r"given = ['l > 2 g', 'g > 3', 'm > l']");
    assert_eq!(verdict(&found), "refuted", "{}", found.text());
    let value = |name: &str| {
        let (_, value) = found.judged.counterexample.iter().find(|(known, _)| known == name).expect("it has a value");
        let (above, below) = value.split_once('/').unwrap_or((value, "1"));
        above.parse::<f64>().unwrap() / below.parse::<f64>().unwrap()
    };
    assert!(value("l") > 2.0 * value("g") && value("g") > 3.0 && value("m") > value("l"), "{}", found.text());
    // no point that satisfies these hypotheses is found
    let found = on_pendulum("formula", r"V = V", r"given = ['g > l + m', 'l > g + m']");
    assert_ne!(verdict(&found), "refuted", "{}", found.text());
}

#[test]
fn a_printed_number_is_judged_to_its_last_digit() {
    let data = r"given = ['l = 2', 'g = 9.81', '\theta = 0.5']";
    // -9.81/2 sin 0.5 = -2.35158...
    for (formula, expected) in [
        (r"\ddot\theta = -2.3516", "enclosed"),
        (r"\ddot\theta = -2.35", "enclosed"),
        (r"\ddot\theta = -2.3515", "refuted"),
        (r"\ddot\theta = 2.3516", "refuted"),
    ] {
        let found = on_pendulum("number", formula, data);
        assert_eq!(verdict(&found), expected, "{}", found.text());
    }
}

#[test]
fn a_display_is_a_claim_for_each_of_its_formulas() {
    let display = r"
\begin{aligned}
T &= \tfrac12 m l^2 \dot{\theta}^2, \\
V &= - m g l \cos\theta, \\
m l \pm T &= m l \pm T \\
\ddot\theta &= - \frac{g}{l}
  \cos\theta
\end{aligned}";
    let claim = format!("[[claim]]\nequation = \"1\"\nkind = \"formula\"\nformula = '''{display}'''\n");
    let found = judged(&format!("{PENDULUM}\n{claim}")).unwrap_or_else(|error| panic!("{error}"));
    let told: Vec<(&str, &str)> = found.iter().map(|found| (found.judged.id.as_str(), verdict(found))).collect();
    let expected = [
        ("paper/eq1/1", "proved"),
        ("paper/eq1/2", "proved"),
        ("paper/eq1/3/upper", "proved"),
        ("paper/eq1/3/lower", "proved"),
        ("paper/eq1/4", "refuted"),
    ];
    assert_eq!(told, expected);
    assert!(found[4].corrections[0].formula.contains(r"\sin\theta"), "{}", found[4].text());
}
