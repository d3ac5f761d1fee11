//! The law of a mode near jamming, in a new variable in which it is regular: the equations for its reactions become singular with their
//! determinant D.

use super::algebraic::Parted;
use super::contacts::{ReactionEquations, leant};
use super::held::eliminated;
use super::mode::Mode;
use crate::letters::Letters;
use field::DoubleDouble;
use integrators::{Dual8, Ode, System};
use model::{Model, Trace};
use simulation::{Program, Running};
use symbolic::{Derivation, Sym, substitute_all};

/// The equations dy/ds = D f(t, y) for positions and speeds, and dt/ds = D for the time as the last component; the time decreases where D
/// is negative. Reactions have the denominator D, so that these equations are regular up to D = 0. D decreases like exp(-s^2), while
/// speeds grow like s within a finite time t.
pub(super) struct Slowed {
    program: Program,
    states: usize,
}

impl Slowed {
    /// Compiles the equations; `None` for a mode with held conditions, or with reactions that are shared or that the mode determines
    /// directly.
    pub fn of(model: &Model, mode: &Mode) -> Option<Self> {
        let states = model.positions() + model.speeds();
        let mut is_known = true;
        let program = Program::of(states + 1, |_, all| {
            let written = written(model, mode, (all[states], &all[..states]));
            is_known = written.is_some();
            written.unwrap_or_default()
        });
        program.filter(|_| is_known).map(|program| Slowed { program, states })
    }

    /// The determinant D at a state with its time.
    pub fn determinant(&self, state: &[DoubleDouble]) -> DoubleDouble {
        let mut rates = vec![DoubleDouble::from(0.0); state.len()];
        Ode::<DoubleDouble>::rates(self, DoubleDouble::from(0.0), state, &mut rates);
        rates[self.states]
    }
}

/// The rates as expressions. By Cramer's rule, D R is the determinant in which the right sides replace the column of the reaction R.
fn written(model: &Model, mode: &Mode, (time, state): (Sym, &[Sym])) -> Option<Vec<Sym>> {
    let trace = Trace::of(model);
    let Parted { accelerations, multipliers, letters, .. } = Parted::of(&trace).ok()?;
    let fixed = |(&letter, case): (&Sym, &super::mode::Case)| {
        Some((letter, if case.fixed()? { Sym::ONE } else { Sym::ZERO })).filter(|_| !case.rests())
    };
    let cases: Option<Vec<(Sym, Sym)>> = trace.switches.iter().zip(&mode.cases).map(fixed).collect();
    let cases = cases.filter(|_| letters.is_empty() && leant(mode).is_empty())?;
    let in_mode = |all: &[Sym]| substitute_all(all, &cases);
    let (accelerations, multipliers) = (in_mode(&accelerations), in_mode(&multipliers));
    let is_direct = vec![false; mode.phases.len()];
    let equations = ReactionEquations::of(&trace, mode, (&cases, &is_direct), (&accelerations, &multipliers));
    let determinant = equations.solved(equations.right.clone()).ok()?.1;
    let numerator = |column: usize| {
        let mut rows = equations.rows.clone();
        rows.iter_mut().zip(&equations.right).for_each(|(row, right)| row[column] = *right);
        // a determinant without a pivot is zero
        eliminated(rows, equations.right.clone()).map_or(Sym::ZERO, |(_, determinant)| determinant)
    };
    let numerators: Vec<Sym> = (0..equations.unknown.len()).map(numerator).collect();
    let letters: Vec<Sym> = equations.unknown.iter().map(|&[contact, part]| trace.reaction(contact, part)).collect();
    let none: Vec<(Sym, Sym)> = letters.iter().map(|&letter| (letter, Sym::ZERO)).collect();
    let slowed = |acceleration: &Sym| {
        let open = acceleration.substitute(&equations.given);
        let slope = |letter: Sym| Derivation::new([(letter, Sym::ONE)]).of(open);
        let of_reactions = letters.iter().zip(&numerators).map(|(&letter, &numerator)| slope(letter) * numerator);
        of_reactions.fold(determinant * open.substitute(&none), |sum, part| sum + part)
    };
    let moved = trace.position_rates.iter().map(|&rate| determinant * rate);
    let rates: Vec<Sym> = moved.chain(accelerations.iter().map(slowed)).chain([determinant]).collect();
    Some(Letters::with_data(time, state).put_into(&trace, &in_mode(&rates)))
}

impl<S: Running> Ode<S> for Slowed {
    fn dimension(&self) -> usize {
        self.states + 1
    }

    fn rates(&self, s: S, y: &[S], dy: &mut [S]) {
        // the program was compiled for this length, so it cannot fail
        self.program.run(s, y, dy).unwrap_or(());
    }
}

impl System for Slowed where Self: Ode<f64> + Ode<Dual8> + Ode<DoubleDouble> {}
