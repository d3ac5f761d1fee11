//! Coulomb friction in space: closed forms, rolling compared with constraints, and refusals.

use super::{METHODS, close, events, last, runs};
use integrators::Method;

/// A ball on a table, with spin about x.
fn ball(friction: f64, rest: &str, height: &str) -> String {
    format!(
        "title = \"ball\"\ngravity = \"-g*N.z\"\n[parameters]\nm = \"0.17 kg\"\nr = \"0.03 m\"\ng = \"9.81 m/s^2\"\nmu = \"{friction}\"\n\
         [coordinates]\nx = \"m\"\ny = \"m\"\nz = \"m\"\n[frames]\nB = \"N free\"\n\
         [points]\nG = \"O + x*N.x + y*N.y + z*N.z\"\nP = \"G - r*N.z\"\n\
         [bodies.ball]\nframe = \"B\"\ncentre = \"G\"\nmass = \"m\"\n\
         inertia = {{ principal = [\"2/5*m*r^2\", \"2/5*m*r^2\", \"2/5*m*r^2\"] }}\n\
         [[contact]]\nname = \"cloth\"\nof = \"ball at P\"\nthrough = \"O\"\nnormal = \"N.z\"\nfriction = \"mu\"\n{rest}\n\
         [outputs]\nT = \"norm(friction(cloth))\"\nv = \"norm(sliding(cloth))\"\nspin = \"angular_velocity(B) . N.y\"\n\
         [start]\nz = \"{height}\"\n\"x'\" = \"2 m/s\"\n\"B.wx\" = \"-60 rad/s\"\n[run]\nspan = \"1 s\"\n"
    )
}

/// The velocity u of the lowest point has a constant direction and decreases by 7/2 mu g; the path is a parabola until the ball rolls (Euler 1758).
#[test]
fn a_ball_with_spin_slides_until_it_rolls() {
    let (mu, g) = (0.2, 9.81);
    let slip = [2.0, -1.8_f64];
    let size = slip[0].hypot(slip[1]);
    let rolls = 2.0 * size / (7.0 * mu * g);
    let text = ball(mu, "touching = true", "0.03 m");
    for method in METHODS {
        let trajectory = runs(&text, method, 1e-12);
        assert_eq!(trajectory.stopped(), None, "{method:?}");
        assert_eq!(events(&trajectory).len(), 1, "{method:?}");
        close(events(&trajectory)[0], rolls, 1e-10);
        for (axis, (name, started)) in [("x", 2.0), ("y", 0.0)].into_iter().enumerate() {
            let slowed = -mu * g * slip[axis] / size;
            let rolling = started + slowed * rolls;
            close(last(&trajectory, &format!("{name}'")), rolling, 1e-10);
            let place = started * rolls + slowed * rolls * rolls / 2.0 + rolling * (1.0 - rolls);
            close(last(&trajectory, name), place, 1e-10);
        }
        for name in ["T", "v"] {
            close(last(&trajectory, name), 0.0, 1e-11);
        }
    }
}

/// If mu is large, sliding ends in the first impact: u becomes zero, which changes the velocity by 2/7 u.
#[test]
fn a_ball_that_bounces_with_spin_leaves_without_sliding() {
    let text = ball(0.4, "restitution = \"0.5\"", "1.03 m");
    let trajectory = runs(&text, Method::DormandPrince8, 1e-12);
    assert_eq!(trajectory.stopped(), None);
    close(events(&trajectory)[0], (2.0_f64 / 9.81).sqrt(), 1e-12);
    close(last(&trajectory, "x'"), 2.0 * 5.0 / 7.0, 1e-11);
    close(last(&trajectory, "y'"), 1.8 * 2.0 / 7.0, 1e-11);
    close(last(&trajectory, "spin"), 2.0 * 5.0 / 7.0 / 0.03, 1e-9);
}

/// A particle on a slope of 0.5 rad.
fn slope(friction: &str, start: &str, force: &str) -> String {
    format!(
        "title = \"slope\"\ngravity = \"-g*N.z\"\n[parameters]\nm = \"2 kg\"\ng = \"9.81 m/s^2\"\na = \"0.5 rad\"\n\
         [coordinates]\nx = \"m\"\ny = \"m\"\nz = \"m\"\n[frames]\nS = \"N turned a about y\"\n\
         [definitions]\nmu = \"{friction}\"\n[points]\nP = \"O + x*S.x + y*S.y + z*S.z\"\n[bodies.block]\ncentre = \"P\"\nmass = \"m\"\n\
         [[contact]]\nname = \"slope\"\nof = \"block\"\nthrough = \"O\"\nnormal = \"S.z\"\nfriction = \"mu\"\ntouching = true\n{force}\n\
         [outputs]\nv = \"norm(sliding(slope))\"\nT = \"norm(friction(slope))\"\n\
         [start]\n{start}\n[run]\nspan = \"2 s\"\n"
    )
}

/// With mu = tan a, the sum of the speed and of its component down the slope is constant.
#[test]
fn a_block_that_is_pushed_across_a_slope_turns_down() {
    for method in METHODS {
        let trajectory = runs(&slope("sin(a)/cos(a)", "\"y'\" = \"1 m/s\"", ""), method, 1e-12);
        assert_eq!(trajectory.stopped(), None, "{method:?}");
        close(last(&trajectory, "v") + last(&trajectory, "x'"), 1.0, 1e-11);
        assert!(last(&trajectory, "y'") < 0.01);
    }
}

#[test]
fn a_block_that_friction_does_not_hold_slides_down() {
    let trajectory = runs(&slope("0.3", "x = \"0 m\"", ""), Method::DormandPrince8, 1e-12);
    let (sin, cos) = 0.5_f64.sin_cos();
    close(last(&trajectory, "x"), 2.0 * 9.81 * (sin - 0.3 * cos), 1e-10);
    close(last(&trajectory, "y"), 0.0, 1e-12);
}

/// Sliding begins where |T| = mu N, for any direction of T; the motion after that is stiff.
#[test]
fn a_block_that_is_pulled_aside_more_and_more_begins_to_slide_where_friction_ends() {
    let force = "[[force]]\non = \"block\"\nis = \"(4 N/s)*t*S.y\"";
    let text = slope("0.6", "x = \"0 m\"", force);
    let (sin, cos) = 0.5_f64.sin_cos();
    let weight = 2.0 * 9.81;
    let begins = ((0.6 * weight * cos).powi(2) - (weight * sin).powi(2)).sqrt() / 4.0;
    let runs = [Method::RadauIIA { stages: 5 }, Method::Gauss { stages: 4 }].map(|method| runs(&text, method, 1e-11));
    for trajectory in &runs {
        assert_eq!(trajectory.stopped(), None);
        close(events(trajectory)[0], begins, 1e-10);
    }
    let [one, other] = &runs;
    for name in ["x", "y", "x'", "y'"] {
        assert!(last(one, name) > 0.01);
        close(last(one, name), last(other, name), 1e-9);
    }
}

/// A particle in a bowl z = (x^2 + y^2)/l: N is normal to the surface, T tangential and opposite to the velocity.
#[test]
fn friction_on_a_curved_surface_opposes_the_sliding() {
    let text = "title = \"bowl\"\ngravity = \"-g*N.z\"\n[parameters]\nm = \"2 kg\"\ng = \"9.81 m/s^2\"\nl = \"1.5 m\"\n\
                [coordinates]\nx = \"m\"\ny = \"m\"\nz = \"m\"\n[points]\nP = \"O + x*N.x + y*N.y + z*N.z\"\n\
                [bodies.bead]\ncentre = \"P\"\nmass = \"m\"\n\
                [[contact]]\nname = \"bowl\"\nof = \"bead\"\ngap = \"z - (x^2 + y^2)/l\"\nnormal = \"N.z - 2*x/l*N.x - 2*y/l*N.y\"\n\
                friction = \"0.15\"\ntouching = true\n\
                [outputs]\nlost = \"friction(bowl) . velocity(P) + 0.15*reaction(bowl)*norm(velocity(P))\"\n\
                across = \"norm(cross(friction(bowl), velocity(P)))\"\ngap = \"gap(bowl)\"\n\
                [start]\nx = \"0.4 m\"\n\"y'\" = \"1.1 m/s\"\n[run]\nspan = \"0.6 s\"\n";
    let trajectory = runs(text, Method::DormandPrince8, 1e-12);
    assert_eq!(trajectory.stopped(), None);
    assert!(last(&trajectory, "x").abs() > 0.01 && last(&trajectory, "y").abs() > 0.01);
    for (name, within) in [("lost", 1e-11), ("across", 1e-11), ("gap", 1e-10)] {
        close(last(&trajectory, name), 0.0, within);
    }
}

/// A coin with the radius 12 mm, rolling by friction, and by constraints.
#[test]
fn a_coin_that_friction_holds_rolls_as_one_that_constraints_hold() {
    let coin = |held: &str| {
        format!(
            "title = \"coin\"\ngravity = \"-g*N.z\"\n[parameters]\nm = \"10 g\"\nr = \"12 mm\"\ng = \"9.81 m/s^2\"\n\
             [coordinates]\nx = \"m\"\ny = \"m\"\nz = \"m\"\nheading = \"rad\"\nlean = \"rad\"\nspin = \"rad\"\n\
             [frames]\nB = \"N turned heading about z\"\nC = \"B turned -lean about x\"\nD = \"C turned spin about y\"\n\
             [points]\nG = \"O + x*N.x + y*N.y + z*N.z\"\nP = \"G - r*C.z\"\n\
             [bodies.coin]\nframe = \"D\"\ncentre = \"G\"\nmass = \"m\"\n\
             inertia = {{ axes = \"C\", principal = [\"m*r^2/4\", \"m*r^2/2\", \"m*r^2/4\"] }}\n{held}\n\
             [start]\nlean = \"0.3 rad\"\n\"spin'\" = \"20 rad/s\"\n\"x'\" = \"0.24 m/s\"\n[run]\nspan = \"0.3 s\"\n"
        )
    };
    let contact = "[[contact]]\nname = \"table\"\nof = \"coin at P\"\nthrough = \"O\"\nnormal = \"N.z\"\nfriction = \"5\"\ntouching = true\n";
    let rolling = "[[constraint]]\nzero = [\"velocity(coin at P) . N.x\", \"velocity(coin at P) . N.y\"]\n\
                   [[constraint]]\nzero = \"z - r*cos(lean)\"\n";
    let [held, constrained] = [contact, rolling].map(|held| runs(&coin(held), Method::DormandPrince8, 1e-12));
    assert_eq!((held.stopped(), constrained.stopped()), (None, None));
    for name in ["x", "y", "z", "heading", "lean", "spin", "lean'", "spin'"] {
        close(last(&held, name), last(&constrained, name), 1e-9 * last(&held, name).abs().max(1.0));
    }
}

/// The message with which the run of a text ends.
fn end(text: &str) -> String {
    runs(text, Method::DormandPrince8, 1e-9).stopped().unwrap_or_default().to_string()
}

#[test]
fn impacts_that_turn_the_sliding_are_refused() {
    let text = ball(0.2, "restitution = \"0.5\"", "1.03 m").replace("[\"2/5*m*r^2\", ", "[\"4/5*m*r^2\", ");
    assert!(end(&text).contains("would turn the direction of sliding"), "{}", end(&text));
}

/// In a sphere without gravity the speed decreases as 1/(1 + f v t/R), also where the normal passes an axis.
#[test]
fn a_particle_slides_round_in_a_sphere_through_every_axis() {
    let text = |start: &str| {
        format!(
            "title = \"sphere\"\n[coordinates]\nx = \"m\"\ny = \"m\"\nz = \"m\"\n[points]\nP = \"O + x*N.x + y*N.y + z*N.z\"\n\
             [bodies.p]\ncentre = \"P\"\nmass = \"(1 kg)\"\n\
             [[contact]]\nname = \"bowl\"\nof = \"p\"\ngap = \"(1 m) - distance(O, P)\"\nnormal = \"-(P - O)\"\nfriction = \"0.1\"\ntouching = true\n\
             [outputs]\nv = \"norm(velocity(P))\"\n[start]\n{start}\n[run]\nspan = \"5 s\"\n"
        )
    };
    for start in
        ["y = \"1 m\"\n\"x'\" = \"3 m/s\"", "x = \"1 m\"\n\"z'\" = \"3 m/s\"", "z = \"1 m\"\n\"x'\" = \"-3 m/s\""]
    {
        let trajectory = runs(&text(start), Method::DormandPrince8, 1e-12);
        assert_eq!(trajectory.stopped(), None, "{start}");
        close(last(&trajectory, "v"), 3.0 / (1.0 + 0.1 * 3.0 * 5.0), 1e-10);
    }
}

/// A block on a straight line on a table with a growing force: friction acts along the line.
#[test]
fn a_block_on_a_line_begins_to_slide_where_the_pull_along_it_exceeds_friction() {
    let text = "title = \"line\"\ngravity = \"-(10 m/s^2)*N.z\"\n[coordinates]\nx = \"m\"\ny = \"m\"\nz = \"m\"\n\
                [points]\nP = \"O + x*N.x + y*N.y + z*N.z\"\n[bodies.p]\ncentre = \"P\"\nmass = \"(1 kg)\"\n\
                [[constraint]]\nzero = \"3*x - 4*y\"\n\
                [[contact]]\nname = \"table\"\nof = \"p\"\nthrough = \"O\"\nnormal = \"N.z\"\nfriction = \"0.2\"\ntouching = true\n\
                [[force]]\non = \"p\"\nis = \"(5 N/s)*t*N.x\"\n[run]\nspan = \"1 s\"\n";
    for method in [Method::DormandPrince8, Method::Radau5] {
        let trajectory = runs(text, method, 1e-11);
        assert_eq!(trajectory.stopped(), None, "{method:?}");
        // 4/5 of the force act along the line
        close(events(&trajectory)[0], 0.5, 1e-10);
        close(last(&trajectory, "x'"), 0.8 * 0.5 * 4.0 * 0.25, 1e-9);
    }
}

/// Neither method works there: one needs a Taylor series, which does not exist, the other steps over the instant of rest.
#[test]
fn methods_that_cannot_follow_a_slip_are_refused() {
    let text = slope("0.3", "x = \"0 m\"", "");
    for (method, said) in [(Method::Taylor, "no Taylor series"), (Method::BaderDeuflhard, "pass over the instant")] {
        let stopped = runs(&text, method, 1e-9).stopped().unwrap_or_default().to_string();
        assert!(stopped.contains(said), "{stopped}");
    }
}
