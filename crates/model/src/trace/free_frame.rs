//! The symbols of a frame that turns freely.

use super::rotation::quaternion_rates;
use crate::parts::{QUATERNION, TURNING};
use field::Scalar;
use symbolic::Sym;

/// Quaternion, angular velocity in the frame's own axes, and its rate.
pub(super) struct FreeFrame {
    pub quaternion: [Sym; 4],
    pub speeds: [Sym; 3],
    pub accelerations: [Sym; 3],
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
        FreeFrame { quaternion, speeds: turning("", ""), accelerations: turning(r"\dot", "'") }
    }

    /// The rates of the quaternion.
    pub fn rates(&self) -> [Sym; 4] {
        quaternion_rates(self.quaternion, self.speeds)
    }

    /// The rates of the quaternion's parts for a turn about each axis of the frame alone.
    pub fn displacements(&self) -> [[(Sym, Sym); 4]; 3] {
        std::array::from_fn(|axis| {
            let about = std::array::from_fn(|other| if other == axis { Sym::ONE } else { Sym::int(0) });
            let rates = quaternion_rates(self.quaternion, about);
            std::array::from_fn(|part| (self.quaternion[part], rates[part]))
        })
    }
}
