//! Linear equations of a model about a point.

use crate::errors::{issue, refused};
use crate::interruptible::interruptible;
use dalembert::scenes::linearisation::{Linear, Names, VariedEquations, inputs_of, point_of};
use dalembert::scenes::{SystemText, Task, without_law};
use numpy::{Complex64, PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// The linear equations x' = A x + B w, y = C x + D w about a point of a model, with the names of x, w and y.
#[pyclass(frozen, module = "dalembert")]
pub struct LinearEquations {
    found: Linear,
    names: Names,
}

impl LinearEquations {
    /// Linearises the system of a text about its start, or about an equilibrium near it.
    pub fn of(py: Python<'_>, text: &SystemText, equilibrium: bool, inputs: &[String]) -> PyResult<Self> {
        let mut model = text.model(Task::Vary).map_err(|error| crate::errors::scene_error(py, &error))?;
        let place = |found: dalembert::reader::Issue| issue(py, (&text.name, &text.text), found);
        model.close_inputs();
        let inputs = inputs_of(&mut model, inputs).map_err(|why| refused(py, &text.name, why))?;
        let found = interruptible(py, move || {
            let ((time, state), choice) = point_of(&mut model, equilibrium)?;
            if let Some(choice) = choice {
                crate::warn(&choice);
            }
            let equations = VariedEquations::of(&model, &inputs);
            let equations = equations.map_err(|why| without_law(&model, &why, "there are no linear equations"))?;
            let found = equations.about(time, &state).map_err(|why| why.at(&model, time))?;
            Ok(LinearEquations { found, names: Names::of(&model, &equations) })
        })?;
        found.map_err(place)
    }

    fn matrix<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let linear = &self.found.linear;
        let matrix = match name {
            "A" => &linear.a,
            "B" => &linear.b,
            "C" => &linear.c,
            _ => &linear.d,
        };
        let (rows, columns) = matrix.shape();
        let entries = (0..rows).flat_map(|i| (0..columns).map(move |j| matrix[(i, j)])).collect();
        PyArray1::from_vec(py, entries).reshape([rows, columns])
    }
}

#[pymethods]
impl LinearEquations {
    /// The matrix A, the derivatives of x' by x.
    #[getter]
    #[pyo3(name = "A")]
    fn a<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.matrix(py, "A")
    }

    /// The matrix B, the derivatives of x' by the inputs w.
    #[getter]
    #[pyo3(name = "B")]
    fn b<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.matrix(py, "B")
    }

    /// The matrix C, the derivatives of the outputs y by x.
    #[getter]
    #[pyo3(name = "C")]
    fn c<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.matrix(py, "C")
    }

    /// The matrix D, the derivatives of the outputs y by the inputs w.
    #[getter]
    #[pyo3(name = "D")]
    fn d<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.matrix(py, "D")
    }

    /// The eigenvalues of A, in 1/s.
    #[getter]
    fn eigenvalues<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<Complex64>> {
        let values = self.found.eigenvalues.iter().map(|[re, im]| Complex64::new(*re, *im)).collect();
        PyArray1::from_vec(py, values)
    }

    /// The verdict on stability by the eigenvalues, as a sentence.
    #[getter]
    fn stability(&self) -> String {
        self.found.stability.to_string()
    }

    /// The names of the components of x: independent variations of coordinates, then of speeds.
    #[getter]
    fn states(&self) -> Vec<String> {
        self.names.states(&self.found.linear)
    }

    /// The names of the components of w.
    #[getter]
    fn inputs(&self) -> Vec<String> {
        self.names.inputs.clone()
    }

    /// The names of the components of y.
    #[getter]
    fn outputs(&self) -> Vec<String> {
        self.names.outputs.clone()
    }

    /// The coordinates and speeds of the point by their names, in SI units.
    #[getter]
    fn point<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let point = &self.found.linear.point;
        let names = self.names.coordinates.iter().chain(&self.names.speeds);
        let all = PyDict::new(py);
        for (name, value) in names.zip(point.coordinates.iter().chain(point.speeds.iter())) {
            all.set_item(name, value)?;
        }
        Ok(all)
    }

    fn __repr__(&self) -> String {
        let names = [self.states(), self.inputs(), self.outputs()].map(|names| names.join(", "));
        let [states, inputs, outputs] = names;
        format!(
            "x' = A x + B w, y = C x + D w with x = ({states}), w = ({inputs}), y = ({outputs}); {}",
            self.stability()
        )
    }
}
