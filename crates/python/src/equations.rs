//! Equations of motion in several notations.

use crate::errors::{not_derived, refused};
use crate::interruptible::interruptible;
use dalembert::scenes::SystemText;
use dalembert::scenes::derivation::{NamedPrinciple, Notation, derived};
use dalembert::symbolic::Language;
use pyo3::prelude::*;

/// The equations of motion of a model by a principle. A notebook shows them typeset.
#[pyclass(frozen, module = "dalembert")]
pub struct Equations {
    text: SystemText,
    principle: NamedPrinciple,
    read: String,
}

impl Equations {
    /// Derives the equations of a text; without a principle by the default one.
    pub fn of(py: Python<'_>, text: &SystemText, principle: Option<&str>) -> PyResult<Self> {
        let asked = principle.map(NamedPrinciple::of_name).transpose().map_err(|why| refused(py, &text.name, why))?;
        let of = text.clone();
        let shown = move || derived(&of, asked, false, |derived| (derived.principle, derived.written(Notation::Text)));
        let found = interruptible(py, shown)?;
        let (principle, read) = found.map_err(|why| not_derived(py, &text.name, why))?;
        // equations that are too long for reading are still available as code
        let read = read.unwrap_or_else(|why| why);
        Ok(Equations { text: text.clone(), principle, read })
    }

    fn written(&self, py: Python<'_>, notation: Notation) -> PyResult<String> {
        let is_code = matches!(notation, Notation::Code(_));
        let (text, principle) = (self.text.clone(), self.principle);
        let shown = move || derived(&text, Some(principle), is_code, |derived| derived.written(notation));
        let found = interruptible(py, shown)?;
        let written = found.map_err(|why| not_derived(py, &self.text.name, why))?;
        written.map_err(|why| refused(py, &self.text.name, why))
    }
}

#[pymethods]
impl Equations {
    /// The name of the principle.
    #[getter]
    fn principle(&self) -> &'static str {
        self.principle.name()
    }

    /// The equations as text: the matrix form M q'' + h = Q, and the letters with their units.
    #[getter]
    fn text(&self) -> &str {
        &self.read
    }

    /// The equations in LaTeX, with an `align` environment for each group.
    #[getter]
    fn latex(&self, py: Python<'_>) -> PyResult<String> {
        self.written(py, Notation::Latex)
    }

    /// The equations as a Python program with SymPy symbols.
    #[getter]
    fn sympy(&self, py: Python<'_>) -> PyResult<String> {
        self.written(py, Notation::Sympy)
    }

    /// The equations as objects of SymPy, which must be installed: q, mass_matrix, inertia, forces and equations; with constraints also jacobian,
    /// bias, constraints and multipliers; `letters` by their names, `values` of parameters.
    #[getter]
    fn sympy_expressions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let program = self.written(py, Notation::Sympy)?;
        py.import("dalembert._sympy")?.call_method1("to_sympy", (program,))
    }

    /// The equations as straight-line code; the language is "c", "python" or "rust".
    fn code(&self, py: Python<'_>, language: &str) -> PyResult<String> {
        let language = match language.to_lowercase().as_str() {
            "c" => Language::C,
            "python" => Language::Python,
            "rust" => Language::Rust,
            _ => {
                let why = format!("no code is written in `{language}`; accepted are c, python, rust");
                return Err(refused(py, &self.text.name, why));
            }
        };
        self.written(py, Notation::Code(language))
    }

    /// The LaTeX for notebooks; None where the equations are too long to be read.
    fn _repr_latex_(&self, py: Python<'_>) -> Option<String> {
        // the typesetter of a notebook supports unnumbered displays, and no comments
        let latex = self.written(py, Notation::Latex).ok()?;
        let lines = latex.lines().filter(|line| !line.starts_with('%'));
        Some(lines.collect::<Vec<_>>().join("\n").replace("{align}", "{align*}"))
    }

    fn __repr__(&self) -> &str {
        &self.read
    }
}
