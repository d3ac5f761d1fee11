//! Nanoseconds per evaluation of the right-hand side and of its full Jacobian: as machine code generated at run time;
//! as the law compiled with the project; and for eight directional derivatives by num-dual. The law is the gyrostat
//! with 8 states (synchronous motor) and with 15 (six damper bars), in both forms. Also reported: the operations, not
//! counting sine and cosine, and the fraction of the processor's peak rate; the second form compared with straight-line
//! C, compiled for any processor of this architecture and for this processor.
//!
//! Run it by `cargo bench --bench rates`. To count the instructions of 1000 right-hand sides and 1000 Jacobians of the
//! second form with 15 or 8 states:
//!
//! ```text
//! CARGO_TARGET_X86_64_UNKNOWN_LINUX_GNU_RUNNER="valgrind --tool=callgrind --callgrind-out-file=/dev/null \\
//!   --toggle-collect=*thousand_values*" cargo bench --bench rates -- thousand 15
//! ```
//!
//! and the same with `thousand_jacobians`.

use dalembert_derivations::machines::multi_current::MultiCurrent;
use dalembert_derivations::machines::synchronous::Synchronous;
use dalembert_derivations::systems::gyrostat::driven::Driven;
use dalembert_derivations::systems::gyrostat::forms::Form;
use field::{Analytic, Over};
use integrators::Dual8;
use motor::Machine;
use native::Code;
use std::hint::black_box;
use std::time::Instant;
use symbolic::{Sym, Tape};

mod gyrostat;
mod peak;
mod straight_line;

const REPEATS: usize = 9;
const CALLS: u32 = 200_000;

fn main() {
    let (gyrostat, windings) = (gyrostat::gyrostat(), gyrostat::windings());
    let single = Synchronous { field_speed: windings.field_speed, b0: windings.b0, f: windings.f };
    let bars = MultiCurrent::evenly(windings, 6);
    let (first, second) = (gyrostat.first_form().0, gyrostat.second_form().0);
    if std::env::args().any(|argument| argument == "thousand") {
        return match std::env::args().any(|argument| argument == "8") {
            true => thousand(&Driven::new(second, single)),
            false => thousand(&Driven::new(second, bars)),
        };
    }
    let peak = peak::flops_per_nanosecond();
    println!("the most that one core can, by products and sums rounded once: {peak:.1} flops/ns");
    println!(
        "states form    value [ns]  flops   of the most   Jacobian [ns]  flops   of the most   compiled: value [ns]   eight directions [ns]"
    );
    row("first", &Driven::new(first, single), peak);
    row("second", &Driven::new(second, single), peak);
    row("first", &Driven::new(first, bars.clone()), peak);
    row("second", &Driven::new(second, bars.clone()), peak);
    println!(
        "states  C for         value: ours, exported C, C by hand [ns]   ratios         Jacobian: ours, exported C [ns]   in values"
    );
    for native in [false, true] {
        beside(native, &Driven::new(second, single), &gyrostat, &windings);
        beside(native, &Driven::new(second, bars.clone()), &gyrostat, &windings);
    }
}

fn thousand<F: Form<f64>, M: Machine<f64>>(law: &Driven<f64, F, M>) {
    if let Some((value, jacobian)) = written(law) {
        thousand_values(&value, law.dimension());
        thousand_jacobians(&jacobian, law.dimension());
    }
}

/// The right-hand side and the Jacobian as tapes.
fn recorded<F: Form<f64>, M: Machine<f64>>(law: &Driven<f64, F, M>) -> Option<(Tape, Tape)> {
    let n = law.dimension();
    let state: Vec<Sym> = (0..n).map(|i| Sym::symbol(&format!("y{i}"))).collect();
    let mut rates = vec![Sym::ZERO; n];
    law.rates(&state, &mut rates);
    let entries: Vec<Sym> = rates.iter().flat_map(|rate| state.iter().map(|&by| rate.diff(by))).collect();
    // the code takes the time as an input too
    let inputs = [state, vec![Sym::symbol("t")]].concat();
    Some((Tape::record(&inputs, &rates).ok()?, Tape::record(&inputs, &entries).ok()?))
}

/// The rates and the entries of their Jacobian as machine code.
fn written<F: Form<f64>, M: Machine<f64>>(law: &Driven<f64, F, M>) -> Option<(Code, Code)> {
    let (tape, entries) = recorded(law)?;
    Some((Code::of(&tape.arranged())?, Code::of(&entries.arranged())?))
}

fn row<F: Form<f64>, M: Machine<f64>>(form: &str, law: &Driven<f64, F, M>, peak: f64) {
    let n = law.dimension();
    let Some(((tape, entries), (value, jacobian))) = recorded(law).zip(written(law)) else {
        return println!("{n:>6} {form:<7} cannot be written");
    };
    let (compiled, directions) = (nanoseconds::<f64, F, M>(law), nanoseconds::<Dual8, F, M>(law));
    let (value, of_value) = (one_call(&value, n, n), tape.flops());
    let (whole, of_whole) = (one_call(&jacobian, n, n * n), entries.flops());
    let share = |flops: usize, time: f64| 100.0 * flops as f64 / time / peak;
    println!(
        "{n:>6} {form:<7} {value:>10.1} {of_value:>6} {:>12.1}% {whole:>15.1} {of_whole:>6} {:>12.1}% {compiled:>22.1} {directions:>23.1}",
        share(of_value, value),
        share(of_whole, whole),
    );
}

/// The median times of this project's code and of C, measured alternately.
fn beside<F: Form<f64>, M: Machine<f64>>(
    native: bool,
    law: &Driven<f64, F, M>,
    gyrostat: &dalembert_derivations::systems::gyrostat::Gyrostat<f64>,
    windings: &dalembert_derivations::machines::multi_current::Windings<f64>,
) {
    let n = law.dimension();
    let Some(((tape, entries), (value, jacobian))) = recorded(law).zip(written(law)) else { return };
    let turns: Option<Vec<[f64; 5]>> = (0..5)
        .map(|_| {
            let c = straight_line::in_c(native, n, gyrostat, windings, &tape, &entries)?;
            let own = [one_call(&value, n, n), one_call(&jacobian, n, n * n)];
            Some([own[0], c.exported, c.by_hand, own[1], c.jacobian])
        })
        .collect();
    let Some(turns) = turns else { return println!("{n:>6}  needs gcc, and values that agree") };
    let [own, exported, by_hand, whole, in_c] = std::array::from_fn(|i| {
        let mut column: Vec<f64> = turns.iter().map(|turn| turn[i]).collect();
        column.sort_by(f64::total_cmp);
        column[column.len() / 2]
    });
    println!(
        "{n:>6}  {:<14} {own:>10.1} {exported:>10.1} {by_hand:>10.1} {:>16.2} {:.2} {whole:>17.1} {in_c:>10.1} {:>18.1}",
        if native { "this processor" } else { "any" },
        own / exported,
        own / by_hand,
        whole / own,
    );
}

#[inline(never)]
fn thousand_values(value: &Code, n: usize) {
    thousand_calls(value, n, n);
}

#[inline(never)]
fn thousand_jacobians(jacobian: &Code, n: usize) {
    thousand_calls(jacobian, n, n * n);
}

fn thousand_calls(code: &Code, n: usize, outputs: usize) {
    let (state, mut values) = (start(n), vec![0.0; outputs]);
    for _ in 0..1000 {
        code.run(black_box(&state), 0.0, &mut values);
        black_box(&mut values);
    }
}

fn start(n: usize) -> Vec<f64> {
    (0..n).map(|i| 0.1 + 0.05 * i as f64).collect()
}

/// Nanoseconds per call of machine code; each call depends on the one before.
fn one_call(code: &Code, n: usize, outputs: usize) -> f64 {
    let (mut state, mut values) = (start(n), vec![0.0; outputs]);
    median(|| {
        code.run(&state, 0.0, &mut values);
        state[0] += values[outputs.min(2) - 1] * 1e-15;
    })
}

/// Nanoseconds per call of a compiled law.
fn nanoseconds<S: Over<f64> + Analytic, F: Form<f64>, M: Machine<f64>>(law: &Driven<f64, F, M>) -> f64 {
    let mut state: Vec<S> = start(law.dimension()).into_iter().map(S::lift).collect();
    let mut rates = state.clone();
    let tiny = S::lift(1e-15);
    median(|| {
        law.rates(&state, &mut rates);
        state[0] += rates[0] * tiny;
    })
}

/// The median over repetitions of the mean over calls.
fn median(mut call: impl FnMut()) -> f64 {
    let mut times: Vec<f64> = (0..REPEATS)
        .map(|_| {
            let start = Instant::now();
            for _ in 0..CALLS {
                call();
            }
            start.elapsed().as_secs_f64() * 1e9 / f64::from(CALLS)
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[REPEATS / 2]
}
