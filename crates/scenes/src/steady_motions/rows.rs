//! Equations of motion without accelerations, one for each speed, over letters of the model.
//!
//! Constraints of speeds determine some of them by the others, u_D = B(q) u_I + b(q). Steady are the others: with u_I' = 0 and
//! u_D' = du_D/dq q', the equations along the displacements that these constraints leave,
//!
//!   r_I + B^T r_D = 0 ,
//!
//! hold none of their reactions (Maggi). A determined speed of a coordinate that occurs must be zero; of others it may change: a disc that
//! rolls in a circle moves steadily.

use super::NoSteadyMotions;
use super::potential::have_potential;
use crate::letters::Letters;
use model::equations::{Equation, Level, Residuals, constraints_of, vanishes};
use model::{Model, Trace};
use symbolic::linear::solve;
use symbolic::{Hypotheses, Sym, substitute_all};

/// The equations, with the data of the file put in.
pub(super) struct Rows {
    /// One for each speed, zero where it asks for nothing.
    pub residuals: Vec<Sym>,
    /// Constraints of positions, and their functions.
    pub constraints: Vec<Equation>,
    pub zeros: Vec<Sym>,
    /// Speeds that constraints of speeds determine, by the others.
    pub determined: Vec<(usize, Sym)>,
    /// Coordinates on which nothing depends.
    pub is_cyclic: Vec<bool>,
    /// Whether the loads have a potential energy, and no constraint holds speeds.
    pub have_potential: bool,
}

/// In systems with more coordinates a coordinate is cyclic where it is not written.
const MOST_DECIDED: usize = 12;

/// Constraints of speeds that are solved as they are written.
const MOST_SOLVED: usize = 4;

impl Rows {
    pub fn of(model: &Model, trace: &Trace<'_>) -> Result<Self, NoSteadyMotions> {
        let is_kept = |one: &Equation| one.gains.is_none() && one.law.is_none();
        let (constraints, of_speeds): (Vec<Equation>, Vec<Equation>) =
            constraints_of(trace).into_iter().partition(|one| one.level == Level::Position);
        if let Some(one) = constraints.iter().chain(&of_speeds).find(|one| !is_kept(one)) {
            return Err(NoSteadyMotions::OfSpeeds { at: one.at.clone() });
        }
        let equations = Residuals::of(trace).into_iter().next().ok_or(NoSteadyMotions::Singular)?;
        let state = [&trace.coordinates[..], &trace.speeds].concat();
        // letters for everything that moves
        let letters = Letters::with_data(trace.time, &state);
        let put = |all: &[Sym]| letters.put_into(trace, all);
        let residuals = put(&equations.residuals[..model.speeds()]);
        let zeros = put(&constraints.iter().map(|one| one.zero).collect::<Vec<_>>());
        let energy = put(&[trace.kinetic_energy()])[0];
        let mut potential = false;
        let (residuals, determined) = match of_speeds.is_empty() {
            true => {
                let resting = at_rest(trace, residuals, &[]);
                potential = have_potential(trace, &resting, energy, &constraints);
                (resting, Vec::new())
            }
            false => projected(trace, residuals, &of_speeds, put)?,
        };
        let plain = |row: Sym| if vanishes(row) { Sym::ZERO } else { row };
        let residuals = residuals.into_iter().map(plain).collect();
        let is_cyclic = vec![true; model.speeds()];
        let mut rows = Rows { residuals, constraints, zeros, determined, is_cyclic, have_potential: potential };
        rows.find_cyclic(trace);
        Ok(rows)
    }

    /// Finds coordinates on which nothing depends. The rate of one that is determined, and on which something depends, is one more row.
    fn find_cyclic(&mut self, trace: &Trace<'_>) {
        loop {
            let held: Vec<(usize, Sym)> =
                self.determined.iter().copied().filter(|&(place, _)| !self.is_cyclic[place]).collect();
            let rows: Vec<Sym> =
                self.residuals.iter().chain(&self.zeros).copied().chain(held.iter().map(|(_, rate)| *rate)).collect();
            let depends = |symbol: Sym| {
                let decides = trace.coordinates.len() <= MOST_DECIDED;
                let holds = |row: &&Sym| row.symbols_of().contains(&symbol);
                rows.iter().filter(holds).any(|row| !decides || !vanishes(row.diff(symbol)))
            };
            let is_cyclic: Vec<bool> = trace.coordinates.iter().map(|&symbol| !depends(symbol)).collect();
            let is_settled = is_cyclic == self.is_cyclic;
            self.is_cyclic = is_cyclic;
            if is_settled {
                held.into_iter().for_each(|(place, rate)| self.residuals[place] = rate);
                break;
            }
        }
        // nothing depends on them: any value serves
        let cyclic = trace.coordinates.iter().zip(&self.is_cyclic).filter(|(_, cyclic)| **cyclic);
        let none: Vec<(Sym, Sym)> = cyclic.map(|(symbol, _)| (*symbol, Sym::ZERO)).collect();
        self.residuals = substitute_all(&self.residuals, &none);
        self.zeros = substitute_all(&self.zeros, &none);
        let rates: Vec<Sym> = self.determined.iter().map(|(_, rate)| *rate).collect();
        self.determined.iter_mut().zip(substitute_all(&rates, &none)).for_each(|(own, rate)| own.1 = rate);
    }
}

/// With accelerations that are zero but for some.
fn at_rest(trace: &Trace<'_>, rows: Vec<Sym>, but: &[(Sym, Sym)]) -> Vec<Sym> {
    let rests = trace.accelerations.iter().map(|symbol| (*symbol, Sym::ZERO));
    substitute_all(&rows, &but.iter().copied().chain(rests).collect::<Vec<_>>())
}

/// Equations, one for each speed, and the speeds that the others determine.
type Projected = (Vec<Sym>, Vec<(usize, Sym)>);

/// The equations along displacements that constraints of speeds leave, and the speeds that these determine.
fn projected(
    trace: &Trace<'_>,
    residuals: Vec<Sym>,
    of_speeds: &[Equation],
    put: impl Fn(&[Sym]) -> Vec<Sym>,
) -> Result<Projected, NoSteadyMotions> {
    let n = trace.speeds.len();
    let refused = || NoSteadyMotions::OfSpeeds { at: of_speeds[0].at.clone() };
    let rows: Vec<Vec<Sym>> = of_speeds.iter().map(|one| put(&one.row)).collect();
    let is_linear = |slope: &Sym| slope.symbols_of().iter().all(|symbol| !trace.speeds.contains(symbol));
    if of_speeds.len() > MOST_SOLVED || !rows.iter().flatten().all(is_linear) {
        return Err(refused());
    }
    let zeros = put(&of_speeds.iter().map(|one| one.zero).collect::<Vec<_>>());
    // those first whose coordinates occur nowhere
    let written: Vec<Sym> = residuals.iter().chain(rows.iter().flatten()).flat_map(|row| row.symbols_of()).collect();
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by_key(|&k| written.contains(&trace.coordinates[k]));
    let chosen = choices(&order, of_speeds.len()).into_iter().find_map(|chosen| {
        let own: Vec<Vec<Sym>> = rows.iter().map(|row| chosen.iter().map(|&k| row[k]).collect()).collect();
        let without: Vec<(Sym, Sym)> = chosen.iter().map(|&k| (trace.speeds[k], Sym::ZERO)).collect();
        let right: Vec<Sym> = substitute_all(&zeros, &without).into_iter().map(|zero| -zero).collect();
        let found = solve(&own, &right, &Hypotheses::none()).ok()?.values();
        Some(chosen.into_iter().zip(found).collect::<Vec<(usize, Sym)>>())
    });
    let determined = chosen.ok_or_else(refused)?;
    let known: Vec<(Sym, Sym)> = determined.iter().map(|&(k, rate)| (trace.speeds[k], rate)).collect();
    let rate_of = |k: usize| substitute_all(&[trace.speeds[k]], &known)[0];
    let moved: Vec<(Sym, Sym)> = determined
        .iter()
        .map(|&(k, rate)| {
            let along = (0..n).map(|j| rate.diff(trace.coordinates[j]) * rate_of(j));
            (trace.accelerations[k], along.fold(Sym::ZERO, |sum, each| sum + each))
        })
        .collect();
    let reactions = of_speeds.iter().map(|one| (one.multiplier, Sym::ZERO));
    let all = at_rest(trace, residuals, &moved.into_iter().chain(reactions).collect::<Vec<_>>());
    let all = substitute_all(&all, &known);
    let along = |i: usize| match determined.iter().any(|(k, _)| *k == i) {
        true => Sym::ZERO,
        false => {
            let by = determined.iter().map(|&(k, rate)| rate.diff(trace.speeds[i]) * all[k]);
            by.fold(all[i], |sum, each| sum + each)
        }
    };
    Ok(((0..n).map(along).collect(), determined))
}

/// All choices of so many, in their order.
fn choices(of: &[usize], count: usize) -> Vec<Vec<usize>> {
    if count == 0 {
        return vec![Vec::new()];
    }
    let with = |first: usize| {
        choices(&of[first + 1..], count - 1).into_iter().map(move |rest| [&[of[first]], &rest[..]].concat())
    };
    (0..of.len()).flat_map(with).collect()
}
