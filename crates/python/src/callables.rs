//! The right-hand side of a model and its Jacobian as objects that Python, SciPy, numba and C can call.

use crate::errors::refused;
use dalembert::integrators::{Jacobian, Ode};
use dalembert::simulation::Law;
use dalembert_native::CFunction;
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1, PyUntypedArrayMethods};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use std::sync::{Arc, OnceLock};

/// A right-hand side, y' = f(t, y), with the names of its states.
#[derive(Clone)]
pub struct NamedLaw {
    pub law: Arc<dyn Law>,
    pub file: String,
    pub states: Vec<String>,
}

impl NamedLaw {
    /// The components of a state, from any object that NumPy converts to an array.
    fn state<'py>(&self, state: &Bound<'py, PyAny>) -> PyResult<PyReadonlyArray1<'py, f64>> {
        let py = state.py();
        let array = match state.cast::<PyArray1<f64>>() {
            Ok(array) if array.is_contiguous() => array.clone(),
            _ => {
                let numpy = py.import("numpy")?;
                if numpy.call_method1("iscomplexobj", (state,))?.is_truthy()? {
                    let why = "a state is real: this one is complex, and derivatives by complex steps are not possible; `jacobian()` is exact";
                    return Err(PyTypeError::new_err(why));
                }
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

/// A right-hand side with its C function, which is compiled at its first use.
pub struct Callable {
    named: NamedLaw,
    entry: OnceLock<Option<CFunction>>,
}

impl From<NamedLaw> for Callable {
    fn from(named: NamedLaw) -> Self {
        Callable { named, entry: OnceLock::new() }
    }
}

impl Callable {
    /// The address of a C function with this number of output values.
    fn address(
        &self,
        py: Python<'_>,
        outputs: usize,
        evaluate: impl Fn(&dyn Law, f64, &[f64], &mut [f64]) + Send + Sync + 'static,
    ) -> PyResult<usize> {
        let NamedLaw { law, file, states } = &self.named;
        let made = self.entry.get_or_init(|| {
            let law = Arc::clone(law);
            CFunction::of([states.len(), outputs], move |t, y, values| evaluate(&*law, t, y, values))
        });
        made.as_ref().map(CFunction::address).ok_or_else(|| {
            let why = "no machine code is made for this processor or system, so that there is no address; the object itself is called from Python";
            refused(py, file, why)
        })
    }
}

/// The right-hand side of the equations of motion: f(t, y) returns y'; y contains the coordinates, then the speeds, in SI units.
#[pyclass(frozen, module = "dalembert")]
pub struct RightHandSide(pub Callable);

#[pymethods]
impl RightHandSide {
    /// The names of the components of y.
    #[getter]
    fn states(&self) -> Vec<String> {
        self.0.named.states.clone()
    }

    /// The size of the machine code with its constants in bytes; None where there is no machine code.
    ///
    /// Where accelerations are solved for at each call, the size is that of the code of the linear equations, without the solver.
    #[getter]
    fn code_size(&self) -> Option<usize> {
        self.0.named.law.code_size()
    }

    /// The address of the C function `void f(double t, const double *y, double *rates)`: t in seconds, y and rates ordered as in `states`.
    ///
    /// Several threads may call it at the same time, without Python's lock, as long as this object exists.
    #[getter]
    fn address(&self, py: Python<'_>) -> PyResult<usize> {
        self.0.address(py, self.0.named.states.len(), |law, t, y, rates| Ode::<f64>::rates(law, t, y, rates))
    }

    /// The time derivative of the state y at the time t in seconds.
    fn __call__<'py>(&self, py: Python<'py>, t: f64, y: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let y = self.0.named.state(y)?;
        let mut rates = vec![f64::NAN; self.0.named.states.len()];
        Ode::<f64>::rates(&*self.0.named.law, t, y.as_slice()?, &mut rates);
        Ok(PyArray1::from_vec(py, rates))
    }

    fn __repr__(&self) -> String {
        format!("<right-hand side f(t, y) of {}, y = ({})>", self.0.named.file, self.0.named.states.join(", "))
    }
}

/// The Jacobian of the right-hand side: J(t, y) returns its exact derivatives with respect to the state.
#[pyclass(frozen, module = "dalembert")]
pub struct JacobianMatrix(pub Callable);

#[pymethods]
impl JacobianMatrix {
    /// The names of the components of y.
    #[getter]
    fn states(&self) -> Vec<String> {
        self.0.named.states.clone()
    }

    /// The size of the machine code with its constants in bytes; None where the right-hand side is differentiated numerically (by dual numbers).
    #[getter]
    fn code_size(&self) -> Option<usize> {
        Jacobian::of(&*self.0.named.law).code_size()
    }

    /// The address of the C function `void jacobian(double t, const double *y, double *matrix)`; the matrix df_i/dy_j is stored by rows.
    ///
    /// Several threads may call it at the same time, without Python's lock, as long as this object exists.
    #[getter]
    fn address(&self, py: Python<'_>) -> PyResult<usize> {
        let size = self.0.named.states.len();
        self.0.address(py, size * size, |law, t, y, matrix| Jacobian::of(law).matrix(t, y, matrix))
    }

    /// The matrix df_i/dy_j at the time t in seconds and the state y.
    fn __call__<'py>(&self, py: Python<'py>, t: f64, y: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let y = self.0.named.state(y)?;
        let n = self.0.named.states.len();
        let mut matrix = vec![f64::NAN; n * n];
        Jacobian::of(&*self.0.named.law).matrix(t, y.as_slice()?, &mut matrix);
        PyArray1::from_vec(py, matrix).reshape([n, n])
    }

    fn __repr__(&self) -> String {
        format!("<Jacobian J(t, y) of {}, y = ({})>", self.0.named.file, self.0.named.states.join(", "))
    }
}
