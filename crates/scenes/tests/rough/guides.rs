//! Guides: reactions of contacts that the coordinates satisfy identically, compared with coordinates that include the normal direction.

use super::{METHODS, close, edited, events, last, runs, stored};
use integrators::Method;

#[test]
fn a_guide_has_the_reaction_of_a_coordinate_that_is_held_across_it() {
    let guided = stored("models/rough_slider_crank");
    let held = guided
        .replacen("s = \"m\"", "s = \"m\"\nacross = \"m\"", 1)
        .replacen("S = \"O + s*N.x\"", "S = \"O + s*N.x + across*N.y\"", 1)
        .replacen(
            "between = \"slider, N along x\"",
            "of = \"slider\"\nthrough = \"O\"\nnormal = \"N.y\"\nsides = \"both\"",
            1,
        );
    for method in METHODS {
        let [one, other] = [&guided, &held].map(|text| runs(text, method, 1e-12));
        assert_eq!((one.stopped(), other.stopped()), (None, None), "{method:?}");
        let (found, known) = (events(&one), events(&other));
        assert_eq!(found.len(), known.len());
        assert!(found.len() >= 8, "{found:?}");
        found.iter().zip(&known).for_each(|(found, known)| close(*found, *known, 1e-9));
        for name in ["theta", "s", "theta'", "N", "T"] {
            close(last(&one, name), last(&other, name), 1e-6 * last(&other, name).abs().max(1.0));
        }
        assert!(last(&other, "across").abs() < 1e-14);
    }
}

/// A bead on a rod that turns at constant speed: m r'' = m w^2 r - T, N = 2 m w r'; T = mu N opposes r'.
#[test]
fn a_bead_on_a_turning_rod_is_pressed_by_coriolis_force() {
    let text = "title = \"bead\"\n[parameters]\nm = \"0.3 kg\"\nw = \"2 rad/s\"\nmu = \"0.25\"\n[coordinates]\nr = \"m\"\n\
                [frames]\nA = \"N turned w*t about z\"\n[points]\nP = \"O + r*A.x\"\n[bodies.rod]\nframe = \"A\"\n\
                centre = \"O\"\nmass = \"(1 kg)\"\ninertia = \"(1 kg m^2)\"\n[bodies.bead]\ncentre = \"P\"\nmass = \"m\"\n\
                [[contact]]\nname = \"rod\"\nbetween = \"bead, rod along x\"\nfriction = \"mu\"\n\
                [outputs]\nN = \"reaction(rod)\"\n[start]\nr = \"0.1 m\"\n\"r'\" = \"0.4 m/s\"\n[run]\nspan = \"1 s\"\n";
    let trajectory = runs(text, Method::DormandPrince8, 1e-12);
    assert_eq!(trajectory.stopped(), None);
    // r'' + 2 mu w r' - w^2 r = 0
    let (w, mu) = (2.0_f64, 0.25_f64);
    let root = (mu * mu + 1.0).sqrt();
    let (a, b) = (w * (root - mu), -w * (root + mu));
    let first = (0.4 - b * 0.1) / (a - b);
    let second = 0.1 - first;
    close(last(&trajectory, "r"), first * a.exp() + second * b.exp(), 1e-11);
    close(last(&trajectory, "N"), 2.0 * 0.3 * w * last(&trajectory, "r'"), 1e-11);
}

/// A bead on a rod whose pivot has the acceleration a: m (r'' - w^2 r) = -m (a.e_r) - T, N = m (2 w r' + a.e_t).
#[test]
fn a_bead_on_a_rod_with_a_moving_pivot_is_pressed_by_its_own_mass_alone() {
    let text = "title = \"bead\"\n[parameters]\nm = \"0.3 kg\"\nw = \"2 rad/s\"\nc = \"0.1 m\"\nM = \"40 kg\"\n[coordinates]\nr = \"m\"\n\
                [frames]\nA = \"N turned w*t about z\"\n[points]\nH = \"O + c*cos(w*t)*N.x\"\nP = \"H + r*A.x\"\n[bodies.rod]\nframe = \"A\"\n\
                centre = \"H\"\nmass = \"M\"\ninertia = \"(1 kg m^2)\"\n[bodies.bead]\ncentre = \"P\"\nmass = \"m\"\n\
                [[contact]]\nname = \"rod\"\nbetween = \"bead, rod along x\"\nfriction = \"0\"\n\
                [outputs]\nN = \"reaction(rod)\"\n[start]\nr = \"0.1 m\"\n\"r'\" = \"0.4 m/s\"\n[run]\nspan = \"1 s\"\n";
    let trajectory = runs(text, Method::DormandPrince8, 1e-12);
    assert_eq!(trajectory.stopped(), None);
    let (w, c, t) = (2.0_f64, 0.1, 1.0_f64);
    let pivot = -c * w * w * (w * t).cos();
    close(last(&trajectory, "N"), 0.3 * (2.0 * w * last(&trajectory, "r'") - pivot * (w * t).sin()), 1e-11);
}

#[test]
fn a_guide_on_a_frame_that_no_body_has_is_one_of_the_ground() {
    let bead = "title = \"bead\"\n[parameters]\nm = \"0.3 kg\"\nw = \"2 rad/s\"\n[coordinates]\nr = \"m\"\n\
                [frames]\nA = \"N turned w*t about z\"\n[points]\nP = \"O + r*A.x\"\n[bodies.bead]\ncentre = \"P\"\nmass = \"m\"\n\
                [[contact]]\nname = \"rod\"\nbetween = \"bead, A along x\"\nfriction = \"0.25\"\n\
                [outputs]\nN = \"reaction(rod)\"\n[start]\nr = \"0.1 m\"\n\"r'\" = \"0.4 m/s\"\n[run]\nspan = \"1 s\"\n";
    let trajectory = runs(bead, Method::DormandPrince8, 1e-12);
    assert_eq!(trajectory.stopped(), None);
    close(last(&trajectory, "N"), 2.0 * 0.3 * 2.0 * last(&trajectory, "r'"), 1e-11);
}

/// The constraint determines the motion of a massless rod, which equals that of a rod with very little mass.
#[test]
fn a_rod_without_mass_goes_as_its_constraint_says() {
    let guided = stored("models/rough_slider_crank");
    let rod = "[bodies.rod]\nframe = \"R\"\ncentre = \"A + l/2*R.x\"\nmass = \"m_rod\"\ninertia = \"m_rod*l^2/12\"\n";
    assert!(guided.contains(rod));
    let massless = guided.replacen(rod, "", 1).replacen("m_rod = \"0.5 kg\"\n", "", 1);
    let light = guided.replacen("m_rod = \"0.5 kg\"", "m_rod = \"1e-9 kg\"", 1);
    let [massless, light] = [&massless, &light].map(|text| runs(text, Method::DormandPrince8, 1e-11));
    assert_eq!((massless.stopped(), light.stopped()), (None, None));
    assert_eq!(events(&massless).len(), events(&light).len());
    events(&massless).iter().zip(&events(&light)).for_each(|(one, other)| close(*one, *other, 1e-7));
    for name in ["theta", "phi", "theta'", "N"] {
        close(last(&massless, name), last(&light, name), 1e-5 * last(&light, name).abs().max(1.0));
    }
}

/// With a zero coefficient of friction the direction of sliding has no effect: the energy gained is the work of the torque.
#[test]
fn a_guide_whose_coefficient_of_friction_is_zero_is_smooth() {
    let text = edited("models/rough_slider_crank", &[("mu", "0")]);
    let run = runs(&text, Method::DormandPrince8, 1e-10);
    assert_eq!(run.stopped(), None);
    let energy = |value: &dyn Fn(&str) -> f64| value("kinetic_energy") + value("potential_energy");
    let place = |name: &str| run.names.iter().position(|known| known == name).expect("a column");
    let gained = energy(&|name| last(&run, name)) - energy(&|name| run.rows[0][place(name)]);
    close(gained, 6.0 * (last(&run, "theta") - 0.3), 1e-6);
    assert_eq!(last(&run, "T"), 0.0);
}
