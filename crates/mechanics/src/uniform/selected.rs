//! The uniform rotations that one more equation selects: all with a given angular momentum about the vertical; all at which
//! the number of rotations with one angular velocity changes.
//!
//! With s = 1/w and lambda = w^2 x, v = -(s N_h + s^2 N_G) / q where (M - x) N = q h and q G (`spectrum`), and
//!
//!   |v| = 1 :             s^2 N_h.N_h + 2 s^3 N_h.N_G + s^4 N_G.N_G = q^2 ,
//!   p = w v.M v + h.v :   x q - p s q + s^3 G.N_h + s^4 G.N_G = 0 .
//!
//! Two rotations merge where at fixed s the derivative of |v|^2 by x vanishes: the coefficients of s^0, s, s^2 in
//! (d/dx - 2 q'/q) (N_h.N_h + 2 s N_h.N_G + s^2 N_G.N_G) q in the place of the second.
//!
//! The resultant of both in s is a polynomial in x; the first subresultant gives s as a fraction in x.

use super::rotations::Kind;
use super::spectrum::{Spectrum, Vector, along, dot, scaled};
use super::{Body, Shape};
use field::Rational;
use std::sync::Arc;
use symbolic::real::{Enclosure, Field, Number, Polynomial, Root, subresultant};

/// All (v, w) that satisfy the equation.
pub struct Selected {
    /// Isolated motions in ascending order of x, families, rests.
    pub motions: Vec<Turning>,
    /// Of the resultant without the factors that stand for no motion, and how many different real roots it has.
    pub degree: usize,
    pub roots: usize,
    /// What may hide further motions, where anything does: then "all" is not proved.
    pub undecided: Vec<Undecided>,
}

/// Why completeness is not proved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Undecided {
    /// The resultant vanishes identically: motions form a curve.
    Curve,
    /// Several angular velocities go with one x.
    Several,
    /// At this principal axis b is orthogonal to it for one w, and no exclusion was found.
    Axis(usize),
    /// The wheels' speed and a principal moment are both irrational.
    TwoFields,
    /// The carrier rests: every direction with a given angle to the wheels' momentum.
    Rests,
}

/// One of them.
#[derive(Clone)]
pub struct Turning {
    pub shape: Shape,
    pub kind: Kind,
    place: Place,
    case: Arc<Case>,
}

#[derive(Clone)]
enum Place {
    /// x
    Regular(Root),
    /// s, at an eigenvalue that neither h nor G sees.
    Beyond { eigenvalue: usize, s: Root },
    /// w = 0, v = G/|G| or its opposite.
    Rest { along: bool },
}

struct Case {
    spectrum: Spectrum,
    body: Body,
    /// s = -ratio[0] / ratio[1]
    ratio: Vec<Polynomial>,
}

const BITS: [usize; 7] = [160, 320, 640, 1280, 2560, 5120, 8192];

impl Body {
    /// All uniform rotations with the angular momentum p about the vertical, N m s. `None` where that is undefined.
    pub fn at_momentum(&self, p: Rational) -> Option<Selected> {
        let (numerator, denominator) = Number::over_common(&[p])?;
        // p times the body's scale is `momentum` / `denominator`
        let momentum = numerator.first()? * &self.scale;
        let spectrum = Spectrum::of(&self.tensor, &[self.spin.clone(), self.weight.clone()]);
        let length = length(&spectrum);
        let balance = self.balance(&spectrum, &momentum, &denominator);
        let (mut all, case) = Selected::of(self, spectrum, &length, &balance);
        all.beyond(&case, &length, &balance);
        all.seen_axes(&case, &momentum, &denominator);
        all.rests(&case, &momentum, &denominator);
        Some(all)
    }

    /// Where rotations with one angular velocity merge or part: between two neighbours of these angular velocities, and
    /// zero, their number is constant.
    pub fn folds(&self) -> Selected {
        let spectrum = Spectrum::of(&self.tensor, &[self.spin.clone(), self.weight.clone()]);
        let length = length(&spectrum);
        let slope = spectrum.seen.derivative();
        let two = Number::from(2);
        let fold = |p: &Polynomial| &(&p.derivative() * &spectrum.seen) - &scaled(&(p * &slope), &two);
        let folds = trimmed(length.iter().skip(2).map(fold).collect());
        let (mut all, case) = Selected::of(self, spectrum, &length, &folds);
        // a pair on both sides of an eigenvector that b never sees begins where |v| = 1 without it
        for &eigenvalue in &case.spectrum.unseen {
            match case.at_eigenvalue(eigenvalue) {
                Some((n, d)) => {
                    all.motions.extend(at_fraction(&length, &n, &d).real_roots().into_iter().map(|s| Turning {
                        shape: Shape::Point,
                        kind: Kind::Degenerate,
                        place: Place::Beyond { eigenvalue, s },
                        case: Arc::clone(&case),
                    }))
                }
                None => all.undecided.push(Undecided::TwoFields),
            }
        }
        all
    }

    /// The coefficients of s in the second equation.
    fn balance(&self, spectrum: &Spectrum, momentum: &Number, denominator: &Number) -> Vec<Polynomial> {
        let [h, g] = [&spectrum.numerators[0], &spectrum.numerators[1]];
        let x = Polynomial::from_integers([0, 1]);
        let zero = Polynomial::default;
        let balance = [&x * &spectrum.seen, zero(), zero(), along(h, &self.weight), along(g, &self.weight)];
        let mut balance: Vec<_> = balance.iter().map(|p| scaled(p, denominator)).collect();
        balance[1] = scaled(&spectrum.seen, &-momentum);
        trimmed(balance)
    }
}

/// The coefficients of s in the first equation.
fn length(spectrum: &Spectrum) -> Vec<Polynomial> {
    let [h, g] = [&spectrum.numerators[0], &spectrum.numerators[1]];
    let q = &spectrum.seen;
    trimmed(vec![-&(q * q), Polynomial::default(), dot(h, h), scaled(&dot(h, g), &Number::from(2)), dot(g, g)])
}

fn trimmed(mut equation: Vec<Polynomial>) -> Vec<Polynomial> {
    while equation.last().is_some_and(Polynomial::is_zero) {
        equation.pop();
    }
    equation
}

impl Selected {
    /// The common solutions of both equations away from the eigenvalues.
    fn of(body: &Body, spectrum: Spectrum, length: &[Polynomial], second: &[Polynomial]) -> (Self, Arc<Case>) {
        let ratio = subresultant(length, second, 1);
        let resultant = subresultant(length, second, 0).pop().unwrap_or_default();
        let case = Arc::new(Case { spectrum, body: body.clone(), ratio });
        let mut all = Selected { motions: Vec::new(), degree: 0, roots: 0, undecided: Vec::new() };
        // without h and G nothing lies away from them
        match (length.len() > 1, resultant.is_zero()) {
            (true, true) => all.undecided.push(Undecided::Curve),
            (true, false) => all.regular(&case, resultant),
            (false, _) => {}
        }
        (all, case)
    }

    fn regular(&mut self, case: &Arc<Case>, resultant: Polynomial) {
        // at the eigenvalues both equations are satisfied for nothing
        let mut rest = resultant.primitive();
        loop {
            let shared = case.spectrum.seen.gcd(&rest);
            let Some(power) = rest.degree().filter(|_| shared.degree().is_some_and(|degree| degree > 0)) else { break };
            rest = rest.quotient(&shared, power + 1).primitive();
        }
        let roots = rest.real_roots();
        (self.degree, self.roots) = (rest.degree().unwrap_or(0), roots.len());
        for mut x in roots {
            // once for all that is asked of it
            x.refine(BITS[0]);
            match case.ratio.get(1) {
                Some(slope) if x.sign_of(slope) != 0 => self.motions.push(Turning::regular(case, x)),
                _ => self.undecided.push(Undecided::Several),
            }
        }
    }

    /// Eigenvalues that neither h nor G sees: v = -N/q + z with z in the eigenspace, wherever that leaves |z|^2 > 0.
    fn beyond(&mut self, case: &Arc<Case>, length: &[Polynomial], balance: &[Polynomial]) {
        for &place in &case.spectrum.unseen {
            let multiplicity = case.spectrum.eigenvalues[place].1;
            let Some((numerator, denominator)) = case.at_eigenvalue(place) else {
                self.undecided.push(Undecided::TwoFields);
                continue;
            };
            let [length, balance] = [length, balance].map(|equation| at_fraction(equation, &numerator, &denominator));
            if balance.is_zero() {
                self.undecided.push(Undecided::Curve);
                continue;
            }
            let inside = |s: &Root| s.sign_of(&Polynomial::from_integers([0, 1])) != 0 && s.sign_of(&length) < 0;
            let [below, _] = case.spectrum.beside(place);
            for s in balance.real_roots().into_iter().filter(inside) {
                let shapes = match multiplicity {
                    1 => [true, false].map(|positive| Shape::Pair { place, positive }).to_vec(),
                    2 => vec![Shape::Circle { place }],
                    _ => vec![Shape::Sphere],
                };
                let kind = match (multiplicity, below) {
                    (1, falling) => Kind::of(falling),
                    (2, 0) => Kind::Minimum,
                    (2, _) => Kind::Maximum,
                    _ => Kind::Degenerate,
                };
                let at = Place::Beyond { eigenvalue: place, s };
                let of_shape = |shape| Turning { shape, kind, place: at.clone(), case: Arc::clone(case) };
                self.motions.extend(shapes.into_iter().map(of_shape));
            }
        }
    }

    /// Eigenvalues k that h or G sees: for s = -h.u/G.u alone b is orthogonal to the eigenvector u, and then v is known but
    /// for its sign along u: usually with another momentum.
    fn seen_axes(&mut self, case: &Case, momentum: &Number, denominator: &Number) {
        for place in 0..case.spectrum.eigenvalues.len() {
            if case.spectrum.unseen.contains(&place) {
                continue;
            }
            let excluded = match case.spectrum.eigenvalues[place].1 {
                1 => case.misses(place, momentum, denominator),
                _ => case.is_spread(place),
            };
            if !excluded {
                self.undecided.push(Undecided::Axis(place));
            }
        }
    }

    /// w = 0: p = h.v with v along the weight, or any v where there is none.
    fn rests(&mut self, case: &Arc<Case>, momentum: &Number, denominator: &Number) {
        let body = &case.body;
        let inner =
            |a: &Vector<Number>, b: &Vector<Number>| (0..3).fold(Number::zero(), |sum, i| &sum + &(&a[i] * &b[i]));
        let (squared, shared) = (inner(&body.weight, &body.weight), inner(&body.spin, &body.weight));
        let shared = &shared * denominator;
        if squared.is_zero() {
            // p^2 <= |h|^2
            let most = &(&inner(&body.spin, &body.spin) * denominator) * denominator;
            if (&(momentum * momentum) - &most).sign() <= 0 {
                self.undecided.push(Undecided::Rests);
            }
            return;
        }
        if (&(&(momentum * momentum) * &squared) - &(&shared * &shared)).is_zero() {
            let same = momentum.sign() * shared.sign() >= 0;
            let sides = if momentum.is_zero() { vec![true, false] } else { vec![same] };
            let of_side = |along: bool| Turning {
                shape: Shape::Point,
                kind: if along { Kind::Maximum } else { Kind::Minimum },
                place: Place::Rest { along },
                case: Arc::clone(case),
            };
            self.motions.extend(sides.into_iter().map(of_side));
        }
    }
}

impl Turning {
    fn regular(case: &Arc<Case>, x: Root) -> Self {
        let place = Place::Regular(x);
        let mut motion = Turning { shape: Shape::Point, kind: Kind::Degenerate, place, case: Arc::clone(case) };
        motion.kind = motion.kind_by_signature().unwrap_or(Kind::Degenerate);
        motion
    }

    /// As for a given w: by the signature of M - x on the tangent plane.
    fn kind_by_signature(&self) -> Option<Kind> {
        let Place::Regular(x) = &self.place else { return None };
        let [below, above] = self.case.spectrum.around(x)?;
        let adjugate = &self.case.spectrum.adjugate;
        let slope = BITS[..4].iter().find_map(|&bits| {
            let (at, (v, _)) = (x.enclosure(bits), self.at(bits)?);
            let mut sum = Enclosure::integer(0, bits);
            for i in 0..3 {
                for j in 0..3 {
                    sum = &sum + &(&(&v[i] * &v[j]) * &adjugate[i][j].enclosure(&at, bits));
                }
            }
            sum.sign()
        })?;
        // the determinant has the sign of the eigenvalues below
        let determinant = if (3 - above) % 2 == 0 { 1 } else { -1 };
        Some(Kind::of(below - usize::from(slope * determinant < 0)))
    }

    /// v (of a circle its centre) and w, rad/s, within 2^-bits. `None` where 8192 bits do not suffice.
    pub fn direction_and_speed(&self, bits: usize) -> Option<(Vector<Enclosure>, Enclosure)> {
        let close = |(v, w): &(Vector<Enclosure>, Enclosure)| v.iter().chain([w]).all(|x| x.is_within(bits));
        BITS.into_iter().filter(|work| *work > bits).filter_map(|work| self.at(work)).find(close)
    }

    /// A unit vector along the axis of a circle.
    pub fn axis(&self, bits: usize) -> Option<Vector<Enclosure>> {
        let Shape::Circle { place } = self.shape else { return None };
        let close = |v: &Vector<Enclosure>| v.iter().all(|x| x.is_within(bits));
        BITS.into_iter()
            .filter(|work| *work > bits)
            .filter_map(|work| self.case.spectrum.normal(place, work))
            .find(close)
    }

    fn at(&self, bits: usize) -> Option<(Vector<Enclosure>, Enclosure)> {
        let (case, spectrum) = (&*self.case, &self.case.spectrum);
        let one = Enclosure::integer(1, bits);
        let (x, s) = match &self.place {
            Place::Rest { along } => {
                let g = case.body.weight.each_ref().map(|g| g.enclosure(bits));
                let length = g.iter().fold(Enclosure::integer(0, bits), |sum, g| &sum + &(g * g)).sqrt()?;
                let v: Vec<_> = g.iter().map(|g| g.over(&length)).collect::<Option<_>>()?;
                let v: Vector<Enclosure> = v.try_into().ok()?;
                let v = if *along { v } else { v.map(|v| -&v) };
                return Some((v, Enclosure::integer(0, bits)));
            }
            Place::Regular(x) => {
                let x = x.enclosure(bits);
                let [constant, slope] = [0, 1].map(|k| case.ratio[k].enclosure(&x, bits));
                (x, (-&constant).over(&slope)?)
            }
            Place::Beyond { eigenvalue, s } => (spectrum.eigenvalues[*eigenvalue].0.enclosure(bits), s.enclosure(bits)),
        };
        let q = spectrum.seen.enclosure(&x, bits);
        let share = |k: usize, i: usize| spectrum.numerators[k][i].enclosure(&x, bits).over(&q);
        let component = |i: usize| Some(-&(&s * &(&share(0, i)? + &(&s * &share(1, i)?))));
        let centre: Vec<_> = (0..3).map(component).collect::<Option<_>>()?;
        let mut v: Vector<Enclosure> = centre.try_into().ok()?;
        if let Shape::Pair { place, positive } = self.shape {
            let reach = v.iter().fold(one.clone(), |rest, v| &rest - &(v * v)).sqrt()?;
            let reach = if positive { reach } else { -&reach };
            let along = spectrum.eigenvector(place, bits)?;
            v = std::array::from_fn(|i| &v[i] + &(&reach * &along[i]));
        }
        Some((v, one.over(&s)?))
    }
}

impl Case {
    /// An eigenvalue as a fraction of numbers that go with those of the body.
    fn at_eigenvalue(&self, place: usize) -> Option<(Number, Number)> {
        let eigenvalue = &self.spectrum.eigenvalues[place].0;
        match eigenvalue.as_rational() {
            Some(value) => Number::over_common(&[value]).and_then(|(mut n, d)| Some((n.pop()?, d))),
            None if self.body.spin.iter().all(|h| h.as_integer().is_some()) => Field::of(eigenvalue),
            None => None,
        }
    }

    /// Whether the eigenvector at a place is surely no part of a motion with this momentum.
    fn misses(&self, place: usize, momentum: &Number, denominator: &Number) -> bool {
        let eigenvalue = &self.spectrum.eigenvalues[place].0;
        let sees =
            |b: &Vector<Number>| self.spectrum.adjugate.iter().any(|row| eigenvalue.sign_of(&along(row, b)) != 0);
        // b.u = s h.u + s^2 G.u vanishes for s = 0 alone, or for no s
        if !(sees(&self.body.spin) && sees(&self.body.weight)) {
            return true;
        }
        BITS[..3].iter().any(|&bits| self.misses_at(place, momentum, denominator, bits) == Some(true))
    }

    /// `None` where these bits do not tell.
    fn misses_at(&self, place: usize, momentum: &Number, denominator: &Number, bits: usize) -> Option<bool> {
        let number = |n: &Number| n.enclosure(bits);
        let k = self.spectrum.eigenvalues[place].0.enclosure(bits);
        let u = self.spectrum.eigenvector(place, bits)?;
        let (h, g) = (self.body.spin.each_ref().map(number), self.body.weight.each_ref().map(number));
        let inner = |a: &Vector<Enclosure>, b: &Vector<Enclosure>| {
            (0..3).fold(Enclosure::integer(0, bits), |sum, i| &sum + &(&a[i] * &b[i]))
        };
        let pull = inner(&g, &u);
        let s = (-&inner(&h, &u)).over(&pull)?;
        let b: Vector<Enclosure> = std::array::from_fn(|i| &s * &(&h[i] + &(&s * &g[i])));
        // (M - k + c u u^T) v = -b is solvable, and its solution is orthogonal to u; c of the size of M
        let c =
            &(&number(&self.body.tensor[0][0]) + &number(&self.body.tensor[1][1])) + &number(&self.body.tensor[2][2]);
        let matrix: [Vector<Enclosure>; 3] = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let entry = &number(&self.body.tensor[i][j]) + &(&c * &(&u[i] * &u[j]));
                if i == j { &entry - &k } else { entry }
            })
        });
        let cross = |a: &Vector<Enclosure>, b: &Vector<Enclosure>| -> Vector<Enclosure> {
            std::array::from_fn(|i| {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                &(&a[j] * &b[k]) - &(&a[k] * &b[j])
            })
        };
        // symmetric: columns are rows
        let [x, y, z] = &matrix;
        let (yz, zx, xy) = (cross(y, z), cross(z, x), cross(x, y));
        let determinant = inner(x, &yz);
        let component = |i: usize| {
            let sum = &(&(&b[0] * &yz[i]) + &(&b[1] * &zx[i])) + &(&b[2] * &xy[i]);
            Some(-&sum.over(&determinant)?)
        };
        let v: Vec<_> = (0..3).map(component).collect::<Option<_>>()?;
        let v: Vector<Enclosure> = v.try_into().ok()?;
        let room = &Enclosure::integer(1, bits) - &inner(&v, &v);
        if room.sign() == Some(-1) {
            return Some(true);
        }
        let p = number(momentum).over(&number(denominator))?;
        let squared = &s * &s;
        let gap = &(&k - &(&p * &s)) - &(&squared * &inner(&g, &v));
        let lift = &squared * &pull;
        let excess = &(&gap * &gap) - &(&(&lift * &lift) * &room);
        Some(excess.sign().is_some_and(|sign| sign != 0))
    }

    /// Whether h and G in a repeated eigenvalue's eigenspace point in different directions, so that no s h + s^2 G is
    /// orthogonal to it.
    fn is_spread(&self, place: usize) -> bool {
        let (h, g) = (&self.body.spin, &self.body.weight);
        let cross: Vector<Number> = std::array::from_fn(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            &(&h[j] * &g[k]) - &(&h[k] * &g[j])
        });
        match self.spectrum.eigenvalues.iter().enumerate().find(|(other, _)| *other != place) {
            Some((_, (axis, _))) => self.spectrum.adjugate.iter().any(|row| axis.sign_of(&along(row, &cross)) != 0),
            None => cross.iter().any(|c| !c.is_zero()),
        }
    }
}

/// An equation in s at x = n/d, d > 0, all coefficients times one positive number.
fn at_fraction(equation: &[Polynomial], n: &Number, d: &Number) -> Polynomial {
    let (n, d) = if d.sign() < 0 { (-n, -d) } else { (n.clone(), d.clone()) };
    let degree = equation.iter().filter_map(Polynomial::degree).max().unwrap_or(0);
    let value = |p: &Polynomial| {
        let own = p.coefficients();
        let mut sum = Number::zero();
        // sum c_i n^i d^(degree - i)
        for power in (0..=degree).rev() {
            let mut term = own.get(power).cloned().unwrap_or_else(Number::zero);
            for _ in power..degree {
                term = &term * &d;
            }
            sum = &(&sum * &n) + &term;
        }
        sum
    };
    Polynomial::new(equation.iter().map(value).collect())
}
