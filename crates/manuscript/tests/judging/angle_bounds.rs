//! Angles between bounds: signs of their sines, and counterexamples at rational multiples of pi.

use crate::{PENDULUM, on, on_pendulum, verdict};

#[test]
fn roots_of_half_angles_have_the_sign_of_the_bounds() {
    let within = r"given = ['\theta > 0', '\theta < \pi']";
    for (formula, given, expected) in [
        (r"\cos\frac{\theta}{2} = \sqrt{\frac{1 + \cos\theta}{2}}", within, "proved"),
        (r"\sin\frac{\theta}{2} = \sqrt{\frac{1 - \cos\theta}{2}}", within, "proved"),
        (r"\sin\theta = \sqrt{1 - \cos^2\theta}", within, "proved"),
        (
            r"\cos\frac{\theta}{2} = \sqrt{\frac{1 + \cos\theta}{2}}",
            r"given = ['\cos\frac{\theta}{2} \geq 0']",
            "proved",
        ),
        (r"\cos\theta = \sqrt{1 - \sin^2\theta}", within, "refuted"),
        (
            r"\cos\frac{\theta}{2} = \sqrt{\frac{1 + \cos\theta}{2}}",
            r"given = ['\theta > \pi', '\theta < 2 \pi']",
            "refuted",
        ),
    ] {
        let found = on_pendulum("identity", formula, given);
        assert_eq!(verdict(&found), expected, "{}", found.text());
    }
}

#[test]
fn a_point_gives_an_angle_beside_its_sine_a_fraction_of_pi() {
    for (kind, formula, at) in [
        ("identity", r"\cos\theta = 1 - \frac{\theta^2}{2}", "pi/2"),
        ("inequality", r"\sin\theta \geq \theta", "pi/2"),
        ("identity", r"\sin\frac{\theta}{2} = \frac12\sin\theta", "pi/2"),
    ] {
        let found = on_pendulum(kind, formula, r"given = ['\theta > 0', '\theta < \pi']");
        assert_eq!(verdict(&found), "refuted", "{}", found.text());
        assert!(found.judged.counterexample.contains(&("theta".to_owned(), at.to_owned())), "{}", found.text());
    }
    let system = PENDULUM.replace("[coordinates]", "phi = \"rad\"\n[coordinates]") + "'\\varphi' = \"phi\"\n";
    let given = r"given = ['\theta > 0', '\varphi > 0']";
    let found = on(&system, "identity", r"\sin(\theta + \varphi) = \sin\theta + \sin\varphi", given);
    assert_eq!(verdict(&found), "refuted", "{}", found.text());
}

#[test]
fn hypotheses_with_roots_hold_somewhere() {
    for given in
        [r"'\sin\theta > \frac{\sqrt{3}}{2}'", r"'\theta > \sqrt{2}', '\theta < \frac{\pi}{2}', '\sin\theta > 0'"]
    {
        let found = on_pendulum("formula", r"T = \frac12 m l^2 \dot\theta^2", &format!("given = [{given}]"));
        assert_eq!(verdict(&found), "proved", "{}", found.text());
    }
}

#[test]
fn factors_of_identities_between_angles_are_corrected() {
    for (printed, right) in [
        (r"\sin 2\theta = \sin\theta\cos\theta", r"\sin 2\theta = 2 \sin\theta\cos\theta"),
        (r"\cos 3\theta = 4\cos^3\theta - \cos\theta", r"\cos 3\theta = 4\cos^3\theta - 3 \cos\theta"),
        (r"\cos 2\theta = \cos^2\theta + \sin^2\theta", r"\cos 2\theta = \cos^2\theta - \sin^2\theta"),
        (r"\cos^2\theta = \frac{1 + \cos\theta}{2}", r"\cos^2\frac{\theta}{2} = \frac{1 + \cos\theta}{2}"),
    ] {
        let found = on_pendulum("identity", printed, "");
        assert!(found.corrections.iter().any(|one| one.formula == right), "{}", found.text());
    }
}

#[test]
fn the_sign_of_a_root_is_corrected() {
    let within = r"given = ['\sin\frac{\theta}{2} \geq 0']";
    let found = on_pendulum("identity", r"\sin\frac{\theta}{2} = -\sqrt{\frac{1 - \cos\theta}{2}}", within);
    let offered: Vec<&str> = found.corrections.iter().map(|one| one.formula.as_str()).collect();
    assert_eq!(offered, [r"\sin\frac{\theta}{2} = \sqrt{\frac{1 - \cos\theta}{2}}"], "{}", found.text());
    let found = on_pendulum("identity", r"\sqrt{h^2 + 2 h l + l^2} = h - l", "given = ['l > 0']");
    assert!(found.corrections.iter().any(|one| one.formula.ends_with("h + l")), "{}", found.text());
}
