//! Export of a system in a file to other simulators, with its equations, variable parameters and events; unsupported features are
//! refused.

mod jumps;
mod refusals;

use crate::readiness::ready;
use crate::row_units::{coherent, unit_of};
use crate::scene::called;
use crate::system_text::SystemText;
use exchange::fmu::{Unit, Variable, Version};
use jumps::sticking;
use model::principles::Principle;
use model::{MatrixForm, Model, Trace};
use reader::{Issue, SceneError, tables};
use refusals::refused;
use simulation::{Run, run};
use std::sync::Arc;

/// A language of exported programs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Program {
    C,
    Python,
    Rust,
    Casadi,
    Modelica,
}

/// The default tolerance and time span (s) of a file without `[run]`.
const TOLERANCE: f64 = 1e-8;
const SPAN: f64 = 10.0;

/// A system with a complete start (coordinates, then speeds), ready for export.
struct Exported<'a> {
    text: &'a SystemText,
    model: Model,
    start: Vec<f64>,
}

impl<'a> Exported<'a> {
    /// The system of a file.
    ///
    /// # Errors
    /// The file has errors, a feature cannot be exported, a quantity has no value, or no motion continues from the start.
    fn of(text: &'a SystemText) -> Result<Self, SceneError> {
        let model = text.for_equations()?;
        let told = |issue: Issue| told(text, issue);
        if let Some(issue) = refused(&model) {
            return Err(told(issue));
        }
        // inputs are zero until the importing program sets them
        let mut closed = Arc::new(model.clone());
        Arc::make_mut(&mut closed).close_inputs();
        let found = ready(&mut closed).map_err(told)?;
        match found.without_motion {
            Some(issue) => Err(told(issue)),
            None => Ok(Exported { text, model, start: found.start }),
        }
    }

    /// Passes the equations in the rates of coordinates to `show`.
    fn shown<R: Send>(
        &self,
        show: impl FnOnce(&Trace<'_>, &MatrixForm) -> Result<R, String> + Send,
    ) -> Result<R, SceneError> {
        let written = symbolic::apart(|| {
            let trace = Trace::of(&self.model);
            let form = MatrixForm::of(&trace, Principle::VirtualPower).map_err(|why| why.to_string());
            let form = form.or_else(|_| MatrixForm::of(&trace, Principle::Lagrange).map_err(|why| why.to_string()))?;
            show(&trace, &form.in_file(&self.model, &self.text.text))
        });
        written.map_err(|why: String| {
            SceneError::whole(
                &self.text.name,
                format!("its equations cannot be written for another program: {why}"),
                "`dalembert run` runs it",
            )
        })
    }
}

impl Exported<'_> {
    /// The exported result, or an error if the condition with the given index may stay at zero.
    fn without_sticking<R>(&self, (written, sticks): (R, Option<usize>)) -> Result<R, SceneError> {
        let Some(condition) = sticks else { return Ok(written) };
        let place = self.model.switch_places[condition].clone();
        let title = "a force jumps where this condition changes with a speed, and may keep it there, as dry friction that sticks";
        let issue = Issue::at(place, title, "no law for that can be written for another simulator");
        Err(told(self.text, issue.accepted("a force without a jump, such as -F*tanh(v/v0)")))
    }
}

fn told(text: &SystemText, issue: Issue) -> SceneError {
    SceneError { path: text.name.clone(), text: text.text.clone(), issues: vec![issue] }
}

/// The run of a file, if it has one.
fn run_of(text: &SystemText) -> Option<Run> {
    let mut found = None;
    // the other tables were checked before
    let _ = tables(&text.name, &text.text, |top, issues| {
        found = run::read(top, issues, None);
        Some(())
    });
    found
}

/// The system of a file as a functional mock-up unit (FMI) for model exchange and co-simulation. `identifier` is its name in C, `origin`
/// one line on its source, `tool` the name of the exporting program.
///
/// # Errors
/// The file has errors, or a feature cannot be exported; each error has its position in the file.
pub fn unit(text: &SystemText, identifier: &str, origin: &str, tool: &str) -> Result<Unit, SceneError> {
    let exported = Exported::of(text)?;
    let Exported { model, start, .. } = &exported;
    let source = exported.shown(|trace, form| Ok((model::exchange(trace, form, start)?, sticking(form))))?;
    let source = exported.without_sticking(source)?;
    let titled = crate::system_text::parse_titled(&text.name, &text.text, crate::size::Task::Write)?.0;
    let run = run_of(text);
    // quantities of different kinds may have one name: the unit belongs to the kind
    let variable = |name: &str, unit: String, description: String, value: f64| Variable {
        name: name.to_owned(),
        unit,
        description,
        value,
    };
    let named = |name: &str, value: f64| variable(name, unit_of(model, name), String::new(), value);
    let states = model.state_names().into_iter().zip(start).map(|((name, _), value)| named(&name, *value));
    let parameters = model
        .parameters
        .iter()
        .map(|each| variable(&each.name, each.unit.clone(), each.written.clone(), each.value.unwrap_or_default()));
    let open = model.inputs.iter().filter(|input| input.value.is_none());
    let line = |at: usize| 1 + text.text.get(..at).unwrap_or_default().matches('\n').count();
    let conditions = model.switch_places.iter().enumerate().map(|(place, at)| Variable {
        name: format!("condition {}", place + 1),
        unit: model.switch_units[place].clone(),
        description: format!("condition {} in line {}", place + 1, line(at.start)),
        value: 0.0,
    });
    let events = model.events.iter().enumerate().map(|(place, event)| Variable {
        name: if event.name.is_empty() { format!("event {}", place + 1) } else { event.name.clone() },
        unit: "1".to_owned(),
        description: called(event, &text.text),
        value: 0.0,
    });
    Ok(Unit {
        version: Version::default(),
        identifier: identifier.to_owned(),
        title: if titled.is_empty() { identifier.to_owned() } else { titled },
        origin: origin.to_owned(),
        tool: tool.to_owned(),
        tolerance: run.as_ref().map_or(TOLERANCE, |run| run.tolerance),
        span: run.as_ref().map_or(SPAN, |run| run.span),
        states: states.collect(),
        parameters: parameters.collect(),
        inputs: open.map(|input| variable(&input.name, coherent(&input.unit), String::new(), 0.0)).collect(),
        outputs: model.outputs.iter().map(|output| named(&output.name, 0.0)).collect(),
        locals: ["kinetic_energy", "potential_energy"]
            .map(|name| variable(name, "J".to_owned(), String::new(), 0.0))
            .to_vec(),
        indicators: conditions.chain(events).collect(),
        source,
    })
}

/// The system of a file as a program in another language, with its start, and sentences on features that the program omits.
///
/// # Errors
/// The file has errors, or a feature cannot be exported; each error has its position in the file.
pub fn program(text: &SystemText, program: Program, identifier: &str) -> Result<(String, Vec<String>), SceneError> {
    let exported = Exported::of(text)?;
    let start = &exported.start;
    if program == Program::Modelica {
        let shown =
            exported.shown(|trace, form| Ok((model::modelica(trace, form, identifier, start)?, sticking(form))))?;
        return Ok((exported.without_sticking(shown)?, Vec::new()));
    }
    exported.shown(|trace, form| {
        let written = match program {
            Program::C => model::code_from(trace, form, symbolic::Language::C, start),
            Program::Python => model::code_from(trace, form, symbolic::Language::Python, start),
            Program::Rust => model::code_from(trace, form, symbolic::Language::Rust, start),
            Program::Casadi => model::casadi(trace, form, start),
            Program::Modelica => model::modelica(trace, form, identifier, start),
        };
        Ok((written?, model::left_out(trace, form)))
    })
}
