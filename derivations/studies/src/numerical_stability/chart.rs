//! Charts of all methods for all steady motions of a scene: the step sizes for which the one-step map preserves
//! stability or instability.

use super::methods::OneStep;
use super::motions::{AllStationed, NoMotions, Rotor, Stationed};
use crate::scene::Scene;
use algebra::real::Enclosure;
use mechanics::one_step_stability::{HalfPlane, Judgement, Mode, Spectrum, StepInterval, Steps};
use mechanics::steady_rotations::Kind;
use std::fmt::{self, Write};

/// The chart for one angular velocity.
pub struct Chart {
    pub all: AllStationed,
    /// The rows of the methods for each motion, in the order of the motions.
    pub rows: Vec<Vec<Row>>,
}

/// The intervals of step sizes of a method at a motion.
#[derive(Clone, Debug)]
pub struct Row {
    pub method: OneStep,
    /// `None` where thresholds cannot be separated.
    pub steps: Option<Steps>,
}

/// The rows of all methods for a motion with these modes.
pub fn rows(modes: &[Mode]) -> Vec<Row> {
    let row = |method: &OneStep| {
        let function = method.function();
        Row { method: *method, steps: function.and_then(|function| Steps::of(modes, &function).ok()) }
    };
    OneStep::ALL.iter().map(row).collect()
}

/// The linear stability of a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChartedMotion {
    /// Every eigenvalue, except those of the integrals, has a negative real part.
    Fades,
    /// No eigenvalue has a positive real part, and `staying` of them are imaginary.
    Stays { staying: usize },
    /// `growing` eigenvalues have a positive real part.
    Grows { growing: usize },
}

impl Chart {
    /// The chart of a scene with the angular velocity w (rad/s) about the vertical.
    ///
    /// # Errors
    /// [`NoMotions`] where the steady motions are not known.
    pub fn of(scene: &Scene, w: f64) -> Result<Self, NoMotions> {
        let all = AllStationed::of(scene, w)?;
        let rows = all
            .motions
            .iter()
            .map(|one| one.spectrum.as_ref().map_or_else(Vec::new, |spectrum| rows(&spectrum.modes)))
            .collect();
        Ok(Chart { all, rows })
    }

    /// The chart as text.
    pub fn text(&self) -> String {
        let mut out = String::new();
        for (place, (motion, rows)) in self.all.motions.iter().zip(&self.rows).enumerate() {
            // writing to a String cannot fail
            let _ = writeln!(out, "\n{} {}", place + 1, motion);
            let Some(spectrum) = &motion.spectrum else {
                out += "  not known: eigenvalues coincide, or a real part vanishes for no known reason\n";
                continue;
            };
            let _ = writeln!(out, "  the motion {}", ChartedMotion::of(spectrum));
            let _ = writeln!(out, "  eigenvalues, 1/s: {}", self.eigenvalues(spectrum));
            for row in rows {
                let _ = writeln!(out, "  {:<20} {}", row.method.to_string(), row.told());
            }
        }
        if self.all.families > 0 {
            let _ = writeln!(out, "\n{} families of motions without a verdict are left out", self.all.families);
        }
        out
    }

    /// All eigenvalues as text, beginning with those known from the structure.
    pub fn eigenvalues(&self, spectrum: &Spectrum) -> String {
        let linear = &self.all.linear;
        let mut each = Vec::new();
        if linear.integrals > 0 {
            each.push(format!("0 ({}, integrals)", linear.integrals));
        }
        for (rate, count) in &linear.idle {
            each.push(format!("-{rate} ({count}, windings that no motion feeds)"));
        }
        let solved = spectrum.modes.len() - linear.idle.len();
        each.extend(spectrum.modes[..solved].iter().map(eigenvalue));
        each.join(", ")
    }
}

impl Row {
    /// The intervals of step sizes with their verdicts, in one line.
    pub fn told(&self) -> String {
        let Some(steps) = &self.steps else { return "not known: thresholds lie too close together".to_owned() };
        let correct = match steps.correct() {
            Ok(None) => "correct at every step".to_owned(),
            Ok(Some(most)) => format!("correct up to h = {}", digits(most)),
            Err(_) => "never correct".to_owned(),
        };
        let stretches: Vec<_> = steps.all().collect();
        let runs = stretches.chunk_by(|a, b| a.2.judgement == b.2.judgement);
        let wrong = runs.filter(|run| run[0].2.judgement != Judgement::Correct);
        let each: Vec<String> =
            wrong.map(|run| format!("{} {}", said(run[0].2), range(run[0].0, run[run.len() - 1].1))).collect();
        if each.is_empty() { correct } else { format!("{correct}; {}", each.join("; ")) }
    }

    /// The thresholds of step sizes at which the map becomes unstable or stable: those that runs can measure.
    pub fn edges(&self) -> Vec<&Enclosure> {
        let Some(steps) = &self.steps else { return Vec::new() };
        let turns = steps.stretches.windows(2).map(|pair| (pair[0].growing == 0) != (pair[1].growing == 0));
        steps.cuts.iter().zip(turns).filter_map(|(cut, turns)| turns.then_some(cut)).collect()
    }
}

/// The word of a chart for a verdict.
pub fn said(stretch: StepInterval) -> &'static str {
    match stretch.judgement {
        Judgement::Correct => "correct",
        Judgement::Hides => "decays although the motion grows",
        Judgement::Invents => "grows although the motion does not",
        Judgement::Damps => "damps an undamped mode",
        Judgement::Confuses => "wrong in some mode",
    }
}

/// An interval of step sizes as text, such as `0.5 < h < 2`.
fn range(from: Option<&Enclosure>, to: Option<&Enclosure>) -> String {
    match (from, to) {
        (None, None) => "at every step".to_owned(),
        (Some(from), None) => format!("for h > {}", digits(from)),
        (None, Some(to)) => format!("for h < {}", digits(to)),
        (Some(from), Some(to)) => format!("for {} < h < {}", digits(from), digits(to)),
    }
}

fn eigenvalue(mode: &Mode) -> String {
    match &mode.place {
        HalfPlane::Real(mu) => digits(mu),
        HalfPlane::Imaginary(b) => format!("\u{b1}{}i", digits(b)),
        HalfPlane::Pair(mu) => format!("{} \u{b1} {}i", digits(&mu.re), digits(&mu.im)),
    }
}

/// The largest number of digits of a printed enclosure.
const DIGITS: usize = 10;

/// The number rounded to ten digits, fewer where its enclosure does not determine them.
pub fn digits(value: &Enclosure) -> String {
    let [low, high] = value.ends();
    let written = |x: f64, digits: usize| format!("{x:.*e}", digits - 1);
    let shared = (1..=DIGITS).rev().map(|digits| (written(low, digits), written(high, digits)));
    let text = shared.into_iter().find_map(|(low, high)| (low == high).then_some(low));
    // parsing and printing give the shortest decimal of the float
    text.and_then(|text| text.parse::<f64>().ok()).map_or_else(|| format!("{low:e} to {high:e}"), plain)
}

/// The number without an exponent where that is short.
fn plain(value: f64) -> String {
    match value.abs() {
        size if size == 0.0 || (1e-4..1e7).contains(&size) => format!("{value}"),
        _ => format!("{value:e}"),
    }
}

impl ChartedMotion {
    /// The linear stability by the eigenvalues.
    pub fn of(spectrum: &Spectrum) -> Self {
        match spectrum.growing() {
            [0, 0] => ChartedMotion::Fades,
            [0, staying] => ChartedMotion::Stays { staying },
            [growing, _] => ChartedMotion::Grows { growing },
        }
    }
}

impl fmt::Display for ChartedMotion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ChartedMotion::Fades => write!(f, "is asymptotically stable, with its integrals held"),
            ChartedMotion::Stays { staying } => write!(
                f,
                "is a centre in the first approximation: {staying} imaginary eigenvalues, no positive real part"
            ),
            ChartedMotion::Grows { growing } => write!(
                f,
                "is unstable: {growing} eigenvalue{} with a positive real part",
                if *growing == 1 { "" } else { "s" }
            ),
        }
    }
}

impl fmt::Display for Stationed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kind = match self.kind {
            Some(Kind::Minimum) => "W least, ",
            Some(Kind::Saddle) => "W a saddle, ",
            Some(Kind::Maximum) => "W greatest, ",
            Some(Kind::Degenerate) => "merging, ",
            None => "",
        };
        write!(f, "{kind}")?;
        if let Some(v) = self.member {
            write!(f, "one of a family, v = ({:.6}, {:.6}, {:.6}), ", v.x, v.y, v.z)?;
        }
        match &self.rotor {
            Rotor::InStep { angle, held } => {
                let held = if *held { "the field drives back to it" } else { "the field drives away from it" };
                write!(f, "rotor in step at {angle:.6} rad, {held}")
            }
            Rotor::At { speed } => write!(f, "rotor at {speed:.6} rad/s"),
        }
    }
}
