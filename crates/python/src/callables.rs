//! The right-hand side of a model and its Jacobian as callables.

use crate::errors::refused;
use dalembert::integrators::{Jacobian, Ode};
use dalembert::simulation::Law;
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1, PyUntypedArrayMethods};
use pyo3::prelude::*;
use std::sync::Arc;

/// A law of motion y' = f(t, y) with the names of its states.
#[derive(Clone)]
pub struct NamedLaw {
    pub law: Arc<dyn Law>,
    pub file: String,
    pub states: Vec<String>,
}

impl NamedLaw {
    /// The numbers of a state; anything that NumPy makes an array of is accepted.
    fn state<'py>(&self, state: &Bound<'py, PyAny>) -> PyResult<PyReadonlyArray1<'py, f64>> {
        let py = state.py();
        let array = match state.cast::<PyArray1<f64>>() {
            Ok(array) if array.is_contiguous() => array.clone(),
            _ => {
                let numpy = py.import("numpy")?;
                let made = numpy.call_method1("ascontiguousarray", (state, numpy.getattr("float64")?))?;
                let shape = made.getattr("shape")?.to_string();
                made.cast_into::<PyArray1<f64>>().map_err(|_| self.wrong_length(py, &shape))?
            }
        };
        if array.len() != self.states.len() {
            return Err(self.wrong_length(py, &format!("({},)", array.len())));
        }
        Ok(array.readonly())
    }

    fn wrong_length(&self, py: Python<'_>, shape: &str) -> PyErr {
        let why = format!(
            "a state of this model is an array of {} numbers, ({}); this one has the shape {shape}",
            self.states.len(),
            self.states.join(", ")
        );
        refused(py, &self.file, why)
    }
}

/// The right-hand side of the equations of motion: f(t, y) gives y', y being coordinates, then speeds, in SI units.
#[pyclass(frozen, module = "dalembert")]
pub struct RightHandSide(pub NamedLaw);

#[pymethods]
impl RightHandSide {
    /// Names of the components of y.
    #[getter]
    fn states(&self) -> Vec<String> {
        self.0.states.clone()
    }

    /// Bytes of its machine code and of the constants in it; None where it is not machine code.
    ///
    /// Where accelerations are solved for at each call, the bytes are those of the linear equations, without the solve.
    #[getter]
    fn code_size(&self) -> Option<usize> {
        self.0.law.code_size()
    }

    /// The rates of the state y at the time t in seconds.
    fn __call__<'py>(&self, py: Python<'py>, t: f64, y: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let y = self.0.state(y)?;
        let mut rates = vec![f64::NAN; self.0.states.len()];
        Ode::<f64>::rates(&*self.0.law, t, y.as_slice()?, &mut rates);
        Ok(PyArray1::from_vec(py, rates))
    }

    fn __repr__(&self) -> String {
        format!("<right-hand side f(t, y) of {}, y = ({})>", self.0.file, self.0.states.join(", "))
    }
}

/// The derivatives of the right-hand side by the state: J(t, y), exact.
#[pyclass(frozen, module = "dalembert")]
pub struct JacobianMatrix(pub NamedLaw);

#[pymethods]
impl JacobianMatrix {
    /// Names of the components of y.
    #[getter]
    fn states(&self) -> Vec<String> {
        self.0.states.clone()
    }

    /// Bytes of its machine code and of the constants in it; None where the right-hand side is differentiated in numbers instead.
    #[getter]
    fn code_size(&self) -> Option<usize> {
        Jacobian::of(&*self.0.law).code_size()
    }

    /// The matrix of the derivatives df_i/dy_j at the time t in seconds and the state y.
    fn __call__<'py>(&self, py: Python<'py>, t: f64, y: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let y = self.0.state(y)?;
        let n = self.0.states.len();
        let mut matrix = vec![f64::NAN; n * n];
        Jacobian::of(&*self.0.law).matrix(t, y.as_slice()?, &mut matrix);
        PyArray1::from_vec(py, matrix).reshape([n, n])
    }

    fn __repr__(&self) -> String {
        format!("<Jacobian J(t, y) of {}, y = ({})>", self.0.file, self.0.states.join(", "))
    }
}
