//! Bodies on more feet than their motion determines: the motion is one, the shares of the feet are not.

use super::{METHODS, close, last, runs};

/// A block of the mass 2 kg on five feet, pushed at a height above the floor.
fn block(push: f64, height: f64) -> String {
    let feet: Vec<String> = ["-0.2", "-0.1", "0", "0.1", "0.2"].iter().map(|at| format!("({at} m)")).collect();
    let points: String = feet.iter().enumerate().map(|(k, at)| format!("F{k} = \"G + {at}*R.x - h*R.y\"\n")).collect();
    let contacts: String = (0..feet.len())
        .map(|k| {
            format!(
                "[[contact]]\nname = \"foot{k}\"\nof = \"block at F{k}\"\nthrough = \"O\"\nnormal = \"N.y\"\n\
                 friction = \"0.3\"\ntouching = true\n"
            )
        })
        .collect();
    let sum = |of: &str| (0..feet.len()).map(|k| format!("{of}(foot{k})")).collect::<Vec<String>>().join(" + ");
    format!(
        "title = \"block\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"2 kg\"\ng = \"9.81 m/s^2\"\nh = \"0.3 m\"\nP = \"{push} N\"\n\
         [coordinates]\nx = \"m\"\ny = \"m\"\na = \"rad\"\n[frames]\nR = \"N turned a about z\"\n\
         [points]\nG = \"O + x*N.x + y*N.y\"\nA = \"G + (({height} m) - h)*R.y\"\n{points}\
         [bodies.block]\nframe = \"R\"\ncentre = \"G\"\nmass = \"m\"\ninertia = \"m*(0.04 m^2)\"\n\
         [[force]]\non = \"block at A\"\nis = \"P*N.x\"\n{contacts}\
         [outputs]\nN = \"{}\"\nT = \"{}\"\n[run]\nspan = \"0.2 s\"\n",
        sum("reaction"),
        sum("friction")
    )
}

#[test]
fn a_block_on_five_feet_stays_while_friction_holds_it() {
    for method in METHODS {
        let trajectory = runs(&block(4.0, 0.1), method, 1e-11);
        assert_eq!(trajectory.stopped(), None, "{method:?}");
        for (name, known) in [("x", 0.0), ("y", 0.3), ("a", 0.0), ("N", 2.0 * 9.81)] {
            close(last(&trajectory, name), known, 1e-13);
        }
        close(last(&trajectory, "T").abs(), 4.0, 1e-12);
    }
}

#[test]
fn a_block_on_five_feet_slides_as_one_body() {
    for method in METHODS {
        let trajectory = runs(&block(10.0, 0.1), method, 1e-11);
        assert_eq!(trajectory.stopped(), None, "{method:?}");
        close(last(&trajectory, "x"), (5.0 - 0.3 * 9.81) * 0.02, 1e-11);
        close(last(&trajectory, "a"), 0.0, 1e-13);
        close(last(&trajectory, "N"), 2.0 * 9.81, 1e-11);
    }
}

/// m g 0.2 m holds it upright against P 0.9 m, about the foot in front, where it sticks.
#[test]
fn a_block_on_five_feet_turns_over_the_foot_in_front() {
    for method in METHODS {
        let trajectory = runs(&block(5.5, 0.9), method, 1e-11);
        assert_eq!(trajectory.stopped(), None, "{method:?}");
        let passages = &trajectory.passages;
        let then = passages[0].then.as_deref().unwrap_or_default();
        assert!(then.contains("contact `foot0` is apart") && then.contains("contact `foot4` sticks"), "{then}");
        assert!(last(&trajectory, "a") < -1e-3);
        // it turns about the foot, which stays
        let (a, x, y) = (last(&trajectory, "a"), last(&trajectory, "x"), last(&trajectory, "y"));
        close(x + 0.2 * a.cos() + 0.3 * a.sin(), 0.2, 1e-10);
        close(y + 0.2 * a.sin() - 0.3 * a.cos(), 0.0, 1e-10);
    }
}
