//! Check of inductances: the matrix of second derivatives of the co-energy with respect to the currents must be positive semidefinite at the start.

use crate::admissible::shown;
use model::{Model, Trace};
use nalgebra::DMatrix;
use reader::Issue;
use symbolic::{Sym, apart};

/// Negative values below this part of the largest are rounding errors.
const ROUNDING: f64 = 1e-12;

/// An issue for physically impossible inductances at `start`: a negative inductance, a mutual inductance that is too large, or a
/// combination of currents with negative energy. `None` if there is none, or the co-energy has no value.
pub(crate) fn impossible_inductances(model: &Model, start: &[f64]) -> Option<Issue> {
    let coenergy = model.energies.coenergy?;
    let (currents, inductances) = apart(|| {
        let trace = Trace::of(model);
        let coenergy = trace.scalar(coenergy);
        let state = trace.coordinates.iter().chain(&trace.speeds);
        let state: Vec<(String, f64)> = state.map(ToString::to_string).zip(start.iter().copied()).collect();
        let value = |expression: Sym| {
            let of = |name: &str| {
                let of_state = state.iter().find(|(own, _)| own == name).map(|(_, value)| *value);
                let parameter = || model.parameters.iter().find(|own| own.name == name)?.value;
                let time = || (Sym::symbol(name) == trace.time).then_some(0.0);
                let pi = || (Sym::symbol(name) == trace.pi).then_some(std::f64::consts::PI);
                of_state.or_else(parameter).or_else(time).or_else(pi)
            };
            expression.evaluate_analytic(&of).ok().filter(|value: &f64| value.is_finite())
        };
        let slopes: Vec<Sym> = (0..trace.speeds.len()).map(|speed| trace.by_speed(coenergy, speed)).collect();
        let currents: Vec<usize> = (0..slopes.len()).filter(|&speed| slopes[speed] != Sym::ZERO).collect();
        let entry = |row: usize, column: usize| value(trace.by_speed(slopes[currents[row]], currents[column]));
        let n = currents.len();
        let all: Option<Vec<f64>> = (0..n * n).map(|place| entry(place / n, place % n)).collect();
        all.map(|all| (currents, DMatrix::from_row_slice(n, n, &all)))
    })?;
    let n = currents.len();
    if n == 0 {
        return None;
    }
    let names: Vec<String> = model.state_names().into_iter().skip(model.positions()).map(|(name, _)| name).collect();
    let name = |place: usize| &names[currents[place]];
    let largest = inductances.amax();
    let fault = |place: usize, title: String, label: String| {
        let at = model.coordinates.get(currents[place]).map_or(0..0, |coordinate| coordinate.at.clone());
        let accepted = "inductances that are positive, and mutual ones with M^2 < L1 L2; a co-energy that bends upwards in every current";
        Some(Issue::at(at, title, label).accepted(accepted))
    };
    if let Some(place) = (0..n).find(|&place| inductances[(place, place)] < -ROUNDING * largest) {
        let title = format!("the inductance of the current {} is negative", name(place));
        return fault(place, title, format!("at the start it is {} H", shown(inductances[(place, place)])));
    }
    for one in 0..n {
        for other in 0..one {
            let mutual = inductances[(one, other)];
            let most = (inductances[(one, one)] * inductances[(other, other)]).max(0.0).sqrt();
            if mutual.abs() > most * (1.0 + ROUNDING) && mutual.abs() > ROUNDING * largest {
                let title = format!(
                    "the mutual inductance of the currents {} and {} is larger than their own ones allow",
                    name(other),
                    name(one)
                );
                let label = format!("at the start it is {} H, and sqrt(L1 L2) is {} H", shown(mutual), shown(most));
                return fault(one, title, label);
            }
        }
    }
    // scaled to a unit diagonal, so that the result does not depend on units
    let scale: Vec<f64> = (0..n).map(|place| inductances[(place, place)].max(0.0).sqrt()).collect();
    let scaled = DMatrix::from_fn(n, n, |row, column| match scale[row] * scale[column] {
        0.0 => 0.0,
        both => inductances[(row, column)] / both,
    });
    let parts = scaled.symmetric_eigen();
    let (least, value) = parts.eigenvalues.iter().enumerate().min_by(|one, other| one.1.total_cmp(other.1))?;
    if *value >= -ROUNDING * n as f64 {
        return None;
    }
    let direction = parts.eigenvectors.column(least);
    let taking = |place: &usize| direction[*place].abs() > 1e-6;
    let together: Vec<&str> = (0..n).filter(taking).map(|place| name(place).as_str()).collect();
    let title = format!("the currents {} together have a negative energy at the start", together.join(", "));
    fault((0..n).find(taking)?, title, "of these inductances".to_owned())
}
