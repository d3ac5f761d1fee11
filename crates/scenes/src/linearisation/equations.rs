//! Variational equations of a model: values and derivatives of all equations at a point.

use crate::compiled_system::{NotCompiled, has_values_but};
use crate::layout::Layout;
use crate::letters::Letters;
use crate::program::recorded;
use crate::row_units::{coherent, multiplier_unit};
use model::equations::{Equation, Level, constraints_of};
use model::{Coordinate, Model, Trace, Variations, Varied, axes};
use nalgebra::{DMatrix, DVector};
use simulation::Program;
use std::ops::Range;
use symbolic::{Dimension, Sym, substitute_all};

/// A point of a motion: all quantities on which the equations depend, in SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// Time, s.
    pub time: f64,
    /// Coordinates, then the quaternions of free frames.
    pub coordinates: DVector<f64>,
    /// Rates of coordinates, then angular velocities of free frames in their own axes.
    pub speeds: DVector<f64>,
    /// Rates of the speeds.
    pub accelerations: DVector<f64>,
    /// Multipliers in the order of [`VariedEquations::constraints`].
    pub multipliers: DVector<f64>,
    /// Inputs in the order of [`VariedEquations::inputs`].
    pub inputs: DVector<f64>,
    /// For each condition: 1 if it is positive, else 0.
    pub switches: DVector<f64>,
}

/// A scalar constraint equation, with its name and units.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedConstraint {
    /// A constraint of positions or of speeds.
    pub level: Level,
    /// The name in the file, which may be empty.
    pub name: String,
    /// Its number among all constraints of the model, from one.
    pub number: usize,
    /// The axis, such as `F3.x`, if the constraint is a component of a vector equation.
    pub axis: Option<String>,
    /// The unit of its expression.
    pub of: String,
    /// The unit of its multiplier: power per rate of the constraint.
    pub unit: String,
    /// True if the constraint is stabilised by gains and not enforced exactly.
    pub is_programmed: bool,
    /// True if it is the equation of motion of a coordinate without inertia. Inputs may appear in it.
    pub is_law: bool,
    /// The byte range in the file.
    pub at: Range<usize>,
}

impl NamedConstraint {
    /// The name in messages, such as: constraint 2 `loop` along F3.x.
    pub fn title(&self) -> String {
        let name = if self.name.is_empty() { String::new() } else { format!(" `{}`", self.name) };
        format!("constraint {}{name}{}", self.number, self.along())
    }

    /// The name of its multiplier, such as: lambda2 loop along F3.x.
    pub fn multiplier(&self) -> String {
        let name = if self.name.is_empty() { String::new() } else { format!(" {}", self.name) };
        format!("lambda{}{name}{}", self.number, self.along())
    }

    fn along(&self) -> String {
        self.axis.as_ref().map_or_else(String::new, |axis| format!(" along {axis}"))
    }
}

/// Values of equations and their derivatives; each row is an equation. Units are those of the equations in SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Values {
    /// The residuals, or the values of outputs.
    pub values: DVector<f64>,
    /// Derivatives by a displacement along each speed: of its coordinate, or by a small rotation about an axis of a free frame.
    pub by_coordinates: DMatrix<f64>,
    /// Derivatives with respect to the speeds.
    pub by_speeds: DMatrix<f64>,
    /// Derivatives by the accelerations.
    pub by_accelerations: DMatrix<f64>,
    /// Derivatives by the multipliers.
    pub by_multipliers: DMatrix<f64>,
    /// Derivatives by the inputs.
    pub by_inputs: DMatrix<f64>,
    /// Partial derivatives with respect to the time.
    pub by_time: DVector<f64>,
}

/// All equations at a point.
#[derive(Clone, Debug, PartialEq)]
pub struct At {
    /// The equations of motion M z + h - Q - J^T lambda.
    pub motion: Values,
    /// f of every constraint.
    pub zero: Values,
    /// df/dt of position constraints, f of constraints of speeds.
    pub rate: Values,
    /// The next time derivative J z + c.
    pub acceleration: Values,
    /// The outputs of the model.
    pub outputs: Values,
}

/// The compiled equations of a model with their derivatives.
#[derive(Debug)]
pub struct VariedEquations {
    program: Program,
    /// The program for the inputs, then the conditions, as functions of all components of a point.
    outside: Program,
    /// The numbers of speeds, constraints, inputs, outputs and conditions.
    pub(super) sizes: [usize; 5],
    pub(super) layout: Layout,
    /// The constraints: position constraints, then constraints of speeds, then stabilised constraints.
    pub constraints: Vec<NamedConstraint>,
    /// Names of the inputs: parameters, then inputs of the model.
    pub inputs: Vec<String>,
    /// Indices of the coordinates that are charges.
    pub charges: Vec<usize>,
    /// Names of inputs of the model whose values depend on coordinates or speeds. The derivatives with respect to the state do not include this
    /// feedback.
    pub feedback: Vec<String>,
    /// For each input: true if the equations of motion are not linear in it.
    pub nonlinear: Vec<bool>,
}

impl VariedEquations {
    /// The equations of a model with the parameters of these indices, and all inputs of the model, as inputs.
    ///
    /// # Errors
    /// A parameter has no value, the model has contacts, or an expression has no value.
    pub fn of(model: &Model, parameters: &[usize]) -> Result<Self, NotCompiled> {
        let all: Vec<usize> = (0..model.inputs.len()).collect();
        VariedEquations::with_inputs(model, parameters, &all)
    }

    /// The equations of a model with the parameters and the model inputs of these indices as inputs. Other inputs are replaced by their
    /// values, whose derivatives are included.
    ///
    /// # Errors
    /// A parameter has no value, the model has contacts, or an expression has no value.
    pub fn with_inputs(model: &Model, parameters: &[usize], inputs: &[usize]) -> Result<Self, NotCompiled> {
        has_values_but(model, parameters)?;
        if !model.contacts.is_empty() {
            return Err(NotCompiled::Changes);
        }
        let model = &*model.with_changing_laws();
        let (open, own) = opened(model, inputs);
        let open = &open;
        let (n, layout) = (model.speeds(), Layout::of(model));
        let known: Vec<NamedConstraint> = symbolic::apart(|| {
            let trace = Trace::of(open);
            let known = |(place, (each, axis)): (usize, (Equation, Option<String>))| NamedConstraint {
                level: each.level,
                number: place + 1,
                axis,
                of: coherent(&model.constraints[each.of[0]].dimension.to_string()),
                unit: multiplier_unit(model, &each),
                is_programmed: each.gains.is_some(),
                is_law: each.law.is_some() && each.level == Level::Speed,
                name: each.name,
                at: each.at,
            };
            constraints_of(&trace).into_iter().zip(axes(&trace)).enumerate().map(known).collect()
        });
        let (m, switches) = (known.len(), model.switches.len());
        let mut order: Vec<usize> = (0..m).collect();
        order.sort_by_key(|&k| (known[k].is_programmed, known[k].level != Level::Position));
        let parameter_names = parameters.iter().map(|&place| model.parameters[place].name.clone());
        let inputs: Vec<String> =
            parameter_names.chain(own.iter().map(|&place| model.inputs[place].name.clone())).collect();
        let length = layout.positions() + 2 * n + m + inputs.len() + switches;
        let mut nonlinear = Vec::new();
        let program = recorded(length, |time, state| {
            let trace = Trace::of(open);
            let letters: Vec<Sym> = inputs.iter().map(|name| Sym::symbol(name)).collect();
            let varied = Variations::of(&trace, &letters);
            let holds_input = |slope: &Sym| slope.symbols_of().iter().any(|symbol| letters.contains(symbol));
            let is_nonlinear = |column: usize| varied.motion.by_inputs.iter().any(|row| holds_input(&row[column]));
            nonlinear = (0..inputs.len()).map(is_nonlinear).collect();
            let everything: Vec<usize> = (0..n).collect();
            let shown: Vec<usize> = (0..model.outputs.len()).collect();
            let mut all = Vec::new();
            flatten(&varied.motion, &everything, &order, &mut all);
            for part in [&varied.zero, &varied.rate, &varied.acceleration] {
                flatten(part, &order, &order, &mut all);
            }
            flatten(&varied.outputs, &shown, &order, &mut all);
            let multipliers: Vec<Sym> = order.iter().map(|&k| varied.multipliers[k]).collect();
            substitute_all(&all, &letters_of(&trace, &multipliers, &letters, time, state))
        });
        let outside = recorded(length, |time, state| {
            // inputs as functions of the state; conditions as functions of the inputs
            let (trace, closed) = (Trace::of(open), Trace::of(model));
            let letters: Vec<Sym> = inputs.iter().map(|name| Sym::symbol(name)).collect();
            let held = constraints_of(&trace);
            let multipliers: Vec<Sym> = order.iter().map(|&k| held[k].multiplier).collect();
            let data = parameters.iter().map(|&place| {
                let value = model.parameters[place].value.unwrap_or(0.0);
                Sym::constant(field::Rational::exactly(value))
            });
            let given =
                own.iter().map(|&place| model.inputs[place].value.map_or(Sym::ZERO, |value| closed.scalar(value)));
            let conditions = model.switches.iter().map(|&condition| trace.scalar(condition));
            let all: Vec<Sym> = data.chain(given).chain(conditions).collect();
            let mut known = letters_of(&trace, &multipliers, &letters, time, state);
            // with substituted inputs, a condition that depends on an input has another symbol
            known.extend(closed.switches.iter().copied().zip(state[length - switches..].iter().copied()));
            substitute_all(&all, &known)
        });
        Ok(VariedEquations {
            program: program?,
            outside: outside?,
            sizes: [n, m, inputs.len(), model.outputs.len(), switches],
            layout,
            constraints: order.iter().map(|&k| known[k].clone()).collect(),
            charges: charges(model),
            feedback: feedback(model, &own),
            inputs,
            nonlinear,
        })
    }

    pub(super) fn program(&self) -> &Program {
        &self.program
    }

    /// The number of position constraints without stabilisation, which are first in the list.
    pub fn positions(&self) -> usize {
        self.constraints.iter().filter(|known| known.level == Level::Position && !known.is_programmed).count()
    }

    /// The number of constraints without stabilisation, which precede the stabilised constraints.
    pub fn kept(&self) -> usize {
        self.constraints.iter().filter(|known| !known.is_programmed).count()
    }

    /// The point at a time (s) and a state, with its inputs and conditions, and with zero accelerations and multipliers.
    pub fn point(&self, time: f64, state: &[f64]) -> Point {
        let [n, m, k, _, s] = self.sizes;
        let (coordinates, speeds) = state.split_at(self.layout.positions());
        let mut point = Point {
            time,
            coordinates: DVector::from_column_slice(coordinates),
            speeds: DVector::from_column_slice(speeds),
            accelerations: DVector::zeros(n),
            multipliers: DVector::zeros(m),
            inputs: DVector::zeros(k),
            switches: DVector::zeros(s),
        };
        self.choose(&mut point);
        point
    }

    /// Sets inputs and conditions of a point to their values at this point.
    pub fn choose(&self, point: &mut Point) {
        let [_, _, k, _, s] = self.sizes;
        // inputs may depend on conditions, and conditions on earlier conditions
        for _ in 0..=s + 1 {
            let numbers = self.conditions(point);
            point.inputs = DVector::from_column_slice(&numbers[..k]);
            let chosen = numbers[k..].iter().map(|value| if *value > 0.0 { 1.0 } else { 0.0 });
            point.switches = DVector::from_iterator(s, chosen);
        }
    }

    /// The inputs at a point, then the values of conditions.
    pub(super) fn conditions(&self, point: &Point) -> Vec<f64> {
        let [_, _, k, _, s] = self.sizes;
        let mut numbers = vec![f64::NAN; k + s];
        self.outside.run(point.time, &flat(point), &mut numbers);
        numbers
    }

    /// All equations with their derivatives at a point.
    pub fn at(&self, point: &Point) -> At {
        let [n, m, k, shown, _] = self.sizes;
        let width = 2 + 3 * n + m + k;
        let mut numbers = vec![f64::NAN; (n + 3 * m + shown) * width];
        self.program.run(point.time, &flat(point), &mut numbers);
        let mut rest = &numbers[..];
        let mut next = |rows: usize| {
            let (own, behind) = rest.split_at(rows * width);
            rest = behind;
            let block = |first: usize, columns: usize| {
                DMatrix::from_fn(rows, columns, |row, column| own[row * width + first + column])
            };
            Values {
                values: DVector::from_fn(rows, |row, _| own[row * width]),
                by_coordinates: block(1, n),
                by_speeds: block(1 + n, n),
                by_accelerations: block(1 + 2 * n, n),
                by_multipliers: block(1 + 3 * n, m),
                by_inputs: block(1 + 3 * n + m, k),
                by_time: DVector::from_fn(rows, |row, _| own[row * width + width - 1]),
            }
        };
        At { motion: next(n), zero: next(m), rate: next(m), acceleration: next(m), outputs: next(shown) }
    }
}

/// The indices of the coordinates whose rates are currents.
fn charges(model: &Model) -> Vec<usize> {
    let charge = Dimension::current() * Dimension::time();
    let is_charge = |(place, one): (usize, &Coordinate)| (one.dimension == charge).then_some(place);
    model.coordinates.iter().enumerate().filter_map(is_charge).collect()
}

/// The model with some of the inputs `among` as symbols, and the indices of these. An input that appears in a constraint keeps its value,
/// since the constraint also contains its rates; in the law of a coordinate without inertia it needs no rates.
fn opened(model: &Model, among: &[usize]) -> (Model, Vec<usize>) {
    let mut open = model.clone();
    among.iter().for_each(|&place| open.inputs[place].value = None);
    let own: Vec<usize> = symbolic::apart(|| {
        let is_led = |one: &Equation| one.law.is_none() || one.level == Level::Position;
        let held = constraints_of(&Trace::of(&open)).into_iter().filter(is_led);
        let used: Vec<Sym> = held.flat_map(|each| [each.zero, each.bias]).flat_map(Sym::symbols_of).collect();
        let is_free = |place: &usize| !used.contains(&Sym::symbol(&model.inputs[*place].name));
        among.iter().copied().filter(is_free).collect()
    });
    for (place, input) in open.inputs.iter_mut().enumerate().filter(|(place, _)| !own.contains(place)) {
        input.value = model.inputs[place].value;
    }
    (open, own)
}

/// The names of the inputs whose values depend on coordinates or speeds, directly or by conditions.
fn feedback(model: &Model, own: &[usize]) -> Vec<String> {
    symbolic::apart(|| {
        let trace = Trace::of(model);
        let mut moving: Vec<Sym> = [&trace.coordinates[..], &trace.speeds].concat();
        // later conditions may contain earlier ones
        for (letter, condition) in trace.switches.iter().zip(&model.switches) {
            if trace.scalar(*condition).symbols_of().iter().any(|symbol| moving.contains(symbol)) {
                moving.push(*letter);
            }
        }
        // a zero gain is no feedback
        let zero = trace.parameters.iter().zip(&model.parameters).filter(|(_, parameter)| parameter.value == Some(0.0));
        let zero: Vec<(Sym, Sym)> = zero.map(|(letter, _)| (*letter, Sym::ZERO)).collect();
        let depends = |place: &&usize| {
            let value = model.inputs[**place].value.map_or(Sym::ZERO, |value| trace.scalar(value).substitute(&zero));
            value.symbols_of().iter().any(|symbol| moving.contains(symbol))
        };
        own.iter().filter(depends).map(|&place| model.inputs[place].name.clone()).collect()
    })
}

/// All components of a point in the order of the programs' inputs.
fn flat(point: &Point) -> Vec<f64> {
    let Point { coordinates, speeds, accelerations, multipliers, inputs, switches, .. } = point;
    let parts = [coordinates, speeds, accelerations, multipliers, inputs, switches];
    parts.into_iter().flat_map(|part| part.iter().copied()).collect()
}

/// Substitutions: symbols of a trace by inputs of a program, parameters by decimals.
fn letters_of(trace: &Trace<'_>, multipliers: &[Sym], inputs: &[Sym], time: Sym, state: &[Sym]) -> Vec<(Sym, Sym)> {
    let moving = trace.coordinates.len() + trace.speeds.len();
    let mut known = Letters::with_decimals(time, &state[..moving]).known(trace);
    known.retain(|(letter, _)| !inputs.contains(letter));
    let others = trace.accelerations.iter().chain(multipliers).chain(inputs).chain(&trace.switches);
    known.extend(others.copied().zip(state[moving..].iter().copied()));
    known
}

/// Appends row after row: the value, then its derivatives.
fn flatten(varied: &Varied, rows: &[usize], multipliers: &[usize], all: &mut Vec<Sym>) {
    for &row in rows {
        all.push(varied.values[row]);
        all.extend_from_slice(&varied.by_coordinates[row]);
        all.extend_from_slice(&varied.by_speeds[row]);
        all.extend_from_slice(&varied.by_accelerations[row]);
        all.extend(multipliers.iter().map(|&k| varied.by_multipliers[row][k]));
        all.extend_from_slice(&varied.by_inputs[row]);
        all.push(varied.by_time[row]);
    }
}
