//! More frictional contacts than speeds: the motion is unique, but the distribution of friction among the contacts is not.

use super::draws::{Draw, ends_at, on_a_line};
use std::fmt::Write;

/// Number of random systems, each run by four methods at three tolerances.
const FEW: u64 = 12;

/// A rope connects two blocks with the friction limits a and b, and a force r t pulls one; both stick until r t = a + b. Before, the fractions
/// s, u with a s + b u = r t are not unique; least squares give s = r t a/(a^2 + b^2) and u = r t b/(a^2 + b^2), while both are
/// below 1.
#[test]
fn blocks_on_a_rope_share_their_friction_and_break_away_together() {
    for number in 0..FEW {
        let mut draw = Draw::new(21, number);
        let [a, b, rate] = draw.array(1.0, 6.0);
        let [m, n] = draw.array(0.5, 3.0);
        let text = |span: f64| {
            on_a_line(
                &[("x", m, &format!("-({a} N)*sign(x')")), ("y", n, &format!("-({b} N)*sign(y') + ({rate} N/s)*t"))],
                &format!(
                    "[[constraint]]\nname = \"rope\"\nzero = \"y - x - (1 m)\"\n[outputs]\ns = \"sign(x')\"\nu = \"sign(y')\"\n\
                     pull = \"reaction(rope)\"\n[start]\ny = \"1 m\"\n[run]\nspan = \"{span} s\"\n"
                ),
            )
        };
        let (squares, breaks) = (a * a + b * b, (a + b) / rate);
        let full = squares / a.max(b) / rate;
        let early = draw.between(0.2, 0.9) * full;
        let [s, u] = [a, b].map(|own| rate * early * own / squares);
        ends_at(&text(early), &[("x", 0.0), ("y", 1.0), ("s", s), ("u", u)], 10.0);
        // the stronger contact is at its limit, the other one carries the rest
        let late = full + draw.between(0.2, 0.9) * (breaks - full);
        let rest = (rate * late - a.max(b)) / a.min(b);
        let [s, u] = if a > b { [1.0, rest] } else { [rest, 1.0] };
        ends_at(&text(late), &[("x", 0.0), ("y", 1.0), ("s", s), ("u", u)], 10.0);
        let span = breaks + draw.between(0.5, 2.0);
        let moved = rate * (span - breaks).powi(3) / (6.0 * (m + n));
        ends_at(&text(span), &[("x", moved), ("y", 1.0 + moved), ("s", 1.0), ("u", 1.0)], 10.0);
    }
}

/// Five blocks in a row, each in contact with the ground and the next: nine contacts and five speeds. A force r t moves the first block alone when
/// it exceeds the friction of its two contacts.
#[test]
fn the_first_block_of_a_row_breaks_away_alone() {
    let names = ["a", "b", "c", "d", "e"];
    for number in 0..FEW {
        let mut draw = Draw::new(22, number);
        let [ground, rate, mass] = [draw.between(2.0, 6.0), draw.between(1.0, 5.0), draw.between(0.5, 3.0)];
        let between = draw.between(0.3, 0.9) * ground;
        let forces: Vec<String> = (0..names.len())
            .map(|own| {
                let mut force = format!("-({ground} N)*sign({}')", names[own]);
                for other in [own.wrapping_sub(1), own + 1].into_iter().filter_map(|place| names.get(place)) {
                    write!(force, " - ({between} N)*sign({}' - {other}')", names[own]).unwrap();
                }
                if own == 0 { force + &format!(" + ({rate} N/s)*t") } else { force }
            })
            .collect();
        let bodies: Vec<(&str, f64, &str)> =
            names.iter().zip(&forces).map(|(name, force)| (*name, mass, force.as_str())).collect();
        let breaks = (ground + between) / rate;
        let span = breaks + draw.between(0.5, 2.0);
        let moved = rate * (span - breaks).powi(3) / (6.0 * mass);
        let text = on_a_line(&bodies, &format!("[run]\nspan = \"{span} s\"\n"));
        ends_at(&text, &[("a", moved), ("b", 0.0), ("c", 0.0), ("d", 0.0), ("e", 0.0)], 10.0);
    }
}

/// Each of four blocks touches every other and the ground with equal friction: ten contacts. A force below friction moves no block, and the
/// contacts between the other blocks carry nothing.
#[test]
fn blocks_that_all_touch_each_other_rest() {
    let names = ["a", "b", "c", "d"];
    let forces: Vec<String> = names
        .iter()
        .map(|own| {
            let pairs = names.iter().filter(|other| *other != own);
            let pairs: String = pairs.map(|other| format!(" - (2 N)*sign({own}' - {other}')")).collect();
            format!("-(2 N)*sign({own}'){pairs}") + if *own == "a" { " + (1 N)*sin((3 rad/s)*t)" } else { "" }
        })
        .collect();
    let bodies: Vec<(&str, f64, &str)> =
        names.iter().zip(&forces).map(|(name, force)| (*name, 1.0, force.as_str())).collect();
    let rest =
        "[outputs]\nidle = \"sign(b' - c')\"\nown = \"sign(a')\"\nother = \"sign(a' - d')\"\n[run]\nspan = \"1 s\"\n";
    // least squares: f = 2 own + 3 (2 other), and for each other block 2 other = 2 ground
    let force = 3f64.sin();
    let [own, other] = [force / 5.0, force / 10.0];
    let known = [("a", 0.0), ("d", 0.0), ("idle", 0.0), ("own", own), ("other", other)];
    ends_at(&on_a_line(&bodies, rest), &known, 10.0);
}

/// An event sets a block to rest at a wall; friction holds the block there, and the event occurs once.
#[test]
fn a_block_that_an_event_sets_to_rest_sticks_there() {
    for number in 0..FEW {
        let mut draw = Draw::new(23, number);
        let [friction, speed, k] = [draw.between(2.0, 5.0), draw.between(1.0, 2.0), draw.between(20.0, 40.0)];
        let wall = draw.between(0.02, 0.09);
        let event = format!("[[event]]\nwhen = \"x - ({wall} m)\"\ndirection = \"up\"\nset = {{ \"x'\" = \"0\" }}\n");
        let start = format!("[start]\n\"x'\" = \"{speed} m/s\"\ny = \"0.2 m\"\n[run]\nspan = \"2 s\"\n");
        // because of a second body, the events of the first one fall within steps
        let bodies = [("x", 1.0, &*format!("-({friction} N)*sign(x')")), ("y", 1.0, &*format!("-({k} N/m)*y"))];
        let y = 0.2 * (2.0 * k.sqrt()).cos();
        ends_at(&on_a_line(&bodies, &(event + &start)), &[("x", wall), ("x'", 0.0), ("y", y)], 1e3);
    }
}

/// A force F + r t^2 on a block with the friction F: the speed grows as t^3, at first below rounding errors.
#[test]
fn a_block_leaves_rest_slower_than_rounding() {
    for number in 0..FEW {
        let mut draw = Draw::new(24, number);
        let [friction, rate, mass] = draw.array(0.5, 6.0);
        let force = format!("-({friction} N)*sign(x') + ({friction} N) + ({rate} N/s^2)*t^2");
        let text = on_a_line(&[("x", mass, &force)], "[run]\nspan = \"1.5 s\"\n");
        ends_at(
            &text,
            &[("x", rate * 1.5f64.powi(4) / (12.0 * mass)), ("x'", rate * 1.5f64.powi(3) / (3.0 * mass))],
            10.0,
        );
    }
}
