//! The method of combining constraints, as theorems on (M, J, R): existence, uniqueness, independence of friction.
//!
//! The dimensions (N, C) are (2, 1), (3, 1), (3, 2), (4, 2); every entry of M, J, R is a symbol. The rows of J may
//! belong to geometric or kinematic constraints, hence nonholonomic systems are included.

use super::alphabet::{letter, letters};
use super::any::{AnySystem, numbered};
use super::cases;
use algebra::linear;
use claims::{Condition, Line, Page};
use field::Analytic;
use mechanics::constrained::PointSystem;
use mechanics::constrained::combining::{extended, painleve};
use mechanics::constrained::rates::jacobian;
use symbolic::{Hypotheses, Sym};

use Condition::{Equal, NonZero, Zero};

/// The conditions for each dimension (N, C), collected for the claims that concern all dimensions.
#[derive(Default)]
struct Sizes {
    exists: Vec<Condition>,
    rank: Vec<Condition>,
    multipliers: Vec<Condition>,
    motion: Vec<Condition>,
    commutes: Vec<Condition>,
}

pub fn claims(page: &mut Page) {
    page.section("Combining constraints");
    let mut all = Sizes::default();
    all.add::<2, 1>();
    all.add::<3, 1>();
    all.add::<3, 2>();
    all.add::<4, 2>();
    page.claim("combining", "exists", r"Every reaction is $R = J^T\lambda + R^\tau$ with $JM^{-1}R^\tau=0$ (the extended choice) and also with $JR^\tau=0$ (Painlevé's), where $J$ has full rank, for the sizes $(N,C)=(2,1),(3,1),(3,2),(4,2)$")
        .in_words()
        .follows(all.exists);
    page.claim("combining", "rank", "The determinant of $JM^{-1}J^T$ is the sum of the squares of the minors of $J$, each over its masses. It is positive if and only if $J$ has full rank, for the sizes $(N,C)=(2,1),(3,1),(3,2),(4,2)$")
        .in_words()
        .follows(all.rank);
    unique::<2, 1>(page, "unique-2-1");
    unique::<3, 2>(page, "unique-3-2");
    unique::<4, 2>(page, "unique-4-2");
    unique_parts::<4, 2>(page);
    page.claim("combining", "multipliers", r"With the extended friction $R^\tau$ in addition to the given forces the multipliers are those without friction, for any masses, kinematic constraints included, for the sizes $(N,C)=(2,1),(3,1),(3,2),(4,2)$")
        .in_words()
        .follows(all.multipliers);
    page.claim("combining", "motion", r"A force of friction $R$ changes the accelerations by $M^{-1}R^\tau$ and the multipliers by those of its own part $R^n=J^T\lambda^n$: $\ddot x(X+R) = \ddot x(X)+M^{-1}R^\tau$, $\lambda(X+R)=\lambda(X)-\lambda^n(R)$, for the sizes $(N,C)=(2,1),(3,1),(3,2),(4,2)$. The motion depends on $R^\tau$ alone, and the multipliers do not depend on $R$ if and only if $\lambda^n=0$, that is $JM^{-1}R=0$")
        .in_words()
        .follows(all.motion);
    painleves_choice(page);
    page.claim("combining", "commutes", "With the projector $P$ onto the virtual displacements, $JM^{-1}P = J(M^{-1}P-PM^{-1})$ and $M^{-1}P-PM^{-1} = J^T(JJ^T)^{-1}K - K^T(JJ^T)^{-1}J$ with $K=JM^{-1}P$. Painlevé's choice leaves the multipliers alone if and only if $M$ commutes with $P$, for the sizes $(N,C)=(2,1),(3,1),(3,2),(4,2)$")
        .in_words()
        .follows(all.commutes);
    rod(page);
}

impl Sizes {
    fn add<const N: usize, const C: usize>(&mut self) {
        let any = AnySystem::<N, C>::new();
        let (force, reaction): ([Sym; N], [Sym; N]) = (numbered("X"), numbered("R"));
        let (Ok(split), Ok(old)) = (extended(any.masses, any.rows, reaction), painleve(any.rows, reaction)) else {
            return self.exists.push(Zero(Sym::UNDEFINED));
        };
        self.exists.extend(any.along_rows(any.per_mass(split.of_friction)).map(Zero));
        self.exists.extend(any.along_rows(old.of_friction).map(Zero));
        self.exists
            .extend((0..N).map(|i| Equal(any.reaction(split.multipliers)[i] + split.of_friction[i], reaction[i])));
        self.rank.push(Equal(determinant(&any.matrix()), minors(&any)));

        let add = |a: [Sym; N], b: [Sym; N]| -> [Sym; N] { std::array::from_fn(|i| a[i] + b[i]) };
        let (free, rubbed) = (any.under(force), any.under(add(force, split.of_friction)));
        self.multipliers.extend((0..C).map(|k| Equal(rubbed.multipliers[k], free.multipliers[k])));
        let raw = any.under(add(force, reaction));
        let moved = add(free.acceleration, any.per_mass(split.of_friction));
        self.motion.extend((0..N).map(|i| Equal(raw.acceleration[i], moved[i])));
        self.motion.extend((0..C).map(|k| Equal(raw.multipliers[k], free.multipliers[k] - split.multipliers[k])));
        self.projector(&any);
    }

    /// K and the commutator, column by column of P.
    fn projector<const N: usize, const C: usize>(&mut self, any: &AnySystem<N, C>) {
        let unit = |j: usize| -> [Sym; N] { mechanics::differentiate::unit(j) };
        let parts: Option<Vec<_>> = (0..N).map(|j| painleve(any.rows, unit(j)).ok()).collect();
        let Some(parts) = parts else { return self.commutes.push(Zero(Sym::UNDEFINED)) };
        // (P)_ij and ((J J^T)^-1 J)_kj
        let p = |i: usize, j: usize| parts[j].of_friction[i];
        let inverse = |k: usize, j: usize| parts[j].multipliers[k];
        let commutator = |i: usize, j: usize| p(i, j) / any.masses[i] - p(i, j) / any.masses[j];
        let k = |c: usize, j: usize| (0..N).fold(Sym::ZERO, |sum, i| sum + any.rows[c][i] * p(i, j) / any.masses[i]);
        for j in 0..N {
            for c in 0..C {
                let row = (0..N).fold(Sym::ZERO, |sum, i| sum + any.rows[c][i] * commutator(i, j));
                self.commutes.push(Equal(k(c, j), row));
            }
            for i in 0..j {
                let right = (0..C).fold(Sym::ZERO, |sum, c| sum + inverse(c, i) * k(c, j) - inverse(c, j) * k(c, i));
                self.commutes.push(Equal(commutator(i, j), right));
            }
        }
    }
}

/// The determinant of a square matrix.
fn determinant<const C: usize>(matrix: &[[Sym; C]; C]) -> Sym {
    linear::determinant(matrix).unwrap_or(Sym::UNDEFINED)
}

/// The sum over all sets of C of the N columns of (minor of J)^2 / (product of the masses of these columns).
fn minors<const N: usize, const C: usize>(any: &AnySystem<N, C>) -> Sym {
    let sets = (0usize..1 << N).filter(|set| set.count_ones() as usize == C);
    sets.fold(Sym::ZERO, |sum, set| {
        let columns: Vec<usize> = (0..N).filter(|i| set >> i & 1 == 1).collect();
        let block = any.rows.map(|row| -> Vec<Sym> { columns.iter().map(|&i| row[i]).collect() });
        let minor = linear::determinant(&block).unwrap_or(Sym::UNDEFINED);
        sum + columns.iter().fold(minor * minor, |term, &i| term / any.masses[i])
    })
}

/// J^T lambda + R^tau = 0 and J M^-1 R^tau = 0 imply lambda = 0, R^tau = 0: det lambda_k and det R^tau_i are linear
/// combinations of their left-hand sides.
fn unique<const N: usize, const C: usize>(page: &mut Page, slug: &'static str) {
    let any = AnySystem::<N, C>::new();
    let (lambda, friction): ([Sym; C], [Sym; N]) = (numbered("λ"), numbered("R"));
    let matrix = any.matrix();
    let det = determinant(&matrix);
    // the adjugate, column by column
    let adjugate: [Vec<Sym>; C] = std::array::from_fn(|c| {
        let unit: [Sym; C] = mechanics::differentiate::unit(c);
        symbolic::linear::solve(&matrix, &unit, &Hypotheses::none()).map_or(vec![Sym::UNDEFINED; C], |s| s.numerators)
    });
    let reaction = any.reaction(lambda);
    let sums = (0..N).map(|i| Zero(reaction[i] + friction[i]));
    let orthogonal = any.along_rows(any.per_mass(friction)).map(Zero);
    // det lambda_k = sum_c adj_kc (sum_i J_ci sums_i / m_i - orthogonal_c); the given expressions: 0 is det, then sums,
    // then orthogonal
    let of_multiplier = |k: usize| -> Vec<(usize, Sym)> {
        let by_sum = (0..N).map(|i| {
            let cofactor = (0..C).fold(Sym::ZERO, |sum, c| sum + adjugate[c][k] * any.rows[c][i] / any.masses[i]);
            (1 + i, cofactor)
        });
        by_sum.chain((0..C).map(|c| (1 + N + c, -adjugate[c][k]))).collect()
    };
    let of_friction = |i: usize| -> Vec<(usize, Sym)> {
        let by_multipliers = (0..C).flat_map(|k| {
            let row = any.rows[k][i];
            of_multiplier(k).into_iter().map(move |(place, cofactor)| (place, -row * cofactor))
        });
        by_multipliers.chain([(1 + i, det)]).collect()
    };
    let lambdas = (0..C).map(|k| (Zero(lambda[k]), vec![0], of_multiplier(k)));
    let frictions = (0..N).map(|i| (Zero(friction[i]), vec![0], of_friction(i)));
    page.claim("combining", slug, format!(r"The extended decomposition is unique, $(N,C)=({N},{C})$, where $\det JM^{{-1}}J^T\ne0$, since the difference of two, $J^T\lambda+R^\tau=0$ with $JM^{{-1}}R^\tau=0$, is zero"))
        .in_words()
        .given([NonZero(det)].into_iter().chain(sums).chain(orthogonal))
        .by_combination(lambdas.chain(frictions));
}

/// Even without full rank of J, sum (R^tau_i)^2/m_i is such a combination: R^tau and R^n are still unique.
fn unique_parts<const N: usize, const C: usize>(page: &mut Page) {
    let any = AnySystem::<N, C>::new();
    let (lambda, friction): ([Sym; C], [Sym; N]) = (numbered("λ"), numbered("R"));
    let reaction = any.reaction(lambda);
    let sums = (0..N).map(|i| Zero(reaction[i] + friction[i]));
    let orthogonal = any.along_rows(any.per_mass(friction)).map(Zero);
    let length = (0..N).fold(Sym::ZERO, |sum, i| sum + friction[i] * friction[i] / any.masses[i]);
    let by_sums = any.per_mass(friction).into_iter().enumerate();
    let cofactors = by_sums.chain((0..C).map(|k| (N + k, -lambda[k]))).collect();
    page.claim("combining", "unique-parts", r"$R^n=J^T\lambda$ and $R^\tau$ are unique for every rank of $J$, here $(N,C)=(4,2)$. The difference of two extended decompositions of one reaction has $\sum (R^\tau)^2/m = 0$")
        .in_words()
        .given(sums.chain(orthogonal))
        .by_combination([(Zero(length), vec![], cofactors)]);
}

/// Painleve's own condition J R^tau = 0 in place of J M^-1 R^tau = 0.
fn painleves_choice(page: &mut Page) {
    let any = AnySystem::<2, 1>::new();
    let reaction: [Sym; 2] = numbered("R");
    let friction = painleve(any.rows, reaction).map_or([Sym::UNDEFINED; 2], |split| split.of_friction);
    let change = any.under(friction).multipliers[0] - any.under([Sym::ZERO; 2]).multipliers[0];
    let [[j1, j2]] = any.rows;
    let ([m1, m2], [r1, r2]) = (any.masses, reaction);
    page.claim("combining", "painleve", r"With Painlevé's choice the multipliers are those without friction, for any masses. With two coordinates and one constraint, $\lambda_1$ does not change")
        .why(r"Painlevé's $R^\tau$ has $JR^\tau=0$; the multipliers depend on $JM^{-1}R^\tau$.")
        .fails([Line::formula(change, letter("λ1"), Sym::ZERO)]);
    let square = j1 * j1 + j2 * j2;
    page.claim(
        "combining",
        "painleve-change",
        "With Painlevé's choice, two coordinates and one constraint, the multiplier changes by the value below. It does not change where the masses are equal or where the constraint concerns one coordinate",
    )
    .holds([Line::formula(
        change,
        letter("λ1"),
        j1 * j2 * (j1 * r2 - j2 * r1) * (m2 - m1) / (square * (m2 * j1 * j1 + m1 * j2 * j2)),
    )]);
    page.correct();
}

/// The contact itself: Coulomb's law relates the reactions of the contact, not the multiplier of the decomposition.
fn rod(page: &mut Page) {
    let case = cases::rod();
    let state = case.motion().state;
    let [m, m1, push, up] = letters(["m", "m1", "R1", "R2"]);
    let point = letter("θ").circle();
    let (cos, sin) = (point.cos, point.sin);
    let rows: [[Sym; 4]; 2] = jacobian(&case.system, &state);
    let masses: [Sym; 4] = case.system.masses();
    // the guide's reaction on M, along the guide and perpendicular to it
    let contact = [push, up, Sym::ZERO, Sym::ZERO];
    let undefined = mechanics::constrained::combining::Combined {
        multipliers: [Sym::UNDEFINED; 2],
        of_constraints: [Sym::UNDEFINED; 4],
        of_friction: [Sym::UNDEFINED; 4],
    };
    let split = extended(masses, rows, contact).unwrap_or(undefined);
    let mu = push / (m + m1 * cos * cos);
    let expected = [m * mu, Sym::ZERO, m1 * mu * cos * cos, m1 * mu * sin * cos];
    page.claim("combining", "rod", r"The guide's reaction $(R_1,R_2)$ on the rod's point $M$ has $R^\tau = \mu\,(m, 0, m_1\cos^2\theta, m_1\sin\theta\cos\theta)$ with $\mu = R_1/(m+m_1\cos^2\theta)$")
        .in_words()
        .follows((0..4).map(|i| Equal(split.of_friction[i], expected[i])));
    // the second row is the gap -y, hence its multiplier is -lambda_2 here
    page.claim("combining", "rod-normal", r"The guide's reaction across itself on the rod's point $M$ is $R_2 = \lambda_2 + m_1\mu\sin\theta\cos\theta$ with $\mu = R_1/(m+m_1\cos^2\theta)$. The contact's normal force is not the multiplier")
        .holds([Line::formula(up + split.multipliers[1], up - letter("λ2"), m1 * mu * sin * cos)]);

    let friction = letter("F");
    let normal = |rubbing: Sym| case.by_multipliers([rubbing, Sym::ZERO, Sym::ZERO, Sym::ZERO]).multipliers[1];
    let change = normal(friction) - normal(Sym::ZERO);
    page.claim(
        "combining",
        "contact",
        r"The guide's push on the rod does not change with the friction $F$ along the guide: $R_2=0$ for the change",
    )
    .why(r"The friction at the contact has a part $R^n$ along the rows of $J$, which the multipliers take up.")
    .fails([Line::formula(change, letter("R2"), Sym::ZERO)]);
    page.claim(
        "combining",
        "contact-change",
        r"The guide's push on the rod changes with the friction $F$ along the guide by the value below",
    )
    .holds([Line::formula(change, letter("R2"), -(m1 * friction * sin * cos / (m + m1 * cos * cos)))]);
    page.correct();
}
