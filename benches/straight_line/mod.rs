//! The gyrostat's right-hand side as straight-line C code, exported from the recorded law and written by hand. It is
//! compiled by `gcc -O3`, if available, for any processor of this architecture or for this processor (`-march=native`).

use dalembert_derivations::machines::multi_current::Windings;
use dalembert_derivations::systems::gyrostat::Gyrostat;
use std::fmt::Write;
use std::process::Command;
use symbolic::{Language, Tape};

/// Nanoseconds per call.
pub struct InC {
    pub exported: f64,
    pub by_hand: f64,
    pub jacobian: f64,
}

/// The times of the second form in C; `native`: compiled for this processor. `None` without a compiler, or if the two
/// codes disagree.
pub fn in_c(
    native: bool,
    n: usize,
    gyrostat: &Gyrostat<f64>,
    windings: &Windings<f64>,
    value: &Tape,
    jacobian: &Tape,
) -> Option<InC> {
    let (moments, axis, axial, weight) = gyrostat.form_data(&gyrostat.derived().full);
    let mut text = String::from(
        "#define _GNU_SOURCE\n#include <math.h>\n#include <stdio.h>\n#include <stdlib.h>\n#include <time.h>\n",
    );
    for (name, number) in [("N", n), ("REPEATS", super::REPEATS), ("CALLS", super::CALLS as usize)] {
        writeln!(text, "#define {name} {number}").ok()?;
    }
    for (name, vector) in [("A", moments), ("AXIS", axis), ("GE", weight)] {
        writeln!(text, "static const double {name}[3] = {{{:?}, {:?}, {:?}}};", vector[0], vector[1], vector[2])
            .ok()?;
    }
    let Windings { field_speed, b0, a1, l1, r1, a2, l2, r2, mu, f } = *windings;
    let mu = if n > 8 { mu } else { 0.0 };
    let numbers = [("A1", a1), ("L1", l1), ("R1", r1), ("A2", a2), ("L2", l2), ("R2", r2), ("MU", mu), ("F", f)];
    for (name, number) in numbers.into_iter().chain([("AXIAL", axial), ("B0", b0), ("FIELD_SPEED", field_speed)]) {
        writeln!(text, "#define {name} {number:?}").ok()?;
    }
    let noinline = "__attribute__((noinline)) ";
    write!(text, "{noinline}{}", value.source(Language::C, "value")).ok()?;
    write!(text, "{noinline}{}", jacobian.source(Language::C, "jacobian")).ok()?;
    text += include_str!("by_hand.c");
    text += include_str!("timing.c");
    let folder = std::env::temp_dir().join(format!("gyrostat_in_c_{}_{n}", std::process::id()));
    std::fs::create_dir_all(&folder).ok()?;
    let (source, program) = (folder.join("law.c"), folder.join("law"));
    std::fs::write(&source, text).ok()?;
    let flags = ["-O3", "-march=native"];
    let flags = if native { &flags[..] } else { &flags[..1] };
    let made = Command::new("gcc").args(flags).arg(&source).arg("-o").arg(&program).arg("-lm").status();
    let output = made.is_ok_and(|status| status.success()).then(|| Command::new(&program).output());
    std::fs::remove_dir_all(&folder).ok()?;
    let text = String::from_utf8(output?.ok()?.stdout).ok()?;
    let numbers: Vec<f64> = text.split_whitespace().filter_map(|word| word.parse().ok()).collect();
    let [exported, by_hand, jacobian, off] = numbers[..] else { return None };
    (off < 1e-12).then_some(InC { exported, by_hand, jacobian })
}
