//! Construction of the speeds as functions of quasi-velocities, and of the quantities derived from these: rates of coordinates, directions, accelerations.

use super::axes::Axes;
use super::independence::Dependence;
use super::inverse::{Solution, solved};
use super::{Independent, QuasiVelocities, ShortForms, coefficients};
use crate::trace::turned_axes;
use crate::{Fault, Trace, Vector};
use std::cell::RefCell;
use symbolic::{Derivation, Sym};

impl<'t, 'm> QuasiVelocities<'t, 'm> {
    /// Solves the constraints and the definitions of quasi-velocities for the speeds. With `is_named`, long derivatives get symbols.
    pub(super) fn written(trace: &'t Trace<'m>, is_named: bool) -> Result<Self, Vec<Fault>> {
        let model = trace.model;
        let Independent { met, programmed, definitions, independent } =
            Independent::of(trace).map_err(|dependence| match dependence {
                Dependence::Forms(faults) => faults,
                Dependence::Ranks(fault) => vec![fault],
            })?;
        let (symbols, accelerations) = letters(trace);
        let n = trace.speeds.len();
        let at_rest: Vec<(Sym, Sym)> = trace.speeds.iter().map(|&speed| (speed, Sym::ZERO)).collect();
        // constraints first, then quasi-velocities; each row with its unit column and its value at zero speeds
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
            // the rate of an angular velocity of one frame in another is equal in both frames
            let along = Vector { frame: parent, components: trace.express(turning, parent) };
            rates.extend(trace.express(along.map(|component| rate.of(component)), own));
            // here R R^T = 1 is used, which no later simplification of sums would recognise
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
}

/// Returns the symbols of quasi-velocities and of their rates. A quasi-velocity that is the rate of a coordinate keeps its symbol.
fn letters(trace: &Trace<'_>) -> (Vec<Sym>, Vec<Sym>) {
    let own = |name: &str| trace.speeds.iter().position(|speed| speed.to_string() == name);
    let letters = |speed: &crate::QuasiVelocity| match own(&speed.name) {
        Some(place) => (trace.speeds[place], trace.accelerations[place]),
        None => {
            let letter = Sym::symbol(&speed.name);
            (letter, Sym::named(&format!("{}'", speed.name), &format!(r"\dot{{{}}}", letter.latex())))
        }
    };
    trace.model.quasi_velocities.iter().map(letters).unzip()
}
