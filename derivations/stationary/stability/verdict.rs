//! What the first approximation and the energy say of a stationary motion.
//!
//! Three theorems, each with hypotheses that are checked exactly:
//!
//! * a root to the right: unstable (Lyapunov's first method);
//! * all roots but the structural zeros to the left: on every level of the integrals near by there is one stationary motion,
//!   and motions tend to it exponentially (Lyapunov, Malkin);
//! * G definite where the integrals' differentials vanish, and dG/dt <= 0: stable (Routh, Lyapunov; Arnold: energy-Casimir).
//!
//! A fourth is a check of the first two, where nothing drives and no root is on the axis: there are as many roots to the right
//! as G has negative squares (Ostrowski, Schneider 1962; Zajac 1964 for systems of this kind).

use super::approximation::Approximation;
use super::linear::Integral;
use mechanics::first_approximation::{HalfPlanes, Inertia, characteristic};
use symbolic::real::Ordered;

/// What becomes of small deviations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
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
    /// One of a connected family.
    Family,
    /// Both angles of the rotor, or two of its speeds, merge.
    PullOut,
    /// A quantity that decides is nearer to zero than 2048 bits tell.
    TooFine,
    /// The integrals' zero roots are not there: this is no stationary motion.
    NotStationary,
}

/// A verdict with what it rests on.
#[derive(Clone, Debug, PartialEq)]
pub struct Judged {
    pub verdict: Verdict,
    /// What gives a zero root each.
    pub integrals: Vec<Integral>,
    /// The roots beside these, where the signs are known.
    pub roots: Option<HalfPlanes>,
    /// The signs of the energy's second variation where the integrals have their values; none where the motor feeds it.
    pub energy: Option<Inertia>,
    /// Whether the energy is conserved; otherwise it falls unless the motor drives.
    pub conservative: bool,
    /// det(mu - A) without the structural zeros, highest power first, rounded.
    pub polynomial: Vec<f64>,
}

impl Judged {
    /// Without a computation.
    pub fn cannot_tell(approximation: &Approximation, reason: Reason) -> Self {
        Judged {
            verdict: Verdict::CannotTell(reason),
            integrals: approximation.integrals.clone(),
            roots: None,
            energy: None,
            conservative: approximation.conservative,
            polynomial: Vec::new(),
        }
    }

    /// At a place (w0, v, W, cos g, sin g). A verdict [`Reason::TooFine`] asks for finer numbers.
    pub fn at<R: Ordered>(approximation: &Approximation, place: &[R; 7], one: &R, rounded: impl Fn(&R) -> f64) -> Self {
        let Approximation { integrals, conservative, steady, fed, balanced, .. } = approximation;
        let undecided = |reason| Judged::cannot_tell(approximation, reason);
        let Some(linear) = approximation.at(place, one) else { return undecided(Reason::TooFine) };
        if linear.missing.iter().any(|m| m.sign().is_some_and(|sign| sign != 0)) {
            return undecided(Reason::NotStationary);
        }
        let mut polynomial = characteristic(&linear.rates, one);
        // a structural zero that is excluded is a contradiction
        let structural = polynomial.split_off(polynomial.len() - integrals.len());
        if structural.iter().any(|c| c.sign().is_some_and(|sign| sign != 0)) {
            return undecided(Reason::NotStationary);
        }
        if *conservative {
            // a conservative system's roots come in pairs mu, -mu
            for c in polynomial.iter_mut().skip(1).step_by(2) {
                if c.sign().is_some_and(|sign| sign != 0) {
                    return undecided(Reason::NotStationary);
                }
                *c = one.integer(0);
            }
        }
        let known = if *balanced { HalfPlanes::without_pair(&polynomial, &place[0].times(&place[0])) } else { None };
        let roots = known.or_else(|| HalfPlanes::of(&polynomial));
        let energy = if *fed { None } else { Inertia::on_subspace(&linear.energy, &linear.integrals, one) };
        // where the moment depends on the slip, a slope that damps here damps near by too
        let (of_slip, of_currents) = linear.damping.split_at(linear.damping.len().min(1));
        let damps = *steady || of_slip.iter().all(|slope| slope.sign() == Some(1));
        let falls = damps && of_currents.iter().all(|one| one.sign().is_some_and(|sign| sign >= 0));
        let neutral = polynomial.last().is_some_and(|c| c.sign() == Some(0));
        Judged {
            verdict: Verdict::of(roots, energy, *conservative, falls, neutral),
            integrals: integrals.clone(),
            roots,
            energy,
            conservative: *conservative,
            polynomial: polynomial.iter().map(rounded).collect(),
        }
    }

    /// Whether the count of roots to the right is that of the energy's negative squares wherever it must be.
    pub fn is_consistent(&self) -> bool {
        match (self.roots, self.energy) {
            (Some(roots), Some(energy)) if !self.conservative && roots.axis == 0 => roots.right == energy.negative,
            _ => true,
        }
    }
}

impl Verdict {
    fn of(roots: Option<HalfPlanes>, energy: Option<Inertia>, conservative: bool, falls: bool, neutral: bool) -> Self {
        let definite = energy
            .is_some_and(|energy| energy.zero == 0 && (energy.negative == 0 || (conservative && energy.positive == 0)));
        match roots {
            Some(HalfPlanes { right, .. }) if right > 0 => Verdict::Unstable { right },
            Some(HalfPlanes { axis: 0, .. }) => Verdict::AsymptoticallyStableModuloIntegrals,
            _ if definite && falls => Verdict::Stable,
            _ if neutral => Verdict::CannotTell(Reason::Neutral),
            Some(_) => match energy {
                Some(energy) => Verdict::CannotTell(Reason::Gyroscopic { negative: energy.negative }),
                None => Verdict::CannotTell(Reason::TooFine),
            },
            None => Verdict::CannotTell(Reason::TooFine),
        }
    }
}
