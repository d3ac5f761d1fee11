//! Comparison of equations of motion from another program with those of a model.

use crate::errors::scene_error;
use dalembert::manuscript::{PeerEquation, PeerEquations, PeerFinding, TermDifference};
use dalembert::scenes::SystemText;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// The comparison of equations of motion with those of a text, as plain data, which can be sent between processes: verdict, sentence,
/// divisors that must not vanish, and a finding on each equation.
pub fn checked<'py>(py: Python<'py>, text: &SystemText, peer: &PeerEquations) -> PyResult<Bound<'py, PyDict>> {
    let found = py.detach(|| peer.compared(text)).map_err(|error| scene_error(py, &error))?;
    let PeerFinding { verdict, sentence, equations, requires } = found;
    let told = PyDict::new(py);
    told.set_item("verdict", verdict.name())?;
    told.set_item("sentence", sentence)?;
    told.set_item("requires", requires)?;
    let equations = equations.into_iter().map(|one| equation(py, one)).collect::<PyResult<Vec<_>>>()?;
    told.set_item("equations", equations)?;
    Ok(told)
}

fn equation(py: Python<'_>, one: PeerEquation) -> PyResult<Bound<'_, PyDict>> {
    let PeerEquation { name, verdict, sentence, terms, left, point } = one;
    let told = PyDict::new(py);
    told.set_item("name", name)?;
    told.set_item("verdict", verdict.name())?;
    told.set_item("sentence", sentence)?;
    told.set_item("left", left)?;
    let values = PyDict::new(py);
    point.iter().try_for_each(|(name, value)| values.set_item(name, value))?;
    told.set_item("point", values)?;
    let terms = terms.into_iter().map(|term| difference(py, term)).collect::<PyResult<Vec<_>>>()?;
    told.set_item("terms", terms)?;
    Ok(told)
}

fn difference(py: Python<'_>, term: TermDifference) -> PyResult<Bound<'_, PyDict>> {
    let TermDifference { of, theirs, ours, difference } = term;
    let told = PyDict::new(py);
    told.set_item("of", of)?;
    told.set_item("theirs", theirs)?;
    told.set_item("ours", ours)?;
    told.set_item("difference", difference)?;
    Ok(told)
}
