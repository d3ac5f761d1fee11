//! Findings on short papers.

mod admissible;
mod angle_bounds;
mod angles;
mod cases;
mod certificates;
mod constrained_rest;
mod constraints;
mod corrections;
mod divisors;
mod domains;
mod empty_corrections;
mod feedback;
mod functions;
mod growing_functions;
mod half_turn;
mod hidden_divisors;
mod hypotheses;
mod inequalities;
mod linearisation;
mod linkages;
mod lost_rates;
mod matrices;
mod messages;
mod numbers;
mod pendulum;
mod plain_corrections;
mod real_signs;
mod relations;
mod sensible_corrections;
mod shortfalls;
mod stability;
mod steady_motions;
mod unreadable;
mod vacuity;

use dalembert_manuscript::{Finding, PaperText};
use reader::SceneError;
use std::path::Path;

/// A pendulum with its letters; claims are added to this text.
pub const PENDULUM: &str = r#"
title = "A pendulum"
gravity = "-g*N.y"
[parameters]
m = "kg"
l = "m"
g = "m/s^2"
[coordinates]
theta = "rad"
[frames]
A = "N turned theta about z"
[points]
P = "O - l*A.y"
[bodies.bob]
centre = "P"
mass = "m"
[letters]
'm' = "m"
'l' = "l"
'g' = "g"
'\theta' = "theta"
'h' = "2*l"
'T' = "kinetic_energy"
'V' = "potential_energy"
'\mathbf{v}' = ["velocity(P) . N.x", "velocity(P) . N.y"]
"#;

/// The findings on the claims of a paper.
pub fn judged(text: &str) -> Result<Vec<Finding>, SceneError> {
    PaperText::parse(Path::new("paper.toml"), text.to_owned())?.judge()
}

/// The finding on one claim about the pendulum.
pub fn on_pendulum(kind: &str, formula: &str, more: &str) -> Finding {
    on(PENDULUM, kind, formula, more)
}

/// The finding on one claim about a system.
pub fn on(system: &str, kind: &str, formula: &str, more: &str) -> Finding {
    let text = format!("{system}\n[[claim]]\nequation = \"1\"\nkind = \"{kind}\"\nformula = '{formula}'\n{more}\n");
    let mut found = judged(&text).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(found.len(), 1);
    found.remove(0)
}

/// The name of a verdict.
pub fn verdict(finding: &Finding) -> &'static str {
    finding.judged.verdict.name()
}

/// All errors of a paper that cannot be read, as text.
pub fn refused(text: &str) -> String {
    match judged(text) {
        Ok(found) => panic!("{} claims were judged", found.len()),
        Err(error) => error.to_string(),
    }
}
