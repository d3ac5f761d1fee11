//! The constraints of a model and their derivatives, compiled for the completion of starts and for the monitoring of runs.

use super::{MET, Open, RANK, ROUNDED, Unmet};
use crate::compiled_system::NotCompiled;
use crate::layout::Layout;
use crate::letters::Inputs;
use crate::row_units::{coherent, rate_unit};
use model::equations::{Equation, Equations, Level};
use model::{Model, Trace, titles};
use nalgebra::{DMatrix, DVector};
use std::ops::Range;
use symbolic::{Sym, Tape, apart};

/// The constraints of a model and the quasi-velocities given at the start, with their derivatives.
#[derive(Debug)]
pub(super) struct Constraints {
    /// Computes from state, parameters, quasi-velocities of the start and time: the residuals, the rates of the residuals, and the derivatives
    /// of these rates by the speeds.
    pub tape: Tape,
    /// The equations in the order of the residuals; constraints of positions come first.
    pub known: Vec<Known>,
    /// The number of enforced constraints, which come first.
    pub kept: usize,
    /// The number of quasi-velocities that the start gives, which come next. Stabilised constraints come last; they need not hold at the start.
    pub started: usize,
    pub layout: Layout,
    /// The names of coordinates and speeds, in the order of the state.
    pub names: Vec<String>,
}

/// A constraint, or a quasi-velocity that the start gives.
#[derive(Debug)]
pub(super) struct Known {
    pub level: Level,
    /// The name of the constraint in messages.
    pub title: String,
    /// The unit of the residual.
    pub unit: String,
    pub at: Range<usize>,
    /// The indices of the constraint in the model and of its component; `None` for a quasi-velocity.
    pub of: Option<[usize; 2]>,
    /// Whether a constraint of speeds depends on coordinates when all speeds are zero, such as the law of a charge.
    pub is_of_places: bool,
}

impl Constraints {
    pub fn of(model: &Model) -> Result<Option<Self>, Unmet> {
        if model.constraints.is_empty() && model.start_speeds.is_empty() {
            return Ok(None);
        }
        apart(|| {
            let trace = Trace::of(model);
            let mut all = Equations::of(&trace).constraints;
            let in_file: Vec<[usize; 2]> = all.iter().map(|constraint| constraint.of).collect();
            all.sort_by_key(|constraint| (constraint.gains.is_some(), constraint.level != Level::Position));
            let kept = all.iter().filter(|constraint| constraint.gains.is_none()).count();
            let chooses = |one: &&Equation| one.zero.symbols_of().iter().any(|symbol| trace.switches.contains(symbol));
            if let Some(constraint) = all.iter().find(chooses) {
                return Err(Unmet::Piecewise(constraint.at.clone()));
            }
            let moving = [&trace.coordinates, &trace.speeds];
            let moves = |one: &&Equation| {
                one.zero.symbols_of().iter().any(|symbol| moving.iter().any(|letters| letters.contains(symbol)))
            };
            if let Some(constraint) = all.iter().find(|one| !moves(one)) {
                return Err(Unmet::Fixed { at: constraint.at.clone() });
            }
            let wrong = |constraint: &&Equation| match (constraint.gains.as_ref().map(Vec::len), constraint.level) {
                (None, _) | (Some(2), Level::Position) | (Some(1), Level::Speed) => false,
                (Some(_), _) => true,
            };
            if let Some(Equation { of: [place, _], level, gains, .. }) = all.iter().find(wrong) {
                let found = gains.as_ref().map_or(0, Vec::len);
                return Err(Unmet::Gains { at: model.constraints[*place].gains_at.clone(), level: *level, found });
            }
            let speeds: Vec<Sym> =
                (0..model.start_speeds.len()).map(|i| Sym::symbol(&format!("quasi-velocity {i}"))).collect();
            let started = model.start_speeds.iter().zip(&speeds).map(|(start, &given)| {
                let of = &model.quasi_velocities[start.of];
                let zero = trace.scalar(of.is) - given;
                let row = (0..trace.speeds.len()).map(|i| trace.by_speed(zero, i)).collect();
                let title = format!("the value of `{}` in [start]", of.name);
                let (unit, at) = (of.unit(), start.at.clone());
                let known = Known { level: Level::Speed, title, unit, at, of: None, is_of_places: false };
                Row { known, zero, rate: zero, row }
            });
            let unit = |of: [usize; 2]| coherent(&model.constraints[of[0]].dimension.to_string());
            let mut rows: Vec<Row> = all.into_iter().map(|equation| Row::of(unit(equation.of), equation)).collect();
            rows.splice(kept..kept, started);
            let zeros = rows.iter().map(|row| row.zero);
            let rates = rows.iter().map(|row| row.rate);
            let slopes = rows.iter().flat_map(|row| row.row.iter().copied());
            let wanted: Vec<Sym> = zeros.chain(rates).chain(slopes).collect();
            let inputs = Inputs::of(model);
            let wanted = inputs.letters().put_into(&trace, &wanted);
            let tape =
                Tape::record(&[&inputs.state, &inputs.parameters, &speeds, &[inputs.time][..]].concat(), &wanted)
                    .map_err(|reason| Unmet::NotCompiled(NotCompiled::Undefined { reason: reason.to_string() }))?
                    .arranged();
            // after the recording, since the order in which expressions are created determines that of the operations
            let at_rest: Vec<(Sym, Sym)> = trace.speeds.iter().map(|&speed| (speed, Sym::ZERO)).collect();
            let is_of_places = |row: &Row| {
                let rest = row.rate.substitute(&at_rest).symbols_of();
                row.known.level == Level::Speed && trace.coordinates.iter().any(|letter| rest.contains(letter))
            };
            let mut known: Vec<Known> =
                rows.into_iter().map(|row| Known { is_of_places: is_of_places(&row), ..row.known }).collect();
            let titles: Vec<String> = titles(&trace).into_iter().map(|(_, title)| title).collect();
            for own in &mut known {
                let place = own.of.and_then(|of| in_file.iter().position(|known| *known == of));
                own.title = place.map_or_else(|| std::mem::take(&mut own.title), |place| titles[place].clone());
            }
            let started = speeds.len();
            let names = model.state_names().into_iter().map(|(name, _)| name).collect();
            let layout = Layout::of(model);
            Ok((!known.is_empty()).then_some(Constraints { tape, known, kept, started, layout, names }))
        })
    }

    /// Residuals and their Jacobian at time zero: of position constraints by displacements (`Level::Position`), or without a level the rates of all
    /// equations by the speeds.
    pub fn at(&self, state: &[f64], parameters: &[f64], level: Option<Level>) -> (DVector<f64>, DMatrix<f64>) {
        let values = self.values(0.0, state, parameters);
        let count = match level {
            Some(level) => self.known[..self.kept].iter().filter(|own| own.level == level).count(),
            None => self.kept + self.started,
        };
        let first = if level.is_some() { 0 } else { self.known.len() };
        (DVector::from_fn(count, |i, _| values[first + i]), self.rows(&values, count))
    }

    /// The residuals, their rates, and the derivatives of the rates with respect to the speeds, as one list.
    pub fn values(&self, time: f64, state: &[f64], parameters: &[f64]) -> Vec<f64> {
        let mut values = vec![f64::NAN; self.known.len() * (2 + self.layout.speeds())];
        self.tape.over().evaluate(&[state, parameters, &[time]].concat(), &mut values);
        values
    }

    /// The derivatives of the first `count` equations with respect to the speeds, from the list of [`Constraints::values`].
    pub fn rows(&self, values: &[f64], count: usize) -> DMatrix<f64> {
        let (m, n) = (self.known.len(), self.layout.speeds());
        DMatrix::from_fn(count, n, |i, j| values[2 * m + i * n + j])
    }

    /// Two contradictory constraints f and g with f = k g + d and d not zero, k and d constant; tested at the state and two displaced states.
    pub fn contradiction(&self, state: &[f64], parameters: &[f64], level: Option<Level>) -> Option<Unmet> {
        let displaced = |by: f64| {
            let mut moved = state.to_vec();
            (0..self.layout.speeds()).for_each(|speed| {
                (0..2).for_each(|order| {
                    self.layout.displace(&mut moved, (speed, order), by * (1.0 + speed as f64).sqrt())
                });
            });
            self.at(&moved, parameters, level)
        };
        let all = [self.at(state, parameters, level), displaced(0.37), displaced(-0.61)];
        let tie = |(residuals, rows): &(DVector<f64>, DMatrix<f64>), one: usize, other: usize| {
            let (first, second) = (rows.row(one), rows.row(other));
            let factor = second.dot(&first) / first.norm_squared();
            let is_parallel = (second - first * factor).norm() <= MET * second.norm();
            is_parallel.then(|| [factor, residuals[other] - factor * residuals[one]])
        };
        let pairs = (0..all[0].0.len()).flat_map(|other| (0..other).map(move |one| (one, other)));
        let apart = |(one, other): (usize, usize)| {
            let ties: Vec<[f64; 2]> = all.iter().filter_map(|at| tie(at, one, other)).collect();
            let [[factor, residual], rest @ ..] = ties.as_slice() else { return None };
            let alike = |known: &f64, other: &f64| (known - other).abs() <= MET * (1.0 + known.abs());
            let stays = rest.iter().all(|[k, d]| alike(factor, k) && alike(residual, d));
            (ties.len() == all.len() && stays && residual.abs() > MET).then_some((one, other, *residual))
        };
        let (one, other, residual) = pairs.into_iter().find_map(apart)?;
        let unit = self.unit_of(other, level);
        Some(Unmet::Contradiction { at: [one, other].map(|place| self.known[place].at.clone()), residual, unit })
    }

    /// Whether each residual is a rounding error, relative to the terms of the equation (derivatives times components of the state) or to one
    /// SI unit.
    pub fn met(&self, state: &[f64], (residuals, jacobian): &(DVector<f64>, DMatrix<f64>), order: usize) -> Vec<bool> {
        let largest = |speed: usize| {
            state[self.layout.places(speed, order)].iter().fold(1.0, |largest: f64, part| largest.max(part.abs()))
        };
        let sizes: Vec<f64> = (0..self.layout.speeds()).map(largest).collect();
        let is_met = |(row, residual): (usize, &f64)| {
            let slopes = jacobian.row(row);
            let terms = slopes.iter().zip(&sizes).map(|(slope, size)| (slope * size).abs());
            residual.abs() <= MET * terms.fold(1.0, f64::max)
        };
        residuals.iter().enumerate().map(is_met).collect()
    }

    /// Whether all residuals are rounding errors of terms of the order of one, or of the derivatives where these are smaller: millimetres by radians.
    pub fn are_rounded(&self, (residuals, jacobian): &(DVector<f64>, DMatrix<f64>)) -> bool {
        residuals
            .iter()
            .enumerate()
            .all(|(row, residual)| residual.abs() <= ROUNDED * jacobian.row(row).amax().min(1.0))
    }

    /// The first constraint that does not hold, with those of the free coordinates, or speeds, that move it.
    pub fn open(&self, state: &[f64], parameters: &[f64], level: Option<Level>, free: &[usize]) -> Option<Open> {
        let at = self.at(state, parameters, level);
        let worst = self.met(state, &at, usize::from(level.is_none())).iter().position(|is_met| !is_met)?;
        let (residuals, jacobian) = at;
        let Known { title, at, level: own, .. } = &self.known[worst];
        let unit = self.unit_of(worst, level);
        let is_rate = level.is_none() && *own == Level::Position;
        let level = if level.is_some() { Level::Position } else { Level::Speed };
        let residual = residuals[worst].is_finite().then_some(residuals[worst]);
        let order = usize::from(level == Level::Speed);
        let slopes = jacobian.row(worst);
        // products of the components of unit vectors leave rounding errors for derivatives that are zero
        let moves = (0..self.layout.speeds()).filter(|&speed| slopes[speed].abs() > RANK * slopes.amax());
        let (moved, given): (Vec<usize>, Vec<usize>) = moves.partition(|speed| free.contains(speed));
        // a free frame has one name for its four coordinates
        let name = |speed: usize| {
            let places = self.layout.places(speed, order);
            let name = &self.names[places.start];
            if places.len() > 1 { name.trim_end_matches(".q0").to_owned() } else { name.clone() }
        };
        let named = |speeds: Vec<usize>| {
            let mut names: Vec<String> = speeds.into_iter().map(name).collect();
            names.dedup();
            names
        };
        let holds = |row: &usize| moved.iter().any(|&speed| jacobian[(*row, speed)] != 0.0);
        let others = (0..jacobian.nrows()).filter(|row| *row != worst && level == Level::Position).filter(holds);
        let others = others.map(|row| self.known[row].title.clone()).collect();
        let (moved, given) = (named(moved), named(given));
        Some(Open { at: at.clone(), name: title.clone(), residual, unit, is_rate, moved, given, others, level })
    }

    /// The unit of a residual; if speeds are solved for, that of the rate of a position constraint.
    pub fn unit_of(&self, row: usize, level: Option<Level>) -> String {
        let Known { unit, level: own, .. } = &self.known[row];
        if level.is_none() && *own == Level::Position { rate_unit(unit) } else { unit.clone() }
    }
}

/// An equation of the start: residual, its rate, and the derivatives of the rate with respect to the speeds.
struct Row {
    known: Known,
    zero: Sym,
    rate: Sym,
    row: Vec<Sym>,
}

impl Row {
    fn of(unit: String, Equation { name, of, level, at, zero, rate, row, .. }: Equation) -> Self {
        Row { known: Known { level, title: name, unit, at, of: Some(of), is_of_places: false }, zero, rate, row }
    }
}
