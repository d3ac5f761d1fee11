//! Moving planes whose speed jumps: friction accelerates a box by 5 m/s^2 to the speed of its belt.

use super::{METHODS, close, events, last, runs};
use dalembert_scenes::ModelScene;
use model::principles::Principle;
use model::{Agreement, Trace, agreement};

fn belt(through: &str, speed: &str) -> String {
    format!(
        "title = \"belt\"\ngravity = \"-(10 m/s^2)*N.y\"\n[parameters]\nv = \"1 m/s\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n\
         [bodies.box]\ncentre = \"O + x*N.x + y*N.y\"\nmass = \"(2 kg)\"\n\
         [[contact]]\nname = \"belt\"\nof = \"box\"\nthrough = \"O + {through}*N.x\"\nnormal = \"N.y\"\nfriction = \"0.5\"\ntouching = true\n\
         [start]\n\"x'\" = \"{speed}\"\n[run]\nspan = \"3 s\"\n"
    )
}

/// The box slides for 0.2 s, moves with the belt, and slides for 0.2 s after the belt has stopped or doubled its speed.
#[test]
fn a_box_slides_where_the_speed_of_its_belt_jumps() {
    for method in METHODS {
        for (through, speed, end) in [
            ("v*min(t, (1 s))", "0 m/s", 1.0),
            ("if(t < (1 s), v*t, v*(1 s))", "0 m/s", 1.0),
            ("v*table(t, (0 s), (0 s), (1 s), (1 s), (2 s), (1 s))", "0 m/s", 1.0),
            ("v*min(t, (1 s))", "1 m/s", 1.1),
            ("if(t < (1 s), v*t, v*(1 s) + 2*v*(t - (1 s)))", "0 m/s", 4.8),
        ] {
            let trajectory = runs(&belt(through, speed), method, 1e-12);
            assert_eq!(trajectory.stopped(), None, "{method:?} {through}");
            close(last(&trajectory, "x"), end, 1e-10);
        }
    }
}

/// The motion of the box with dry friction as a force instead of a contact.
#[test]
fn dry_friction_slides_where_the_speed_beside_it_jumps() {
    let text = "title = \"belt\"\n[parameters]\nv = \"1 m/s\"\n[coordinates]\nx = \"m\"\n\
                [bodies.box]\ncentre = \"O + x*N.x\"\nmass = \"(2 kg)\"\n\
                [[force]]\non = \"box\"\nis = \"-(10 N)*sign(x' - if(t < (1 s), v, 0*v))*N.x\"\n[run]\nspan = \"3 s\"\n";
    for method in METHODS {
        let trajectory = runs(text, method, 1e-12);
        assert_eq!(trajectory.stopped(), None, "{method:?}");
        close(last(&trajectory, "x"), 1.0, 1e-10);
    }
}

/// Relative to a plate with the acceleration 2 m/s^2, a ball falls with 12 m/s^2. Its bounces, with restitution 1/2, end after three times the first
/// fall.
#[test]
fn bounces_on_a_plate_that_moves_end_too() {
    let text = "title = \"ball\"\ngravity = \"-(10 m/s^2)*N.y\"\n[coordinates]\ny = \"m\"\n\
                [bodies.ball]\ncentre = \"O + y*N.y\"\nmass = \"(1 kg)\"\n\
                [[contact]]\nname = \"floor\"\nof = \"ball\"\nthrough = \"O + (2 m/s^2)*t^2/2*N.y\"\nnormal = \"N.y\"\nrestitution = \"0.5\"\n\
                [start]\ny = \"1 m\"\n[outputs]\nN = \"reaction(floor)\"\n[run]\nspan = \"3 s\"\n";
    for method in METHODS {
        let trajectory = runs(text, method, 1e-10);
        assert_eq!(trajectory.stopped(), None, "{method:?}");
        let times = events(&trajectory);
        // the last bounce is as high as the rounding error of the gap
        close(times[times.len() - 1], 3.0 * (1.0_f64 / 6.0).sqrt(), 1e-6);
        close(last(&trajectory, "N"), 12.0, 1e-10);
        close(last(&trajectory, "y"), 9.0, 1e-10);
    }
}

/// Another particle is the body that is touched, and carries the reaction.
#[test]
fn a_contact_of_two_particles_is_one_pair_by_every_principle() {
    let text = "title = \"two\"\n[parameters]\nm = \"1 kg\"\nM = \"3 kg\"\n[coordinates]\nx = \"m\"\nz = \"m\"\n\
                [bodies.a]\ncentre = \"O + x*N.x\"\nmass = \"m\"\n[bodies.b]\ncentre = \"O + z*N.x\"\nmass = \"M\"\n\
                [[contact]]\nname = \"hit\"\nof = \"b\"\nwith = \"a\"\nthrough = \"O + (x + (0.1 m))*N.x\"\nnormal = \"N.x\"\nrestitution = \"0.5\"\n\
                [start]\nz = \"1 m\"\n\"x'\" = \"2 m/s\"\n[outputs]\np = \"m*x' + M*z'\"\n[run]\nspan = \"1 s\"\n";
    let scene = ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"));
    for principle in Principle::ALL {
        let found = symbolic::apart(|| agreement(&Trace::of(&scene.model), Principle::Lagrange, principle));
        assert!(matches!(found, Ok(Agreement::Proved { .. })), "{principle:?}: {found:?}");
    }
    let trajectory = runs(text, METHODS[0], 1e-12);
    close(last(&trajectory, "p"), 2.0, 1e-13);
    close(last(&trajectory, "z'") - last(&trajectory, "x'"), 1.0, 1e-13);
}
