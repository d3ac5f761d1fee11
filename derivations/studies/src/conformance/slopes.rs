//! Check of the Jacobian by two methods: dual numbers, and symbolic differentiation.

use claims::finding::PropertyVerdict;
use integrators::{Dual8, Jacobian, Ode, System};
use motor::{Bench, Motor};
use simulation::{CompiledLaw, SymbolicLaw};
use std::sync::Arc;

/// The allowed difference of two entries, relative to the largest entry.
const ROUNDING: f64 = 1e-13;
/// States at which the entries are compared.
const STATES: usize = 5;

/// Compares both Jacobians of a motor on a bench.
pub(super) fn jacobian(machine: &Motor) -> PropertyVerdict {
    let bench = Bench { machine: machine.clone(), axial: 0.7 };
    match bench.dimension() {
        0 => PropertyVerdict::DoesNotApply("a kept rotor without windings has no state of its own".to_owned()),
        _ => compared(Arc::new(bench)).map_or_else(PropertyVerdict::Fails, |recorded| match recorded {
            true => PropertyVerdict::Tested("dual numbers and recorded polynomials give the same".to_owned()),
            false => PropertyVerdict::DoesNotApply("an entry is no polynomial: dual numbers alone give it".to_owned()),
        }),
    }
}

/// Whether a law has a symbolic Jacobian; compares it with that by dual numbers.
///
/// # Errors
/// The first entry that differs.
pub fn compared<L>(law: Arc<L>) -> Result<bool, String>
where
    L: Ode<Dual8> + SymbolicLaw + 'static,
{
    let system = CompiledLaw::of(Arc::clone(&law) as Arc<dyn SymbolicLaw>);
    let n = Ode::<f64>::dimension(&system);
    let dual: &dyn Ode<Dual8> = &*law;
    let (mut ours, mut theirs) = (vec![f64::NAN; n * n], vec![f64::NAN; n * n]);
    for turn in 0..STATES {
        let y: Vec<f64> = (0..n).map(|i| 2.0 * ((7 * turn + 3 * i) as f64).sin()).collect();
        Jacobian::of(&system).matrix(0.0, &y, &mut ours);
        Jacobian::new(dual).matrix(0.0, &y, &mut theirs);
        let size = theirs.iter().fold(1.0, |most: f64, entry| most.max(entry.abs()));
        for (place, (ours, theirs)) in ours.iter().zip(&theirs).enumerate() {
            let alike = (ours - theirs).abs() < ROUNDING * size;
            if !alike {
                return Err(format!("row {}, column {}: the two routes differ", place / n, place % n));
            }
        }
    }
    Ok(system.jacobian_fn().is_some())
}
