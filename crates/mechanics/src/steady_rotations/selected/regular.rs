//! Common solutions of both equations away from the eigenvalues of M.

use super::{Case, RotationPlace, Selected, Turning, Undecided};
use crate::steady_rotations::spectrum::Spectrum;
use crate::steady_rotations::{Body, Kind, Shape};
use algebra::real::{Nested, Polynomial, Root, subresultant};
use std::sync::Arc;

/// The precision of a root, in bits.
const BITS: usize = 160;

impl Selected {
    /// The regular motions, and the data for the other motions.
    pub(super) fn of(
        body: &Body,
        spectrum: Spectrum,
        length: &[Polynomial],
        second: &[Polynomial],
    ) -> (Self, Arc<Case>) {
        let ratio = subresultant(length, second, 1);
        let resultant = subresultant(length, second, 0).pop().unwrap_or_default();
        let case = Arc::new(Case { spectrum, body: body.clone(), ratio });
        let mut all = Selected { motions: Vec::new(), degree: 0, roots: 0, undecided: None };
        // without h and G no motion exists away from the eigenvalues
        match (length.len() > 1, resultant.is_zero()) {
            (true, true) => all.undecided = Some(Undecided::Curve),
            (true, false) => all.regular(&case, resultant, length, second),
            (false, _) => {}
        }
        (all, case)
    }

    fn regular(&mut self, case: &Arc<Case>, resultant: Polynomial, length: &[Polynomial], second: &[Polynomial]) {
        // both equations hold at the eigenvalues without being a motion
        let mut rest = resultant.primitive();
        loop {
            let shared = case.spectrum.seen.gcd(&rest);
            let Some(power) = rest.degree().filter(|_| shared.degree().is_some_and(|degree| degree > 0)) else { break };
            rest = rest.quotient(&shared, power + 1).primitive();
        }
        let roots = rest.real_roots();
        (self.degree, self.roots) = (rest.degree().unwrap_or(0), roots.len());
        for mut x in roots {
            x.refine(BITS);
            match case.ratio.get(1) {
                Some(slope) if x.sign_of(slope) != 0 => {
                    self.motions.push(Turning::away(case, RotationPlace::Regular(x)))
                }
                _ => self.shared(case, x, length, second),
            }
        }
    }

    /// The solutions with several s for one x: the common divisor is the first subresultant whose leading coefficient
    /// does not vanish at x. The leading coefficient of |v| = 1 never vanishes, that of the second equation may vanish
    /// identically.
    fn shared(&mut self, case: &Arc<Case>, x: Root, length: &[Polynomial], second: &[Polynomial]) {
        let leads = |p: &[Polynomial]| p.last().is_some_and(|lead| x.sign_of(lead) != 0);
        let divisor = (2..second.len() - 1).map(|k| subresultant(length, second, k)).find(|divisor| leads(divisor));
        let divisor = divisor.unwrap_or_else(|| if leads(second) { second.to_vec() } else { length.to_vec() });
        let each =
            Nested::roots(&x, &divisor).into_iter().map(|s| Turning::away(case, RotationPlace::Shared(s, x.clone())));
        self.motions.extend(each);
    }
}

impl Turning {
    fn away(case: &Arc<Case>, place: RotationPlace) -> Self {
        let mut motion = Turning { shape: Shape::Point, kind: Kind::Degenerate, place, case: Arc::clone(case) };
        motion.kind = motion.kind_by_signature().unwrap_or(Kind::Degenerate);
        motion
    }
}
