//! All directions of uniform rotation for a given angular velocity w.

use super::Body;
use super::spectrum::{Matrix, Spectrum, Vector, dot};
use algebra::real::{Enclosure, Number, Polynomial, Root};
use field::Rational;
use std::sync::Arc;

/// All directions v for one w.
pub struct Rotations {
    /// Isolated directions in ascending order of their multipliers, then families.
    pub motions: Vec<SteadyRotation>,
    /// The degree of the polynomial in lambda, whose real roots are the directions without symmetric pairs.
    pub degree: usize,
    /// The number of its distinct real roots, by Descartes' rule.
    pub roots: usize,
    case: Arc<Case>,
}

/// One direction, or a connected family of directions.
#[derive(Clone)]
pub struct SteadyRotation {
    pub shape: Shape,
    pub kind: Kind,
    /// lambda times a common positive number.
    multiplier: Root,
    case: Arc<Case>,
}

/// The shape of a connected set of directions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// One direction.
    Point,
    /// One of two directions exchanged by a symmetry: on the positive or negative side of the eigenvector with index
    /// `place`.
    Pair { place: usize, positive: bool },
    /// A circle about the normal of the eigenspace with index `place`.
    Circle { place: usize },
    /// Every direction.
    Sphere,
}

/// The kind of critical point of W on the sphere; for a family, transverse to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    Minimum,
    Saddle,
    Maximum,
    /// The second derivative is degenerate: rotations merge here.
    Degenerate,
}

struct Case {
    spectrum: Spectrum,
    /// The polynomial F = |N|^2 - q^2, with |v|^2 - 1 = F / q^2.
    excess: Polynomial,
    /// The divisor that gives lambda in N m from the multipliers.
    scale: Number,
}

/// The working precisions tried in turn, in bits.
const BITS: [usize; 8] = [128, 256, 512, 1024, 2048, 4096, 8192, 16384];

impl Body {
    /// All directions of rotation with the angular velocity w, rad/s. `None` where w is undefined.
    pub fn rotations(&self, w: Rational) -> Option<Rotations> {
        let (numerator, d) = Number::over_common(&[w])?;
        let n = numerator.first()?.clone();
        // (n^2 M - x) v + n d h + d^2 G = 0
        let (squared, mixed, common) = (&n * &n, &n * &d, &d * &d);
        let matrix: Matrix<Number> = std::array::from_fn(|i| std::array::from_fn(|j| &self.tensor[i][j] * &squared));
        let b: Vector<Number> = std::array::from_fn(|i| &(&self.spin[i] * &mixed) + &(&self.weight[i] * &common));
        Some(Rotations::of(&matrix, b, &self.scale * &common))
    }
}

impl Rotations {
    /// All unit vectors v with (K - x) v + b = 0 for some x.
    fn of(matrix: &Matrix<Number>, b: Vector<Number>, scale: Number) -> Self {
        let spectrum = Spectrum::of(matrix, &[b]);
        let n = &spectrum.numerators[0];
        let excess = &dot(n, n) - &(&spectrum.seen * &spectrum.seen);
        let excess = excess.primitive();
        let case = Arc::new(Case { spectrum, excess, scale });
        let roots = case.excess.real_roots();
        let count = roots.len();
        let of_root = |multiplier: Root| SteadyRotation {
            shape: Shape::Point,
            kind: case.kind(&multiplier),
            multiplier,
            case: Arc::clone(&case),
        };
        let mut motions: Vec<SteadyRotation> = roots.into_iter().map(of_root).collect();
        for &place in &case.spectrum.unseen {
            motions.extend(Case::beyond(&case, place));
        }
        Rotations { degree: case.excess.degree().unwrap_or(0), roots: count, motions, case }
    }

    /// The number of distinct real roots of the polynomial by Sturm's theorem: an independent check, slower than
    /// isolation.
    pub fn roots_by_sturm(&self) -> usize {
        self.case.excess.count_by_sturm()
    }

    /// The Morse sum minima - saddles + maxima, each family weighted by its Euler characteristic; it must be 2, that of
    /// the sphere. `None` where there is a degenerate point.
    pub fn morse(&self) -> Option<i32> {
        let each = self.motions.iter().map(|motion| match (motion.shape, motion.kind) {
            (Shape::Circle { .. }, _) => Some(0),
            (Shape::Sphere, _) => Some(2),
            (_, Kind::Minimum | Kind::Maximum) => Some(1),
            (_, Kind::Saddle) => Some(-1),
            (_, Kind::Degenerate) => None,
        });
        each.sum()
    }

    /// The number of isolated directions.
    pub fn isolated(&self) -> usize {
        self.motions.iter().filter(|motion| matches!(motion.shape, Shape::Point | Shape::Pair { .. })).count()
    }

    /// Disjoint boxes of directions of width at most 2^-bits: each isolated direction has one, which contains no other.
    /// For a family: the box of its centre. `None` where 16384 bits do not suffice.
    pub fn boxes(&self, bits: usize) -> Option<Vec<Vector<Enclosure>>> {
        let mut bits = bits;
        while bits <= 4096 {
            let all: Vec<_> = self.motions.iter().map(|motion| motion.direction(bits)).collect::<Option<_>>()?;
            let apart = |a: &Vector<Enclosure>, b: &Vector<Enclosure>| (0..3).any(|i| a[i].is_apart_from(&b[i]));
            let points = &all[..self.isolated()];
            if points.iter().enumerate().all(|(k, a)| points[..k].iter().all(|b| apart(a, b))) {
                return Some(all);
            }
            bits *= 2;
        }
        None
    }
}

impl SteadyRotation {
    /// The direction v to 2^-bits in every component; for a circle its centre, for the sphere zero.
    pub fn direction(&self, bits: usize) -> Option<Vector<Enclosure>> {
        let close = |v: &Vector<Enclosure>| v.iter().all(|x| x.is_within(bits));
        BITS.into_iter().filter(|work| *work > bits).filter_map(|work| self.at(work)).find(close)
    }

    /// The ends of the interval that isolates lambda, N m: it contains no other root.
    pub fn interval(&self) -> Option<[f64; 2]> {
        let bits = BITS[1];
        let scale = self.case.scale.enclosure(bits);
        Some(self.multiplier.interval(bits).over(&scale)?.ends())
    }

    /// The multiplier lambda to 2^-bits, N m.
    pub fn multiplier(&self, bits: usize) -> Option<Enclosure> {
        let of = |work| self.multiplier.enclosure(work).over(&self.case.scale.enclosure(work));
        BITS.into_iter().filter(|work| *work > bits).filter_map(of).find(|x| x.is_within(bits))
    }

    /// The radius of a circle or sphere about its centre.
    pub fn radius(&self, bits: usize) -> Option<Enclosure> {
        let at = |work| self.case.reach(&self.multiplier.enclosure(work), work);
        BITS.into_iter().filter(|work| *work > bits).filter_map(at).find(|r| r.is_within(bits))
    }

    /// A unit vector along the axis of a circle.
    pub fn axis(&self, bits: usize) -> Option<Vector<Enclosure>> {
        let Shape::Circle { place } = self.shape else { return None };
        let close = |v: &Vector<Enclosure>| v.iter().all(|x| x.is_within(bits));
        let at = |work| self.case.spectrum.normal(place, work);
        BITS.into_iter().filter(|work| *work > bits).filter_map(at).find(close)
    }

    fn at(&self, bits: usize) -> Option<Vector<Enclosure>> {
        let (at, spectrum) = (self.multiplier.enclosure(bits), &self.case.spectrum);
        let q = spectrum.seen.enclosure(&at, bits);
        let centre: Vec<_> = spectrum.numerators[0].iter().map(|n| Some(-&n.enclosure(&at, bits).over(&q)?)).collect();
        let mut v: Vector<Enclosure> = centre.into_iter().collect::<Option<Vec<_>>>()?.try_into().ok()?;
        if let Shape::Pair { place, positive } = self.shape {
            let reach = self.case.reach(&at, bits)?;
            let reach = if positive { reach } else { -&reach };
            let along = spectrum.eigenvector(place, bits)?;
            v = std::array::from_fn(|i| &v[i] + &(&reach * &along[i]));
        }
        Some(v)
    }
}

impl Case {
    /// The kind from the signature of K - lambda on the tangent plane: that in space, less the sign of v.(K -
    /// lambda)^-1 v, which is half the derivative of |v|^2 and has the sign of F'.
    fn kind(&self, multiplier: &Root) -> Kind {
        let slope = multiplier.sign_of(&self.excess.derivative());
        match (self.spectrum.around(multiplier), slope) {
            (None, _) | (_, 0) => Kind::Degenerate,
            (Some([below, _]), slope) => Kind::of(below - usize::from(slope < 0)),
        }
    }

    /// The additional directions of an eigenvalue whose eigenvector is orthogonal to b: v = -N/q + z with z in its
    /// eigenspace and |z|^2 = -F/q^2. A direction with z = 0 is a root of F and is not included.
    fn beyond(case: &Arc<Self>, place: usize) -> Vec<SteadyRotation> {
        let (multiplier, multiplicity) = &case.spectrum.eigenvalues[place];
        if multiplier.sign_of(&case.excess) >= 0 {
            return Vec::new();
        }
        let [below, _] = case.spectrum.beside(place);
        let (shapes, kind) = match multiplicity {
            1 => ([true, false].map(|positive| Shape::Pair { place, positive }).to_vec(), Kind::of(below)),
            2 => (vec![Shape::Circle { place }], if below == 0 { Kind::Minimum } else { Kind::Maximum }),
            _ => (vec![Shape::Sphere], Kind::Degenerate),
        };
        let of_shape = |shape| SteadyRotation { shape, kind, multiplier: multiplier.clone(), case: Arc::clone(case) };
        shapes.into_iter().map(of_shape).collect()
    }

    /// The radius sqrt(-F)/|q| = sqrt(1 - |N/q|^2).
    fn reach(&self, at: &Enclosure, bits: usize) -> Option<Enclosure> {
        let q = self.spectrum.seen.enclosure(at, bits);
        let n = &self.spectrum.numerators[0];
        let shares: Vec<_> = n.iter().map(|n| n.enclosure(at, bits).over(&q)).collect::<Option<_>>()?;
        let one = Enclosure::integer(1, bits);
        shares.iter().fold(one, |rest, share| &rest - &(share * share)).sqrt()
    }
}

impl Kind {
    /// The kind from the number of directions in which W decreases.
    pub(super) fn of(falling: usize) -> Self {
        match falling {
            0 => Kind::Minimum,
            1 => Kind::Saddle,
            _ => Kind::Maximum,
        }
    }
}
