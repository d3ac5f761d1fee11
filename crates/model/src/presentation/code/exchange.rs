//! Export to C for programs that run the system themselves: the rates, outputs, conditions, events, and directional derivatives
//! of all of these. The cases of conditions are arguments of each function, since they change only at events.

use super::c::{self, Form};
use super::letters::Letters;
use super::{Program, assigned, indented, terms};
use crate::equations::{Level, constraints_of};
use crate::presentation::matrix_form::MatrixForm;
use crate::{Direction, Event, Trace};
use std::fmt::Write;
use symbolic::{Derivation, Language, Statements, Sym, substitute_all};

/// The expressions in addition to the equations of motion.
pub(super) struct Shown {
    /// Outputs, then kinetic and potential energy. They may depend on accelerations and multipliers.
    pub outputs: Vec<Sym>,
    /// The expressions of events.
    pub events: Vec<Sym>,
    /// For each event, the indices of the state that it sets, and the values.
    pub sets: Vec<Vec<(usize, Sym)>>,
}

impl Shown {
    pub fn of(trace: &Trace<'_>, form: &MatrixForm) -> Self {
        let multipliers = constraints_of(trace).into_iter().map(|one| one.multiplier);
        let known: Vec<(Sym, Sym)> = multipliers.zip(form.multipliers.iter().copied()).collect();
        let written = |expressions: Vec<Sym>| trace.with_masses(&substitute_all(&expressions, &known));
        let outputs = trace.model.outputs.iter().map(|output| trace.scalar(output.is));
        let outputs = outputs.chain([trace.kinetic_energy(), trace.potential_energy()]);
        let place = |coordinate: usize, order: usize| coordinate + order * form.positions.len();
        let set = |event: &Event| {
            let places = event.set.iter().map(|each| place(each.coordinate, each.order));
            places.zip(written(event.set.iter().map(|each| trace.scalar(each.is)).collect())).collect()
        };
        Shown {
            outputs: written(outputs.collect()),
            events: written(trace.model.events.iter().map(|event| trace.scalar(event.when)).collect()),
            sets: trace.model.events.iter().map(set).collect(),
        }
    }
}

/// The direction of a derivative: changes of time, coordinates, speeds and data.
const DIRECTION: &str = "double dt, const double *dq, const double *du, const struct parameters *dp";
const UNUSED: &str = "(void)dt; (void)dq; (void)du; (void)dp;";
/// Accelerations and multipliers, and their changes.
const SOLVED: &str = "const double *a, const double *lambda";
const SOLVED_CHANGE: &str = "const double *da, const double *dlambda";

/// Writes the functions of one file.
struct Writer {
    letters: Letters,
    text: String,
}

impl Writer {
    fn function(
        &mut self,
        told: &str,
        name: &str,
        more: &str,
        unused: &str,
        expressions: &[Sym],
    ) -> Result<(), String> {
        let Statements { lines, outputs } = self.letters.statements(expressions)?;
        let form = Form::PART;
        let more = if more.is_empty() { String::new() } else { format!(", {more}") };
        let _ = writeln!(
            self.text,
            "\n// {told}\n{}void {name}({}{more}, double *out)\n{{\n    {} {unused}\n{}{}}}",
            form.storage,
            form.declared(),
            form.unused(),
            indented(&lines),
            indented(&assigned("out", &outputs)),
        );
        Ok(())
    }
}

/// Returns a part of a C file: data with their values, the start, and all functions of a system. Inputs without a value are data with the initial value zero,
/// listed after the parameters.
///
/// # Errors
/// The errors of [`super::code`]; or an output or event depends on a quantity that these equations do not give.
pub fn exchange(trace: &Trace<'_>, form: &MatrixForm, start: &[f64]) -> Result<String, String> {
    let mut program = Program::of(trace, form, Language::C)?;
    program.start = Some(start.to_vec());
    let parameters = trace.model.parameters.len();
    program.close_inputs(trace);
    let inputs = program.parameters.len() - parameters;
    let letters = Letters::of(trace, form, Language::C);
    let solved: Vec<Sym> = form.accelerations.iter().chain(&form.multipliers).copied().collect();
    let named = |of: &str, count: usize| (0..count).map(|k| format!("{of}[{k}]")).collect::<Vec<_>>();
    let solved_texts = |d: &str| {
        [named(&format!("{d}a"), form.accelerations.len()), named(&format!("{d}lambda"), form.multipliers.len())]
            .concat()
    };
    // the symbol of the differential of a symbol
    let change = |letter: &Sym| Sym::symbol(&format!("change of {letter}"));
    let given: Vec<Sym> = form.parameters.iter().chain(&form.inputs).copied().collect();
    let moving = std::iter::once((form.time, "dt".to_owned()));
    let moving = moving.chain(form.positions.iter().copied().zip(named("dq", form.positions.len())));
    let moving = moving.chain(form.speeds.iter().copied().zip(named("du", form.speeds.len())));
    let moving = moving.chain(given.iter().copied().zip(letters.names.iter().map(|name| format!("dp->{name}"))));
    let moving = moving.chain(solved.iter().copied().zip(solved_texts("d")));
    let moving: Vec<(Sym, String)> = moving.collect();
    let mut along = Derivation::new(moving.iter().map(|(letter, _)| (*letter, change(letter))));
    let letters = letters.with(solved.iter().copied().zip(solved_texts("")));
    let letters = letters.with(moving.iter().map(|(letter, text)| (change(letter), text.clone())));

    let Shown { outputs, events, sets } = Shown::of(trace, form);
    let indicators: Vec<Sym> = form.switches.iter().map(|(_, condition)| *condition).chain(events).collect();
    let zeros: Vec<Sym> = form.constraints.iter().map(|held| held.zero).collect();
    let text = format!(
        "{}enum {{ PARAMETERS = {parameters}, INPUTS = {inputs}, OUTPUTS = {}, CONDITIONS = {}, EVENTS = {} }};\n",
        c::functions(&program, Form::PART),
        outputs.len(),
        form.switches.len(),
        sets.len(),
    );
    let mut writer = Writer { letters, text };
    let solved = "(void)a; (void)lambda;";
    writer.function(
        "expressions that are positive where conditions hold; then those that pass zero at events",
        "indicators",
        "",
        "",
        &indicators,
    )?;
    writer.function("outputs, kinetic and potential energy", "outputs", SOLVED, solved, &outputs)?;
    writer.function("dy/dt, coordinates alone", "position_rates", "", "", &form.position_rates)?;
    let mut changes = |expressions: &[Sym]| expressions.iter().map(|each| along.of(*each)).collect::<Vec<_>>();
    let told = |of: &str| format!("the change of {of} along a direction");
    writer.function(&told("terms"), "terms_along", DIRECTION, UNUSED, &changes(&terms(form)))?;
    writer.function(
        &told("dy/dt, coordinates alone"),
        "position_rates_along",
        DIRECTION,
        UNUSED,
        &changes(&form.position_rates),
    )?;
    writer.function(&told("constraints"), "constraints_along", DIRECTION, UNUSED, &changes(&zeros))?;
    writer.function(&told("indicators"), "indicators_along", DIRECTION, UNUSED, &changes(&indicators))?;
    let (more, unused) =
        (format!("{SOLVED}, {DIRECTION}, {SOLVED_CHANGE}"), format!("{solved} {UNUSED} (void)da; (void)dlambda;"));
    writer.function(&told("outputs"), "outputs_along", &more, &unused, &changes(&outputs))?;
    let Writer { letters, mut text } = writer;

    let listed = |numbers: Vec<i32>| numbers.iter().chain([&0]).map(i32::to_string).collect::<Vec<_>>().join(", ");
    let gains = constraints_of(trace).into_iter().map(|one| one.gains.is_some());
    let kept = form.constraints.iter().zip(gains).map(|(held, is_led)| match held.level {
        _ if is_led => 2,
        Level::Position => 1,
        Level::Speed => 0,
    });
    let kept = listed(kept.collect());
    let directions = trace.model.events.iter().map(|event| match event.direction {
        Direction::Up => 1,
        Direction::Down => -1,
        Direction::Both => 0,
    });
    let ends = trace.model.events.iter().map(|event| i32::from(event.ends)).collect();
    let _ = writeln!(
        text,
        "\n// zero for a constraint of speeds, one for one of coordinates, two for one that is led by a law of its own\nstatic const int kept[] = {{{}}};\n\
         // the direction in which an event passes zero: up, down, or zero for both\nstatic const int directions[] = {{{}}};\n\
         // one for an event that ends the run\nstatic const int ends[] = {{{}}};\n\n\
         // the state after an event, from that before it\n\
         static void set_by_event(int event, {}, double *y)\n{{\n    (void)event; {}",
        kept,
        listed(directions.collect()),
        listed(ends),
        Form::PART.declared(),
        Form::PART.unused().replace("out", "y"),
    );
    for (event, set) in sets.iter().enumerate().filter(|(_, set)| !set.is_empty()) {
        let (places, values): (Vec<usize>, Vec<Sym>) = set.iter().copied().unzip();
        let Statements { lines, outputs } = letters.statements(&values)?;
        let assigned = places.iter().zip(&outputs).map(|(place, value)| format!("y[{place}] = {value};"));
        let _ = writeln!(
            text,
            "    if (event == {event}) {{\n{}{}    }}",
            indented(&lines),
            indented(&assigned.collect::<Vec<_>>())
        );
    }
    text += "}\n";
    Ok(text)
}
