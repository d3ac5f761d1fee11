//! Fuzz tests of ensemble members.

use super::{Drawn, changed};
use dalembert_scenes::parse_ensemble;

#[test]
fn whatever_varies_a_member_starts_or_says_why() {
    let text = include_str!("../../../../scenes/models/slider_crank.toml").to_owned()
        + "\n[ensemble]\nmembers = 4\n[ensemble.vary]\nparameters.l = { from = \"0.01 m\", to = \"0.06 m\" }\n\
        start.theta = { mean = \"0 rad\", deviation = \"1 rad\" }\nstart.\"phi'\" = { values = \"1 2 3 4 rad/s\" }\n";
    let sound = with_guess(&text);
    let mut drawn = Drawn(37);
    let (mut started, mut stopped, mut refused) = (0, 0, 0);
    for _ in 0..1_000 {
        match parse_ensemble("scene.toml", &changed(&sound, &mut drawn)) {
            Ok(scene) => {
                for number in 1..=scene.members.min(4) {
                    match scene.member(number) {
                        Ok(member) => {
                            started += 1;
                            assert!(member.state.iter().all(|number| number.is_finite()), "{sound}");
                        }
                        Err(why) => {
                            stopped += 1;
                            assert!(!why.to_string().contains("NaN"), "{why}");
                        }
                    }
                }
            }
            Err(error) => {
                refused += 1;
                assert!(!error.issues.is_empty() && !error.to_string().is_empty(), "{error}");
            }
        }
    }
    assert!(started > 100 && stopped > 50 && refused > 100, "{started} {stopped} {refused}");
}

/// The text with the slider's position as a guess, so that the closed loop determines it.
fn with_guess(text: &str) -> String {
    text.replace("s = \"0.4 m\"", "s = \"guess 0.4 m\"")
}
