//! Steady motions found from a start that is not steady.

use super::model;
use dalembert_scenes::steady_motions::{EnclosedSpectrum, NotEnclosed, Side};

/// A bead on a spring that moves in a circle, k (r - a) = m r w^2; the squared frequency of its oscillations is k/m + 3 w^2.
#[test]
fn the_radius_of_a_circle_follows_the_speed() {
    let text = "title = \"Circle\"\n[parameters]\nm = \"1 kg\"\nk = \"4 N/m\"\na = \"0.5 m\"\n[coordinates]\nr = \"m\"\ns = \"rad\"\n[frames]\nA = \"N turned s about z\"\n\
        [bodies]\nb = { centre = \"O + r*A.x\", mass = \"m\" }\n[energies]\npotential = \"k*(r - a)^2/2\"\n";
    let model = model(text);
    for speed in [0.5_f64, 1.0, 1.5] {
        let state = [0.6, 0.0, 0.0, speed];
        assert_eq!(EnclosedSpectrum::near(&model, &state, || true).err(), Some(NotEnclosed::NoMotion));
        let found = EnclosedSpectrum::following(&model, &state, || true).expect("it is found");
        let frequency = (4.0 + 3.0 * speed * speed).sqrt();
        let [first, _] = &found.discs[..] else { panic!("{found:?}") };
        assert!(first.side == Side::Axis && (first.centre[1].abs() - frequency).abs() < 1e-12, "{found:?}");
    }
}
