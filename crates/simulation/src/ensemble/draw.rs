//! Counter-based random numbers, which do not depend on the order or thread of computation.

use std::f64::consts::TAU;

/// The random numbers of one datum of one member.
#[derive(Clone, Copy, Debug)]
pub struct Draw {
    key: u64,
}

impl Draw {
    /// The random numbers of a datum, identified by its name: they do not depend on other data that vary.
    pub fn new(seed: u64, member: u64, datum: &str) -> Self {
        let name = datum.bytes().fold(seed, |key, byte| mixed(key ^ u64::from(byte)));
        Draw { key: mixed(name ^ mixed(member)) }
    }

    /// Number i, uniform on the open interval (0, 1).
    pub fn even(self, i: usize) -> f64 {
        let bits = mixed(self.key ^ mixed(!(i as u64))) >> 11;
        (bits as f64 + 0.5) / (1_u64 << 53) as f64
    }

    /// Number i, normal with mean 0 and standard deviation 1 (Box and Muller 1958).
    pub fn normal(self, i: usize) -> f64 {
        (-2.0 * self.even(2 * i).ln()).sqrt() * (TAU * self.even(2 * i + 1)).cos()
    }
}

/// One step of SplitMix64 (Steele, Lea and Flood 2014), a hash of 64 bits.
fn mixed(number: u64) -> u64 {
    let z = number.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
