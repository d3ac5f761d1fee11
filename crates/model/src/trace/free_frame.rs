//! The symbols of a frame that turns freely.

use super::rotation::{Rotation, quaternion_rates};
use crate::parts::{QUATERNION, TURNING};
use symbolic::Sym;

/// Quaternion, angular velocity in the frame's own axes, and its rate.
pub(super) struct FreeFrame {
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
    /// By the quaternion's rates the same comes out, of any length, and much longer.
    pub fn turned(&self, w: [Sym; 3]) -> impl Iterator<Item = (Sym, Sym)> {
        self.cosines.into_iter().flat_map(move |row| {
            (0..3).map(move |column| {
                let (next, last) = ((column + 1) % 3, (column + 2) % 3);
                (row[column], row[next] * w[last] - row[last] * w[next])
            })
        })
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
