//! The symbols of a frame that turns freely.

use super::rotation::{Rotation, quaternion_product, quaternion_rates};
use super::{Trace, Vector};
use crate::parts::{QUATERNION, TURNING};
use symbolic::Sym;

/// The rates of the quaternion of a free frame, by its number, and of its direction cosines, each with its rate, for an angular
/// velocity in its parent along any axes:
///
///   q' = q w/2 along its own, q' = W q/2 along those of the parent, R' = [W x] R .
pub(crate) fn turned_axes(trace: &Trace<'_>, number: usize, turning: Vector) -> ([Sym; 4], Vec<(Sym, Sym)>) {
    let model = trace.model;
    let (own, first) = (model.free[number], model.coordinates.len() + 4 * number);
    let quaternion: [Sym; 4] = std::array::from_fn(|k| trace.coordinates[first + k]);
    let cosines = trace.cosines[number];
    if turning.frame == own {
        let rates = quaternion_rates(quaternion, turning.components);
        return (rates, turned(cosines, turning.components).collect());
    }
    let half = Sym::constant(field::Rational::new(1, 2));
    let [x, y, z] = trace.express(turning, trace.parent(own));
    let rates = quaternion_product([Sym::ZERO, x, y, z], quaternion).map(|part| half * part);
    let rates_of_row = |row: usize| {
        let (next, last) = ((row + 1) % 3, (row + 2) % 3);
        let turning = [x, y, z];
        (0..3).map(move |column| {
            let rate = turning[next] * cosines[last][column] - turning[last] * cosines[next][column];
            (cosines[row][column], rate)
        })
    };
    (rates, (0..3).flat_map(rates_of_row).collect())
}

/// Quaternion, angular velocity in the frame's own axes, and its rate.
pub(crate) struct FreeFrame {
    pub quaternion: [Sym; 4],
    pub speeds: [Sym; 3],
    pub accelerations: [Sym; 3],
    /// Direction cosines: row i, column j holds the axis i of the parent times the axis j of the frame.
    pub cosines: [[Sym; 3]; 3],
}

impl FreeFrame {
    pub fn named(name: &str) -> Self {
        let letter = Sym::symbol(name).latex();
        let turning = |dot: &str, prime: &str| {
            TURNING.map(|part| {
                let latex = format!(r"{dot}{{\omega}}_{{{letter},{}}}", &part[1..]);
                Sym::named(&format!("{name}.{part}{prime}"), &latex)
            })
        };
        let quaternion =
            QUATERNION.map(|part| Sym::named(&format!("{name}.{part}"), &format!("q_{{{letter},{}}}", &part[1..])));
        let cosines = Rotation::direction_cosines(quaternion);
        FreeFrame { quaternion, speeds: turning("", ""), accelerations: turning(r"\dot", "'"), cosines }
    }

    /// The direction cosines, each with its rate where the frame turns at this angular velocity, w in its own axes:
    ///
    ///   R' = R [w x] .
    ///
    /// The rates of the quaternion give an equal expression, for any norm, which is much longer.
    pub fn turned(&self, w: [Sym; 3]) -> impl Iterator<Item = (Sym, Sym)> {
        turned(self.cosines, w)
    }

    /// The rates of the quaternion.
    pub fn rates(&self) -> [Sym; 4] {
        quaternion_rates(self.quaternion, self.speeds)
    }

    /// The rates of the quaternion's parts and of the direction cosines for a turn about each axis of the frame alone.
    pub fn displacements(&self) -> [Vec<(Sym, Sym)>; 3] {
        std::array::from_fn(|axis| {
            let about = std::array::from_fn(|other| if other == axis { Sym::ONE } else { Sym::ZERO });
            let rates = quaternion_rates(self.quaternion, about);
            self.quaternion.into_iter().zip(rates).chain(self.turned(about)).collect()
        })
    }
}

fn turned(cosines: [[Sym; 3]; 3], w: [Sym; 3]) -> impl Iterator<Item = (Sym, Sym)> {
    cosines.into_iter().flat_map(move |row| {
        (0..3).map(move |column| {
            let (next, last) = ((column + 1) % 3, (column + 2) % 3);
            (row[column], row[next] * w[last] - row[last] * w[next])
        })
    })
}
