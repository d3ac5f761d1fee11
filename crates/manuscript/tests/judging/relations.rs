//! Relations between letters: inequations, and conditions of second degree.

use crate::{PENDULUM, on, on_pendulum, verdict};

#[test]
fn sides_that_differ_are_shown_by_the_square_of_their_difference() {
    for (formula, given, expected) in [
        (r"m^2 + l^2 \neq 0", "given = ['m > 0']", "proved"),
        (r"m l \neq 0", r"given = ['m > 0', 'l \neq 0']", "proved"),
        (r"m \neq l", "given = ['m > l']", "proved"),
        (r"m \neq l", "", "refuted"),
        (r"\sin\theta \neq 2", "", "proved"),
        (r"\sin\theta \neq 1", "", "refuted"),
        (r"m^2 \neq 2", "given = ['m > 0']", "refuted"),
    ] {
        let found = on_pendulum("inequality", formula, given);
        assert_eq!(verdict(&found), expected, "{}", found.text());
        assert!(found.judged.text[0].contains("!="), "{}", found.text());
    }
    let found = on_pendulum("inequality", r"m \neq l", "");
    let [(_, one), (_, other)] = &found.judged.counterexample[..2] else { panic!("{}", found.text()) };
    assert_eq!(one, other, "{}", found.text());
}

#[test]
fn squares_are_equal_for_opposite_letters_too() {
    for (formula, given, expected) in [
        (r"\theta^2 = \varphi^2 \iff \theta = \varphi", "", "refuted"),
        (r"\theta^2 = \varphi^2 \iff \theta = \varphi", r"given = ['\theta > 0', '\varphi > 0']", "proved"),
        (r"\theta^2 - \varphi^2 = 0 \iff (\theta - \varphi)(\theta + \varphi) = 0", "", "proved"),
        // a condition that always holds is not equivalent to one that may fail
        (r"\theta^2 = \theta^2 \iff \theta = \varphi", "", "refuted"),
        (
            r"\theta^2 - 3 \theta \varphi + 2 \varphi^2 = 0 \iff \theta = \varphi",
            r"given = ['\theta \neq 2 \varphi']",
            "proved",
        ),
    ] {
        let system = PENDULUM.replace("[coordinates]", "phi = \"rad\"\n[coordinates]") + "'\\varphi' = \"phi\"\n";
        let found = on(&system, "equivalence", formula, given);
        assert_eq!(verdict(&found), expected, "{}", found.text());
        assert!(found.corrections.iter().all(|one| one.formula == formula), "{}", found.text());
    }
}

#[test]
fn a_square_with_a_root_is_not_negative() {
    let inequality = r"m \dot\theta^2 + l \theta^2 \geq 2 \theta \dot\theta \sqrt{m l}";
    let found = on_pendulum("inequality", inequality, "given = ['m > 0', 'l > 0']");
    assert_eq!(verdict(&found), "proved", "{}", found.text());
    let found = on_pendulum("inequality", r"l \cos 2 < 0", "given = ['l > 0']");
    assert_eq!(verdict(&found), "proved", "{}", found.text());
}
