//! The receipt of a choice, as text and as JSON.

use super::command::typed;
use serde_json::{Value, json};
use simulation::methods;
use std::fmt::Write;
use studies::model_reduction::forms::SWITCHING;
use studies::model_reduction::sampled_run::{INSTANTS, LOOKS};
use studies::model_reduction::switching::INTERVALS;
use studies::model_reduction::{Line, Loss, Receipt, Sufficiency};

/// The receipt as text.
pub fn text(title: &str, (receipt, origin): (&Receipt, &str), command: Option<&[String]>) -> String {
    let mut out =
        format!("{title}\n\nto {:.0e} in {} ({origin})\n\n", receipt.tolerance, receipt.watched.names.join(", "));
    let head = ["model", "states", "estimate", "small", "evaluations", "time", "promised", "measured"];
    let longest = receipt.lines.iter().filter(|line| !hopeless(line)).map(|line| line.name.chars().count()).max();
    let widths = [longest.unwrap_or(0).max(30) + 5, 8, 11, 11, 13, 8, 11, 10];
    let row = |cells: [String; 8]| {
        let cells = cells.iter().zip(widths).map(|(cell, width)| format!("{cell:<width$}"));
        format!("{}\n", cells.collect::<String>().trim_end())
    };
    out += &row(head.map(str::to_owned));
    let unit = receipt.lines.first().and_then(|line| line.choice.as_ref()?.seconds);
    for (at, line) in receipt.lines.iter().enumerate().filter(|(_, line)| !hopeless(line)) {
        let choice = line.choice.as_ref();
        let mark = if receipt.taken == Some(at) { " <-" } else { "" };
        let model = line.model.as_ref().ok();
        let exact = !matches!(line.loss, Loss::Small { .. });
        out += &row([
            format!("{}{mark}", line.name),
            line.states.to_string(),
            if exact { "exact".to_owned() } else { told(model.map(|model| model.first)) },
            told(model.and_then(|model| model.small)),
            choice.map_or_else(|| said(line), |choice| choice.work.evaluations.to_string()),
            choice.and_then(|choice| Some(format!("{:.2}", choice.seconds? / unit?))).unwrap_or_default(),
            choice.map_or_else(String::new, |choice| format!("{:.1e}", choice.promised)),
            choice.and_then(|choice| choice.measured).map_or_else(String::new, |error| format!("{error:.1e}")),
        ]);
    }
    let far: Vec<String> = receipt.lines.iter().filter(|line| hopeless(line)).map(beyond).collect();
    // writing to a String cannot fail
    if !far.is_empty() {
        let _ = writeln!(
            out,
            "\nthese change the outputs by more than is allowed (estimates in brackets): {}",
            far.join(" | ")
        );
    }
    let told = receipt.lines.iter().skip(1).filter(|line| !hopeless(line)).collect::<Vec<_>>();
    if !told.is_empty() {
        let _ = writeln!(out, "\nterms that each model drops, and the reason");
    }
    for line in told {
        let why = match line.loss {
            Loss::Own => String::new(),
            Loss::Nothing { claim: Some(claim) } => format!("exact, proved for these data; for all: {claim}"),
            Loss::Nothing { claim: None } => "exact: the laws do not differ, which is decided".to_owned(),
            Loss::Small { parameter } => format!("small: {parameter}"),
        };
        let why_not = line.model.as_ref().err().filter(|_| line.verdict == Sufficiency::NotCarried);
        let not = why_not.map_or_else(String::new, |why| format!("; {why}"));
        let largest = line.model.as_ref().ok().filter(|model| model.first > 0.0 && line.name != SWITCHING);
        let largest = largest.map_or_else(String::new, |model| format!("; its error is largest at {:.4e} s", model.at));
        let unasked = if line.asked_as.is_none() { "; `dalembert run` has no option for it" } else { "" };
        let _ = writeln!(out, "  {}: {} ({why}){largest}{not}{unasked}", line.name, line.dropped);
    }
    if let (Some(at), Some(command)) = (receipt.taken, command) {
        let _ = writeln!(out, "\ntaken: {}\nrun it: {}", receipt.lines[at].name, typed(command));
        if let Some(saved) = receipt.saved(at).filter(|_| at > 0) {
            let _ = writeln!(
                out,
                "saved: the scene's own model by its best method takes {saved:.2} times as many evaluations"
            );
        }
        if let Some((cheapest, saved)) =
            receipt.cheapest().filter(|cheapest| *cheapest != at).and_then(|line| Some((line, receipt.saved(line)?)))
        {
            let _ = writeln!(
                out,
                "not chosen, since `dalembert run` has no option for it: {}; the scene's own model takes {saved:.2} times as many evaluations",
                receipt.lines[cheapest].name
            );
        }
    } else {
        let _ = writeln!(out, "\nno model for which `dalembert run` has an option meets the tolerance");
    }
    let _ = writeln!(out, "{}\n{}", decided(receipt), promise(receipt));
    out
}

/// A sentence on the error estimates: their kind, and the instants at which errors are compared.
fn promise(receipt: &Receipt) -> String {
    let mut text = format!(
        "promised: the largest error of the whole run: of a method the difference from a finer run, of a smaller model the difference from \
         the run of the scene's own model; taken at steps and at {LOOKS} equidistant instants, and doubled for the instants between (times \
         five for implicit methods); not a bound"
    );
    if receipt.lines.iter().any(|line| line.model.as_ref().is_ok_and(|model| model.first > 0.0)) {
        text += "\nestimate: to first order, by the defect of the smaller model along a coarse run";
    }
    if receipt.lines.iter().any(|line| line.name == SWITCHING) {
        text += &format!("\nswitching: promised only at the ends of {INTERVALS} intervals");
    }
    if receipt.lines.iter().any(|line| line.choice.as_ref().is_some_and(|choice| choice.measured.is_some())) {
        text += &format!("\nmeasured: only at the {INSTANTS} instants of the reference");
    }
    text
}

/// Whether a model runs but does not meet the tolerance. One sentence names all such models.
fn hopeless(line: &Line) -> bool {
    line.verdict == Sufficiency::TooFar && line.asked_as.is_some()
}

/// The name of a model that does not meet the tolerance, with its estimated error if there is one.
fn beyond(line: &Line) -> String {
    let error = line.model.as_ref().ok().filter(|model| model.first > 0.0);
    error.map_or_else(|| line.name.clone(), |model| format!("{} ({:.0e})", line.name, model.first))
}

/// The evaluations that the choice itself took, and the number of runs after which it saves work.
fn decided(receipt: &Receipt) -> String {
    let worth = receipt
        .worth()
        .map_or_else(String::new, |runs| format!(", as many as {runs:.0} runs of the scene's own model"));
    let pays = match receipt.pays_from() {
        Some(1) => "it has paid with the first run".to_owned(),
        Some(run) => format!("it has paid from run {run} on"),
        None => "this choice saves no work".to_owned(),
    };
    format!("deciding took {} evaluations{worth}: {pays}", receipt.deciding)
}

fn told(value: Option<f64>) -> String {
    let known = value.filter(|value| value.is_finite());
    known.map_or_else(|| "-".to_owned(), |value| format!("{value:.1e}"))
}

/// The reason for which a line of the receipt has no run.
fn said(line: &Line) -> String {
    match line.verdict {
        Sufficiency::Suffices => "too inexact",
        Sufficiency::TooFar => "too far",
        Sufficiency::NotBelieved => "no estimate",
        Sufficiency::NotCarried => "not carried",
        Sufficiency::NotRun => "not run",
        Sufficiency::NotCheaper => "not cheaper",
        Sufficiency::NotTried => "not tried",
    }
    .to_owned()
}

/// The receipt as JSON.
pub fn object(title: &str, (receipt, origin): (&Receipt, &str), command: Option<&[String]>) -> Value {
    let line = |line: &Line| {
        let model = line.model.as_ref().ok();
        let loss = match line.loss {
            Loss::Own => json!("own"),
            Loss::Nothing { claim } => json!({ "exact": true, "claim": claim }),
            Loss::Small { parameter } => {
                json!({ "exact": false, "parameter": parameter, "value": model.and_then(|model| model.small) })
            }
        };
        json!({
            "model": line.name,
            "dropped": line.dropped,
            "loss": loss,
            "states": line.states,
            "estimate": model.map(|model| json!({
                "first": model.first,
                "at": model.at,
                "outputs": receipt.watched.names.iter().cloned().zip(model.each.iter().map(|each| json!(each))).collect::<serde_json::Map<_, _>>(),
            })),
            "run_takes_it": line.asked_as.is_some(),
            "why_not": line.model.as_ref().err().filter(|_| line.verdict == Sufficiency::NotCarried),
            "verdict": line.choice.as_ref().map_or_else(|| said(line), |_| "suffices".to_owned()),
            "run": line.choice.as_ref().map(|choice| json!({
                "method": methods::written(choice.plan.method),
                "form": choice.plan.axes.to_string(),
                "tolerance": choice.plan.tolerance,
                "evaluations": choice.work.evaluations,
                "seconds": choice.seconds,
                "promised": choice.promised,
                "measured": choice.measured,
            })),
        })
    };
    json!({
        "title": title,
        "tolerance": receipt.tolerance,
        "outputs": receipt.watched.names,
        "outputs_from": origin,
        "taken": receipt.taken.map(|at| &receipt.lines[at].name),
        "command": command,
        "cheapest": receipt.cheapest().map(|at| &receipt.lines[at].name),
        "saved": receipt.taken.and_then(|at| receipt.saved(at)),
        "promised_at": { "steps": true, "even_instants": LOOKS },
        "measured_at": { "even_instants": INSTANTS },
        "deciding": { "evaluations": receipt.deciding, "own_runs": receipt.worth(), "pays_from_run": receipt.pays_from() },
        "models": receipt.lines.iter().map(line).collect::<Vec<_>>(),
    })
}
