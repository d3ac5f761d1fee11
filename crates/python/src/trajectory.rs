//! The results of a run, as objects of Python.

use dalembert::integrators::{Lost, StepHalvingCheck as StepHalving};
use dalembert::simulation::events::Passage;
use dalembert::simulation::{RunFailure, RunNotes, Trajectory};
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// The numbers and the facts of a run; the class Trajectory of the Python package presents them.
#[pyclass(frozen, module = "dalembert._native")]
pub struct NativeTrajectory {
    #[pyo3(get)]
    time: Py<PyArray1<f64>>,
    /// The values of all columns, one row for each time.
    #[pyo3(get)]
    rows: Py<PyArray2<f64>>,
    #[pyo3(get)]
    names: Vec<String>,
    #[pyo3(get)]
    units: Vec<String>,
    #[pyo3(get)]
    method: String,
    #[pyo3(get)]
    tolerance: f64,
    /// The number of leading columns that form the state.
    #[pyo3(get)]
    states: usize,
    trajectory: Trajectory,
    told: RunNotes,
    beside: Option<StepHalving>,
}

/// The facts of a run in addition to its trajectory.
pub struct Beside {
    pub units: Vec<String>,
    pub method: String,
    pub tolerance: f64,
    pub states: usize,
    pub told: RunNotes,
    /// For a method with constant steps: the comparison with a run with half the step size.
    pub steps: Option<StepHalving>,
}

impl NativeTrajectory {
    /// Converts a trajectory; its rows become one array.
    pub fn of(py: Python<'_>, mut trajectory: Trajectory, beside: Beside) -> PyResult<Self> {
        let Beside { units, method, tolerance, states, told, steps } = beside;
        let columns = trajectory.names.len();
        let mut rows = std::mem::take(&mut trajectory.rows);
        let mut times = std::mem::take(&mut trajectory.times);
        // the instant at which a run stopped is a row too
        if times.last().is_none_or(|last| *last < trajectory.outcome.time) {
            times.push(trajectory.outcome.time);
            rows.push(trajectory.last.clone());
        }
        let count = rows.len();
        let rows = PyArray1::from_vec(py, rows.concat()).reshape([count, columns])?;
        Ok(NativeTrajectory {
            time: PyArray1::from_vec(py, times).unbind(),
            rows: rows.unbind(),
            names: trajectory.names.clone(),
            units,
            method,
            tolerance,
            states,
            trajectory,
            told,
            beside: steps,
        })
    }
}

#[pymethods]
impl NativeTrajectory {
    /// The reason for which the run stopped before its end; None where it reached the end.
    #[getter]
    fn stopped(&self) -> Option<String> {
        self.trajectory.stopped()
    }

    /// Sentences with results of theory on the run.
    #[getter]
    fn theory(&self) -> Vec<String> {
        self.told.theory.clone()
    }

    /// The reason of an early end, where it is known.
    #[getter]
    fn diagnosis(&self) -> Option<String> {
        self.told.diagnosis.clone()
    }

    /// Failures: name, time in seconds, evidence, remedy.
    #[getter]
    fn failures(&self) -> Vec<(&'static str, f64, String, String)> {
        let told =
            |failure: &RunFailure| (failure.kind.name(), failure.at, failure.evidence.clone(), failure.remedy.clone());
        self.told.failures.iter().map(told).collect()
    }

    /// The conserved quantity that the run did not conserve, with the time of the deviation and the magnitude to which it is compared.
    #[getter]
    fn lost(&self) -> Option<(String, f64, f64)> {
        self.trajectory.lost().map(|(own, Lost { at, size })| (own.name.clone(), at, size))
    }

    /// For a method with constant steps: the verdict of the comparison with half the step size, and whether the run follows the motion.
    #[getter]
    fn steps(&self) -> Option<(String, bool)> {
        self.beside.as_ref().map(|beside| (beside.to_string(), beside.verdict.serves()))
    }

    /// Quantities that should stay zero, by their names, with a value for each sample.
    #[getter]
    fn checks<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let all = PyDict::new(py);
        for (place, name) in self.trajectory.checks.iter().enumerate() {
            let values = self.trajectory.checked.iter().map(|row| row[place]).collect();
            all.set_item(name, PyArray1::from_vec(py, values))?;
        }
        Ok(all)
    }

    /// The names of columns without a value at the end.
    #[getter]
    fn undefined(&self) -> Vec<String> {
        self.trajectory.undefined().into_iter().map(str::to_owned).collect()
    }

    /// Conserved quantities by their names: the first value and the largest change.
    #[getter]
    fn invariants<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let all = PyDict::new(py);
        for deviation in &self.trajectory.outcome.deviations {
            all.set_item(&deviation.name, (deviation.first, deviation.largest))?;
        }
        Ok(all)
    }

    /// Events: time in seconds, description, the law after the event.
    #[getter]
    fn events(&self) -> Vec<(f64, String, Option<String>)> {
        let event = |Passage { time, what, then, .. }: &Passage| (*time, what.clone(), then.clone());
        self.trajectory.passages.iter().map(event).collect()
    }

    /// The numbers of evaluations, Jacobians, factorisations, steps and rejected steps.
    #[getter]
    fn work<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let work = &self.trajectory.outcome.work;
        let all = PyDict::new(py);
        all.set_item("evaluations", work.rates)?;
        all.set_item("jacobians", work.jacobians)?;
        all.set_item("factorisations", work.factorisations)?;
        all.set_item("steps", work.steps)?;
        all.set_item("rejected", work.rejected)?;
        Ok(all)
    }
}
