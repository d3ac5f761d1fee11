//! The Jacobian of a long law by directional derivatives, several directions at once: machine code computes weights at
//! a point, then sums ([`symbolic::Differential`]) give as many columns as fit in a register.

mod block;
mod sums;

use crate::law::compiled_law::{Differentiable, SymbolicLaw};
use crate::law::program::Program;
use block::{Block, LANES, blocks};
use integrators::JacobianFn;
use pulp::Arch;
use std::sync::{Arc, OnceLock};
use sums::{Run, Sums};
use symbolic::{Differential, Sym};

/// Computes the symbolic differential of the rates with respect to the state and the time.
type Write = dyn Fn(&[Sym], Sym) -> Differential + Send + Sync;

/// The derivatives of a law with respect to state and time.
pub struct DirectionalProgram {
    states: usize,
    write: Box<Write>,
    /// Compiled when first needed; `None` where an expression is undefined.
    made: OnceLock<Option<Made>>,
}

#[derive(Debug)]
struct Made {
    weights: Program,
    sums: Sums,
    /// The columns of the state, then that of the time.
    blocks: Vec<Block>,
}

impl DirectionalProgram {
    /// The number of directions per block.
    pub const DIRECTIONS: usize = LANES;

    /// The derivatives from a differential whose inputs are the states and the time, and whose outputs are the rates.
    pub fn by(states: usize, write: impl Fn(&[Sym], Sym) -> Differential + Send + Sync + 'static) -> Self {
        DirectionalProgram { states, write: Box::new(write), made: OnceLock::new() }
    }

    /// The derivatives from the rates of a law.
    pub fn of(law: Arc<dyn SymbolicLaw>) -> Self {
        let states = law.dimension();
        DirectionalProgram::by(states, move |state, time| DirectionalProgram::of_rates(&*law, state, time))
    }

    /// The differential of the rates of a law.
    pub fn of_rates(law: &dyn SymbolicLaw, state: &[Sym], time: Sym) -> Differential {
        let mut rates = vec![Sym::ZERO; state.len()];
        law.rates(time, state, &mut rates);
        Differential::of(&[state, &[time]].concat(), &rates)
    }

    fn make(&self) -> Option<Made> {
        let mut found = None;
        let weights = Program::of(self.states, |time, state| {
            let differential = (self.write)(state, time);
            let weights = differential.weights();
            let sums = Sums::of(&differential);
            found = Some((blocks(&sums), sums));
            weights
        })?;
        let (blocks, sums) = found?;
        Some(Made { weights, sums, blocks })
    }
}

impl Differentiable for DirectionalProgram {
    fn jacobian_fn(&self) -> Option<Box<dyn JacobianFn + '_>> {
        let made = self.made.get_or_init(|| self.make()).as_ref()?;
        let Made { sums, .. } = made;
        Some(Box::new(Directions {
            made,
            weights: vec![0.0; sums.terms()],
            places: vec![[0.0; LANES]; sums.places()],
            arch: Arch::new(),
        }))
    }
}

/// The derivatives with buffers for one run.
struct Directions<'a> {
    made: &'a Made,
    weights: Vec<f64>,
    places: Vec<[f64; LANES]>,
    arch: Arch,
}

impl Directions<'_> {
    /// Writes the derivatives in the directions of some blocks, into rows of `width` numbers.
    fn run(&mut self, point: (f64, &[f64]), blocks: &[Block], (width, rows): (usize, &mut [f64])) {
        let Made { weights, sums, .. } = self.made;
        // the length of the state is correct by construction
        weights.run(point.0, point.1, &mut self.weights).unwrap_or(());
        rows.fill(0.0);
        self.arch.dispatch(Run { sums, blocks, weights: &self.weights, places: &mut self.places, width, rows });
    }
}

impl JacobianFn for Directions<'_> {
    fn code_size(&self) -> Option<usize> {
        self.made.weights.code_size()
    }

    fn matrix(&mut self, t: f64, y: &[f64], matrix: &mut [f64]) {
        let Some((_, blocks)) = self.made.blocks.split_last() else { return };
        self.run((t, y), blocks, (y.len(), matrix));
    }

    fn by_time(&mut self, t: f64, y: &[f64], slopes: &mut [f64]) {
        let Some(block) = self.made.blocks.last() else { return };
        // intermediate results are reused between evaluations of the blocks of the state
        self.places.fill([0.0; LANES]);
        self.run((t, y), std::slice::from_ref(block), (1, slopes));
        self.places.fill([0.0; LANES]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use field::{Analytic, Scalar};
    use symbolic::{Tape, apart};

    const STATES: usize = 2 * LANES + 3;

    /// Each rate depends on its neighbours, some on the time, one on nothing; products of neighbours occur in two
    /// rates, also across the ends of blocks.
    fn rates(state: &[Sym], time: Sym) -> Vec<Sym> {
        let beside = |i: usize| state[(i + 1) % STATES];
        let shared = |i: usize| (state[i] * beside(i)).circle().sin;
        let rate = |i: usize| match i {
            0 => Sym::int(2),
            _ if i.is_multiple_of(6) => (state[i] * time).circle().sin + state[i],
            _ => shared(i) * shared(i - 1) / (Sym::int(2) + shared(i) * shared(i)),
        };
        (0..STATES).map(rate).collect()
    }

    #[test]
    fn derivatives_in_blocks_are_those_of_expressions_whatever_ran_before() {
        let program = DirectionalProgram::by(STATES, |state, time| {
            Differential::of(&[state, &[time]].concat(), &rates(state, time))
        });
        let mut directions = program.jacobian_fn().expect("it has values");
        let y: Vec<f64> = (0..STATES).map(|i| (i as f64).sin()).collect();
        let t = 0.7;
        let tape = apart(|| {
            let state: Vec<Sym> = (0..STATES).map(|i| Sym::symbol(&format!("y{i}"))).collect();
            let inputs = [&state[..], &[Sym::symbol("t")]].concat();
            let all = rates(&state, inputs[STATES]);
            let slopes: Vec<Sym> = all.iter().flat_map(|rate| inputs.iter().map(|&by| rate.diff(by))).collect();
            Tape::record(&inputs, &slopes).expect("it has values")
        });
        let mut wanted = vec![0.0; STATES * (STATES + 1)];
        tape.over::<f64>().evaluate(&[&y[..], &[t]].concat(), &mut wanted);
        let (mut matrix, mut by_time) = (vec![f64::NAN; STATES * STATES], vec![f64::NAN; STATES]);
        for _ in 0..2 {
            directions.matrix(t, &y, &mut matrix);
            directions.by_time(t, &y, &mut by_time);
            for (row, wanted) in wanted.chunks(STATES + 1).enumerate() {
                let own = matrix[row * STATES..][..STATES].iter().chain([&by_time[row]]);
                for (own, wanted) in own.zip(wanted) {
                    assert!((own - wanted).abs() < 1e-15 * wanted.abs().max(1.0), "{own} {wanted}");
                }
            }
        }
        assert!(by_time.iter().any(|slope| slope.abs() > 0.1));
    }
}
