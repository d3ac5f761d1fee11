//! Divisors, radicands and angles of a law as a program.

use crate::law::program::Program;
use integrators::Divisors;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicU32, Ordering};
use symbolic::Tape;

/// The number of evaluations after which machine code is generated: generating it costs as much as some hundreds of
/// interpreted evaluations.
const WRITTEN_AFTER: u32 = 500;

/// The divisors, radicands and angles of a program, interpreted until a run is long.
#[derive(Debug)]
pub(super) struct DivisorProgram {
    tape: Tape,
    counts: [usize; 3],
    followed: Program,
    written: OnceLock<Option<Program>>,
    evaluations: AtomicU32,
}

impl DivisorProgram {
    /// The divisors of a program; `None` where it divides by constants only and has neither square roots nor angles.
    pub fn of(program: &Program) -> Option<Self> {
        let (tape, counts) = program.singular_places()?;
        Some(DivisorProgram {
            followed: Program::without_code(tape.clone()),
            tape,
            counts,
            written: OnceLock::new(),
            evaluations: AtomicU32::new(0),
        })
    }

    fn program(&self) -> &Program {
        if self.evaluations.load(Ordering::Relaxed) < WRITTEN_AFTER {
            self.evaluations.fetch_add(1, Ordering::Relaxed);
            return &self.followed;
        }
        self.written.get_or_init(|| Program::of_tape(self.tape.clone())).as_ref().unwrap_or(&self.followed)
    }
}

impl Divisors for DivisorProgram {
    fn counts(&self) -> [usize; 3] {
        self.counts
    }

    fn at(&self, t: f64, y: &[f64], out: &mut [f64]) {
        // the length of the state is correct by construction
        self.program().run(t, y, out).unwrap_or(());
    }
}
