//! Stability verdicts on a steady motion by its linearisation and energy.
//!
//! Three theorems, each with hypotheses that are checked exactly:
//!
//! * an eigenvalue with positive real part: unstable (Lyapunov's first method);
//! * all eigenvalues but the structural zeros with negative real parts: every nearby level of the integrals has one stationary
//!   motion, to which motions tend exponentially (Lyapunov, Malkin);
//! * G definite where the integrals' differentials vanish, and dG/dt <= 0: stable (Routh, Lyapunov; Arnold: energy-Casimir).
//!
//! For a motion in a connected family all three hold for the family: its members share w0 and lambda, hence the function G,
//! which is stationary along the family. A direction of the family in which no integral changes gives one more
//! zero eigenvalue, and G does not change along it. If G is definite across the family, the family is stable (Morse, Bott); if
//! all other eigenvalues have negative real parts, motions tend to the steady motions of the family and its neighbours.
//! Directions in which an integral changes are no exception: the neighbours have other values of the integrals.
//!
//! Without weight x is constant in space, and any multiple of |x - p v|^2, p = x.v, may be added to G: it suffices that G is
//! definite where dx = p dv (Finsler).
//!
//! A fourth theorem checks the first two, without a drive and without eigenvalues on the axis: the number of eigenvalues with
//! positive real part equals the number of negative squares of G (Ostrowski, Schneider 1962; Zajac 1964 for such systems).

use mechanics::linear_stability::{HalfPlanes, Inertia};

/// The stability of a steady motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StabilityVerdict {
    /// Small deviations stay small: the energy is definite on the level of the integrals.
    Stable,
    /// Small deviations decay, on each level of the integrals towards the steady motion of this level.
    AsymptoticallyStableModuloIntegrals,
    /// This many eigenvalues have a positive real part.
    Unstable { right: usize },
    /// The linearisation and the energy do not decide.
    CannotTell(Reason),
}

/// The reason why there is no verdict.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// No eigenvalue has a positive real part, and the energy has this many negative squares: the motion can only be stable
    /// by gyroscopic forces, and nonlinear terms decide.
    Gyroscopic { negative: usize },
    /// A further eigenvalue is zero: motions merge, or their neighbours are stationary too.
    Neutral,
    /// A family with irrational data, which no symmetry explains.
    Family,
    /// A single direction of a family at which a decisive quantity vanishes.
    Edge,
    /// Both angles of the rotor, or two of its speeds, merge.
    PullOut,
    /// The sign of a decisive quantity is not known with 2048 bits.
    TooFine,
    /// The integrals' zero eigenvalues are missing: this is no steady motion.
    NotStationary,
}

impl StabilityVerdict {
    /// `falls`: G is conserved or never grows. `neutral`: an eigenvalue is zero without explanation.
    pub(super) fn of(
        roots: Option<HalfPlanes>,
        energy: Option<Inertia>,
        conservative: bool,
        falls: bool,
        neutral: bool,
    ) -> Self {
        let definite = energy
            .is_some_and(|energy| energy.zero == 0 && (energy.negative == 0 || (conservative && energy.positive == 0)));
        match roots {
            Some(HalfPlanes { right, .. }) if right > 0 => StabilityVerdict::Unstable { right },
            Some(HalfPlanes { axis: 0, .. }) => StabilityVerdict::AsymptoticallyStableModuloIntegrals,
            _ if definite && falls => StabilityVerdict::Stable,
            _ if neutral => StabilityVerdict::CannotTell(Reason::Neutral),
            Some(_) => match energy {
                Some(energy) => StabilityVerdict::CannotTell(Reason::Gyroscopic { negative: energy.negative }),
                None => StabilityVerdict::CannotTell(Reason::TooFine),
            },
            None => StabilityVerdict::CannotTell(Reason::TooFine),
        }
    }
}
