//! Quasi-velocities w, and the speeds u by them.
//!
//! Each w is affine in the speeds, w = B u + b. With the rates s = J u + c of the constraints that hold they determine the speeds,
//!
//!   u = C w + D s + d,    J C = 0,    B C = 1 ,
//!
//! and s = 0 along every motion. The columns of C are directions of admissible displacements. Programmed constraints are no part of s:
//! they need not hold, and stay equations with multipliers.
//!
//! Angular velocities of free frames are solved for along axes in which slopes are short. The speeds have no other divisors than the
//! determinant of the whole change, up to its factors that are constants.

mod appell;
mod coefficients;
mod hamel;
mod independence;
mod inverse;
mod maggi;
mod reduced_equations;
mod short_forms;
mod turning;
mod virtual_power;

pub use coefficients::Coefficient;
pub use reduced_equations::{QuasiPrinciple, quasi_agreement};

use crate::equations::{Equation, Level, constraints_of};
use crate::trace::turned_axes;
use crate::{Fault, FrameId, Trace, Turn, Vector};
use independence::Dependence;
use inverse::{Solution, solved};
use short_forms::ShortForms;
use std::cell::RefCell;
use symbolic::{Derivation, Sym, substitute_all};
use turning::Axes;

/// Quasi-velocities over the symbols of a trace.
pub struct QuasiVelocities<'t, 'm> {
    trace: &'t Trace<'m>,
    /// w.
    pub symbols: Vec<Sym>,
    /// w'.
    pub accelerations: Vec<Sym>,
    /// w by coordinates, speeds and the time.
    pub definitions: Vec<Sym>,
    /// u by coordinates, w and the time.
    pub speeds: Vec<Sym>,
    /// q' by coordinates, w and the time: kinematic equations.
    pub position_rates: Vec<Sym>,
    /// C: of each speed by each w.
    directions: Vec<Vec<Sym>>,
    /// D: of each speed by the rate of each independent constraint that holds.
    across: Vec<Vec<Sym>>,
    /// Constraints that hold.
    pub met: Vec<Equation>,
    /// Constraints that are led to zero.
    pub programmed: Vec<Equation>,
    /// Those of the first that are independent, by their places.
    independent: Vec<usize>,
    /// Expressions that the speeds are divided by: where one of them vanishes, the quasi-velocities do not determine the speeds.
    pub divisors: Vec<Sym>,
    /// Letters in the directions, where they are asked for.
    pub coefficients: Vec<Coefficient>,
    is_named: bool,
    /// Angular velocities of free frames in their parents, by w.
    turning: Vec<Vector>,
    /// Along the motion, over coordinates, w and w'.
    rate: RefCell<Derivation>,
    /// u and u' by w and w'.
    known: [Vec<(Sym, Sym)>; 2],
}

/// Constraints and definitions, before speeds are solved for.
struct Independent {
    met: Vec<Equation>,
    programmed: Vec<Equation>,
    definitions: Vec<Sym>,
    /// Places of the constraints that are independent.
    independent: Vec<usize>,
}

impl Independent {
    fn of(trace: &Trace<'_>) -> Result<Self, Dependence> {
        let (met, programmed): (Vec<Equation>, Vec<Equation>) =
            constraints_of(trace).into_iter().partition(|constraint| constraint.gains.is_none());
        let quasi_velocities = trace.model.quasi_velocities.iter();
        let definitions: Vec<Sym> = quasi_velocities.map(|speed| trace.scalar(speed.is)).collect();
        let independent = independence::independent(trace, &met, &definitions)?;
        Ok(Independent { met, programmed, definitions, independent })
    }
}

/// Faults of the quasi-velocities of a model, and whether they may be none on the branch of the start: constraints of positions may be
/// dependent there, and at a general point are not.
pub(crate) fn faults(trace: &Trace<'_>) -> (Vec<Fault>, bool) {
    match Independent::of(trace) {
        Ok(_) => (Vec::new(), false),
        Err(Dependence::Forms(faults)) => (faults, false),
        Err(Dependence::Ranks(fault)) => {
            let is_kept = |one: &Equation| one.gains.is_none() && one.level == Level::Position;
            (vec![fault], constraints_of(trace).iter().any(is_kept))
        }
    }
}

impl<'t, 'm> QuasiVelocities<'t, 'm> {
    /// The quasi-velocities of a model.
    ///
    /// # Errors
    /// Each of them that is not affine in the speeds or depends on others; or how many are missing.
    pub fn of(trace: &'t Trace<'m>) -> Result<Self, Vec<Fault>> {
        QuasiVelocities::written(trace, false)
    }

    /// The same with letters for long slopes of speeds: equations hold these and their rates. Hamel's equations cannot be written
    /// with them.
    ///
    /// # Errors
    /// As [`QuasiVelocities::of`].
    pub fn named(trace: &'t Trace<'m>) -> Result<Self, Vec<Fault>> {
        QuasiVelocities::written(trace, true)
    }

    /// The quasi-velocities of the same model with other loads, written in the same way.
    pub(crate) fn beside<'o, 'n>(&self, trace: &'o Trace<'n>) -> Result<QuasiVelocities<'o, 'n>, Vec<Fault>> {
        QuasiVelocities::written(trace, self.is_named)
    }

    fn written(trace: &'t Trace<'m>, is_named: bool) -> Result<Self, Vec<Fault>> {
        let model = trace.model;
        let Independent { met, programmed, definitions, independent } =
            Independent::of(trace).map_err(|dependence| match dependence {
                Dependence::Forms(faults) => faults,
                Dependence::Ranks(fault) => vec![fault],
            })?;
        let letters = |primes: &str, dot: &str| -> Vec<Sym> {
            let named = |speed: &crate::QuasiVelocity| {
                let latex = Sym::symbol(&speed.name).latex();
                let latex = if dot.is_empty() { latex } else { format!("{dot}{{{latex}}}") };
                Sym::named(&format!("{}{primes}", speed.name), &latex)
            };
            model.quasi_velocities.iter().map(named).collect()
        };
        let (symbols, accelerations) = (letters("", ""), letters("'", r"\dot"));
        let n = trace.speeds.len();
        let at_rest: Vec<(Sym, Sym)> = trace.speeds.iter().map(|&speed| (speed, Sym::ZERO)).collect();
        // constraints first, then quasi-velocities; each row with its unit column and what is left of it at rest
        let k = independent.len();
        let rates = independent.iter().map(|&place| met[place].rate);
        let rows: Vec<Sym> = rates.chain(definitions.iter().copied()).collect();
        let right = |(place, &row): (usize, &Sym)| {
            let mut right: Vec<Sym> = (0..n).map(|each| if each == place { Sym::ONE } else { Sym::ZERO }).collect();
            right.push(-row.substitute(&at_rest));
            right
        };
        let right = rows.iter().enumerate().map(right).collect();
        let slopes = |row: &Sym| (0..n).map(|i| trace.by_speed(*row, i)).collect();
        let slopes: Vec<Vec<Sym>> = rows.iter().map(slopes).collect();
        let (axes, mut forms) = (Axes::of(trace, &slopes), ShortForms::of(trace));
        let matrix = slopes.iter().map(|row| axes.of_unknowns(trace, row, &mut forms)).collect();
        let Solution { mut unknowns, divisors } = solved(matrix, right, &mut forms);
        let (mut axes, mut coefficients) = (axes, Vec::new());
        if is_named {
            (axes, unknowns) = axes.with_own_of_bodies(trace, unknowns);
            coefficients = coefficients::named(&mut unknowns, k, &mut forms);
        }
        let sum = |row: &Vec<Sym>| row[k..n].iter().zip(&symbols).fold(row[n], |sum, (&slope, &w)| sum + slope * w);
        let values: Vec<Sym> = unknowns.iter().map(sum).collect();
        let turning: Vec<Vector> = (0..model.free.len()).map(|number| axes.turning(trace, number, &values)).collect();
        let of_speeds = axes.of_speeds(trace, unknowns);
        let across = of_speeds.iter().map(|row| row[..k].to_vec()).collect();
        let directions: Vec<Vec<Sym>> = of_speeds.iter().map(|row| row[k..n].to_vec()).collect();
        let mut speeds = values;
        for (number, &turning) in turning.iter().enumerate() {
            let first = model.free_speed(number);
            speeds[first..first + 3].copy_from_slice(&trace.express(turning, model.free[number]));
        }
        let mut position_rates = speeds[..model.coordinates.len()].to_vec();
        let mut turned = Vec::new();
        for (number, &turning) in turning.iter().enumerate() {
            let (rates, cosines) = turned_axes(trace, number, turning);
            position_rates.extend(rates);
            turned.extend(cosines);
        }
        let along = trace.coordinates.iter().zip(&position_rates).chain(symbols.iter().zip(&accelerations));
        let along = along.map(|(&of, &rate)| (of, rate)).chain([(trace.time, Sym::ONE)]).chain(turned);
        let mut rate = Derivation::new(along.chain(coefficients.iter().map(|each| (each.letter, each.rate))));
        for coefficient in &mut coefficients {
            coefficient.rate_is = rate.of(coefficient.is);
        }
        let mut rates: Vec<Sym> = speeds[..model.coordinates.len()].iter().map(|&speed| rate.of(speed)).collect();
        let mut by_speeds: Vec<(Sym, Sym)> = trace.speeds.iter().copied().zip(speeds.iter().copied()).collect();
        for (number, &turning) in turning.iter().enumerate() {
            let own = model.free[number];
            let parent = trace.parent(own);
            // the frame and its parent see the same rate of an angular velocity that one has in the other
            let along = Vector { frame: parent, components: trace.express(turning, parent) };
            rates.extend(trace.express(along.map(|component| rate.of(component)), own));
            // R R^T = 1 is known here, and to no sum of products
            let first = model.free_speed(number);
            let own = Vector { frame: own, components: std::array::from_fn(|k| trace.speeds[first + k]) };
            if turning.frame != own.frame {
                by_speeds.extend(trace.express(own, parent).into_iter().zip(along.components));
            }
        }
        let by_accelerations = trace.accelerations.iter().copied().zip(rates).collect();
        Ok(QuasiVelocities {
            trace,
            symbols,
            accelerations,
            definitions,
            speeds,
            position_rates,
            directions,
            across,
            met,
            programmed,
            independent,
            divisors,
            coefficients,
            is_named,
            turning,
            rate: RefCell::new(rate),
            known: [by_speeds, by_accelerations],
        })
    }

    /// Expressions over speeds and accelerations by w and w'; masses that vary by their values.
    pub fn by_quasi_velocities(&self, expressions: &[Sym]) -> Vec<Sym> {
        let [speeds, accelerations] = &self.known;
        let with_masses = self.trace.with_masses(expressions);
        substitute_all(&substitute_all(&with_masses, accelerations), speeds)
    }

    /// The same of one expression, in which letters of masses that vary stay.
    fn moved(&self, expression: Sym) -> Sym {
        let [speeds, accelerations] = &self.known;
        expression.substitute(accelerations).substitute(speeds)
    }

    fn moved_vector(&self, vector: Vector) -> Vector {
        vector.map(|component| self.moved(component))
    }

    /// The angular velocity of a frame, of a free one along the axes in which it is short.
    fn turning(&self, frame: FrameId) -> Vector {
        match self.trace.model.frames[frame.0].parent {
            Some((parent, Turn::Free { number })) => self.trace.sum(self.turning(parent), self.turning[number]),
            _ => self.moved_vector(self.trace.turning(frame)),
        }
    }

    /// The rate along the motion of an expression over coordinates and w.
    fn rate_of(&self, expression: Sym) -> Sym {
        self.rate.borrow_mut().of(expression)
    }

    /// The rate of a vector over coordinates and w, as the ground sees it.
    fn vector_rate(&self, vector: Vector) -> Vector {
        let own = vector.map(|component| self.rate_of(component));
        let turning = self.turning(vector.frame);
        self.trace.sum(own, self.trace.cross(turning, vector))
    }

    /// C^T v: values for each speed along each w.
    fn along(&self, values: &[Sym]) -> Vec<Sym> {
        let along = |r: usize| {
            let terms = values.iter().zip(&self.directions);
            terms.fold(Sym::ZERO, |sum, (&value, row)| sum + value * row[r])
        };
        (0..self.symbols.len()).map(along).collect()
    }
}
