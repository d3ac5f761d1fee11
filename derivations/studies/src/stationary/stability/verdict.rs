//! What the first approximation and the energy say of a stationary motion.
//!
//! Three theorems, each with hypotheses that are checked exactly:
//!
//! * a root to the right: unstable (Lyapunov's first method);
//! * all roots but the structural zeros to the left: on every level of the integrals near by there is one stationary motion,
//!   and motions tend to it exponentially (Lyapunov, Malkin);
//! * G definite where the integrals' differentials vanish, and dG/dt <= 0: stable (Routh, Lyapunov; Arnold: energy-Casimir).
//!
//! Of a motion in a connected family all three are said of the family: G is the same function for all of its members, which
//! share w0 and lambda, so that it is stationary along it. A direction of the family in which no integral changes is one more
//! zero root, and one along which G does not change; where G is definite across it the family is stable (Morse, Bott), and
//! where all other roots lie to the left motions tend to the stationary motions of the family and its neighbours. Directions
//! in which an integral changes are no exception: the neighbours have other integrals.
//!
//! Without weight x stays in space, and any multiple of |x - p v|^2, p = x.v, may be added to G: it is enough that G is
//! definite where dx = p dv (Finsler).
//!
//! A fourth is a check of the first two, where nothing drives and no root is on the axis: there are as many roots to the right
//! as G has negative squares (Ostrowski, Schneider 1962; Zajac 1964 for systems of this kind).

use mechanics::linear_stability::{HalfPlanes, Inertia};

/// What becomes of small deviations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StabilityVerdict {
    /// They stay small: the energy is definite where the integrals have their values.
    Stable,
    /// They fade, on each level of the integrals towards the stationary motion of this level.
    AsymptoticallyStableModuloIntegrals,
    /// So many roots lie to the right of the imaginary axis.
    Unstable { right: usize },
    /// The first approximation and the energy do not decide.
    CannotTell(Reason),
}

/// Why there is no verdict.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// All roots are to the left or on the axis, and the energy has so many negative squares: if this is stable at all, then
    /// by gyroscopic forces, and the terms beyond the first approximation decide.
    Gyroscopic { negative: usize },
    /// A further root is zero: motions merge, or their neighbours are stationary too.
    Neutral,
    /// A family whose numbers are no fractions, and which no symmetry explains.
    Family,
    /// A single direction of a family at which something that decides vanishes.
    Edge,
    /// Both angles of the rotor, or two of its speeds, merge.
    PullOut,
    /// A quantity that decides is nearer to zero than 2048 bits tell.
    TooFine,
    /// The integrals' zero roots are not there: this is no stationary motion.
    NotStationary,
}

impl StabilityVerdict {
    /// `falls`: G is conserved or never grows. `neutral`: a root is zero that nothing explains.
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
