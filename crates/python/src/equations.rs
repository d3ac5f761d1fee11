//! Equations of motion in every notation.

use crate::errors::{not_derived, refused};
use dalembert::scenes::SystemText;
use dalembert::scenes::derivation::{NamedPrinciple, Notation, derived};
use dalembert::symbolic::Language;
use pyo3::prelude::*;

/// Equations of motion of a model by a principle. A notebook shows them typeset.
#[pyclass(frozen, module = "dalembert")]
pub struct Equations {
    text: SystemText,
    principle: NamedPrinciple,
    read: String,
}

impl Equations {
    /// Derives the equations of a text.
    pub fn of(py: Python<'_>, text: &SystemText, principle: Option<&str>) -> PyResult<Self> {
        let asked = principle.map(NamedPrinciple::of_name).transpose().map_err(|why| refused(py, &text.name, why))?;
        let found =
            py.detach(|| derived(text, asked, false, |derived| (derived.principle, derived.written(Notation::Text))));
        let (principle, read) = found.map_err(|why| not_derived(py, &text.name, why))?;
        // equations too long for reading can still be code
        let read = read.unwrap_or_else(|why| why);
        Ok(Equations { text: text.clone(), principle, read })
    }

    fn written(&self, py: Python<'_>, notation: Notation) -> PyResult<String> {
        let is_code = matches!(notation, Notation::Code(_));
        let found =
            py.detach(|| derived(&self.text, Some(self.principle), is_code, |derived| derived.written(notation)));
        let written = found.map_err(|why| not_derived(py, &self.text.name, why))?;
        written.map_err(|why| refused(py, &self.text.name, why))
    }
}

#[pymethods]
impl Equations {
    /// The principle by its name.
    #[getter]
    fn principle(&self) -> &'static str {
        self.principle.name()
    }

    /// For reading: the matrix form M q'' + h = Q, its letters with their units.
    #[getter]
    fn text(&self) -> &str {
        &self.read
    }

    /// LaTeX, an `align` for each group.
    #[getter]
    fn latex(&self, py: Python<'_>) -> PyResult<String> {
        self.written(py, Notation::Latex)
    }

    /// A Python program over SymPy's symbols.
    #[getter]
    fn sympy(&self, py: Python<'_>) -> PyResult<String> {
        self.written(py, Notation::Sympy)
    }

    /// The same as objects of SymPy, which must be installed: q, mass_matrix, inertia, forces and equations, with constraints their jacobian,
    /// bias, constraints and multipliers; `letters` by their names, `values` of parameters.
    #[getter]
    fn sympy_expressions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let program = self.written(py, Notation::Sympy)?;
        py.import("dalembert._sympy")?.call_method1("to_sympy", (program,))
    }

    /// Straight-line code: language "c", "python" or "rust".
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

    /// For notebooks; none where the equations are too long to be read.
    fn _repr_latex_(&self, py: Python<'_>) -> Option<String> {
        // a notebook's typesetter knows aligned displays, and no comments
        let latex = self.written(py, Notation::Latex).ok()?;
        let lines = latex.lines().filter(|line| !line.starts_with('%'));
        Some(lines.collect::<Vec<_>>().join("\n").replace("{align}", "{align*}"))
    }

    fn __repr__(&self) -> &str {
        &self.read
    }
}
