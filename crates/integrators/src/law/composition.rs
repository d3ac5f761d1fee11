//! Compositions of a splitting with its adjoint: coefficients, and the sequence of sub-flows.
//!
//! Let f = f_1 + .. + f_m with known flows phi_k. With chi_h = phi_m(h) .. phi_1(h), of order 1, and its adjoint
//! chi*_h = phi_1(h) .. phi_m(h), a step is
//!
//!   chi*(a_2s h) chi(a_2s-1 h) .. chi*(a_2 h) chi(a_1 h)   with   a_i = a_(2s+1-i), sum a_i = 1 :
//!
//! The step is symmetric, hence of even order, and a step of -h inverts it. Invariants, Poisson brackets and rates of
//! volume that every sub-flow preserves are preserved by the step. For orders above 2 some a_i are negative (Sheng
//! 1989, Suzuki 1991). A negative sub-step b runs friction backwards: a component that decays as exp(-r t) grows by
//! exp(r h |b|) before it decays again. The sub-steps of the first piece are a_2i + a_2i+1, those of the last a_2i-1 +
//! a_2i; in both, negative and positive coefficients largely cancel, but not equally. Friction belongs into the first
//! piece. Where the last piece has the smaller negative sub-steps, the order of the pieces is reversed.

use crate::Real;

/// A composition, named by authors and order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Splitting {
    /// chi*(h/2) chi(h/2), where chi composes the flows of the pieces and chi* composes them in the reverse order (Strang 1968): order 2, no negative sub-step.
    Strang,
    /// S6 of Blanes and Moan (2002): order 4, 6 stages; the most negative sub-step of the first piece is 0.042.
    BlanesMoan4,
    /// S10 of Blanes and Moan (2002): order 6, 10 stages, with the pieces in reversed order; the most negative sub-step
    /// of the first piece is then 0.132 instead of 0.726.
    BlanesMoan6,
    /// Kahan and Li (1997): order 8, 17 stages; the most negative sub-step of the first piece is 0.155.
    KahanLi8,
}

impl Splitting {
    /// All compositions, by order.
    pub const ALL: [Splitting; 4] =
        [Splitting::Strang, Splitting::BlanesMoan4, Splitting::BlanesMoan6, Splitting::KahanLi8];

    /// The order of convergence.
    pub fn order(self) -> u32 {
        match self {
            Splitting::Strang => 2,
            Splitting::BlanesMoan4 => 4,
            Splitting::BlanesMoan6 => 6,
            Splitting::KahanLi8 => 8,
        }
    }

    /// The number of stages s: a step has s flows of the first piece, s of the last, and 2s of each piece between.
    pub fn stages(self) -> u64 {
        match self {
            Splitting::Strang => 1,
            Splitting::BlanesMoan4 => 6,
            Splitting::BlanesMoan6 => 10,
            Splitting::KahanLi8 => 17,
        }
    }

    /// The authors, with the order where they have several methods.
    pub fn name(self) -> &'static str {
        match self {
            Splitting::Strang => "Strang",
            Splitting::BlanesMoan4 => "Blanes-Moan 4",
            Splitting::BlanesMoan6 => "Blanes-Moan 6",
            Splitting::KahanLi8 => "Kahan-Li 8",
        }
    }

    /// Whether the coefficients are known to more digits than those of double precision.
    pub fn exact(self) -> bool {
        matches!(self, Splitting::Strang | Splitting::KahanLi8)
    }

    /// The coefficients a_1 .. a_2s of s stages, as fractions of a step.
    pub fn coefficients<S: Real>(self) -> Vec<S> {
        match self {
            Splitting::Strang => vec![S::ratio(1, 2); 2],
            Splitting::BlanesMoan4 => alternating(
                &[0.0792036964311957, 0.353172906049774, -0.0420650803577195],
                &[0.209515106613362, -0.143851773179818],
            ),
            Splitting::BlanesMoan6 => alternating(
                &[0.0502627644003922, 0.413514300428344, 0.0450798897943977, -0.188054853819569, 0.541960678450780],
                &[0.148816447901042, -0.132385865767784, 0.067307604692185, 0.432666402578175],
            ),
            Splitting::KahanLi8 => halved(&[
                // the first seventeen digits, then the next ten
                (13_020_248_308_889_008, 0.087_881_763),
                (56_116_298_177_510_838, 0.456_196_444),
                (-38_947_496_264_484_728, -0.640_807_861),
                (15_884_190_655_515_560, 0.089_621_075),
                (-39_590_389_413_323_757, -0.733_623_154),
                (18_453_964_097_831_570, 0.709_183_254),
                (25_837_438_768_632_204, 0.729_397_911),
                (29_501_172_360_931_029, 0.887_096_624),
            ]),
        }
    }

    /// Whether the order of the pieces is reversed, since the last piece has the smaller negative sub-steps.
    fn turned(self) -> bool {
        self == Splitting::BlanesMoan6
    }

    /// The length of the most negative sub-step of the first piece, as a fraction of the step.
    pub fn most_negative_substep(self) -> f64 {
        let schedule = self.schedule::<f64>(2);
        let shares = schedule.iter().filter(|(piece, _)| *piece == 0).map(|(_, share)| *share);
        shares.fold(0.0, |back, share| (-share).max(back))
    }

    /// The sequence of sub-flows of a step for `pieces` >= 1 pieces: for each the index of the piece, and the
    /// fraction of the step, which may be negative.
    pub fn schedule<S: Real>(self, pieces: usize) -> Vec<(usize, S)> {
        let mut schedule: Vec<(usize, S)> = Vec::new();
        for (place, share) in self.coefficients::<S>().into_iter().enumerate() {
            let forwards = (place % 2 == 0) != self.turned();
            let turned = |k: usize| if forwards { k } else { pieces - 1 - k };
            for piece in (0..pieces).map(turned) {
                match schedule.last_mut() {
                    Some((last, sum)) if *last == piece => *sum += share,
                    _ => schedule.push((piece, share)),
                }
            }
        }
        schedule
    }
}

/// The coefficients from the sub-steps of the first piece, A_1 .. A_r, and of the last, B_1 .. B_(r-1), in half a step:
/// A_1 = a_1, B_1 = a_1 + a_2, A_2 = a_2 + a_3, ...; all B sum to one half.
fn alternating<S: Real>(first: &[f64], last: &[f64]) -> Vec<S> {
    let rest = last.iter().fold(S::ratio(1, 2), |rest, share| rest - S::lift(*share));
    let last = last.iter().map(|share| S::lift(*share)).chain([rest]);
    let shares = first.iter().zip(last).flat_map(|(a, b)| [S::lift(*a), b]);
    let half = shares.scan(S::zero(), |before, share| {
        *before = share - *before;
        Some(*before)
    });
    mirrored(half.collect())
}

/// The coefficients of a symmetric composition of steps of order 2. The arguments are their fractions in units of
/// 1e-17, each with its remainder; the fraction of the middle step follows, since all sum to one.
fn halved<S: Real>(shares: &[(i64, f64)]) -> Vec<S> {
    let unit = S::int(100_000_000_000_000_000);
    let shares: Vec<S> = shares.iter().map(|(whole, rest)| (S::int(*whole) + S::lift(*rest)) / unit).collect();
    let middle = shares.iter().fold(S::ratio(1, 2), |middle, share| middle - *share);
    mirrored(shares.into_iter().flat_map(|share| [share.half(); 2]).chain([middle]).collect())
}

fn mirrored<S: Real>(half: Vec<S>) -> Vec<S> {
    let back: Vec<S> = half.iter().rev().copied().collect();
    half.into_iter().chain(back).collect()
}

#[cfg(test)]
mod tests {
    use super::Splitting;

    #[test]
    fn coefficients_are_symmetric_and_sum_to_one() {
        for splitting in Splitting::ALL {
            let a = splitting.coefficients::<f64>();
            assert_eq!(a.len() as u64, 2 * splitting.stages());
            assert!((a.iter().sum::<f64>() - 1.0).abs() < 1e-15, "{splitting:?}");
            assert!(a.iter().zip(a.iter().rev()).all(|(a, b)| a == b), "{splitting:?}");
        }
    }

    /// The most negative sub-steps are those of the documentation.
    #[test]
    fn the_first_piece_goes_back_by_as_much_as_is_said() {
        for (splitting, most) in Splitting::ALL.into_iter().zip([0.0, 0.042, 0.132, 0.155]) {
            let found = splitting.most_negative_substep();
            assert!((found - most).abs() < 0.0006, "{splitting:?}: {found}");
            let share = |place: usize| {
                let shares = splitting.schedule::<f64>(3).into_iter().filter(|(piece, _)| *piece == place);
                shares.fold(0.0_f64, |back, (_, share)| back.max(-share))
            };
            assert_eq!(share(0), found);
            assert!(share(0) <= share(2), "{splitting:?}: the last piece goes back less");
        }
    }
}
