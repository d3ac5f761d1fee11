//! The symbols of a free frame.

use super::rotation::{Rotation, quaternion_product, quaternion_rates};
use super::{Trace, Vector};
use crate::parts::{QUATERNION, TURNING};
use symbolic::Sym;

/// Returns the rates of the quaternion of free frame `number`, and each direction cosine with its rate, for an angular
/// velocity relative to the parent, along any axes:
///
///   q' = q w/2 along the frame's own axes, q' = W q/2 along the parent's axes, R' = [W x] R .
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

/// The symbols of a free frame: quaternion, angular velocity along its own axes, and the rate of the latter.
pub(crate) struct FreeFrame {
    pub quaternion: [Sym; 4],
    pub speeds: [Sym; 3],
    pub accelerations: [Sym; 3],
    /// The direction cosines: entry (i, j) is axis i of the parent times axis j of the frame.
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

    /// Returns each direction cosine with its rate, for the angular velocity w along the frame's own axes:
    ///
    ///   R' = R [w x] .
    ///
    /// The rates of the quaternion give an equal expression, for any norm, which is much longer.
    pub fn turned(&self, w: [Sym; 3]) -> impl Iterator<Item = (Sym, Sym)> {
        turned(self.cosines, w)
    }

    /// Returns the rates of the quaternion.
    pub fn rates(&self) -> [Sym; 4] {
        quaternion_rates(self.quaternion, self.speeds)
    }

    /// Returns the rates of the quaternion's components and of the direction cosines, for a unit rotation about each axis of the frame.
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
