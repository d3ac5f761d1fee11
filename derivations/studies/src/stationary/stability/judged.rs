//! A stability verdict with its evidence, computed from the matrices over any ordered field.

use super::approximation::Approximation;
use super::family::cross;
use super::linear::{Integral, Linear};
use super::verdict::{Reason, StabilityVerdict};
use algebra::real::Ordered;
use mechanics::linear_stability::{HalfPlanes, Inertia, characteristic, growth};

/// A stability verdict with its evidence.
#[derive(Clone, Debug, PartialEq)]
pub struct Judged {
    pub verdict: StabilityVerdict,
    /// The integrals, each with a zero eigenvalue.
    pub integrals: Vec<Integral>,
    /// The number of directions of a family without a change of the integrals, each with a further zero eigenvalue.
    pub along: usize,
    /// The number of directions of the family in which the energy need not be definite.
    pub aside: usize,
    /// The number of explained zero eigenvalues; for a conservative system the number of the others is even.
    pub zeros: usize,
    /// The half-planes of the other eigenvalues, if the signs are known.
    pub roots: Option<HalfPlanes>,
    /// The signature of the energy's second variation on the level of the integrals, transverse to the family; `None`
    /// if the motor supplies energy.
    pub energy: Option<Inertia>,
    /// Whether the energy is conserved; otherwise it decreases unless the motor drives.
    pub conservative: bool,
    /// Bounds of the largest growth rate of an unstable motion, 1/s.
    pub growth: Option<[f64; 2]>,
    /// det(mu - A) without the structural zeros, the highest power first, rounded.
    pub polynomial: Vec<f64>,
}

/// The family of which a motion is a member.
#[derive(Clone, Debug)]
pub struct Among<R> {
    /// Independent directions dv of the family.
    pub tangents: Vec<[R; 3]>,
    /// An axis n of symmetry, not parallel to v: x.n is conserved.
    pub axis: Option<[R; 3]>,
    /// A number r with z^2 + r a known divisor of the characteristic polynomial.
    pub pair: Option<R>,
}

impl<R> Among<R> {
    /// An isolated motion.
    pub fn none() -> Self {
        Among { tangents: Vec::new(), axis: None, pair: None }
    }
}

impl Judged {
    /// An undecided verdict without a computation.
    pub fn cannot_tell(approximation: &Approximation, reason: Reason) -> Self {
        Judged {
            verdict: StabilityVerdict::CannotTell(reason),
            integrals: approximation.integrals.clone(),
            along: 0,
            aside: 0,
            zeros: approximation.integrals.len(),
            roots: None,
            energy: None,
            conservative: approximation.conservative,
            growth: None,
            polynomial: Vec::new(),
        }
    }

    /// The verdict on an isolated motion at (w0, v, W, cos g, sin g). [`Reason::TooFine`] means that a higher precision
    /// is needed.
    pub fn at<R: Ordered>(approximation: &Approximation, place: &[R; 7], one: &R, rounded: impl Fn(&R) -> f64) -> Self {
        Judged::among(approximation, place, &Among::none(), one, rounded)
    }

    /// The verdict on a motion that may be a member of a family.
    pub fn among<R: Ordered>(
        approximation: &Approximation,
        place: &[R; 7],
        among: &Among<R>,
        one: &R,
        rounded: impl Fn(&R) -> f64,
    ) -> Self {
        let Approximation { conservative, steady, fed, .. } = approximation;
        let undecided = |reason| Judged::cannot_tell(approximation, reason);
        let Some(linear) = approximation.at(place, one) else { return undecided(Reason::TooFine) };
        if linear.missing.iter().any(excluded) {
            return undecided(Reason::NotStationary);
        }
        let mut polynomial = characteristic(&linear.rates, one);
        let Some(Kept { integrals, rows, constraints }) = Kept::of(approximation, place, among, &linear) else {
            return undecided(Reason::TooFine);
        };
        let tangents: Option<Vec<Vec<R>>> =
            among.tangents.iter().map(|dv| moved(approximation, place, dv, &linear, one)).collect();
        let Some(tangents) = tangents else { return undecided(Reason::TooFine) };
        let inside = |rows: &[Vec<R>]| -> Vec<Vec<R>> {
            let kept = |tangent: &&Vec<R>| rows.iter().all(|row| !excluded(&dot(row, tangent, one)));
            tangents.iter().filter(kept).cloned().collect()
        };
        let along = inside(&rows).len();
        let mut zeros = integrals.len() + along;
        if *conservative && (polynomial.len() - 1 - zeros) % 2 == 1 {
            zeros += 1;
        }
        // a structural zero eigenvalue that is excluded is a contradiction
        let structural = polynomial.split_off(polynomial.len() - zeros);
        if structural.iter().any(excluded) {
            return undecided(Reason::NotStationary);
        }
        if *conservative {
            // eigenvalues of a conservative system come in pairs mu, -mu
            for c in polynomial.iter_mut().skip(1).step_by(2) {
                if excluded(c) {
                    return undecided(Reason::NotStationary);
                }
                *c = one.integer(0);
            }
        }
        let pair = if approximation.balanced { Some(place[0].times(&place[0])) } else { among.pair.clone() };
        let known = pair.and_then(|square| HalfPlanes::without_pair(&polynomial, &square));
        let roots = known.or_else(|| HalfPlanes::of(&polynomial));
        let beside = inside(&constraints);
        let aside = beside.len();
        let across = [constraints, beside].concat();
        let energy = if *fed { None } else { Inertia::on_subspace(&linear.energy, &across, one) };
        // if the torque depends on the slip, a slope that damps here damps nearby too
        let (of_slip, of_currents) = linear.damping.split_at(linear.damping.len().min(1));
        let damps = *steady || of_slip.iter().all(|slope| slope.sign() == Some(1));
        let falls = damps && of_currents.iter().all(|one| one.sign().is_some_and(|sign| sign >= 0));
        let neutral = polynomial.last().is_some_and(|c| c.sign() == Some(0));
        let unstable = roots.is_some_and(|roots| roots.right > 0);
        Judged {
            verdict: StabilityVerdict::of(roots, energy, *conservative, falls, neutral),
            growth: if unstable { growth(&polynomial) } else { None },
            integrals,
            along,
            aside,
            zeros,
            roots,
            energy,
            conservative: *conservative,
            polynomial: polynomial.iter().map(rounded).collect(),
        }
    }

    /// Whether the number of unstable eigenvalues equals the number of negative squares of the energy, wherever the
    /// theorem applies.
    pub fn is_consistent(&self) -> bool {
        match (self.roots, self.energy) {
            (Some(roots), Some(energy)) if !self.conservative && roots.axis == 0 => roots.right == energy.negative,
            _ => true,
        }
    }
}

/// The integrals, and the space on which the energy must be definite.
struct Kept<R> {
    integrals: Vec<Integral>,
    /// The integrals' differentials.
    rows: Vec<Vec<R>>,
    /// Independent linear forms, which vanish on that space.
    constraints: Vec<Vec<R>>,
}

impl<R: Ordered> Kept<R> {
    /// The integrals at a state; `None` where it is unknown whether x is parallel to v.
    fn of(approximation: &Approximation, place: &[R; 7], among: &Among<R>, linear: &Linear<R>) -> Option<Self> {
        let (mut integrals, mut rows) = (approximation.integrals.clone(), linear.integrals.clone());
        let [speed, v1, v2, v3, ..] = place;
        let v = [v1.clone(), v2.clone(), v3.clone()];
        let x: [R; 3] = linear.momentum.clone().try_into().ok()?;
        let along = |a: &[R; 3]| combined(a, &linear.turning, speed);
        if !approximation.balanced {
            if let Some(axis) = &among.axis {
                integrals.push(Integral::Axis);
                rows.push(along(axis)?);
            }
            return Some(Kept { integrals, constraints: rows.clone(), rows });
        }
        // w0 x x v = 0; at rest x may have any direction
        let turns = speed.sign().is_some_and(|sign| sign != 0);
        let beside: Vec<Option<i32>> = cross(&x, &v).iter().map(R::sign).collect();
        if !turns && beside.iter().any(|sign| sign.is_some_and(|sign| sign != 0)) {
            integrals.push(Integral::Size);
            rows.push(along(&x)?);
            return Some(Kept { integrals, constraints: rows.clone(), rows });
        }
        if !turns && beside.iter().any(Option::is_none) {
            return None;
        }
        // dx - p dv
        let p = (0..3).fold(speed.integer(0), |sum, i| sum.plus(&x[i].times(&v[i])));
        let mut constraints = vec![rows[0].clone()];
        for (i, row) in linear.turning.iter().enumerate() {
            let mut row = row.clone();
            row[3 + i] = row[3 + i].minus(&p);
            constraints.push(row);
        }
        constraints.extend(rows.get(2).cloned());
        if let Some(axis) = &among.axis {
            integrals.push(Integral::Axis);
            rows.push(along(axis)?);
            // for p = 0 it follows from the others
            if excluded(&p) {
                constraints.push(along(axis)?);
            }
        }
        Some(Kept { integrals, rows, constraints })
    }
}

/// The deviation of the state along dv: dw = w0 dv, and the rotor's speed changes with its own momentum conserved, if it is.
fn moved<R: Ordered>(
    approximation: &Approximation,
    place: &[R; 7],
    dv: &[R; 3],
    linear: &Linear<R>,
    one: &R,
) -> Option<Vec<R>> {
    let mut state = vec![one.integer(0); approximation.layout.size()];
    for (i, dv) in dv.iter().enumerate() {
        state[i] = place[0].times(dv);
        state[3 + i] = dv.clone();
    }
    if let (Some(spin), Some(slip)) = (linear.integrals.get(2), approximation.layout.slip()) {
        state[slip] = one.integer(0).minus(&dot(spin, &state, one)).over(&spin[slip])?;
    }
    Some(state)
}

/// The combination sum_i a_i row_i.
fn combined<R: Ordered>(a: &[R; 3], rows: &[Vec<R>], like: &R) -> Option<Vec<R>> {
    let columns = rows.first()?.len();
    let zero = like.integer(0);
    let entry = |j: usize| a.iter().zip(rows).fold(zero.clone(), |sum, (a, row)| sum.plus(&a.times(&row[j])));
    Some((0..columns).map(entry).collect())
}

fn dot<R: Ordered>(a: &[R], b: &[R], one: &R) -> R {
    a.iter().zip(b).fold(one.integer(0), |sum, (a, b)| sum.plus(&a.times(b)))
}

/// Whether a number is known not to be zero.
fn excluded<R: Ordered>(number: &R) -> bool {
    number.sign().is_some_and(|sign| sign != 0)
}
