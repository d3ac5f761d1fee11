//! The letter pi is the number pi, unless the paper declares the letter.

use crate::{PENDULUM, on, on_pendulum, refused, verdict};

#[test]
fn formulas_hold_for_the_number_pi() {
    for (kind, formula, given, expected) in [
        ("identity", r"2 \pi l = \pi h", "", "proved"),
        ("identity", r"\pi l = 3 l", "", "refuted"),
        ("identity", r"\pi = \frac{22}{7}", "", "refuted"),
        ("identity", r"\sin(\theta + \pi) = -\sin\theta", "", "proved"),
        ("equivalence", r"g = \pi l \iff l = \frac{g}{\pi}", "", "proved"),
        ("inequality", r"\pi > 3", "", "proved"),
        ("inequality", r"\pi \geq \frac{22}{7}", "", "refuted"),
        ("inequality", r"\pi^2 > 10", "", "refuted"),
        ("inequality", r"\pi m > 3 m", "given = ['m > 0']", "proved"),
        ("inequality", r"2 \pi m l > 0", "given = ['m > 0', 'l > 0']", "proved"),
        ("inequality", r"\pi l > g", "given = ['g > 0', 'l > g']", "proved"),
        ("inequality", r"\pi^{10} > 93648", "", "enclosed"),
        ("inequality", r"\pi^{10} < 93648", "", "refuted"),
        ("number", r"2 \pi m = 6.28", "given = ['m = 1']", "enclosed"),
        ("number", r"2 \pi m = 6.29", "given = ['m = 1']", "refuted"),
    ] {
        let found = on_pendulum(kind, formula, given);
        assert_eq!(verdict(&found), expected, "{}", found.text());
    }
}

#[test]
fn no_counterexample_gives_pi_a_value() {
    for (kind, formula) in [
        ("equation of motion", r"l \ddot\theta + 2 \pi g \sin\theta = 0"),
        ("formula", r"T = \pi m l^2 \dot\theta^2"),
        ("inequality", r"\pi l > 4 l"),
    ] {
        let found = on_pendulum(kind, formula, "");
        assert_eq!(verdict(&found), "refuted", "{}", found.text());
        assert!(!found.judged.counterexample.is_empty(), "{}", found.text());
        assert!(found.judged.counterexample.iter().all(|(name, _)| name != "pi"), "{}", found.text());
    }
    let found = on_pendulum("formula", r"T = \pi m", "");
    let sides = found.sides.expect("both sides have values");
    assert!(sides.right.ends_with("pi"), "{}", sides.right);
}

#[test]
fn a_letter_that_is_declared_is_what_the_paper_says() {
    let system = PENDULUM.replace(
        "'h' =",
        r"'\pi' = 'm*l'
'h' =",
    );
    let found = on(&system, "identity", r"2 \pi = m h", "");
    assert_eq!(verdict(&found), "proved", "{}", found.text());
    let found = on(&system, "identity", r"\pi = m", "");
    assert!(found.judged.counterexample.iter().any(|(name, _)| name == "pi"), "{}", found.text());
}

#[test]
fn an_angle_has_one_value() {
    let claim = "[[claim]]\nequation = \"1\"\nkind = \"identity\"\nformula = '\\theta = m'\n";
    let told = refused(&format!("{PENDULUM}\n{claim}given = ['\\theta = \\pi', '\\theta = 0']\n"));
    assert!(told.contains("contradicts"), "{told}");
    let told = refused(&format!("{PENDULUM}\n{claim}given = ['\\pi > 4']\n"));
    assert!(told.contains("contradict each other"), "{told}");
}

/// Cosines of rational multiples of pi are constants; a counterexample does not choose their values.
#[test]
fn no_point_gives_a_value_to_the_cosine_of_a_part_of_a_half_turn() {
    for (formula, may_be) in [
        (r"\cos\frac{\pi}{5} - \cos\frac{2\pi}{5} = \frac12", ["proved", "undecided"]),
        (r"\sin(1000\pi) = 0", ["proved", "undecided"]),
        (r"m \sqrt{\pi^2} = \pi m", ["proved", "undecided"]),
        (r"\sin\frac{\pi}{5} = \frac35", ["refuted", "refuted"]),
        (r"m \sin\frac{\pi}{5} = \frac{3 m}{5}", ["refuted", "refuted"]),
    ] {
        let found = on_pendulum("identity", formula, "");
        assert!(may_be.contains(&verdict(&found)), "{}", found.text());
        assert!(found.judged.counterexample.iter().all(|(name, _)| !name.contains("pi")), "{}", found.text());
    }
}
