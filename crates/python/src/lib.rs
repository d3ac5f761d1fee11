//! The native module `dalembert._native` of the Python package `dalembert`.
//!
//! Only this package uses the module; the documentation for users is in the package.

mod callables;
mod equations;
mod errors;
mod interruptible;
mod judgement;
mod linear;
mod model;
mod motions;
mod peer;
mod results;
mod time_limit;
mod trajectory;
mod wording;

// linked for the motors and the derivations that they register
use dalembert::scenes::derivation::NamedPrinciple;
use dalembert_machines as _;
use dalembert_studies as _;
use pyo3::prelude::*;

/// Issues a Python warning about a text.
fn warn(text: &str) {
    if interruptible::handed(text) {
        return;
    }
    Python::attach(|py| {
        let text = text.strip_prefix("warning: ").unwrap_or(text);
        let told = std::ffi::CString::new(text).map(|text| {
            let category = py.get_type::<pyo3::exceptions::PyUserWarning>();
            PyErr::warn(py, &category, &text, 2)
        });
        // a filter may turn the warning into an error, which cannot be raised here
        drop(told);
    });
}

#[pymodule]
fn _native(module: &Bound<'_, PyModule>) -> PyResult<()> {
    dalembert::scenes::register(warn);
    module.add_class::<model::NativeModel>()?;
    module.add_class::<equations::Equations>()?;
    module.add_class::<judgement::Judgement>()?;
    module.add_class::<trajectory::NativeTrajectory>()?;
    module.add_class::<linear::LinearEquations>()?;
    module.add_class::<callables::RightHandSide>()?;
    module.add_class::<callables::JacobianMatrix>()?;
    module.add_function(wrap_pyfunction!(results::judge_paper, module)?)?;
    module.add_function(wrap_pyfunction!(time_limit::end_process_after, module)?)?;
    errors::add(module)?;
    module.add("METHODS", dalembert::simulation::methods::list().map(|(name, _)| name).collect::<Vec<_>>())?;
    let principles = NamedPrinciple::all().into_iter().map(NamedPrinciple::name);
    module.add("PRINCIPLES", principles.collect::<Vec<_>>())?;
    module.add("VERSION", env!("CARGO_PKG_VERSION"))
}
