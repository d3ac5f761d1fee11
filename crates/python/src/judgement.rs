//! Statements about a model with their verdicts.

use dalembert::model;
use pyo3::prelude::*;

/// A statement about a model with its verdict.
#[pyclass(frozen, module = "dalembert")]
pub struct Judgement(pub model::Judgement);

#[pymethods]
impl Judgement {
    /// The statement: two principles that are compared, or a quantity with the conservation law for it.
    #[getter]
    fn statement(&self) -> String {
        self.0.title()
    }

    /// The verdict: proved, identified, tested, refuted, undecided, or "does not apply".
    #[getter]
    fn verdict(&self) -> &'static str {
        self.0.degree()
    }

    /// The verdict as a sentence, with its ground and the values for which it holds.
    #[getter]
    fn sentence(&self) -> String {
        self.0.said()
    }

    /// Further grounds of the verdict, one per line.
    #[getter]
    fn grounds(&self) -> Vec<String> {
        self.0.behind.clone()
    }

    /// Whether a statement that must hold was refuted or not decided.
    #[getter]
    fn fails(&self) -> bool {
        self.0.fails()
    }

    fn __repr__(&self) -> String {
        format!("{}: {}", self.0.title(), self.0.said())
    }
}
