//! Steady motions of a gyrostat as text.

use super::{Given, motor, why};
use crate::stability;
use mechanics::steady_rotations::{Census, Kind, Shape, Undecided};
use std::fmt::Write;
use studies::scene::Scene;
use studies::stationary::energies::Kept;
use studies::stationary::motions::{Answer, Certificate, Found, Stationary};

pub(super) fn all(scene: &Scene, all: &Stationary<'_>, given: Given, answers: &[Answer]) -> String {
    let mut out = format!("{}\n{}", scene.title, motor::text(&all.motor));
    // writing to a String cannot fail
    let _ = match given {
        Given::Speed(w) => writeln!(out, "angular velocity about the vertical: {w} rad/s"),
        Given::Momentum(p) => writeln!(out, "angular momentum about the vertical: {p} N m s"),
    };
    for answer in answers {
        let _ = writeln!(out, "\n{}: {}", kept(all.kept, answer.value), certificate(answer));
        if !answer.found.is_empty() {
            let head = ["v1", "v2", "v3", "w0, rad/s", "phi', rad/s", "x.v, N m s", "residual"];
            let head = head.map(|name| format!("{name:>13}")).concat();
            let _ = writeln!(out, "  W           {head}");
        }
        for (place, found) in answer.found.iter().enumerate() {
            out += &line(place + 1, found);
            out += &match &found.family {
                Some(members) => stability::along(&all.motor, &members.along),
                None => stability::text(&all.motor, &found.stability),
            };
        }
    }
    out
}

fn line(place: usize, found: &Found) -> String {
    let numbers = [
        found.enclosed[0].to_f64(),
        found.enclosed[1].to_f64(),
        found.enclosed[2].to_f64(),
        found.speed,
        found.rotor_speed,
        found.momentum,
    ];
    // a value that prints as zero is printed without a sign
    let numbers = numbers.map(|x| format!("{:>13.8}", if x.abs() < 5e-9 { 0.0 } else { x })).concat();
    let mut out = format!("  {place} {:<10}{numbers}{:>13.1e}\n", kind(found.kind), found.residual);
    if let Some([low, high]) = found.multiplier {
        let _ = writeln!(out, "    lambda alone in [{low:.6e}, {high:.6e}] N m");
    }
    let circle = found.family.as_ref().and_then(|members| members.circle);
    let family = match (found.shape, circle) {
        (Shape::Circle { .. }, Some((radius, axis))) => format!(
            "a family: the circle of radius {radius:.8} about the axis ({:.8}, {:.8}, {:.8}), its centre is given",
            axis.x, axis.y, axis.z
        ),
        (Shape::Sphere, _) => "a family: every direction".to_owned(),
        (Shape::Pair { .. }, _) => "one of two on both sides of a principal plane".to_owned(),
        _ => return out,
    };
    let _ = writeln!(out, "    {family}");
    out
}

/// The certificate that no motion is missing, such as `6 of 6; none missing: ...`.
fn certificate(answer: &Answer) -> String {
    let Certificate { degree, roots, again, morse, undecided } = &answer.certificate;
    let families = answer.found.iter().filter(|one| matches!(one.shape, Shape::Circle { .. } | Shape::Sphere)).count();
    let isolated = answer.found.len() - families;
    let number = |n: usize, name: &str| format!("{n} {name}{}", if n == 1 { "" } else { "s" });
    let mut out = number(isolated, "motion");
    if families > 0 {
        let _ = write!(
            out,
            " and {} of motions",
            if families == 1 { "a family".to_owned() } else { format!("{families} families") }
        );
    }
    if !answer.certificate.is_complete() {
        let reason = undecided.map_or("two counts of roots differ", why);
        let _ = write!(out, "; that none is missing is NOT proved: {reason}");
        return out;
    }
    let _ = write!(out, "; none missing: {} of a polynomial of degree {degree}, isolated", number(*roots, "real root"));
    if again.is_some() {
        out += " by Descartes' rule and counted again by Sturm's theorem";
    }
    let beyond = answer.found.iter().filter(|one| !matches!(one.shape, Shape::Point)).count();
    if beyond > 0 {
        let _ = write!(
            out,
            ", and {beyond} at eigenvalues whose directions are orthogonal to the weight and to the axis of the rotor"
        );
    }
    match morse {
        Some(sum) => {
            let _ = write!(out, "; minima - saddles + maxima = {sum}");
        }
        None if again.is_some() => out += "; two motions merge here",
        None => {}
    }
    out
}

pub(super) fn counts(all: &Stationary<'_>, census: &[Result<Census, Undecided>]) -> String {
    let mut out = String::new();
    for (case, census) in all.cases.iter().zip(census) {
        let _ =
            writeln!(out, "\n{}: the number of stationary motions for every w0", kept(all.kept, case.value.to_f64()));
        match census {
            Ok(census) => {
                for stretch in &census.stretches {
                    let families = if stretch.families > 0 {
                        format!(" and {} families", stretch.families)
                    } else {
                        String::new()
                    };
                    let _ = writeln!(
                        out,
                        "  {:>16.9} < w0 < {:<16.9} {}{families}",
                        stretch.from, stretch.to, stretch.isolated
                    );
                }
                out += "  none missing: every angular velocity at which two motions merge is a common root of two polynomials, isolated;\n  \
                        between two of them, and zero, the number is constant and was counted once, exactly\n";
            }
            Err(reason) => {
                let _ = writeln!(out, "  not known: {}", why(*reason));
            }
        }
    }
    out
}

fn kept(kept: Kept, value: f64) -> String {
    match kept {
        Kept::RelativeSpeed => format!("rotor at {value} rad/s"),
        Kept::Momentum => format!("rotor with the momentum {value} N m s, which it keeps"),
    }
}

pub(super) fn kind(kind: Kind) -> &'static str {
    match kind {
        Kind::Minimum => "minimum",
        Kind::Saddle => "saddle",
        Kind::Maximum => "maximum",
        Kind::Degenerate => "merging",
    }
}
