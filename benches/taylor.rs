//! The Taylor method for the gyrostat with 6 states (constant speed), 7 (free rotor), 8 (synchronous motor) and 15 (six
//! damper bars), in both forms: the time to record the laws, and the time of a run of two seconds for several
//! tolerances. Run it by `cargo bench --bench taylor`.

use dalembert_derivations::machines::multi_current::MultiCurrent;
use dalembert_derivations::machines::synchronous::Synchronous;
use dalembert_derivations::systems::gyrostat::driven::Driven;
use integrators::{System, Taylor, Tolerance};
use motor::ConstantSpeed;
use motor::FreeRotor;
use simulation::{CompiledLaw, SymbolicLaw};
use std::time::Instant;

mod gyrostat;

const REPEATS: usize = 15;
const RUNS: u32 = 20;
const SPAN: f64 = 2.0;

fn main() {
    let (gyrostat, windings) = (gyrostat::gyrostat(), gyrostat::windings());
    let single = Synchronous { field_speed: windings.field_speed, b0: windings.b0, f: windings.f };
    let bars = MultiCurrent::evenly(windings, 6);
    let (first, second) = (gyrostat.first_form().0, gyrostat.second_form().0);
    println!("states form    recorded [ms]   tolerance order steps   run [us]  step [ns]   error");
    rows("second", Driven::new(second, ConstantSpeed { speed: windings.field_speed }));
    rows("second", Driven::new(second, FreeRotor::default()));
    rows("first", Driven::new(first, single));
    rows("second", Driven::new(second, single));
    rows("first", Driven::new(first, bars.clone()));
    rows("second", Driven::new(second, bars));
}

fn rows(form: &str, law: impl SymbolicLaw + 'static) {
    let states = law.dimension();
    let start = Instant::now();
    let system = CompiledLaw::new(law);
    let recorded = start.elapsed().as_secs_f64() * 1e3;
    let mut first = vec![1.0, -2.0, 3.0, 0.6, 0.0, 0.8, 0.3, -1.0];
    first.resize(states, 0.1);
    let run = |tolerance: f64| -> Option<(usize, u64, f64, Vec<f64>)> {
        let mut taylor = Taylor::new(system.taylor()?, &Tolerance::both(tolerance));
        let mut state = first.clone();
        let steps = taylor.propagate(0.0, SPAN, &mut state).ok()?;
        let mut times: Vec<f64> = (0..REPEATS)
            .map(|_| {
                let start = Instant::now();
                for _ in 0..RUNS {
                    state.copy_from_slice(&first);
                    if taylor.propagate(0.0, SPAN, &mut state).is_err() {
                        return f64::NAN;
                    }
                }
                start.elapsed().as_secs_f64() * 1e6 / f64::from(RUNS)
            })
            .collect();
        times.sort_by(f64::total_cmp);
        Some((taylor.order(), steps, times[REPEATS / 2], state))
    };
    let Some((.., exact)) = run(3e-15) else { return println!("{states:>6} {form:<7} no run") };
    for tolerance in [1e-6, 1e-9, 1e-12, 1e-14] {
        let Some((order, steps, time, end)) = run(tolerance) else { continue };
        let error = end.iter().zip(&exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let step = time * 1e3 / steps as f64;
        println!(
            "{states:>6} {form:<7} {recorded:>13.2}   {tolerance:>9.0e} {order:>5} {steps:>5} {time:>10.1} {step:>10.0}  {error:>6.0e}"
        );
    }
}
