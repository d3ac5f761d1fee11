//! Bodies on more feet than their motion determines: the motion is unique, the reactions of the feet are not.

use super::{METHODS, close, last, runs};

/// Number of feet; two would determine the reactions of a plane body.
const FEET: usize = 12;

/// A block of 2 kg on many feet, with a force at a height above the floor.
fn block(push: f64, height: f64) -> String {
    let feet: Vec<String> = (0..FEET).map(|k| format!("({} m)", 0.4 * k as f64 / (FEET - 1) as f64 - 0.2)).collect();
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
fn a_block_on_twelve_feet_stays_while_friction_holds_it() {
    for method in METHODS {
        let trajectory = runs(&block(4.0, 0.1), method, 1e-11);
        assert_eq!(trajectory.stopped(), None, "{method:?}");
        for (name, known) in [("x", 0.0), ("y", 0.3), ("a", 0.0), ("N", 2.0 * 9.81)] {
            close(last(&trajectory, name), known, 1e-13);
        }
        close(last(&trajectory, "T").abs(), 4.0, 1e-12);
        let then = trajectory.passages[0].then.as_deref().unwrap_or_default();
        assert_eq!(then.matches("touches without force").count(), FEET - 2, "{then}");
    }
}

#[test]
fn a_block_on_twelve_feet_slides_as_one_body() {
    for method in METHODS {
        let trajectory = runs(&block(10.0, 0.1), method, 1e-11);
        assert_eq!(trajectory.stopped(), None, "{method:?}");
        close(last(&trajectory, "x"), (5.0 - 0.3 * 9.81) * 0.02, 1e-11);
        close(last(&trajectory, "a"), 0.0, 1e-13);
        close(last(&trajectory, "N"), 2.0 * 9.81, 1e-11);
    }
}

/// The torque m g 0.2 m of the weight is less than P 0.9 m: the block turns about the front foot, which sticks.
#[test]
fn a_block_on_twelve_feet_turns_over_the_foot_in_front() {
    for method in METHODS {
        let trajectory = runs(&block(5.5, 0.9), method, 1e-11);
        assert_eq!(trajectory.stopped(), None, "{method:?}");
        let passages = &trajectory.passages;
        let then = passages[0].then.as_deref().unwrap_or_default();
        assert!(then.contains("contact `foot0` is apart") && then.contains("contact `foot11` sticks"), "{then}");
        assert!(last(&trajectory, "a") < -1e-3);
        // the block turns about the fixed foot
        let (a, x, y) = (last(&trajectory, "a"), last(&trajectory, "x"), last(&trajectory, "y"));
        close(x + 0.2 * a.cos() + 0.3 * a.sin(), 0.2, 1e-10);
        close(y + 0.2 * a.sin() - 0.3 * a.cos(), 0.0, 1e-10);
    }
}

/// Two stacked blocks, the upper one pulled: below mu m g both stay at rest, above only the upper one slides.
#[test]
fn a_stack_stays_or_slides_where_its_friction_is_least() {
    for (pull, moves) in [(5.0, 0.0), (8.0, (8.0 - 0.3 * 2.0 * 9.81) / 2.0 * 0.02)] {
        let trajectory = runs(&stack(pull), METHODS[0], 1e-11);
        assert_eq!(trajectory.stopped(), None);
        close(last(&trajectory, "x1"), moves, 1e-12);
        for name in ["x0", "a0", "a1"] {
            close(last(&trajectory, name), 0.0, 1e-12);
        }
    }
}

fn stack(pull: f64) -> String {
    let of_each = |part: &dyn Fn(usize) -> String| (0..2).map(part).collect::<String>();
    let contact = |block: usize, foot: usize| {
        let on = ["through = \"O\"\nnormal = \"N.y\"", "with = \"block0\"\nthrough = \"T0\"\nnormal = \"R0.y\""][block];
        format!("[[contact]]\nof = \"block{block} at F{block}{foot}\"\n{on}\nfriction = \"0.3\"\ntouching = true\n")
    };
    [
        "title = \"stack\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"2 kg\"\ng = \"9.81 m/s^2\"\nh = \"0.3 m\"\n[coordinates]\n".to_owned(),
        of_each(&|k| format!("x{k} = \"m\"\ny{k} = \"m\"\na{k} = \"rad\"\n")),
        "[frames]\n".to_owned(),
        of_each(&|k| format!("R{k} = \"N turned a{k} about z\"\n")),
        "[points]\n".to_owned(),
        of_each(&|k| {
            format!(
                "G{k} = \"O + x{k}*N.x + y{k}*N.y\"\nT{k} = \"G{k} + h*R{k}.y\"\nF{k}0 = \"G{k} - (0.2 m)*R{k}.x - h*R{k}.y\"\n\
                 F{k}1 = \"G{k} + (0.2 m)*R{k}.x - h*R{k}.y\"\n"
            )
        }),
        of_each(&|k| format!("[bodies.block{k}]\nframe = \"R{k}\"\ncentre = \"G{k}\"\nmass = \"m\"\ninertia = \"m*(0.04 m^2)\"\n")),
        format!("[[force]]\non = \"block1\"\nis = \"({pull} N)*N.x\"\n"),
        of_each(&|k| contact(k, 0) + &contact(k, 1)),
        "[start]\ny0 = \"0.3 m\"\ny1 = \"0.9 m\"\n[run]\nspan = \"0.2 s\"\n".to_owned(),
    ]
    .concat()
}
