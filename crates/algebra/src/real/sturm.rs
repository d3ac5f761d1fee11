//! The number of real roots by Sturm's theorem: an independent check of Descartes' rule.

use super::Polynomial;

impl Polynomial {
    /// The number of distinct real roots by Sturm's chain; zero for the zero polynomial.
    pub fn count_by_sturm(&self) -> usize {
        let (mut a, mut b) = (self.primitive(), self.derivative().primitive());
        let mut ends = [signs_at_ends(&a)].to_vec();
        while !b.is_zero() {
            ends.push(signs_at_ends(&b));
            let rest = -&a.remainder(&b).primitive();
            (a, b) = (b, rest);
        }
        let changes = |side: usize| ends.windows(2).filter(|pair| pair[0][side] * pair[1][side] < 0).count();
        changes(0).saturating_sub(changes(1))
    }
}

/// The signs at minus infinity and at plus infinity.
fn signs_at_ends(p: &Polynomial) -> [i32; 2] {
    let sign = p.lead().sign();
    let odd = p.degree().is_some_and(|degree| degree % 2 == 1);
    [if odd { -sign } else { sign }, sign]
}
