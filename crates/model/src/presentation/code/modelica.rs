//! Export to Modelica: a flat model with every quantity of the system, its conditions and its events.

use super::exchange::Shown;
use super::letters::Letters;
use super::{Program, terms};
use crate::presentation::conditions::left_out_between_events;
use crate::presentation::identifiers::identifiers;
use crate::presentation::matrix_form::MatrixForm;
use crate::{Direction, Trace};
use std::fmt::Write;
use symbolic::{Language, Statements, Sym};

pub(super) const WORDS: &str = "algorithm and annotation block break class connect connector constant constrainedby der discrete each else \
    elseif elsewhen encapsulated end enumeration equation expandable extends external false final flow for function if import impure in \
    initial inner input loop model not operator or outer output package parameter partial protected public pure record redeclare \
    replaceable return stream then true type when while within time sin cos tan asin acos atan atan2 sinh cosh tanh exp log log10 sqrt \
    abs sign min max sum product mod rem div ceil floor integer pre edge change reinit assert terminate sample noEvent smooth delay \
    cardinality homotopy semiLinear inStream actualStream spatialDistribution getInstanceName size fill zeros ones vector matrix scalar \
    transpose cross skew identity diagonal linspace cat String Real Integer Boolean ExternalObject";

/// The identifiers of a model's quantities.
struct Names {
    given: Vec<String>,
    state: Vec<String>,
    outputs: Vec<String>,
    accelerations: Vec<String>,
    multipliers: Vec<String>,
    /// The names of the cases of conditions.
    cases: Vec<String>,
}

impl Names {
    fn of(trace: &Trace<'_>, form: &MatrixForm) -> Self {
        let texts = |letters: &[Sym]| letters.iter().map(Sym::to_string).collect::<Vec<_>>();
        let mut outputs: Vec<String> = trace.model.outputs.iter().map(|output| output.name.clone()).collect();
        outputs.extend(["kinetic_energy", "potential_energy"].map(str::to_owned));
        let cases = (1..=form.switches.len()).map(|k| format!("condition{k}"));
        let parts = [
            texts(&[&form.parameters[..], &form.inputs].concat()),
            texts(&[&form.positions[..], &form.speeds].concat()),
            outputs,
            texts(&form.accelerations),
            texts(&form.multipliers),
            cases.collect(),
        ];
        let letters: Vec<Sym> = parts.iter().flatten().map(|name| Sym::symbol(name)).collect();
        // names of intermediate results
        let is_result = |name: &String| name.strip_prefix('r').is_some_and(|number| number.parse::<u64>().is_ok());
        let results = letters.iter().filter_map(|letter| letter.identifier()).filter(is_result);
        let taken = results.fold(WORDS.to_owned(), |words, name| words + " " + &name);
        let mut names = identifiers(&letters, &taken).into_iter();
        let [given, state, outputs, accelerations, multipliers, cases] =
            parts.map(|part| names.by_ref().take(part.len()).collect());
        Names { given, state, outputs, accelerations, multipliers, cases }
    }
}

/// Returns a declaration. The name in the file is added as a comment if the identifier differs.
fn declared(kind: &str, name: &str, (attributes, own): (&[String], &str)) -> String {
    let attributes = if attributes.is_empty() { String::new() } else { format!("({})", attributes.join(", ")) };
    let comment = if own == name { String::new() } else { format!(" {}", quoted(own)) };
    format!("  {kind}Real {name}{attributes}{comment};\n")
}

/// Returns a text in quotes.
fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

/// Converts a unit to Modelica's notation, `kg.m2/s2`, with at most one slash.
fn unit(unit: &str) -> String {
    let plain = unit.replace('^', "").replace("ohm", "Ohm");
    let product = |part: &str| part.split_whitespace().collect::<Vec<_>>().join(".");
    let mut parts = plain.split('/').map(product);
    let above = parts.next().filter(|above| !above.is_empty()).unwrap_or_else(|| "1".to_owned());
    let below: Vec<String> = parts.collect();
    let written = match &below[..] {
        [] => above,
        [one] if !one.contains('.') => format!("{above}/{one}"),
        several => format!("{above}/({})", several.join(".")),
    };
    format!("unit = {}", quoted(&written))
}

/// Returns the name of the model; an underscore is appended to a keyword of Modelica.
fn model_name(name: &str) -> String {
    if WORDS.split_whitespace().any(|word| word == name) { format!("{name}_") } else { name.to_owned() }
}

/// Returns a flat model; `start` contains coordinates, then speeds.
///
/// # Errors
/// The errors of [`super::code`].
pub fn modelica(trace: &Trace<'_>, form: &MatrixForm, name: &str, start: &[f64]) -> Result<String, String> {
    let mut program = Program::of(trace, form, Language::Modelica)?;
    program.left_out = left_out_between_events(trace, form);
    let Names { given, state, outputs, accelerations, multipliers, cases } = Names::of(trace, form);
    let (n, parameters) = (form.speeds.len(), form.parameters.len());
    let letters = [&form.parameters[..], &form.inputs, &form.positions, &form.speeds].concat();
    let texts = letters.into_iter().zip(given.iter().chain(&state).cloned());
    let solved = form.accelerations.iter().chain(&form.multipliers).copied();
    let texts = texts.chain(solved.zip(accelerations.iter().chain(&multipliers).cloned()));
    let texts = texts.chain(form.switches.iter().map(|(letter, _)| *letter).zip(cases.iter().cloned()));
    let letters = Letters::of(trace, form, Language::Modelica).with(texts.chain([(form.time, "time".to_owned())]));

    let shown = Shown::of(trace, form);
    let sets: Vec<Sym> = shown.sets.iter().flatten().map(|(_, value)| *value).collect();
    let parts = [
        terms(form),
        form.position_rates.clone(),
        form.switches.iter().map(|(_, condition)| *condition).collect(),
        shown.outputs.clone(),
        shown.events.clone(),
        sets,
    ];
    let Statements { lines, outputs: values } = letters.statements(&parts.concat())?;
    let mut values = values.into_iter();
    let [terms, rates, conditions, shown_values, events, sets] =
        parts.map(|part| values.by_ref().take(part.len()).collect::<Vec<String>>());

    let name = &model_name(name);
    let mut text = program.heading("//") + &format!("model {name}\n");
    for (named, name) in program.parameters[..parameters].iter().zip(&given) {
        let value = named.value.map_or_else(String::new, |value| format!(" = {value:?}"));
        let own = if named.letter == *name { String::new() } else { format!(" {}", quoted(&named.letter)) };
        let _ = writeln!(text, "  parameter Real {name}({}){value}{own};", unit(&named.unit));
    }
    for (named, name) in program.parameters[parameters..].iter().zip(&given[parameters..]) {
        text += &declared("input ", name, (&[unit(&named.unit), "start = 0".to_owned()], &named.letter));
    }
    for ((name, (own, measure)), value) in state.iter().zip(trace.model.state_names()).zip(start) {
        let attributes = [unit(&measure), format!("start = {value:?}"), "fixed = true".to_owned()];
        text += &declared("", name, (&attributes, &own));
    }
    let coherent = |output: &crate::Output| units::Dimension::of(&output.dimension.to_string()).coherent();
    let own = trace.model.outputs.iter().map(|output| (output.name.as_str(), coherent(output)));
    let energies = ["kinetic_energy", "potential_energy"].map(|energy| (energy, "J".to_owned()));
    for (name, (own, measure)) in outputs.iter().zip(own.chain(energies)) {
        text += &declared("output ", name, (&[unit(&measure)], own));
    }
    text += "protected\n";
    let results = lines.iter().flat_map(|line| line.lines()).filter_map(|line| line.trim().split_once(" = "));
    let inner = results
        .map(|(result, _)| result)
        .chain(accelerations.iter().chain(&multipliers).chain(&cases).map(String::as_str));
    for name in inner {
        let _ = writeln!(text, "  Real {name};");
    }
    text += "equation\n";
    let lines = lines.iter().flat_map(|line| line.lines()).map(|line| format!("  {}\n", line.trim()));
    text.extend(lines);
    for (place, (case, condition)) in cases.iter().zip(&conditions).enumerate() {
        let _ = writeln!(text, "  {case} = if {condition} {} 0 then 1 else 0;", form.relation(place));
    }
    for (name, rate) in state.iter().zip(rates.iter().chain(&accelerations)) {
        let _ = writeln!(text, "  der({name}) = {rate};");
    }
    // omits terms that are constantly zero
    let sum = |terms: Vec<(&String, &String)>, last: &String| {
        let kept = terms.into_iter().filter(|(factor, _)| !is_zero(factor));
        let terms = kept.map(|(factor, of)| format!("{}*{of}", signed(factor)));
        terms.chain((!is_zero(last)).then(|| signed(last))).collect::<Vec<_>>().join(" + ")
    };
    let or_zero = |sum: String| if sum.is_empty() { "0".to_owned() } else { sum };
    let (mass, rest) = terms.split_at(n * n);
    let (loads, rest) = rest.split_at(n);
    let (rows, biases) = rest.split_at(multipliers.len() * n);
    let zero = "0".to_owned();
    for (i, load) in loads.iter().enumerate() {
        let left = sum(mass[n * i..n * i + n].iter().zip(&accelerations).collect(), load);
        let right =
            sum(multipliers.iter().enumerate().map(|(k, multiplier)| (&rows[n * k + i], multiplier)).collect(), &zero);
        let _ = writeln!(text, "  {} = {};", or_zero(left), or_zero(right));
    }
    for (k, bias) in biases.iter().enumerate() {
        let _ = writeln!(
            text,
            "  {} = 0;",
            or_zero(sum(rows[n * k..n * k + n].iter().zip(&accelerations).collect(), bias))
        );
    }
    for (name, value) in outputs.iter().zip(&shown_values) {
        let _ = writeln!(text, "  {name} = {value};");
    }
    text += &when_clauses(trace, &shown.sets, &sets, &events, &state);
    let _ = writeln!(text, "end {name};");
    Ok(text)
}

/// Returns the clauses of events. Events that set a common state are branches of one clause, since Modelica allows `reinit` of a state in one clause only.
fn when_clauses(
    trace: &Trace<'_>,
    places: &[Vec<(usize, Sym)>],
    values: &[String],
    expressions: &[String],
    state: &[String],
) -> String {
    let mut values = values.iter();
    let mut clauses: Vec<(Vec<usize>, String)> = Vec::new();
    for ((event, set), expression) in trace.model.events.iter().zip(places).zip(expressions) {
        let passes = match event.direction {
            Direction::Up => format!("{expression} > 0"),
            Direction::Down => format!("{expression} < 0"),
            Direction::Both => format!("{{{expression} > 0, {expression} < 0}}"),
        };
        let mut branch = format!("when {passes} then\n");
        for ((place, _), value) in set.iter().zip(&mut values) {
            let _ = writeln!(branch, "    reinit({}, {value});", state[*place]);
        }
        if event.ends {
            let told = if event.name.is_empty() { "an event ends the run" } else { &event.name };
            let _ = writeln!(branch, "    terminate({});", quoted(told));
        }
        let own: Vec<usize> = set.iter().map(|(place, _)| *place).collect();
        // merges all clauses that set a state of this event
        let (with, without): (Vec<_>, Vec<_>) =
            clauses.into_iter().partition(|(known, _)| known.iter().any(|place| own.contains(place)));
        clauses = without;
        let mut joined = (own, branch);
        if !with.is_empty() {
            let branches = with.iter().map(|(_, branch)| branch.as_str()).chain([joined.1.as_str()]);
            let text = branches.collect::<Vec<_>>().join("  else");
            joined = (with.iter().flat_map(|(known, _)| known.clone()).chain(joined.0).collect(), text);
        }
        clauses.push(joined);
    }
    clauses.iter().map(|(_, branches)| format!("  {branches}  end when;\n")).collect()
}

/// Puts a text into parentheses if it begins with a sign.
fn signed(text: &str) -> String {
    if text.starts_with('-') { format!("({text})") } else { text.to_owned() }
}

/// Returns whether the text is the number zero.
fn is_zero(text: &str) -> bool {
    text.parse::<f64>().is_ok_and(|value| value == 0.0)
}
