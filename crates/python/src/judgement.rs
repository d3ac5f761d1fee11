//! Statements about a model with their verdicts.

use dalembert::model;
use pyo3::prelude::*;

/// A statement about a model with its verdict.
#[pyclass(frozen, module = "dalembert")]
pub struct Judgement(pub model::Judgement);

#[pymethods]
impl Judgement {
    /// The statement: two principles that are compared, or a quantity and what the equations say of it.
    #[getter]
    fn statement(&self) -> String {
        self.0.title()
    }

    /// In one word: proved, identified, tested, refuted, undecided, or "does not apply".
    #[getter]
    fn verdict(&self) -> &'static str {
        self.0.degree()
    }

    /// The verdict in a sentence: on what ground, for which values.
    #[getter]
    fn sentence(&self) -> String {
        self.0.said()
    }

    /// Grounds of the verdict, line by line.
    #[getter]
    fn grounds(&self) -> Vec<String> {
        self.0.behind.clone()
    }

    /// Whether something that must hold is refuted, or could not be decided.
    #[getter]
    fn fails(&self) -> bool {
        self.0.fails()
    }

    fn __repr__(&self) -> String {
        format!("{}: {}", self.0.title(), self.0.said())
    }
}
