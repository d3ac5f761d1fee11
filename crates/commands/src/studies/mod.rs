//! Studies in the report: gains and treatments of stabilised constraints, the electromechanical drive, long runs,
//! numerical stability, a synchronous motor under load, failures of methods.

pub mod atlas;
mod drive;
mod endurance;
mod failures;
mod foreign;
mod gains;
mod million;
mod numerical_stability;
pub mod peers;
pub mod synchronism;
mod treatments;

pub use drive::Drive;
pub use endurance::Endurance;
pub use failures::Failures;
pub use foreign::{FOLDER, ForeignProblems};
pub use gains::Gains;
pub use numerical_stability::NumericalStability;
pub use synchronism::Synchronism;

use charts::AreaCurve;
use integrators::Failure;

fn missing(failure: &Failure) -> String {
    format!("Not measured, because the reference stopped: {failure}.")
}

fn extent(curves: &[AreaCurve], value: impl Fn(&(f64, f64)) -> f64) -> [f64; 2] {
    let all = curves.iter().flat_map(|curve| &curve.points).map(value);
    let (low, high) = all.fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(x), high.max(x)));
    let margin = 0.08 * (high - low).max(1e-9);
    [low - margin, high + margin]
}
