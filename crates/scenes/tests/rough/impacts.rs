//! Impacts and slopes, compared with closed forms.

use super::{METHODS, close, events, last, runs};

const BALL: &str = "title = \"ball\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"0.2 kg\"\nr = \"0.05 m\"\ng = \"9.81 m/s^2\"\n\
                    e = \"0.8\"\nmu = \"0.3\"\n[coordinates]\nx = \"m\"\ny = \"m\"\na = \"rad\"\n\
                    [frames]\nB = \"N turned a about z\"\n[points]\nG = \"O + x*N.x + y*N.y\"\nP = \"G - r*N.y\"\n\
                    [bodies.ball]\nframe = \"B\"\ncentre = \"G\"\nmass = \"m\"\ninertia = \"2/5*m*r^2\"\n\
                    [[contact]]\nname = \"floor\"\nof = \"ball at P\"\nthrough = \"O\"\nnormal = \"N.y\"\nfriction = \"mu\"\n\
                    restitution = \"e\"\n[start]\ny = \"1.05 m\"\n\"x'\" = \"2 m/s\"\n[run]\nspan = \"1 s\"\n";

/// Impact at v = sqrt(2 g h): the ball sticks if the impulse mu (1 + e) v m is enough to stop its sliding, which takes 2/7 of the momentum.
#[test]
fn a_ball_grips_or_slips_in_an_impact_as_coulomb_says() {
    let fall = (2.0_f64 * 9.81).sqrt();
    for method in METHODS {
        let trajectory = runs(BALL, method, 1e-12);
        assert_eq!(trajectory.stopped(), None);
        close(events(&trajectory)[0], fall / 9.81, 1e-12);
        // 2/7 of 2 m/s is less than 0.3 1.8 v
        close(last(&trajectory, "x'"), 5.0 / 7.0 * 2.0, 1e-12);
        close(last(&trajectory, "a'"), -last(&trajectory, "x'") / 0.05, 1e-10);
        let slips = runs(&BALL.replace("mu = \"0.3\"", "mu = \"0.02\""), method, 1e-12);
        close(last(&slips, "x'"), 2.0 - 0.02 * 1.8 * fall, 1e-12);
    }
}

fn disc(mu: f64) -> String {
    format!(
        "title = \"disc\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"2 kg\"\nr = \"0.1 m\"\ng = \"9.81 m/s^2\"\nmu = \"{mu}\"\n\
         b = \"30 deg\"\n[coordinates]\nx = \"m\"\ny = \"m\"\na = \"rad\"\n\
         [frames]\nI = \"N turned -b about z\"\nB = \"N turned a about z\"\n\
         [points]\nG = \"O + x*N.x + y*N.y\"\nP = \"G - r*I.y\"\n\
         [bodies.disc]\nframe = \"B\"\ncentre = \"G\"\nmass = \"m\"\ninertia = \"m*r^2/2\"\n\
         [[contact]]\nname = \"incline\"\nof = \"disc at P\"\nthrough = \"O\"\nnormal = \"I.y\"\nfriction = \"mu\"\ntouching = true\n\
         [outputs]\nN = \"reaction(incline)\"\nT = \"friction(incline)\"\n[run]\nspan = \"1 s\"\n"
    )
}

/// A disc rolls down if mu >= tan(b)/3, with the acceleration 2/3 g sin(b); otherwise it slides with g (sin(b) - mu cos(b)).
#[test]
fn a_disc_on_an_incline_rolls_or_slides() {
    let (s, c) = (0.5, 0.75_f64.sqrt());
    for method in METHODS {
        for (mu, along) in [(0.2, 2.0 / 3.0 * 9.81 * s), (0.15, 9.81 * (s - 0.15 * c))] {
            let trajectory = runs(&disc(mu), method, 1e-11);
            assert_eq!(trajectory.stopped(), None);
            close(last(&trajectory, "x'"), along * c, 1e-9);
            close(last(&trajectory, "N"), 2.0 * 9.81 * c, 1e-9);
            close(last(&trajectory, "T").abs(), 2.0 * (9.81 * s - along), 1e-9);
        }
    }
}

/// A block on a sliding wedge, with friction between them: both accelerations in closed form.
#[test]
fn a_block_slides_down_a_wedge_that_slides_away() {
    let text = "title = \"wedge\"\ngravity = \"-g*N.y\"\n[parameters]\nM = \"5 kg\"\nm = \"1 kg\"\ng = \"9.81 m/s^2\"\nmu = \"0.2\"\n\
                b = \"35 deg\"\n[coordinates]\nX = \"m\"\nx = \"m\"\ny = \"m\"\n[frames]\nI = \"N turned -b about z\"\n\
                [points]\nW = \"O + X*N.x\"\nP = \"O + x*N.x + y*N.y\"\n\
                [bodies.wedge]\nframe = \"N\"\ncentre = \"W\"\nmass = \"M\"\n[bodies.block]\ncentre = \"P\"\nmass = \"m\"\n\
                [[contact]]\nname = \"slope\"\nof = \"block\"\nwith = \"wedge\"\nthrough = \"W\"\nnormal = \"I.y\"\nfriction = \"mu\"\n\
                touching = true\n[outputs]\nN = \"reaction(slope)\"\n[run]\nspan = \"1 s\"\n";
    let (m, wedge, mu, b) = (1.0, 5.0, 0.2_f64, 35.0_f64.to_radians());
    let (s, c) = b.sin_cos();
    // N = m g c / (1 + m/M s (s - mu c)), X'' = -N (s - mu c)/M
    let normal = m * 9.81 * c / (1.0 + m / wedge * s * (s - mu * c));
    for method in METHODS {
        let trajectory = runs(text, method, 1e-11);
        assert_eq!(trajectory.stopped(), None);
        close(last(&trajectory, "N"), normal, 1e-9);
        close(last(&trajectory, "X'"), -normal * (s - mu * c) / wedge, 1e-9);
        close(last(&trajectory, "x'") + wedge * last(&trajectory, "X'"), 0.0, 1e-9);
    }
}

/// A load slides on a cart, both of them particles, until their speeds are equal: 2 m/s = (F/m + 2 mu g) t. Then it slides backwards.
#[test]
fn a_particle_carries_the_plane_on_which_another_slides() {
    let text = "title = \"cart\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"1 kg\"\ng = \"9.81 m/s^2\"\nF = \"10 N\"\nmu = \"0.2\"\n\
                [coordinates]\nX = \"m\"\nx = \"m\"\ny = \"m\"\n[points]\nC = \"O + X*N.x\"\nP = \"O + x*N.x + y*N.y\"\n\
                [bodies.cart]\ncentre = \"C\"\nmass = \"m\"\n[bodies.load]\ncentre = \"P\"\nmass = \"m\"\n\
                [[force]]\non = \"cart\"\nis = \"F*N.x\"\n\
                [[contact]]\nname = \"floor\"\nof = \"load\"\nwith = \"cart\"\nthrough = \"O\"\nnormal = \"N.y\"\nfriction = \"mu\"\n\
                [outputs]\ngap = \"gap(\\\"floor\\\")\"\n[start]\n\"x'\" = \"2 m/s\"\n[run]\nspan = \"1 s\"\n";
    for method in METHODS {
        let trajectory = runs(text, method, 1e-12);
        assert_eq!(trajectory.stopped(), None);
        let (drag, stops) = (0.2 * 9.81, 2.0 / (10.0 + 0.4 * 9.81));
        close(events(&trajectory)[0], stops, 1e-12);
        // friction decelerates the load, and accelerates it afterwards
        close(last(&trajectory, "x'"), 2.0 - drag * stops + drag * (1.0 - stops), 1e-11);
        close(last(&trajectory, "X'"), (10.0 + drag) * stops + (10.0 - drag) * (1.0 - stops), 1e-11);
    }
}
