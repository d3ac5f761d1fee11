//! Continuation of a uniform rotation along a path of data, with a proof by Krawczyk's operator.
//!
//! The unknown z = (v, lambda) satisfies f(z; t) = ((K - lambda) v + b, (|v|^2 - 1)/2) = 0, where t runs along the
//! path. For a point y of a box Z, an interval T of t and a matrix C near the inverse of f', the box
//!
//!   N = y - C f(y; T) + (1 - C f'(Z; T)) (Z - y)
//!
//! contains every solution in Z for t in T. If N lies in the interior of Z there is exactly one solution for each t
//! (Krawczyk 1969, Moore 1977), and it depends continuously on t. Steps in t are made up to the end; they become short
//! near a fold, and none crosses a fold.

use super::spectrum::{Matrix, Vector};
use crate::linear_stability::real_roots;
use algebra::real::Enclosure;
use nalgebra::{Matrix4, Vector4};

/// Enclosures of (v, lambda).
pub type EnclosedPoint = [Enclosure; 4];

/// The data (K, b).
pub type Data = (Matrix<Enclosure>, Vector<Enclosure>);

/// K and b for all t in a subinterval of [0, 1]; `None` where they may be undefined.
pub type Path<'a> = dyn Fn(&Enclosure) -> Option<Data> + 'a;

/// The shortest step, as a fraction of the path.
const LEAST: f64 = 1.0 / 1024.0;
/// The smallest radius of a box, and the margin around the expected solution, as a fraction of the radius.
const MARGIN: f64 = 1e-9;
const ROOM: f64 = 0.25;
/// The number of boxes tried for a step.
const TRIALS: usize = 3;
/// Iterations of Newton's method.
const ROUNDS: usize = 4;

/// The solution at t = 1 on the path that begins at the solution `from` at t = 0; `None` where the continuation fails.
pub fn followed(path: &Path<'_>, from: &EnclosedPoint) -> Option<EnclosedPoint> {
    let (mut place, mut t, mut step) = (from.clone(), 0.0, 1.0);
    while t < 1.0 {
        // the ends of steps are dyadic numbers, exact in floating point
        let end = f64::min(t + step, 1.0);
        match across(path, &place, [t, end]) {
            Some(next) => (place, t, step) = (next, end, 2.0 * step),
            None if step > LEAST => step *= 0.5,
            None => return None,
        }
    }
    Some(place)
}

/// One step of the continuation.
fn across(path: &Path<'_>, from: &EnclosedPoint, [start, end]: [f64; 2]) -> Option<EnclosedPoint> {
    let bits = from[0].bits();
    let at = |t: f64| Enclosure::float(t, bits);
    let (begun, ended) = (path(&at(start)?)?, path(&at(end)?)?);
    let expected = newton(&ended, from.each_ref().map(Enclosure::to_f64))?;
    let hull: Vec<Enclosure> =
        from.iter().zip(expected).map(|(z, to)| Some(z.hull(&at(to)?))).collect::<Option<_>>()?;
    let hull: EnclosedPoint = hull.try_into().ok()?;
    let during = path(&at(start)?.hull(&at(end)?))?;
    // if the image N is not inside the box, a wider box around the image is tried
    let mut boxed = wider(&hull, size(&begun))?;
    for _ in 0..TRIALS {
        let place = held(&during, &boxed)?;
        if place.iter().zip(&boxed).all(|(inner, outer)| inner.is_inside(outer)) {
            return sharpened(&ended, place);
        }
        boxed = wider(&std::array::from_fn(|i| place[i].hull(&hull[i])), size(&begun))?;
    }
    None
}

/// A wider box.
fn wider(hull: &EnclosedPoint, size: f64) -> Option<EnclosedPoint> {
    let widest = hull[..3].iter().map(Enclosure::radius).fold(MARGIN, f64::max);
    let room = |i: usize| {
        let margin = ROOM * if i < 3 { widest } else { hull[i].radius().max(size * MARGIN) };
        let [low, high] = [-margin, margin].map(|m| Enclosure::float(m, hull[i].bits()));
        Some(&hull[i] + &low?.hull(&high?))
    };
    let all: Vec<Enclosure> = (0..4).map(room).collect::<Option<_>>()?;
    all.try_into().ok()
}

/// The unique solution in a box, as precisely as the data determine it.
pub fn sharpened(data: &Data, mut place: EnclosedPoint) -> Option<EnclosedPoint> {
    loop {
        let next = held(data, &place)?;
        let width = |place: &EnclosedPoint| place.iter().map(Enclosure::radius).fold(0.0, f64::max);
        if width(&next) >= 0.5 * width(&place) {
            return Some(next);
        }
        place = next;
    }
}

/// The image N, which contains every solution in the box.
fn held((k, b): &Data, boxed: &EnclosedPoint) -> Option<EnclosedPoint> {
    let bits = boxed[0].bits();
    let middle = boxed.each_ref().map(Enclosure::middle);
    let near = |e: &Enclosure| e.to_f64();
    let slopes = slopes(k, &middle);
    let inverse = Matrix4::from_fn(|i, j| near(&slopes[i][j])).try_inverse()?;
    let rows: Vec<Enclosure> = inverse.transpose().iter().map(|x| Enclosure::float(*x, bits)).collect::<Option<_>>()?;
    let c = |i: usize, j: usize| &rows[4 * i + j];
    let sum = |terms: [Enclosure; 4]| terms.iter().skip(1).fold(terms[0].clone(), |sum, term| &sum + term);
    let missing = missing(k, b, &middle);
    let slopes = self::slopes(k, boxed);
    let component = |i: usize| {
        let step = sum(std::array::from_fn(|j| c(i, j) * &missing[j]));
        let spread = sum(std::array::from_fn(|j| {
            let unit = Enclosure::integer(i64::from(i == j), bits);
            let rest = &unit - &sum(std::array::from_fn(|l| c(i, l) * &slopes[l][j]));
            &rest * &(&boxed[j] - &middle[j])
        }));
        &(&middle[i] - &step) + &spread
    };
    Some(std::array::from_fn(component))
}

/// The number of solutions, if it is equal for all K and b in the enclosures and no two solutions merge; `None`
/// otherwise. The solutions are the real roots of |adj(K - x) b|^2 - det(K - x)^2, which has a double root if b is
/// orthogonal to an eigenvector.
pub fn count((k, b): &Data) -> Option<usize> {
    let zero = Enclosure::integer(0, b[0].bits());
    let sum = |terms: [Enclosure; 3]| terms.iter().fold(zero.clone(), |sum, term| &sum + term);
    let times = |m: &Matrix<Enclosure>| -> Vector<Enclosure> {
        std::array::from_fn(|i| sum(std::array::from_fn(|j| &m[i][j] * &b[j])))
    };
    let minors: Matrix<Enclosure> = std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let (a, b, c, d) = ((j + 1) % 3, (j + 2) % 3, (i + 1) % 3, (i + 2) % 3);
            &(&k[a][c] * &k[b][d]) - &(&k[a][d] * &k[b][c])
        })
    });
    let trace = |m: &Matrix<Enclosure>| sum(std::array::from_fn(|i| m[i][i].clone()));
    let determinant = sum(std::array::from_fn(|j| &k[0][j] * &minors[j][0]));
    // adj(K - x) = adj K + x (K - tr K) + x^2 and det(K - x) = det K - x tr adj K + x^2 tr K - x^3
    let (still, once, twice) = (times(&minors), times(k), b);
    let once: Vector<Enclosure> = std::array::from_fn(|i| &once[i] - &(&trace(k) * &b[i]));
    let dot = |p: &Vector<Enclosure>, q: &Vector<Enclosure>| sum(std::array::from_fn(|i| &p[i] * &q[i]));
    let numerator = [&still, &once, twice];
    let seen = [determinant, -&trace(&minors), trace(k), Enclosure::integer(-1, zero.bits())];
    let coefficient = |power: usize| {
        let pairs = |most: usize| (0..=most).filter(move |i| *i <= power && power - i <= most);
        let above = pairs(2).fold(zero.clone(), |all, i| &all + &dot(numerator[i], numerator[power - i]));
        pairs(3).fold(above, |all, i| &all - &(&seen[i] * &seen[power - i]))
    };
    real_roots(&(0..=6).rev().map(coefficient).collect::<Vec<_>>())
}

/// The residual f.
fn missing(k: &Matrix<Enclosure>, b: &Vector<Enclosure>, [v1, v2, v3, multiplier]: &EnclosedPoint) -> EnclosedPoint {
    let v = [v1, v2, v3];
    let row = |i: usize| (0..3).fold(&b[i] - &(multiplier * v[i]), |sum, j| &sum + &(&k[i][j] * v[j]));
    let one = Enclosure::integer(1, v1.bits());
    let excess = v.iter().fold(-&one, |sum, v| &sum + &(*v * *v));
    // half of it, for consistency with the Jacobian
    let half = Enclosure::float(0.5, v1.bits()).map_or(excess.clone(), |half| &half * &excess);
    [row(0), row(1), row(2), half]
}

/// The Jacobian f'.
fn slopes(k: &Matrix<Enclosure>, place: &EnclosedPoint) -> [[Enclosure; 4]; 4] {
    let zero = Enclosure::integer(0, place[0].bits());
    std::array::from_fn(|i| {
        std::array::from_fn(|j| match (i, j) {
            (3, 3) => zero.clone(),
            (3, j) => place[j].clone(),
            (i, 3) => -&place[i],
            (i, j) if i == j => &k[i][j] - &place[3],
            (i, j) => k[i][j].clone(),
        })
    })
}

/// The solution near a point in double precision, without proof.
fn newton((k, b): &Data, from: [f64; 4]) -> Option<[f64; 4]> {
    let k = k.each_ref().map(|row| row.each_ref().map(Enclosure::to_f64));
    let b = b.each_ref().map(Enclosure::to_f64);
    let mut z = Vector4::from(from);
    for _ in 0..ROUNDS {
        let row = |i: usize| b[i] - z[3] * z[i] + (0..3).map(|j| k[i][j] * z[j]).sum::<f64>();
        let excess = 0.5 * (z[0] * z[0] + z[1] * z[1] + z[2] * z[2] - 1.0);
        let slope = Matrix4::from_fn(|i, j| match (i, j) {
            (3, 3) => 0.0,
            (3, j) => z[j],
            (i, 3) => -z[i],
            (i, j) => k[i][j] - if i == j { z[3] } else { 0.0 },
        });
        z -= slope.try_inverse()? * Vector4::new(row(0), row(1), row(2), excess);
    }
    z.iter().all(|x| x.is_finite()).then(|| z.into())
}

/// The magnitude of the multipliers.
fn size((k, b): &Data) -> f64 {
    k.iter().flatten().chain(b).map(|x| x.to_f64().abs()).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    const BITS: usize = 96;

    /// Data with K = diag(1, 2, 3), and b on the segment between two vectors.
    fn path(from: [f64; 3], to: [f64; 3]) -> impl Fn(&Enclosure) -> Option<Data> {
        let number = |x: f64| Enclosure::float(x, BITS).unwrap();
        let b = move |t: &Enclosure, i: usize| &number(from[i]) + &(t * &number(to[i] - from[i]));
        let k = |i: usize, j: usize| Enclosure::integer(if i == j { i as i64 + 1 } else { 0 }, BITS);
        move |t| Some((std::array::from_fn(|i| std::array::from_fn(|j| k(i, j))), std::array::from_fn(|i| b(t, i))))
    }

    fn start(path: &Path<'_>, guess: [f64; 4]) -> EnclosedPoint {
        let still = path(&Enclosure::integer(0, BITS)).unwrap();
        let near = newton(&still, newton(&still, guess).unwrap()).unwrap();
        let wide = Enclosure::float(-1e-9, BITS).unwrap().hull(&Enclosure::float(1e-9, BITS).unwrap());
        held(&still, &near.map(|x| &Enclosure::float(x, BITS).unwrap() + &wide)).unwrap()
    }

    #[test]
    fn solutions_are_counted_for_all_data_at_once() {
        let at = |b: [f64; 3]| count(&path(b, b)(&Enclosure::integer(0, BITS)).unwrap());
        assert_eq!([at(SMALL), at(SMALL.map(|b| 10.0 * b))], [Some(6), Some(2)]);
        // an eigenvalue whose eigenvector is orthogonal to b, and data on both sides of a fold
        assert_eq!(at([0.1, 0.0, 0.1]), None);
        let all = Enclosure::integer(0, BITS).hull(&Enclosure::integer(1, BITS));
        assert_eq!(count(&path(SMALL, SMALL.map(|b| 10.0 * b))(&all).unwrap()), None);
    }

    const SMALL: [f64; 3] = [0.075, 0.05, 0.025];

    #[test]
    fn a_direction_is_followed_through_a_multiplier_that_is_an_eigenvalue() {
        // b2 changes its sign, v2 does not: lambda passes through K2
        let law = path(SMALL, [0.075, -0.2, 0.025]);
        let end = followed(&law, &start(&law, [0.0, 1.0, 0.0, 2.05])).unwrap().each_ref().map(Enclosure::to_f64);
        assert!(end[1] > 0.9 && end[3] < 2.0, "{end:?}");
        assert!((end[..3].iter().map(|v| v * v).sum::<f64>() - 1.0).abs() < 1e-12);
    }

    #[test]
    fn a_box_about_another_middle_is_mapped_to_what_holds_its_solution() {
        let law = path(SMALL, SMALL);
        let still = law(&Enclosure::integer(0, BITS)).unwrap();
        let solution = sharpened(&still, start(&law, [0.0, 1.0, 0.0, 2.05])).unwrap();
        let beside = |z: &Enclosure| {
            let [low, high] = [-0.01, 0.03].map(|off| Enclosure::float(off, BITS).unwrap());
            z + &low.hull(&high)
        };
        let mapped = held(&still, &solution.each_ref().map(beside)).unwrap();
        assert!(mapped.iter().zip(&solution).all(|(held, z)| z.is_inside(held)), "{mapped:?}");
    }

    #[test]
    fn a_direction_that_ends_in_a_fold_is_not_followed_across_it() {
        // with a tenfold b only the smallest and the largest multiplier remain
        let law = path(SMALL, SMALL.map(|b| 10.0 * b));
        assert!(followed(&law, &start(&law, [0.0, 1.0, 0.0, 2.05])).is_none());
        assert!(followed(&law, &start(&law, [-1.0, 0.0, 0.0, 0.92])).is_some());
    }
}
