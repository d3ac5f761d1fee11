//! Exceptions with the place of the fault in the text, and a remedy.

use dalembert::reader::{Issue, SceneError};
use dalembert::scenes::derivation::NotDerived;
use pyo3::create_exception;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList, PyString};

create_exception!(
    dalembert,
    ModelError,
    PyValueError,
    "A model that cannot be read, or that cannot do what is asked of it.\n\n\
     file, line, column: where, counted from one; None where it concerns the whole text.\n\
     title: what is wrong, in one line. label: what stands at the place. remedy: what is accepted there.\n\
     issues: all that is wrong, a list of dictionaries with these keys."
);

/// Adds the exceptions to the module.
pub fn add(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("ModelError", module.py().get_type::<ModelError>())
}

/// The line and the column of a byte, counted from one.
fn place(text: &str, byte: usize) -> (usize, usize) {
    let before = text.get(..byte).unwrap_or(text);
    (before.matches('\n').count() + 1, before.chars().rev().take_while(|c| *c != '\n').count() + 1)
}

fn described<'py>(py: Python<'py>, error: &SceneError, issue: &Issue) -> PyResult<Bound<'py, PyDict>> {
    let found = issue.span.as_ref().filter(|_| !error.text.is_empty()).map(|span| place(&error.text, span.start));
    let dictionary = PyDict::new(py);
    dictionary.set_item("file", &error.path)?;
    dictionary.set_item("line", found.map(|(line, _)| line))?;
    dictionary.set_item("column", found.map(|(_, column)| column))?;
    dictionary.set_item("title", &issue.title)?;
    dictionary.set_item("label", &issue.label)?;
    dictionary.set_item("remedy", &issue.help)?;
    Ok(dictionary)
}

/// The exception for all faults of a text.
pub fn scene_error(py: Python<'_>, error: &SceneError) -> PyErr {
    let exception = ModelError::new_err(error.to_string());
    let described = || -> PyResult<()> {
        let value = exception.value(py);
        let all: Vec<_> = error.issues.iter().map(|issue| described(py, error, issue)).collect::<PyResult<_>>()?;
        if let Some(first) = all.first() {
            for (name, item) in first.iter() {
                value.setattr(name.cast::<PyString>()?, item)?;
            }
        }
        value.setattr("issues", PyList::new(py, all)?)
    };
    match described() {
        Ok(()) => exception,
        Err(other) => other,
    }
}

/// The exception for one fault of a text.
pub fn issue(py: Python<'_>, (name, text): (&str, &str), issue: Issue) -> PyErr {
    scene_error(py, &SceneError { path: name.to_owned(), text: text.to_owned(), issues: vec![issue] })
}

/// The exception for a refusal without a place in the text.
pub fn refused(py: Python<'_>, name: &str, why: impl Into<String>) -> PyErr {
    let issue = Issue { span: None, title: why.into(), label: String::new(), help: None };
    scene_error(py, &SceneError { path: name.to_owned(), text: String::new(), issues: vec![issue] })
}

/// The exception for equations that could not be derived.
pub fn not_derived(py: Python<'_>, name: &str, error: NotDerived) -> PyErr {
    match error {
        NotDerived::Text(error) => scene_error(py, &error),
        NotDerived::Refused(why) => refused(py, name, why),
    }
}
