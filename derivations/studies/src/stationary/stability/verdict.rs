//! The stability of a steady motion, decided by its linearisation and its energy.
//!
//! Three theorems are applied, with hypotheses that are checked exactly:
//!
//! * an eigenvalue with positive real part: unstable (Lyapunov's first method);
//! * all eigenvalues except the structural zeros have negative real parts: on every nearby level set of the integrals
//!   there is one steady motion, and motions tend to it exponentially (Lyapunov, Malkin);
//! * G is definite on the subspace on which the differentials of the integrals vanish, and dG/dt <= 0: stable (Routh,
//!   Lyapunov; Arnold: energy-Casimir method).
//!
//! For a motion in a connected family the three theorems apply to the whole family: its members share w0 and lambda,
//! hence the function G, which is stationary along the family. Each direction of the family in which no integral
//! changes adds one zero eigenvalue, and G is constant along it. If G is definite transversally to the family, then the
//! family is stable (Morse, Bott). If all other eigenvalues have negative real parts, motions tend to steady motions of
//! the family or of neighbouring families. Directions in which an integral changes need no special treatment: the
//! neighbours have other values of the integrals.
//!
//! Without weight, x is constant in space, and any multiple of |x - p v|^2, p = x.v, may be added to G. It therefore
//! suffices that G is definite on the subspace dx = p dv (Finsler).
//!
//! A fourth theorem verifies the results of the first two, for systems without a drive and without eigenvalues on the
//! imaginary axis: the number of eigenvalues with positive real part equals the number of negative squares of G
//! (Ostrowski, Schneider 1962; Zajac 1964 for such systems).

use mechanics::linear_stability::{HalfPlanes, Inertia};

/// The stability of a steady motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StabilityVerdict {
    /// Small deviations remain small: the energy is definite on the level set of the integrals.
    Stable,
    /// Small deviations decay: on each level set of the integrals motions tend to the steady motion there.
    AsymptoticallyStableModuloIntegrals,
    /// This many eigenvalues have a positive real part.
    Unstable { right: usize },
    /// The linearisation and the energy do not decide.
    CannotTell(Reason),
}

/// The reason why there is no verdict.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// No eigenvalue has a positive real part, and the energy has this many negative squares: if the motion is stable,
    /// then by gyroscopic forces only, and nonlinear terms decide.
    Gyroscopic { negative: usize },
    /// One more eigenvalue is zero: motions merge, or neighbouring motions are steady too.
    Neutral,
    /// A family with irrational data that does not follow from a symmetry.
    Family,
    /// An isolated member of a family at which one of the decisive quantities vanishes.
    Edge,
    /// Two angles or two speeds of the rotor merge.
    PullOut,
    /// The sign of a decisive quantity is not determined with 2048 bits.
    TooFine,
    /// The zero eigenvalues that the integrals imply are missing: this is no steady motion.
    NotStationary,
}

impl StabilityVerdict {
    /// The verdict. `falls`: G is conserved or never increases; `neutral`: there is a zero eigenvalue that neither
    /// integrals nor a family explain.
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
