//! One contact with dry friction: breakaway, sliding, sticking and grazing, compared with closed forms.

use super::draws::{DRAWS, Draw, ends_at, first_zero, on_a_line};
use dalembert_scenes::ModelScene;
use integrators::Method;
use simulation::{Axes, Choice, IvpScene};
use std::f64::consts::{PI, TAU};

/// A force r t moves a block from the time F/r on: m x = r (t - F/r)^3/6.
#[test]
fn a_growing_force_breaks_a_block_away_when_it_equals_friction() {
    for number in 0..DRAWS {
        let mut draw = Draw::new(1, number);
        let [friction, rate, mass] = draw.array(0.5, 9.0);
        let span = friction / rate + draw.between(1.0, 3.0);
        let force = format!("-({friction} N)*sign(x') + ({rate} N/s)*t");
        let text = on_a_line(&[("x", mass, &force)], &format!("[run]\nspan = \"{span} s\"\n"));
        let moved = span - friction / rate;
        let known = [("x", rate * moved.powi(3) / (6.0 * mass)), ("x'", rate * moved.powi(2) / (2.0 * mass))];
        ends_at(&text, &known, 10.0);
    }
}

/// A periodic force whose maximum equals the limit of friction does not move a block.
#[test]
fn a_force_that_rises_up_to_friction_moves_nothing() {
    for number in 0..DRAWS {
        let mut draw = Draw::new(2, number);
        let [friction, rate, mass] = draw.array(0.5, 9.0);
        let force = format!("-({friction} N)*sign(x') + ({friction} N)*sin(({rate} rad/s)*t)");
        let text = on_a_line(&[("x", mass, &force)], "[run]\nspan = \"20 s\"\n");
        ends_at(&text, &[("x", 0.0), ("x'", 0.0)], 0.0);
    }
}

/// The force (p + q t) sin w t exceeds the limit F only after some periods; no step of the resting block may miss this.
#[test]
fn a_growing_oscillation_breaks_a_block_away_at_its_first_peak_beyond_friction() {
    for number in 0..DRAWS {
        let mut draw = Draw::new(3, number);
        let [friction, mass] = draw.array(2.0, 5.0);
        let [p, q, w] = [draw.between(0.3, 0.9) * friction, draw.between(0.05, 0.5), draw.between(2.0, 9.0)];
        let force = |t: f64| (p + q * t) * (w * t).sin();
        let breaks = first_zero(|t| force(t).abs() - friction, 0.0, 1e-3 / w);
        let side = force(breaks).signum();
        // sliding lasts longer than the force exceeds friction
        let back = first_zero(|t| force(t).abs() - friction, breaks, 1e-3 / w);
        let pushed = |t: f64| (force(t) - side * friction) / mass;
        // Simpson's rule for the speed, and for the position as the integral of (end - t) x''
        let cells = 2000;
        let h = (back - breaks) / f64::from(cells);
        let integral = |f: &dyn Fn(f64) -> f64| -> f64 {
            let cell = |k: i32| breaks + h * f64::from(k);
            (0..cells).map(|k| h / 6.0 * (f(cell(k)) + 4.0 * f(cell(k) + 0.5 * h) + f(cell(k + 1)))).sum()
        };
        let known = [("x'", integral(&pushed)), ("x", integral(&|t| (back - t) * pushed(t)))];
        let applied = format!("-({friction} N)*sign(x') + (({p} N) + ({q} N/s)*t)*sin(({w} rad/s)*t)");
        let text = on_a_line(&[("x", mass, &applied)], &format!("[run]\nspan = \"{back} s\"\n"));
        ends_at(&text, &known, 1e3);
    }
}

/// A block on a table with the speed A w cos w t slides with x'' = ∓F/m and sticks while A w^2 |sin w t| < F/m.
#[test]
fn a_block_on_a_shaken_table_slides_and_sticks() {
    for number in 0..DRAWS {
        let mut draw = Draw::new(4, number);
        let [mass, w] = [draw.between(0.5, 3.0), draw.between(2.0, 8.0)];
        let amplitude = draw.between(0.02, 0.1);
        // covers frequent sticking to permanent sliding
        let grip = draw.between(0.2, 0.95) * amplitude * w * w;
        let span = 4.3 * TAU / w;
        let table = |t: f64| amplitude * w * (w * t).cos();
        let (mut t, mut x, mut v, mut sticks) = (0.0, 0.0, 0.0, false);
        // sign of the table's speed relative to the block
        let mut side = 1.0;
        while t < span {
            if sticks {
                // friction holds the block while |sin w t| is small
                let (bound, phase) = ((grip / (amplitude * w * w)).asin(), (w * t).rem_euclid(PI));
                let rest = if phase < bound { bound - phase } else { PI + bound - phase };
                let leaves = (t + rest / w).min(span);
                x += amplitude * ((w * leaves).sin() - (w * t).sin());
                (t, v, sticks, side) = (leaves, table(leaves), false, -(w * leaves).sin().signum());
            } else {
                let slides = side * grip;
                let meets = first_zero(|s| v + slides * (s - t) - table(s), t, 1e-3 / w).min(span);
                let time = meets - t;
                x += v * time + 0.5 * slides * time * time;
                (t, v, side) = (meets, v + slides * time, -side);
                sticks = amplitude * w * w * (w * t).sin().abs() < grip;
            }
        }
        let force = format!("-({} N)*sign(x' - ({} m/s)*cos(({w} rad/s)*t))", grip * mass, amplitude * w);
        let text = on_a_line(&[("x", mass, &force)], &format!("[run]\nspan = \"{span} s\"\n"));
        ends_at(&text, &[("x", x), ("x'", v)], 1e3);
    }
}

/// A belt carries a block until its spring pulls with F. The block then oscillates about F/k, and in every period its speed touches that of
/// the belt.
#[test]
fn a_block_on_a_belt_grazes_the_speed_of_the_belt() {
    for number in 0..DRAWS {
        let mut draw = Draw::new(5, number);
        let [mass, friction] = [draw.between(0.5, 3.0), draw.between(1.0, 6.0)];
        let [k, belt] = [draw.between(20.0, 80.0), draw.between(0.1, 0.6)];
        let (w, leaves) = ((k / mass).sqrt(), friction / (k * belt));
        let span = leaves + draw.between(2.1, 4.9) * TAU / w;
        let phase = w * (span - leaves);
        let force = format!("-({k} N/m)*x - ({friction} N)*sign(x' - ({belt} m/s))");
        let start = format!("[start]\n\"x'\" = \"{belt} m/s\"\n[run]\nspan = \"{span} s\"\n");
        let text = on_a_line(&[("x", mass, &force)], &start);
        ends_at(&text, &[("x", friction / k + belt / w * phase.sin()), ("x'", belt * phase.cos())], 3e4);
    }
}

/// Friction that decreases with the speed, F (1 - c |x' - v|). While slipping, x'' - (F c/m) x' + (k/m) x = F (1 - c v)/m; a stick-slip cycle
/// follows.
#[test]
fn a_block_on_a_belt_sticks_and_slips() {
    for number in 0..DRAWS {
        let mut draw = Draw::new(6, number);
        let [mass, friction] = [draw.between(0.5, 3.0), draw.between(2.0, 6.0)];
        let k = draw.between(20.0, 80.0);
        let w = (k / mass).sqrt();
        let belt = draw.between(0.1, 0.4) * friction * w / k;
        // a small decrease, so that the block sticks before it is faster than the belt
        let fall = draw.between(0.02, 0.15) * mass * w / friction;
        let grows = 0.5 * friction * fall / mass;
        let turns = (w * w - grows * grows).sqrt();
        let rest = friction * (1.0 - fall * belt) / k;
        let slipping = |t: f64| -> [f64; 2] {
            // from x = F/k with the speed of the belt
            let (a, b) = (friction / k - rest, (belt - grows * (friction / k - rest)) / turns);
            let (sin, cos) = (turns * t).sin_cos();
            let x = (grows * t).exp() * (a * cos + b * sin);
            let v = (grows * t).exp() * ((grows * a + turns * b) * cos + (grows * b - turns * a) * sin);
            [rest + x, v]
        };
        let slips = first_zero(|t| slipping(t)[1] - belt, 0.0, 1e-3 / w);
        let sticks = (friction / k - slipping(slips)[0]) / belt;
        assert!(sticks > 0.0 && sticks * belt < 2.0 * friction / k);
        let first = friction / (k * belt);
        // two cycles, and a part of the third slip phase
        let part = draw.between(0.2, 0.8) * slips;
        let span = first + 2.0 * (slips + sticks) + part;
        let force =
            format!("-({k} N/m)*x - ({friction} N)*(1 - ({fall} s/m)*abs(x' - ({belt} m/s)))*sign(x' - ({belt} m/s))");
        let start = format!("[start]\n\"x'\" = \"{belt} m/s\"\n[run]\nspan = \"{span} s\"\n");
        let text = on_a_line(&[("x", mass, &force)], &start);
        let [x, v] = slipping(part);
        ends_at(&text, &[("x", x), ("x'", v)], 1e4);
    }
}

/// Friction F (1 + c e^(-v/d)) with v = 20 d to 500 d at the start: w = e^(v/d) satisfies w' = -(F/m d)(w + c). Steps that do not resolve the
/// exponential would miss its effect.
#[test]
fn friction_that_rises_next_to_rest_is_seen_from_afar() {
    for number in 0..DRAWS / 4 {
        let mut draw = Draw::new(7, number);
        let [mass, friction, more] = [draw.between(0.5, 3.0), draw.between(1.0, 5.0), draw.between(0.2, 2.0)];
        let (speed, times) = (draw.between(0.3, 1.5), 10f64.powf(draw.between(1.3, 2.7)));
        let scale = speed / times;
        // it slides until w = 1
        let rest = mass / friction * (speed - scale * (1.0 + more).ln());
        let span = rest - draw.between(0.1, 2.0) * scale * mass / friction;
        let left = ((speed - friction / mass * span) / scale).exp() * (1.0 + more * (-times).exp()) - more;
        let force = format!("-({friction} N)*(1 + {more}*exp(-abs(x')/({scale} m/s)))*sign(x')");
        let run = |span: f64| {
            let start = format!("[start]\n\"x'\" = \"{speed} m/s\"\n[run]\nspan = \"{span} s\"\n");
            on_a_line(&[("x", mass, &force)], &start)
        };
        ends_at(&run(span), &[("x'", scale * left.ln())], 1e4);
        ends_at(&run(rest + 0.1), &[("x'", 0.0)], 1e3);
    }
}

/// Smooth friction F tanh(v/d): sinh(v/d) decays as e^(-F t/(m d)).
#[test]
fn smooth_friction_brings_a_fast_block_to_rest() {
    for number in 0..DRAWS / 4 {
        let mut draw = Draw::new(8, number);
        let [mass, friction] = [draw.between(0.5, 3.0), draw.between(1.0, 5.0)];
        let (speed, times) = (draw.between(0.3, 1.5), 10f64.powf(draw.between(1.5, 3.0)));
        let scale = speed / times;
        let after = draw.between(-1.0, 2.0);
        let span = (speed + after * scale) * mass / friction;
        let force = format!("-({friction} N)*tanh(x'/({scale} m/s))");
        let start = format!("[start]\n\"x'\" = \"{speed} m/s\"\n[run]\nspan = \"{span} s\"\n");
        let known = scale * (0.5 * (-after).exp()).asinh();
        ends_at(&on_a_line(&[("x", mass, &force)], &start), &[("x'", known)], 1e3);
    }
}

/// A block that friction holds from 0.3 s on, beside a mass whose spring force contains a root.
const HELD: &str = r#"
title = "A block that friction holds beside a mass on an oblique spring"
[coordinates]
x = "m"
y = "m"
[points]
P = "O + y*N.x"
[bodies]
block = { centre = "O + (1 m)*N.y + x*N.x", mass = "1 kg" }
bob = { centre = "P", mass = "1 kg" }
[[force]]
on = "block"
is = "((3 N)*sin((2 1/s)*t) - (50 N/m)*(x - (0.01 m)) - (5 N)*sign(x'))*N.x"
[[force]]
between = ["ground at O - (1 m)*N.y", "bob"]
is = "-(20 N/m)*(distance(O - (1 m)*N.y, P) - (0.5 m))"
[start]
x = "0.3 m"
"x'" = "0.5 m/s"
y = "0.3 m"
[run]
span = "10 s"
"#;

/// The rates of the resting block are rounding errors, and must not be taken for another branch of the root.
#[test]
fn taylor_goes_on_while_friction_holds_a_block() {
    let scene = ModelScene::parse("held.toml", HELD).unwrap_or_else(|error| panic!("{error}"));
    let problem = scene.problem(Axes::First);
    let end = |method: Method, tolerance: f64| {
        let run = problem.simulate(&Choice { method, tolerance, ..scene.run().choice() }, |_| ());
        assert_eq!(run.stopped(), None, "{method} {tolerance}");
        run.outcome.state
    };
    let known = end(Method::DormandPrince8, 1e-12);
    for tolerance in [1e-6, 1e-8, 1e-10, 1e-12] {
        let state = end(Method::Taylor, tolerance);
        let apart = state.iter().zip(&known).map(|(one, other)| (one - other).abs());
        assert!(apart.fold(0.0, f64::max) < 1e-9 + 1e2 * tolerance, "{tolerance}");
    }
}
