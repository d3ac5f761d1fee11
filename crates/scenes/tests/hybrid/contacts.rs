//! Several contacts with dry friction.

use super::draws::{DRAWS, Draw, ends_at, on_a_line};
use super::runs;
use integrators::Method;

/// A polynomial motion: position and speed at the time `since`, and the acceleration c + r t from then on.
#[derive(Clone, Copy)]
struct Piece {
    since: f64,
    x: f64,
    v: f64,
}

impl Piece {
    fn after(self, until: f64, [c, r]: [f64; 2]) -> Piece {
        let (h, c) = (until - self.since, c + r * self.since);
        let x = self.x + self.v * h + c * h * h / 2.0 + r * h.powi(3) / 6.0;
        Piece { since: until, x, v: self.v + c * h + r * h * h / 2.0 }
    }
}

/// Three stacked blocks, the lowest pulled by the force r t: they move together until friction cannot accelerate the upper ones.
#[test]
fn a_stack_that_is_pulled_comes_apart_where_its_weakest_contact_says() {
    for number in 0..DRAWS {
        let mut draw = Draw::new(11, number);
        let [ground, middle, top] = [draw.between(2.0, 8.0), draw.between(1.0, 4.0), draw.between(0.3, 3.0)];
        let [a, b, c] = draw.array(0.5, 3.0);
        let rate = draw.between(1.0, 6.0);
        // the acceleration of the blocks that move together, and its value where a contact slips
        let together = |mass: f64, against: f64| [-against / mass, rate / mass];
        let when = |[c, r]: [f64; 2], acceleration: f64| (acceleration - c) / r;
        let begin = Piece { since: ground / rate, x: 0.0, v: 0.0 };
        let all = together(a + b + c, ground);
        let lower_slips_first = middle / (b + c) < top / c;
        let (span, [x, y, z]);
        if lower_slips_first {
            let slips = when(all, middle / (b + c));
            span = slips + draw.between(0.5, 2.0);
            let apart = begin.after(slips, all);
            let upper = apart.after(span, [middle / (b + c), 0.0]);
            [x, y, z] = [apart.after(span, together(a, ground + middle)), upper, upper];
        } else {
            let slips = when(all, top / c);
            let apart = begin.after(slips, all);
            let two = together(a + b, ground + top);
            let second = when(two, (middle - top) / b);
            span = second + draw.between(0.5, 2.0);
            let lower = apart.after(second, two);
            x = lower.after(span, together(a, ground + middle));
            y = lower.after(span, [(middle - top) / b, 0.0]);
            z = apart.after(span, [top / c, 0.0]);
        }
        let [low, high] = [format!("({middle} N)*sign(x' - y')"), format!("({top} N)*sign(y' - z')")];
        let text = on_a_line(
            &[
                ("x", a, &format!("-({ground} N)*sign(x') - {low} + ({rate} N/s)*t")),
                // the same contacts with exchanged bodies, one with a multiple of its sliding speed
                ("y", b, &format!("-({middle} N)*sign(2*(y' - x')) - {high}")),
                ("z", c, &format!("-({top} N)*sign((z' - y')/(3 m/s))")),
            ],
            &format!("[run]\nspan = \"{span} s\"\n"),
        );
        let known = [("x", x.x), ("x'", x.v), ("y", y.x), ("y'", y.v), ("z", z.x), ("z'", z.v)];
        ends_at(&text, &known, 10.0);
    }
}

/// Two equal blocks side by side on a belt, with friction between them: three contacts and two speeds, so that the forces of friction are not
/// unique while all stick. Each block moves as a single block.
#[test]
fn equal_blocks_on_a_belt_do_not_feel_the_contact_between_them() {
    for number in 0..DRAWS {
        let mut draw = Draw::new(12, number);
        let [mass, friction] = [draw.between(0.5, 3.0), draw.between(1.0, 6.0)];
        let [k, belt, between] = [draw.between(20.0, 80.0), draw.between(0.1, 0.6), draw.between(0.5, 3.0)];
        let (w, leaves) = ((k / mass).sqrt(), friction / (k * belt));
        let span = leaves + draw.between(0.3, 0.9) * std::f64::consts::TAU / w;
        let phase = w * (span - leaves);
        let force = |own: &str, other: &str| {
            format!(
                "-({k} N/m)*{own} - ({friction} N)*sign({own}' - ({belt} m/s)) - ({between} N)*sign({own}' - {other}')"
            )
        };
        let start = format!("[start]\n\"x'\" = \"{belt} m/s\"\n\"y'\" = \"{belt} m/s\"\n[run]\nspan = \"{span} s\"\n");
        let text = on_a_line(&[("x", mass, &force("x", "y")), ("y", mass, &force("y", "x"))], &start);
        let (x, v) = (friction / k + belt / w * phase.sin(), belt * phase.cos());
        ends_at(&text, &[("x", x), ("x'", v), ("y", x), ("y'", v)], 1e4);
    }
}

/// Blocks with equal data start, stop and turn at equal times, each as a single block: x'' = -x - sgn x', by half circles in the phase plane.
#[test]
fn equal_blocks_stop_together() {
    for number in 0..DRAWS {
        let mut draw = Draw::new(13, number);
        let away = draw.between(1.5, 12.0);
        // half circles about -1 and 1 until one ends between them
        let (mut x, mut halves) = (away, 0);
        while x.abs() > 1.0 {
            x = if x > 0.0 { 2.0 - x } else { -2.0 - x };
            halves += 1;
        }
        let span = std::f64::consts::PI * f64::from(halves) + 1.0;
        let force = |name: &str| format!("-(1 N/m)*{name} - (1 N)*sign({name}')");
        let forces = ["x", "y", "z"].map(force);
        let text = on_a_line(
            &[("x", 1.0, &forces[0]), ("y", 1.0, &forces[1]), ("z", 1.0, &forces[2])],
            &format!("[start]\nx = \"{away} m\"\ny = \"-{away} m\"\nz = \"{away} m\"\n[run]\nspan = \"{span} s\"\n"),
        );
        ends_at(&text, &[("x", x), ("x'", 0.0), ("y", -x), ("y'", 0.0), ("z", x), ("z'", 0.0)], 1e3);
    }
}

/// Nine blocks stop at one instant: they have more combinations of cases than the search enumerates.
#[test]
fn many_blocks_stop_together() {
    let names = ["a", "b", "c", "d", "e", "f", "i", "j", "k"];
    let forces = names.map(|name| format!("-(1 N/m)*{name} - (1 N)*sign({name}')"));
    let bodies: Vec<(&str, f64, &str)> =
        names.iter().zip(&forces).map(|(name, force)| (*name, 1.0, force.as_str())).collect();
    let starts: String = names.iter().map(|name| format!("{name} = \"3.4 m\"\n")).collect();
    let text = on_a_line(&bodies, &format!("[start]\n{starts}[run]\nspan = \"8 s\"\n"));
    // turning points 3.4, -1.4, -0.6
    ends_at(&text, &names.map(|name| (name, -0.6)), 1e3);
}

/// A chain of three links with dry friction in each joint.
#[test]
fn friction_in_three_joints_brings_an_arm_to_rest() {
    let mut text = "title = \"arm\"\ngravity = \"-(9.81 m/s^2)*N.y\"\n[coordinates]\n".to_owned();
    text += "a0 = \"rad\"\na1 = \"rad\"\na2 = \"rad\"\n[frames]\n";
    text += "A0 = \"N turned a0 about z\"\nA1 = \"A0 turned a1 about z\"\nA2 = \"A1 turned a2 about z\"\n[points]\n";
    text += "P0 = \"O + (0.3 m)*A0.x\"\nP1 = \"P0 + (0.3 m)*A1.x\"\nP2 = \"P1 + (0.3 m)*A2.x\"\n";
    for k in 0..3 {
        let below = if k == 0 { "ground".to_owned() } else { format!("b{}", k - 1) };
        text += &format!(
            "[bodies.b{k}]\nframe = \"A{k}\"\ncentre = \"P{k}\"\nmass = \"(1 kg)\"\ninertia = \"(0.01 kg m^2)\"\n\
             [[torque]]\nbetween = [\"{below}\", \"b{k}\"]\nis = \"-(0.5 N m)*sign(a{k}')*N.z\"\n"
        );
    }
    text += "[start]\na0 = \"-80 deg\"\n[run]\nspan = \"3 s\"\n";
    let ends = [Method::Taylor, Method::DormandPrince8].map(|method| {
        let trajectory = runs(&text, method);
        assert_eq!(trajectory.stopped(), None, "{method:?}");
        trajectory.last
    });
    for (taylor, other) in ends[0].iter().zip(&ends[1]) {
        assert!((taylor - other).abs() < 1e-6, "{ends:?}");
    }
    // the chain is at rest, not exactly vertical
    assert!(ends[0][3..6].iter().all(|speed| speed.abs() < 1e-9), "{ends:?}");
}

/// Four links with dry friction in each joint and between the first and the third: four conditions, any three of which imply the fourth. The
/// bound of rounding errors of the accelerations is wider than the friction of a contact.
#[test]
fn links_with_friction_in_a_loop_move_alike_by_every_method() {
    let mut text = "title = \"links\"\ngravity = \"-(9.81 m/s^2)*N.y\"\n[coordinates]\n".to_owned();
    text += &(0..4).map(|k| format!("a{k} = \"rad\"\n")).collect::<String>();
    text += "[frames]\n";
    text += &(0..4).map(|k| format!("A{k} = \"N turned a{k} about z\"\n")).collect::<String>();
    text += "[points]\nP0 = \"O + (0.3 m)*A0.x\"\n";
    text += &(1..4).map(|k| format!("P{k} = \"P{} + (0.3 m)*A{k}.x\"\n", k - 1)).collect::<String>();
    for (k, mass) in [1.0, 1.0, 2.0, 0.5].into_iter().enumerate() {
        text += &format!(
            "[bodies.b{k}]\nframe = \"A{k}\"\ncentre = \"P{k}\"\nmass = \"({mass} kg)\"\ninertia = \"(0.01 kg m^2)\"\n"
        );
    }
    let joints = [("ground", 0, 0.2), ("b0", 1, 1.0), ("b1", 2, 0.2), ("b2", 3, 0.2), ("b0", 2, 0.3)];
    for (below, above, friction) in joints {
        let other = below.strip_prefix('b').map_or(String::new(), |number| format!(" - a{number}'"));
        text += &format!(
            "[[torque]]\nbetween = [\"{below}\", \"b{above}\"]\nis = \"-({friction} N m)*sign(a{above}'{other})*N.z\"\n"
        );
    }
    text += "[[torque]]\non = \"b3\"\nis = \"(3 N m)*sin((1 rad/s)*t)*N.z\"\n";
    text += "[start]\na0 = \"-60 deg\"\na1 = \"-60 deg\"\n[run]\nspan = \"2 s\"\n";
    let ends = [Method::Taylor, Method::DormandPrince8, Method::Radau5].map(|method| {
        let trajectory = runs(&text, method);
        assert_eq!(trajectory.stopped(), None, "{method:?}");
        trajectory.last
    });
    for end in &ends[1..] {
        assert!(ends[0].iter().zip(end).all(|(a, b)| (a - b).abs() < 1e-6), "{ends:?}");
    }
}

/// A chain of six links with dry friction in the joints, compared with smooth friction. The bound of rounding errors exceeds a jump of
/// friction; nothing may stick for this reason.
#[test]
fn an_arm_of_six_links_moves_as_with_smooth_friction() {
    let arm = |friction: fn(usize) -> String| {
        let mut text = "title = \"arm\"\ngravity = \"-(9.81 m/s^2)*N.y\"\n[coordinates]\n".to_owned();
        text += &(0..6).map(|k| format!("a{k} = \"rad\"\n")).collect::<String>();
        text += "[frames]\nA0 = \"N turned a0 about z\"\n";
        text += &(1..6).map(|k| format!("A{k} = \"A{} turned a{k} about z\"\n", k - 1)).collect::<String>();
        text += "[points]\nP0 = \"O + (0.3 m)*A0.x\"\n";
        text += &(1..6).map(|k| format!("P{k} = \"P{} + (0.3 m)*A{k}.x\"\n", k - 1)).collect::<String>();
        for k in 0..6 {
            let below = if k == 0 { "ground".to_owned() } else { format!("b{}", k - 1) };
            text += &format!(
                "[bodies.b{k}]\nframe = \"A{k}\"\ncentre = \"P{k}\"\nmass = \"(1 kg)\"\ninertia = \"(0.01 kg m^2)\"\n\
                 [[torque]]\nbetween = [\"{below}\", \"b{k}\"]\nis = \"-(0.5 N m)*{}*N.z\"\n",
                friction(k)
            );
        }
        text + "[start]\na0 = \"-80 deg\"\n[run]\nspan = \"2 s\"\n"
    };
    let dry = runs(&arm(|k| format!("sign(a{k}')")), Method::DormandPrince8);
    let smooth = runs(&arm(|k| format!("tanh(a{k}'/(0.001 rad/s))")), Method::Radau5);
    assert_eq!([dry.stopped(), smooth.stopped()], [None, None]);
    assert!(
        dry.last[..6].iter().zip(&smooth.last).all(|(a, b)| (a - b).abs() < 2e-3),
        "{:?} {:?}",
        dry.last,
        smooth.last
    );
    // the chain is still moving
    assert!(dry.last[6].abs() > 0.1, "{:?}", dry.last);
}
