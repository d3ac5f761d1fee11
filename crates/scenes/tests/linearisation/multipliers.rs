//! Floquet multipliers of periodic motions compared with closed forms.

use dalembert_scenes::ModelScene;
use dalembert_scenes::linearisation::{Multipliers, NoMultipliers, Orbit};
use std::f64::consts::{PI, TAU};

fn scene(force: &str, start: &str) -> ModelScene {
    let text = format!(
        "title = \"Oscillator\"\n[coordinates]\nx = \"rad\"\n[energies]\nkinetic = \"(1 kg m^2)/2*x'^2\"\n\
         [[force]]\nalong = \"x\"\nis = \"(1 N m)*({force})\"\n[start]\n{start}\n[run]\nspan = \"1 s\"\n"
    );
    ModelScene::parse("scene.toml", &text).unwrap_or_else(|error| panic!("{error}"))
}

/// Mathieu's equation x'' + (a - 2 q cos 2t) x = 0 with q = 1: the trace of the monodromy matrix is 2 at a_0 = -0.4551386041 and
/// b_2 = 3.9170247730, and -2 at a_1 = 1.8591080725 (Abramowitz, Stegun 1964, chapter 20).
#[test]
fn mathieus_equation_has_its_characteristic_values() {
    let mathieu = |a: f64| {
        let scene = scene(&format!("-({a} - 2*cos((2 rad/s)*t))*x"), "x = \"0\"");
        Multipliers::of(&scene, PI).unwrap_or_else(|why| panic!("{why}"))
    };
    for (a, trace) in [(-0.455_138_604_1, 2.0), (3.917_024_773_0, 2.0), (1.859_108_072_5, -2.0)] {
        let found = mathieu(a);
        assert!((found.monodromy.trace() - trace).abs() < 1e-8, "{a}: {}", found.monodromy);
        assert!((found.monodromy.determinant() - 1.0).abs() < 1e-11);
    }
    // oscillation between a_0 and b_1, growth between b_1 and a_1
    assert_eq!(mathieu(-0.3).orbit(), Orbit::Undecided(2));
    assert_eq!(mathieu(1.0).orbit(), Orbit::Unstable(1));
    let ones = mathieu(1.0).ones;
    assert_eq!((ones.cyclic, ones.shift, ones.energy), (0, false, false));
}

/// The determinant of the monodromy matrix is exp(-c T); the multipliers of x'' + c x' + x = 0 are exp(mu T).
#[test]
fn the_determinant_is_the_exponential_of_the_damping() {
    let found = Multipliers::of(&scene("-x - (0.2 s)*x'", "x = \"0\""), 3.0).unwrap_or_else(|why| panic!("{why}"));
    assert!((found.monodromy.determinant() - (-0.6_f64).exp()).abs() < 1e-11);
    assert!((found.values[0][0].hypot(found.values[0][1]) - (-0.3_f64).exp()).abs() < 1e-11);
    assert_eq!(found.orbit(), Orbit::Asymptotic);
}

/// The limit cycle of Van der Pol's equation with mu = 1 has the period 6.6632868593231.
#[test]
fn a_limit_cycle_has_one_multiplier_that_is_one() {
    let law = "(1 s)*(1 - x^2)*x' - x";
    let on_cycle = scene(law, "x = \"2.00861986087484\"");
    let found = Multipliers::of(&on_cycle, 6.663_286_859_323_1).unwrap_or_else(|why| panic!("{why}"));
    assert!((found.values[0][0] - 1.0).abs() < 1e-9 && found.ones.shift && !found.ones.energy, "{found:?}");
    assert_eq!(found.orbit(), Orbit::Asymptotic);
    assert!((found.monodromy.determinant() - found.values[0][0] * found.values[1][0]).abs() < 1e-9);
    let open = Multipliers::of(&on_cycle, 6.5);
    assert!(matches!(open, Err(NoMultipliers::Open { distance, .. }) if distance > 1e-3), "{open:?}");
}

/// One turn of a rotor: the state returns modulo a full turn, and the cyclic angle gives the multiplier one.
#[test]
fn a_full_turn_is_a_return() {
    // x'' = -x' (x' - 1)/10: the speed 1 rad/s is attracting
    let turning = scene("-x'*(1 s)/10*(x'*(1 s) - 1)", "\"x'\" = \"1 rad/s\"");
    let found = Multipliers::of(&turning, TAU).unwrap_or_else(|why| panic!("{why}"));
    assert_eq!((found.ones.cyclic, found.ones.shift), (1, false));
    // deviations of the speed decay at the rate 1/10
    assert!((found.others()[0][0] - (-TAU / 10.0).exp()).abs() < 1e-10, "{:?}", found.values);
    assert_eq!(found.orbit(), Orbit::Asymptotic);
}

#[test]
fn a_time_within_which_nothing_returns_is_no_period() {
    let law = scene("-(1 - 2*cos((2 rad/s)*t))*x", "x = \"0\"");
    let over = |scene: &ModelScene, period: f64| Multipliers::of(scene, period).map(|found| found.orbit());
    assert!(matches!(over(&law, 1e-5), Err(NoMultipliers::OtherLaw)), "{:?}", over(&law, 1e-5));
    assert!(matches!(over(&law, 1e-11), Err(NoMultipliers::Short)), "{:?}", over(&law, 1e-11));
    // the period is given with seven digits
    assert!(over(&law, (PI * 1e7).round() / 1e7).is_ok());
    let swing = scene("-x", "x = \"1\"");
    assert!(matches!(over(&swing, 1e-8), Err(NoMultipliers::Short)) && over(&swing, TAU).is_ok());
}

/// A disc that rolls in a circle, with ten digits of its lean: its family has several multipliers one, which an error splits by its square root.
#[test]
fn several_ones_that_an_error_splits_lie_on_the_circle() {
    let text = "title = \"Disc\"\ngravity = \"-g*N.z\"\n[parameters]\nm = \"1 kg\"\nr = \"0.3 m\"\ng = \"9 m/s^2\"\n\
                [coordinates]\nx = \"m\"\ny = \"m\"\npsi = \"rad\"\nth = \"rad\"\ns = \"rad\"\n\
                [frames]\nH = \"N turned psi about z\"\nL = \"H turned th about x\"\nW = \"L turned s about y\"\n\
                [points]\nC = \"O + x*N.x + y*N.y\"\nG = \"C + r*L.z\"\n\
                [bodies.disc]\nframe = \"W\"\ncentre = \"G\"\nmass = \"m\"\ninertia = { principal = [\"m*r^2/4\", \"m*r^2/2\", \"m*r^2/4\"] }\n\
                [[constraint]]\nname = \"roll\"\nzero = \"velocity(disc at C)\"\n\
                [start]\nth = \"0.6023163586 rad\"\n\"psi'\" = \"3 rad/s\"\n\"s'\" = \"-6 rad/s\"\n[run]\nspan = \"3 s\"\n";
    let disc = ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"));
    let found = Multipliers::of(&disc, TAU / 3.0).unwrap_or_else(|why| panic!("{why}"));
    assert!(matches!(found.orbit(), Orbit::Undecided(_)), "{:?}", found.values);
}
