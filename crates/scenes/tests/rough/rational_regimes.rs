//! Regimes and margins of a system as text in double precision, compared with those of the system in rational arithmetic.

use super::{close, rod};
use dalembert_scenes::{Motions, Task, parse_titled, regimes};
use field::{Circle, Rational};
use mechanics::constrained::State;
use mechanics::regimes::{Consistency, posed, verdict};
use systems::slender_rod::SlenderRod;

/// Tangents of half angles, angular velocities in rad/s and coefficients of friction, in tenths.
const HALVES: [i64; 7] = [1, 3, 4, 5, 7, 8, 9];
const SPINS: [i64; 4] = [0, 4, 11, 35];
const FRICTIONS: [i64; 4] = [3, 12, 17, 29];

fn tenths(number: i64) -> Rational {
    Rational::new(number, 10)
}

/// A rod with m = l = g = 1 whose end slides backwards at 1 m/s.
fn exactly(angle: Circle<Rational>, spin: Rational, friction: Rational) -> Consistency<Rational, 1> {
    let one = Rational::new(1, 1);
    let rod = SlenderRod { mass: one, inertia: Rational::new(1, 3), half_length: one, gravity: one, friction };
    let velocity = [-one - spin * angle.sin, spin * angle.cos, -spin * angle.sin, spin * angle.cos];
    let place = [angle.cos, angle.sin, angle.cos, angle.sin];
    let (dry, touches) = posed(&rod, &State { time: Rational::new(0, 1), place, velocity }).expect("it is in touch");
    verdict(&dry, &touches)
}

#[test]
fn a_rod_as_text_has_the_regimes_and_reactions_of_rational_numbers() {
    let mut seen = [0; 3];
    for (half, (spin, friction)) in
        HALVES.iter().flat_map(|half| SPINS.iter().flat_map(move |spin| FRICTIONS.map(|f| (half, (spin, f)))))
    {
        let angle = Circle::from_half_tangent(tenths(*half));
        let [sin, cos] = [angle.sin, angle.cos].map(|part| part.to_f64());
        let text = rod(&format!("{} rad", sin.atan2(cos)), &format!("{} rad/s", *spin as f64 / 10.0), -1.0)
            .replace("9.81", "1")
            .replace("f = \"2\"", &format!("f = \"{}\"", friction as f64 / 10.0));
        let (_, model) = parse_titled("scene.toml", &text, Task::Run).unwrap_or_else(|error| panic!("{error}"));
        let found = regimes(model).unwrap_or_else(|issue| panic!("{issue:?}"));
        let normal = |regime: usize| found.regimes[regime].margins[0].value;
        match exactly(angle, tenths(*spin), tenths(friction)) {
            Consistency::Unique(known) => {
                seen[0] += 1;
                assert_eq!(found.motions, Motions::One, "{text}");
                let pressed = known.reactions[0][0].to_f64();
                if pressed > 0.0 {
                    close(normal(0), pressed, 1e-13 * pressed.max(1.0));
                }
            }
            Consistency::None => {
                seen[1] += 1;
                assert_eq!(found.motions, Motions::None, "{text}");
            }
            Consistency::Several(..) => {
                seen[2] += 1;
                assert_eq!(found.motions, Motions::Several, "{text}");
            }
            other => panic!("{other:?}"),
        }
    }
    assert!(seen.iter().all(|count| *count > 3), "{seen:?}");
}
