//! Maps of all steady motions over any two data of a scene; the rotor's axis need not be a principal axis, and its
//! speed may be irrational.
//!
//! # Overview
//! * [`Region`]: a scene, two data with their ranges, and the grid;
//! * `law`: the linearised law with symbols for all quantities that vary over the map;
//! * [`node`]: all steady motions at two values of the data, with verdicts from `spot`;
//! * [`line`](mod@line): which motions of two neighbours are proved to be the same; the borders between them, where a
//!   motion ends or its verdict changes;
//! * [`atlas`]: branches, each with at most one motion at a node.
//!
//! At the nodes all verdicts are proved. Between two neighbours a motion is continued by Krawczyk's operator over the
//! whole interval. Where its verdict changes, or where it merges with another motion, the point is found by bisection;
//! the verdicts at the bisection points are proved as at the nodes. Other events between neighbours, such as a region
//! smaller than the mesh, are not excluded.

pub mod atlas;
mod law;
pub mod line;
pub mod node;
mod spot;

pub use atlas::{Atlas, Branch};
pub use line::{Border, Change};
pub use node::{Class, Node, NodeMotions};

use super::datum::{Datum, Setting};
use crate::ensemble::known::Data;
use crate::scene::Scene;
use crate::stationary::motor::NoMotor;
use law::{Ground, Letters};
use std::fmt;
use std::sync::{Arc, OnceLock};

/// A map over two data of a scene.
pub struct Region<'a> {
    scene: &'a Scene,
    data: [&'a Datum; 2],
    /// The values of the two data at the nodes.
    pub values: [Vec<f64>; 2],
    general: Setting,
    letters: Letters,
    common: OnceLock<Result<Arc<Ground>, NoMotor>>,
}

/// The reason why there is no map.
#[derive(Clone, Debug, PartialEq)]
pub enum NoRegion {
    Bench,
    /// Only the first of the two data may change the motor's steady state.
    OfMotor(String),
    Motor(NoMotor),
    /// A number is infinite or not a number.
    NotFinite(f64),
}

impl<'a> Region<'a> {
    /// The map over two data in their ranges, with the numbers of columns and rows of cells. `speed` is w0, rad/s, and
    /// is ignored if w0 is one of the data.
    ///
    /// # Errors
    /// [`NoRegion`] gives the reason why there is no map.
    pub fn of(
        scene: &'a Scene,
        data: [(&'a Datum, [f64; 2]); 2],
        speed: f64,
        cells: [usize; 2],
    ) -> Result<Self, NoRegion> {
        if scene.on_bench() {
            return Err(NoRegion::Bench);
        }
        let [(first, _), (second, _)] = data;
        if second.is_of_motor() {
            return Err(NoRegion::OfMotor(second.name.clone()));
        }
        let ends = data.iter().flat_map(|(_, range)| range).chain([&speed]);
        if let Some(wrong) = ends.into_iter().find(|x| !x.is_finite()) {
            return Err(NoRegion::NotFinite(*wrong));
        }
        let values = [0, 1].map(|k| nodes(data[k].1, cells[k]));
        let general = Setting { data: Data::of(scene), load: 0.0, speed, rotor_speed: None };
        let letters = Letters::of(scene, [first, second]).map_err(NoRegion::Motor)?;
        Ok(Region { scene, data: [first, second], values, general, letters, common: OnceLock::new() })
    }

    fn setting(&self, [first, second]: [f64; 2]) -> Setting {
        self.general.with(self.data[0], first).with(self.data[1], second)
    }
}

/// The midpoints of the cells, rounded relative to the range, so that they are short decimals.
pub fn nodes([low, high]: [f64; 2], cells: usize) -> Vec<f64> {
    let step = 10f64.powf((high - low).abs().log10().floor() - 5.0);
    let rounded = |value: f64| {
        let rounded = (value / step).round() * step;
        format!("{rounded:.6e}").parse().unwrap_or(rounded)
    };
    (0..cells).map(|k| rounded(low + (high - low) * (2 * k + 1) as f64 / (2 * cells) as f64)).collect()
}

impl fmt::Display for NoRegion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Bench => {
                write!(f, "a motor on a bench has no carrier; a scene with system = \"gyrostat\" is accepted")
            }
            Self::OfMotor(name) => {
                write!(f, "`{name}` changes what the motor keeps; it is accepted as the first of the two data")
            }
            Self::Motor(reason) => reason.fmt(f),
            Self::NotFinite(value) => write!(f, "{value} is not finite; a finite number is accepted"),
        }
    }
}

impl std::error::Error for NoRegion {}
