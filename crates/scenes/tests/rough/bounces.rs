//! Infinitely many bounces in a finite time, and impacts while other contacts are closed.

use super::{METHODS, close, events, last, runs};

fn ball(e: f64, rest: &str) -> String {
    format!(
        "title = \"ball\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"0.2 kg\"\ng = \"9.81 m/s^2\"\ne = \"{e}\"\n\
         [coordinates]\nx = \"m\"\ny = \"m\"\n[points]\nP = \"O + x*N.x + y*N.y\"\n[bodies.ball]\ncentre = \"P\"\nmass = \"m\"\n\
         [[contact]]\nname = \"floor\"\nof = \"ball\"\nthrough = \"O\"\nnormal = \"N.y\"\nrestitution = \"e\"\n{rest}\
         [outputs]\nN = \"reaction(floor)\"\n[start]\ny = \"1 m\"\n\"x'\" = \"1 m/s\"\n[run]\nspan = \"2 s\"\n"
    )
}

/// The flights take t (1 + e)/(1 - e) in all, with the time t of the first fall; then the ball is at rest.
#[test]
fn bounces_come_to_an_end_where_their_sum_does() {
    let fall = (2.0_f64 / 9.81).sqrt();
    for method in METHODS {
        for e in [0.2, 0.5] {
            let trajectory = runs(&ball(e, ""), method, 1e-12);
            assert_eq!(trajectory.stopped(), None, "{method:?}");
            let times = events(&trajectory);
            close(times[times.len() - 1], fall * (1.0 + e) / (1.0 - e), 3e-9);
            for (name, known) in [("y", 0.0), ("y'", 0.0), ("N", 0.2 * 9.81), ("x'", 1.0)] {
                close(last(&trajectory, name), known, 1e-12);
            }
        }
    }
}

/// Without a coordinate along the floor, friction has no effect.
#[test]
fn a_rough_floor_under_a_ball_on_a_line_is_as_a_smooth_one() {
    let on_a_line = |friction: &str| {
        let text = ball(0.5, friction).replace("x = \"m\"\n", "").replace("x*N.x + ", "");
        text.replace("\"x'\" = \"1 m/s\"\n", "").replace("span = \"2 s\"", "span = \"1 s\"")
    };
    for impact in ["newton", "poisson", "moreau"] {
        let law = format!("impact = \"{impact}\"\n");
        let [smooth, rough] = [law.clone(), format!("{law}friction = \"0.3\"\n")]
            .map(|friction| runs(&on_a_line(&friction), METHODS[0], 1e-12));
        assert_eq!((smooth.stopped(), rough.stopped()), (None, None), "{impact}");
        close(last(&rough, "y"), last(&smooth, "y"), 1e-12);
        assert_eq!(events(&rough).len(), events(&smooth).len(), "{impact}");
        assert!(events(&rough).len() >= 2, "{impact}");
    }
}

#[test]
fn a_coefficient_of_one_keeps_the_energy() {
    let trajectory = runs(&ball(1.0, ""), METHODS[0], 1e-12);
    assert_eq!(trajectory.stopped(), None);
    let energy = 0.5 * last(&trajectory, "y'").powi(2) + 9.81 * last(&trajectory, "y");
    close(energy, 9.81, 1e-11);
}

/// A rough floor does not influence an impact on a wall: the impulse of the wall is tangential to the floor, whose own impulse is zero.
#[test]
fn an_impact_on_a_wall_leaves_a_floor_in_touch() {
    let wall = "friction = \"0.1\"\n[[contact]]\nname = \"wall\"\nof = \"ball\"\nthrough = \"O + (0.5 m)*N.x\"\nnormal = \"-N.x\"\n\
                restitution = \"0.5\"\nfriction = \"0.3\"\n";
    let text = ball(0.0, wall).replace("y = \"1 m\"", "y = \"0 m\"").replace("span = \"2 s\"", "span = \"1.2 s\"");
    for method in METHODS {
        let trajectory = runs(&text, method, 1e-12);
        assert_eq!(trajectory.stopped(), None, "{method:?}");
        // 0.5 = t - a t^2/2 with a = 0.1 g
        let a = 0.981;
        let speed = (1.0 - 2.0 * a * 0.5_f64).sqrt();
        let hit = (1.0 - speed) / a;
        close(events(&trajectory)[0], hit, 1e-12);
        let times = events(&trajectory);
        close(times[1], hit + 0.5 * speed / a, 1e-11);
        close(last(&trajectory, "x"), 0.5 - 0.125 * speed * speed / a, 1e-11);
    }
}

/// A load that slides on a floor hits a slope: the impulse lifts the load from the floor.
#[test]
fn a_contact_in_touch_opens_where_an_impact_lifts_it() {
    let text = "title = \"stop\"\n[parameters]\nm = \"1 kg\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n[points]\nP = \"O + x*N.x + y*N.y\"\n\
                [bodies.load]\ncentre = \"P\"\nmass = \"m\"\n\
                [[contact]]\nname = \"floor\"\nof = \"load\"\nthrough = \"O\"\nnormal = \"N.y\"\n\
                [[contact]]\nname = \"slope\"\nof = \"load\"\nthrough = \"O + (1 m)*N.x\"\nnormal = \"N.y - N.x\"\nrestitution = \"0.5\"\n\
                [start]\n\"x'\" = \"2 m/s\"\n[run]\nspan = \"1 s\"\n";
    for method in METHODS {
        let trajectory = runs(text, method, 1e-12);
        assert_eq!(trajectory.stopped(), None, "{method:?}");
        let then = trajectory.passages[1].then.as_deref().unwrap_or_default();
        assert_eq!(then, "contact `floor` is apart, contact `slope` is apart");
        // the normal velocity is reversed with the factor 1.5: (2, 0) - 1.5 (1, -1)
        close(last(&trajectory, "x'"), 0.5, 1e-13);
        close(last(&trajectory, "y'"), 1.5, 1e-13);
    }
}

/// The gap to a floor at 0.03 m has a rounding error, which makes falls longer; high bounces must end nevertheless.
#[test]
fn bounces_on_a_floor_off_zero_end_too() {
    for e in [0.8, 0.9] {
        let text = ball(e, "")
            .replace("through = \"O\"", "through = \"O + (0.03 m)*N.y\"")
            .replace("y = \"1 m\"", "y = \"1.03 m\"");
        let trajectory = runs(&text.replace("span = \"2 s\"", "span = \"10 s\""), METHODS[0], 1e-10);
        assert_eq!(trajectory.stopped(), None, "{e}");
        let times = events(&trajectory);
        close(times[times.len() - 1], (2.0_f64 / 9.81).sqrt() * (1.0 + e) / (1.0 - e), 1e-5);
        close(last(&trajectory, "y"), 0.03, 1e-13);
    }
}
