//! Random numbers by their place: every member has its own at once, whoever computes it and when.

use std::f64::consts::TAU;

/// The numbers of one datum of one member.
#[derive(Clone, Copy, Debug)]
pub struct Draw {
    key: u64,
}

impl Draw {
    /// Of a datum, by its name: what else varies changes nothing.
    pub fn new(seed: u64, member: u64, datum: &str) -> Self {
        let name = datum.bytes().fold(seed, |key, byte| mixed(key ^ u64::from(byte)));
        Draw { key: mixed(name ^ mixed(member)) }
    }

    /// Number i, even between 0 and 1, both excluded.
    pub fn even(self, i: usize) -> f64 {
        let bits = mixed(self.key ^ mixed(!(i as u64))) >> 11;
        (bits as f64 + 0.5) / (1_u64 << 53) as f64
    }

    /// Number i, normal with mean 0 and deviation 1 (Box and Muller 1958).
    pub fn normal(self, i: usize) -> f64 {
        (-2.0 * self.even(2 * i).ln()).sqrt() * (TAU * self.even(2 * i + 1)).cos()
    }
}

/// One step of SplitMix64 (Steele, Lea and Flood 2014): near numbers become unrelated ones.
fn mixed(number: u64) -> u64 {
    let z = number.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::Draw;

    #[test]
    fn numbers_have_the_moments_of_their_distribution() {
        let count = 40_000;
        let moments = |number: &dyn Fn(u64) -> f64| {
            let powers = |power: i32| (0..count).map(|n| number(n).powi(power)).sum::<f64>() / count as f64;
            [powers(1), powers(2), powers(4)]
        };
        let near = |found: [f64; 3], known: [f64; 3]| found.iter().zip(known).all(|(a, b)| (a - b).abs() < 0.05);
        let [even, normal] = [moments(&|n| Draw::new(1, n, "x").even(0)), moments(&|n| Draw::new(1, n, "x").normal(2))];
        assert!(near(even, [1.0 / 2.0, 1.0 / 3.0, 1.0 / 5.0]) && near(normal, [0.0, 1.0, 3.0]), "{even:?} {normal:?}");
    }

    #[test]
    fn seed_member_datum_and_place_each_change_the_number() {
        let of = |seed, member, datum, i| Draw::new(seed, member, datum).even(i);
        let one = of(1, 1, "a", 0);
        assert!([of(2, 1, "a", 0), of(1, 2, "a", 0), of(1, 1, "b", 0), of(1, 1, "a", 1)].iter().all(|x| *x != one));
        assert_eq!(of(1, 1, "a", 0), one);
    }
}
