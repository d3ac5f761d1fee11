//! A model in numbers: consistent states, motions, and values of expressions.

use super::numbers::{Drawn, dot, solved, unit};
use dalembert_model::equations::{Equation, Level, constraints_of};
use dalembert_model::principles::Principle;
use dalembert_model::{FrameId, Model, PointId, Trace, Vector};
use std::cell::RefCell;
use symbolic::{Sym, Tape, substitute_all};

/// Time, coordinates and speeds.
#[derive(Clone, Debug)]
pub struct State {
    pub time: f64,
    pub q: Vec<f64>,
    pub u: Vec<f64>,
}

/// Runge-Kutta steps of [`System::later`].
const STEPS: usize = 3;

/// Bound of accelerations and multipliers: above it a state is nearly singular and difference quotients are inaccurate.
const MOST: f64 = 60.0;

/// Expressions recorded as one tape, and their number.
pub struct Numbers(Tape, usize);

pub struct System<'t, 'm> {
    pub trace: &'t Trace<'m>,
    pub constraints: Vec<Equation>,
    letters: Vec<Sym>,
    constants: Vec<f64>,
    switches: RefCell<Vec<f64>>,
    pub places: Numbers,
    residual: Numbers,
    held: Numbers,
}

impl<'t, 'm> System<'t, 'm> {
    /// Returns the system with parameters that differ randomly from those of the text by up to 20 %.
    pub fn of(trace: &'t Trace<'m>, drawn: &mut Drawn) -> Self {
        let model = trace.model;
        let open: Vec<Sym> =
            model.inputs.iter().filter(|input| input.value.is_none()).map(|input| Sym::symbol(&input.name)).collect();
        let constraints = constraints_of(trace);
        let multipliers = constraints.iter().map(|one| one.multiplier);
        let letters: Vec<Sym> = (trace.parameters.iter().chain([&trace.pi]).chain(&open).copied())
            .chain([trace.time])
            .chain(trace.coordinates.iter().chain(&trace.speeds).chain(&trace.accelerations).copied())
            .chain(multipliers)
            .chain(trace.switches.iter().copied())
            .collect();
        let values = model.parameters.iter().map(|one| one.value.unwrap_or(1.0) * (1.0 + 0.2 * drawn.number()));
        let mut constants: Vec<f64> = values.chain([std::f64::consts::PI]).collect();
        constants.extend(open.iter().map(|_| drawn.number()));
        let numbers = |wanted: &[Sym]| Numbers::of(trace, &letters, wanted);
        let ground = |vector: Vector| trace.express(vector, FrameId::GROUND);
        let points = (0..model.points.len()).flat_map(|point| ground(trace.position(PointId(point))));
        let frames =
            (0..model.frames.len()).flat_map(|frame| (0..3).map(move |axis| Vector::axis(FrameId(frame), axis)));
        let places = numbers(&points.chain(frames.flat_map(ground)).collect::<Vec<_>>());
        let principle = if model.energies.kinetic.is_some() { Principle::Lagrange } else { Principle::VirtualPower };
        let residual = numbers(&principle.residual(trace).expect("it applies"));
        let held = constraints.iter().flat_map(|one| {
            [one.zero, one.rate, one.bias].into_iter().chain(one.row.iter().copied()).collect::<Vec<_>>()
        });
        let held = numbers(&held.collect::<Vec<_>>());
        let switches = RefCell::new(vec![0.0; model.switches.len()]);
        System { trace, constraints, letters, constants, switches, places, residual, held }
    }

    pub fn model(&self) -> &'m Model {
        self.trace.model
    }

    pub fn numbers(&self, wanted: &[Sym]) -> Numbers {
        Numbers::of(self.trace, &self.letters, wanted)
    }

    /// Returns values of expressions at a state with given accelerations and multipliers (missing ones are zero). The truth values of
    /// conditions are those of the state drawn last.
    pub fn at(&self, wanted: &Numbers, state: &State, solved: &[f64]) -> Vec<f64> {
        let mut inputs = self.constants.clone();
        inputs.push(state.time);
        inputs.extend(state.q.iter().chain(&state.u));
        let n = state.u.len() + self.constraints.len();
        inputs.extend((0..n).map(|k| solved.get(k).copied().unwrap_or(0.0)));
        inputs.extend(self.switches.borrow().iter());
        let mut outputs = vec![0.0; wanted.1];
        wanted.0.over::<f64>().evaluate(&inputs, &mut outputs);
        outputs
    }

    /// Returns the value of a symbol; `lambda1` is the first multiplier.
    pub fn letter(&self, name: &str, state: &State, solved: &[f64]) -> f64 {
        if let Some(number) = name.strip_prefix("lambda").and_then(|number| number.parse::<usize>().ok()) {
            return solved[state.u.len() + number - 1];
        }
        let known = self.letters.iter().find(|letter| letter.to_string() == name);
        let letter = known.unwrap_or_else(|| panic!("`{name}` is no letter of the system"));
        self.at(&self.numbers(&[*letter]), state, solved)[0]
    }

    /// Returns the state after one step of the classical Runge-Kutta method. `time_runs` is false for displacements at constant time.
    fn stepped(
        &self,
        state: &State,
        length: f64,
        accelerations: &dyn Fn(&State) -> Vec<f64>,
        time_runs: bool,
    ) -> State {
        let rates = |at: &State| {
            let mut rates = vec![0.0; at.q.len()];
            self.model().position_rates(&[&at.q[..], &at.u[..]].concat(), &mut rates);
            [rates, accelerations(at)].concat()
        };
        let later = |rates: &[f64], part: f64| {
            let step = |(value, rate): (&f64, &f64)| value + part * length * rate;
            let (of_q, of_u) = rates.split_at(state.q.len());
            State {
                time: state.time + if time_runs { part * length } else { 0.0 },
                q: state.q.iter().zip(of_q).map(step).collect(),
                u: state.u.iter().zip(of_u).map(step).collect(),
            }
        };
        let first = rates(state);
        let second = rates(&later(&first, 0.5));
        let third = rates(&later(&second, 0.5));
        let fourth = rates(&later(&third, 1.0));
        let mean = |k: usize| (first[k] + 2.0 * (second[k] + third[k]) + fourth[k]) / 6.0;
        later(&(0..first.len()).map(mean).collect::<Vec<f64>>(), 1.0)
    }

    /// Returns the state after a duration with constant accelerations.
    pub fn moved(&self, state: &State, accelerations: &[f64], length: f64) -> State {
        self.stepped(state, length, &|_| accelerations.to_vec(), true)
    }

    /// Returns the state after a duration of the motion.
    pub fn later(&self, state: &State, length: f64) -> State {
        let accelerations = |at: &State| self.motion(at).0[..at.u.len()].to_vec();
        (0..STEPS).fold(state.clone(), |at, _| self.stepped(&at, length / STEPS as f64, &accelerations, true))
    }

    /// Returns the state displaced along a direction of speeds at constant time; its speeds are unchanged.
    pub fn displaced(&self, state: &State, along: &[f64], length: f64) -> State {
        let start = State { u: along.to_vec(), ..state.clone() };
        let end = self.stepped(&start, length, &|at| vec![0.0; at.u.len()], false);
        State { u: state.u.clone(), ..end }
    }

    /// Draws a state and projects it on all constraints without stabilisation. Returns `None` without convergence or near a singular state.
    pub fn drawn(&self, drawn: &mut Drawn) -> Option<State> {
        let numbers = |count: usize, drawn: &mut Drawn| (0..count).map(|_| 1.2 * drawn.number()).collect::<Vec<f64>>();
        let time = 0.7 + 0.5 * drawn.number();
        let (q, u) = (numbers(self.trace.coordinates.len(), drawn), numbers(self.trace.speeds.len(), drawn));
        let mut state = State { time, q, u };
        let n = state.u.len();
        for _ in 0..40 {
            let positions = self.violated(&state, |one| (one.level == Level::Position).then_some(0));
            let (step, _) = solved(&positions.0, &positions.1);
            state = self.displaced(&state, &step, 1.0);
            let speeds = self.violated(&state, |_| Some(1));
            let (step, _) = solved(&speeds.0, &speeds.1);
            state.u.iter_mut().zip(&step).for_each(|(speed, step)| *speed += step);
            let open = |(_, right): (Vec<Vec<f64>>, Vec<f64>)| right.iter().all(|value| value.abs() < 1e-11);
            let is_near = state.q.iter().chain(&state.u).all(|value| value.abs() < 20.0);
            if is_near
                && open(self.violated(&state, |one| (one.level == Level::Position).then_some(0)))
                && open(self.violated(&state, |_| Some(1)))
            {
                self.choose(&state);
                let (solved, pivots) = self.motion(&state);
                let is_met = self.kept(&state, &solved[..n]).iter().all(|rate| rate.abs() < 1e-9);
                let is_regular = pivots >= n && is_met && solved.iter().all(|value| value.abs() < MOST);
                return is_regular.then_some(state);
            }
        }
        None
    }

    /// Returns rows and right sides of linearised constraints without stabilisation; the residual is f (0) or f' (1), by `place`.
    fn violated(&self, state: &State, place: impl Fn(&Equation) -> Option<usize>) -> (Vec<Vec<f64>>, Vec<f64>) {
        let n = state.u.len();
        let values = self.at(&self.held, state, &[]);
        let (mut rows, mut right) = (vec![vec![0.0; n]], vec![0.0]);
        for (constraint, values) in self.constraints.iter().zip(values.chunks(n + 3)) {
            if let (None, Some(place)) = (&constraint.gains, place(constraint)) {
                rows.push(values[3..].to_vec());
                right.push(-values[place]);
            }
        }
        (rows, right)
    }

    /// Returns rows and rates of all constraints.
    pub fn rates(&self, state: &State) -> (Vec<Vec<f64>>, Vec<f64>) {
        let values = self.at(&self.held, state, &[]);
        values.chunks(state.u.len() + 3).map(|values| (values[3..].to_vec(), values[1])).unzip()
    }

    /// Sets the truth values of all conditions at a state; a nested condition precedes the condition that contains it.
    fn choose(&self, state: &State) {
        let conditions: Vec<Sym> =
            self.model().switches.iter().map(|&condition| self.trace.scalar(condition)).collect();
        for (place, condition) in conditions.iter().enumerate() {
            let value = self.at(&self.numbers(&[*condition]), state, &[])[0];
            self.switches.borrow_mut()[place] = if value > 0.0 { 1.0 } else { 0.0 };
        }
    }

    /// Returns J u' + c of all constraints for given accelerations.
    pub fn kept(&self, state: &State, accelerations: &[f64]) -> Vec<f64> {
        let values = self.at(&self.held, state, &[]);
        values.chunks(state.u.len() + 3).map(|values| values[2] + dot(&values[3..], accelerations)).collect()
    }

    /// Solves M u' + h = J^T lambda, J u' + c = 0 for the accelerations and multipliers; returns the solution and the rank of the system.
    pub fn motion(&self, state: &State) -> (Vec<f64>, usize) {
        let (n, k) = (state.u.len(), self.constraints.len());
        let bias = self.at(&self.residual, state, &[]);
        let held = self.at(&self.held, state, &[]);
        let columns: Vec<Vec<f64>> = (0..n)
            .map(|j| {
                self.at(&self.residual, state, &unit(n, j))
                    .iter()
                    .zip(&bias)
                    .map(|(value, bias)| value - bias)
                    .collect()
            })
            .collect();
        let rows: Vec<&[f64]> = held.chunks(n + 3).map(|values| &values[3..]).collect();
        let of_motion = (0..n).map(|i| {
            let inertia = columns.iter().map(|column| column[i]);
            inertia.chain(rows.iter().map(|row| -row[i])).collect::<Vec<f64>>()
        });
        let of_constraints = rows.iter().map(|row| [row, &vec![0.0; k][..]].concat());
        let matrix: Vec<Vec<f64>> = of_motion.chain(of_constraints).collect();
        let right = bias.iter().copied().chain(held.chunks(n + 3).map(|values| values[2]));
        let right: Vec<f64> = right.map(|rest| -rest).collect();
        solved(&matrix, &right)
    }
}

impl Numbers {
    fn of(trace: &Trace<'_>, letters: &[Sym], wanted: &[Sym]) -> Self {
        let wanted = substitute_all(wanted, &trace.solid());
        Numbers(Tape::record(letters, &wanted).expect("it has values"), wanted.len())
    }
}
