//! A regulator as text and as JSON.

use super::{columns, stopped};
use crate::summary::{passed, told_passages};
use ::scenes::ModelScene;
use ::scenes::regulator::{ClosedRun, Controllability, Regulated, States};
use model::Regulator;
use nalgebra::{Complex, DMatrix};
use serde_json::{Value, json};
use simulation::events::Passage;
use std::fmt::Write;

/// A regulator with the names of its states and inputs.
pub(super) struct Told<'a> {
    scene: &'a ModelScene,
    found: &'a Regulated,
    names: Vec<String>,
    chosen: Vec<String>,
    units: Vec<String>,
}

impl<'a> Told<'a> {
    pub(super) fn of(scene: &'a ModelScene, found: &'a Regulated) -> Self {
        let (mut names, units): (Vec<String>, Vec<String>) = columns(scene).into_iter().unzip();
        let inputs = scene.model.regulator.as_ref().map_or(0, |regulator| regulator.inputs.len());
        let chosen = names.split_off(names.len() - inputs);
        Told { scene, found, names, chosen, units }
    }

    /// The name of the variation with this index.
    fn variation(&self, place: usize) -> &str {
        &self.names[self.found.places[place]]
    }

    /// The names of the states. A state is a variation plus multiples of the variations that are left out, for example `x - 2 theta`.
    fn states(&self) -> Vec<String> {
        let States { by_variations, kept, left_out } = &self.found.states;
        let named = |(row, &place): (usize, &usize)| {
            let parts = left_out.iter().map(|&other| (self.variation(other), by_variations[(row, other)]));
            parts.filter(|(_, factor)| *factor != 0.0).fold(
                self.variation(place).to_owned(),
                |name, (other, factor)| {
                    let (sign, size) = (if factor < 0.0 { '-' } else { '+' }, factor.abs());
                    match (size - 1.0).abs() < 1e-12 {
                        true => format!("{name} {sign} {other}"),
                        false => format!("{name} {sign} {size:.6} {other}"),
                    }
                },
            )
        };
        kept.iter().enumerate().map(named).collect()
    }

    /// A sentence on each variation that is not a state, with the reason.
    fn left_out(&self) -> Vec<String> {
        let States { by_variations, left_out, .. } = &self.found.states;
        let states = self.states();
        let told = |&place: &usize| {
            let column = by_variations.column(place);
            let with: Vec<&str> = states
                .iter()
                .zip(&column)
                .filter(|(_, factor)| **factor != 0.0)
                .map(|(name, _)| name.as_str())
                .collect();
            let name = self.variation(place);
            match with.is_empty() {
                true => format!("{name} is left out: neither the linear equations nor the cost depend on it"),
                false => format!("{name} is left out: the equations and the cost depend on {} only", with.join(", ")),
            }
        };
        left_out.iter().map(told).collect()
    }

    /// The cost of the run up to its end, plus the predicted cost of the remaining deviation.
    fn cost(&self) -> f64 {
        self.found.run.costs.last().copied().unwrap_or(0.0) + self.found.left
    }

    pub(super) fn text(&self) -> String {
        let Regulated { controllability, gains, value, residual, open, closed, predicted, left, run, .. } = self.found;
        let horizon = self.scene.model.regulator.as_ref().and_then(|Regulator { horizon, .. }| *horizon);
        let states = self.states();
        let mut text = format!("{}\n\n", self.scene.title);
        let mut line = |name: &str, value: String| {
            let _ = writeln!(text, "{name:<21}{value}");
        };
        line("states", states.join(", "));
        self.left_out().into_iter().for_each(|told| line("", told));
        line("inputs", self.chosen.join(", "));
        match horizon {
            None => line("criterion", "the integral of the cost without an end".to_owned()),
            Some(horizon) => line("criterion", format!("the integral of the cost up to t = {horizon} s")),
        }
        line("controllability", said(controllability));
        line(if horizon.is_some() { "eigenvalues at t = 0" } else { "eigenvalues" }, eigenvalues(open));
        if let Some(closed) = closed {
            line("of the closed loop", eigenvalues(closed));
        }
        let _ = writeln!(text, "gains K, u = u0 - K (x - x0){}", if horizon.is_some() { ", at the start" } else { "" });
        table(&mut text, &self.chosen, &states, gains);
        let _ = writeln!(text, "P of the least cost x^T P x{}", if horizon.is_some() { ", at the start" } else { "" });
        table(&mut text, &states, &states, value);
        let mut line = |name: &str, value: String| {
            let _ = writeln!(text, "{name:<21}{value}");
        };
        match horizon {
            None => line("Bellman's equation", format!("holds to {residual:.0e} of its largest part")),
            Some(_) => line(
                "Riccati's equation",
                format!("P changes by {residual:.0e} of its largest entry with half the steps"),
            ),
        }
        line("cost by Riccati", number(*predicted));
        let rest = match horizon {
            _ if *left == 0.0 => String::new(),
            None => format!(", {left:.1e} of it after t = {} s", run.outcome.time),
            Some(_) => format!(", {left:.1e} of it the cost of the end"),
        };
        line("cost of the run", number(self.cost()) + &rest);
        told_passages(&run.passages).iter().for_each(|told| line("event", told.line()));
        let ended = run.passages.last().filter(|passage| passage.then.is_none());
        match (stopped(run), ended) {
            (Some(why), _) => line("stopped", why),
            (None, None) => line("reached", format!("t = {} s", run.outcome.time)),
            (None, Some(Passage { what, .. })) => {
                line("reached", format!("t = {} s: {what} ends the run", run.outcome.time));
            }
        }
        let last = run.states.last().into_iter().flatten();
        for (name, value) in self.names.iter().zip(last) {
            let _ = writeln!(text, "  {name:<19}{value:.9}");
        }
        text
    }

    pub(super) fn object(&self) -> Value {
        let Regulated { controllability, gains, value, residual, open, closed, predicted, run, .. } = self.found;
        let rows = |matrix: &DMatrix<f64>| -> Vec<Vec<f64>> {
            matrix.row_iter().map(|row| row.iter().copied().collect()).collect()
        };
        let pairs = |values: &[Complex<f64>]| values.iter().map(|value| [value.re, value.im]).collect::<Vec<_>>();
        let ClosedRun { times, states, inputs, costs, .. } = run;
        json!({
            "states": self.states(),
            "left_out": self.found.states.left_out.iter().map(|&place| self.variation(place)).collect::<Vec<_>>(),
            "inputs": self.chosen,
            "controllable": is_whole(controllability),
            "controllability": said(controllability),
            "eigenvalues": pairs(open),
            "eigenvalues_closed": closed.as_deref().map(pairs),
            "gains": rows(gains),
            "riccati": rows(value),
            "residual": residual,
            "cost_by_riccati": predicted,
            "cost_of_run": self.cost(),
            "reached": stopped(run).is_none(),
            "events": run.passages.iter().map(passed).collect::<Vec<_>>(),
            "stopped": stopped(run),
            "columns": self.names,
            "units": self.units,
            "run": { "times": times, "states": states, "inputs": inputs, "costs": costs },
        })
    }
}

/// A number with nine decimals, or in scientific notation with nine digits.
fn number(value: f64) -> String {
    if value == 0.0 || (1e-3..1e6).contains(&value.abs()) { format!("{value:.9}") } else { format!("{value:.8e}") }
}

fn is_whole(controllability: &Controllability) -> bool {
    match controllability {
        Controllability::Modes(modes) => modes.is_empty(),
        Controllability::Directions { rank, of } => rank == of,
    }
}

fn said(controllability: &Controllability) -> String {
    match controllability {
        Controllability::Modes(modes) if modes.is_empty() => "every variation can be reached by the inputs".to_owned(),
        Controllability::Modes(modes) => {
            format!("no input reaches the eigenvalues {}, which die away", eigenvalues(modes))
        }
        Controllability::Directions { rank, of } if rank == of => {
            format!("every variation can be reached within the horizon: the Gramian has the rank {rank}")
        }
        Controllability::Directions { rank, of } => {
            format!(
                "within the horizon the inputs reach {rank} of {of} independent variations: the rank of the Gramian"
            )
        }
    }
}

fn eigenvalues(values: &[Complex<f64>]) -> String {
    let shown = |value: &Complex<f64>| match value.im {
        0.0 => format!("{:.6}", value.re),
        im => format!("{:.6} {} {:.6} i", value.re, if im < 0.0 { "-" } else { "+" }, im.abs()),
    };
    values.iter().map(shown).collect::<Vec<_>>().join(", ")
}

fn table(text: &mut String, rows: &[String], columns: &[String], matrix: &DMatrix<f64>) {
    let wide = rows.iter().map(|name| name.chars().count()).max().unwrap_or(0);
    let heading: String = columns.iter().map(|name| format!(" {name:>16}")).collect();
    let _ = writeln!(text, "  {:wide$}{heading}", "");
    for (name, row) in rows.iter().zip(matrix.row_iter()) {
        let entries: String = row.iter().map(|value| format!(" {value:>16.9}")).collect();
        let _ = writeln!(text, "  {name:wide$}{entries}");
    }
}
