//! Impulses of several contacts that are closed or close at one instant (Moreau 1988).
//!
//! The impulses N along the normals and T along the tangents of all contacts change gap' and v of each contact. For each contact
//!
//! * N >= 0 and gap' after >= -e gap' before, and one of the two is an equation (for a two-sided contact: gap' = 0 after, N of either
//!   sign);
//! * |T| <= mu |N| if v = 0 after, else T = -mu |N| sign(v).
//!
//! Each contact has no impulse, sticks, or slides in one of two directions; every combination is solved and tested. Combinations with
//! equal velocities after the impact count as one solution; they differ only in the distribution of the impulses. For one contact this is
//! Newton's law.

use super::impact_law::NotStruck;
use integrators::Real;

/// Differences below this part of the largest velocity, or of the largest impulse, are rounding errors.
const ROUNDING: f64 = 1e-9;

/// A pivot below this part of the largest response counts as zero.
const SINGULAR: f64 = 1e-12;

/// The largest number of combinations that are tried.
const MOST_COMBINATIONS: usize = 4096;

/// A contact that takes part in the impact.
#[derive(Clone, Copy, Debug)]
pub(super) struct Partner<S> {
    /// The rate gap' of the gap and the sliding velocity v before the impact, m/s.
    pub closing: S,
    pub sliding: S,
    /// The coefficient of friction; `None` for a smooth contact.
    pub friction: Option<S>,
    /// The coefficient of restitution.
    pub restitution: S,
    /// True for a two-sided contact.
    pub holds: bool,
}

/// The state of a contact during the impact.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Part {
    Off,
    Smooth,
    Sticks,
    /// Sliding: T = -mu |N| `way`, where `way` is the sign of v and `normal` the sign of N.
    Slides {
        way: f64,
        normal: f64,
    },
}

impl<S: Real> Partner<S> {
    fn parts(&self) -> Vec<Part> {
        let slides = |normal: f64| [1.0, -1.0].map(|way| Part::Slides { way, normal });
        let mut parts = if self.holds { Vec::new() } else { vec![Part::Off] };
        match (self.friction, self.holds) {
            (None, _) => parts.push(Part::Smooth),
            (Some(_), false) => parts.extend([Part::Sticks].into_iter().chain(slides(1.0))),
            (Some(_), true) => parts.extend([Part::Sticks].into_iter().chain(slides(1.0)).chain(slides(-1.0))),
        }
        parts
    }

    /// The rate gap' after the impact of a contact with an impulse. A contact that already opens has no restitution.
    fn opening(&self) -> S {
        if self.closing < S::zero() { -self.restitution * self.closing } else { S::zero() }
    }
}

/// The impulse of a contact, and whether its velocities are zero up to rounding after the impact.
#[derive(Clone, Copy, Debug)]
pub(super) struct Struck<S> {
    /// N and T, N s.
    pub impulse: [S; 2],
    /// True if gap' is zero.
    pub stays: bool,
    /// True if v is zero.
    pub sticks: bool,
}

/// The impulses of all contacts. `responses` is the matrix of the changes of gap' and v of each contact by unit impulses N and T of each
/// contact, 1/kg.
///
/// # Errors
/// [`NotStruck`] if the law does not determine the velocities, the energy would increase, or a coefficient is out of its range.
pub(super) fn impulses<S: Real>(partners: &[Partner<S>], responses: &[Vec<S>]) -> Result<Vec<Struck<S>>, NotStruck> {
    if partners.iter().any(|partner| !(0.0..=1.0).contains(&partner.restitution.approx())) {
        return Err(NotStruck::Restitution);
    }
    if partners
        .iter()
        .filter_map(|partner| partner.friction)
        .any(|friction| friction.approx().is_nan() || friction < S::zero())
    {
        return Err(NotStruck::Friction);
    }
    let parts: Vec<Vec<Part>> = partners.iter().map(Partner::parts).collect();
    let count = parts.iter().try_fold(1_usize, |count, parts| count.checked_mul(parts.len()));
    let Some(count) = count.filter(|count| *count <= MOST_COMBINATIONS) else { return Err(NotStruck::Together) };
    let impact = Impact { partners, responses };
    let mut found: Option<(Vec<S>, Vec<S>)> = None;
    for number in 0..count {
        let mut left = number;
        let combination: Vec<Part> = parts
            .iter()
            .map(|parts| {
                let part = parts[left % parts.len()];
                left /= parts.len();
                part
            })
            .collect();
        let Some(impulses) = impact.solved(&combination) else { continue };
        let after = impact.after(&impulses);
        if !impact.is_allowed(&combination, &impulses, &after) {
            continue;
        }
        match &found {
            None => found = Some((impulses, after)),
            Some((_, known)) if impact.is_same(known, &after) => {}
            Some(_) => return Err(NotStruck::Undetermined),
        }
    }
    let Some((impulses, after)) = found else { return Err(NotStruck::Undetermined) };
    if impact.adds_energy(&impulses, &after) {
        return Err(NotStruck::AddsEnergy);
    }
    let slow = ROUNDING * impact.fastest();
    let struck = |(pair, (partner, after)): (&[S], (&Partner<S>, &[S]))| Struck {
        impulse: [pair[0], pair[1]],
        stays: partner.opening().is_zero() && after[0].approx().abs() <= slow,
        sticks: after[1].approx().abs() <= slow,
    };
    Ok(impulses.chunks(2).zip(partners.iter().zip(after.chunks(2))).map(struck).collect())
}

struct Impact<'a, S> {
    partners: &'a [Partner<S>],
    responses: &'a [Vec<S>],
}

impl<S: Real> Impact<'_, S> {
    fn before(&self) -> impl Iterator<Item = S> + '_ {
        self.partners.iter().flat_map(|partner| [partner.closing, partner.sliding])
    }

    fn after(&self, impulses: &[S]) -> Vec<S> {
        let change = |row: &Vec<S>| row.iter().zip(impulses).fold(S::zero(), |sum, (slope, part)| sum + *slope * *part);
        self.before().zip(self.responses).map(|(before, row)| before + change(row)).collect()
    }

    /// The largest velocity before the impact, m/s.
    fn fastest(&self) -> f64 {
        self.before().map(|part| part.approx().abs()).fold(0.0, f64::max)
    }

    /// The impulses of a combination; `None` if they are not determined.
    fn solved(&self, combination: &[Part]) -> Option<Vec<S>> {
        let n = 2 * combination.len();
        let unit = |place: usize| (0..n).map(|column| if column == place { S::one() } else { S::zero() }).collect();
        let (mut rows, mut right): (Vec<Vec<S>>, Vec<S>) = (Vec::new(), Vec::new());
        for (place, (part, partner)) in combination.iter().zip(self.partners).enumerate() {
            let [normal, tangent] = [2 * place, 2 * place + 1];
            match part {
                Part::Off => {
                    rows.push(unit(normal));
                    right.push(S::zero());
                }
                _ => {
                    rows.push(self.responses[normal].clone());
                    right.push(partner.opening() - partner.closing);
                }
            }
            match part {
                Part::Off | Part::Smooth => {
                    rows.push(unit(tangent));
                    right.push(S::zero());
                }
                Part::Sticks => {
                    rows.push(self.responses[tangent].clone());
                    right.push(-partner.sliding);
                }
                Part::Slides { way, normal: sign } => {
                    let mut row: Vec<S> = unit(tangent);
                    let friction = partner.friction.unwrap_or(S::zero());
                    row[normal] = if way * sign < 0.0 { -friction } else { friction };
                    rows.push(row);
                    right.push(S::zero());
                }
            }
        }
        eliminated(rows, right)
    }

    /// True if the inequalities of a combination hold.
    fn is_allowed(&self, combination: &[Part], impulses: &[S], after: &[S]) -> bool {
        let fastest = self.fastest();
        let largest = impulses.iter().map(|impulse| impulse.approx().abs()).fold(0.0, f64::max);
        let (slow, light) = (ROUNDING * fastest, ROUNDING * largest);
        let all = combination.iter().zip(self.partners).enumerate();
        all.into_iter().all(|(place, (part, partner))| {
            let [normal, tangent] = [impulses[2 * place].approx(), impulses[2 * place + 1].approx()];
            let [gap_rate, slide] = [after[2 * place].approx(), after[2 * place + 1].approx()];
            let bound = partner.friction.map_or(0.0, S::approx) * normal.abs();
            let pushes = partner.holds || normal >= -light;
            match *part {
                Part::Off => gap_rate >= partner.opening().approx() - slow,
                Part::Smooth => pushes,
                Part::Sticks => pushes && tangent.abs() <= bound + light,
                Part::Slides { way, normal: sign } => way * slide >= -slow && sign * normal >= -light,
            }
        })
    }

    fn is_same(&self, one: &[S], other: &[S]) -> bool {
        let slow = 10.0 * ROUNDING * self.fastest();
        one.iter().zip(other).all(|(one, other)| (one.approx() - other.approx()).abs() <= slow)
    }

    /// True if the work of the impulses, the sum of impulses times mean velocities, is positive beyond rounding.
    fn adds_energy(&self, impulses: &[S], after: &[S]) -> bool {
        let works = impulses.iter().zip(self.before().zip(after));
        let works: Vec<f64> = works
            .flat_map(|(impulse, (before, after))| [(*impulse * before).approx(), (*impulse * *after).approx()])
            .collect();
        works.iter().sum::<f64>() > ROUNDING * works.iter().map(|work| work.abs()).sum::<f64>()
    }
}

/// Solves linear equations by Gaussian elimination with partial pivoting; `None` if a pivot is zero.
fn eliminated<S: Real>(mut rows: Vec<Vec<S>>, mut right: Vec<S>) -> Option<Vec<S>> {
    let n = right.len();
    let largest = rows.iter().flatten().map(|entry| entry.approx().abs()).fold(0.0, f64::max);
    for pivot in 0..n {
        let size = |row: usize| rows[row][pivot].approx().abs();
        let row = (pivot..n).max_by(|&a, &b| size(a).total_cmp(&size(b)))?;
        if size(row).is_nan() || size(row) <= SINGULAR * largest {
            return None;
        }
        rows.swap(pivot, row);
        right.swap(pivot, row);
        for below in pivot + 1..n {
            let factor = rows[below][pivot] / rows[pivot][pivot];
            let (upper, lower) = rows.split_at_mut(below);
            for (entry, &above) in lower[0].iter_mut().zip(&upper[pivot]).skip(pivot) {
                *entry -= factor * above;
            }
            let part = factor * right[pivot];
            right[below] -= part;
        }
    }
    for row in (0..n).rev() {
        let known = (row + 1..n).fold(right[row], |rest, column| rest - rows[row][column] * right[column]);
        right[row] = known / rows[row][row];
    }
    Some(right)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found_by(partners: &[Partner<f64>], responses: &[Vec<f64>]) -> Result<Vec<[f64; 2]>, NotStruck> {
        impulses(partners, responses).map(|struck| struck.into_iter().map(|one| one.impulse).collect())
    }

    fn partner(closing: f64, sliding: f64, friction: Option<f64>, restitution: f64) -> Partner<f64> {
        Partner { closing, sliding, friction, restitution, holds: false }
    }

    /// A level rod of mass 1, half length 1 and moment of inertia 1/3 with both ends over the floor: the responses of its ends.
    fn level_rod() -> Vec<Vec<f64>> {
        vec![vec![4.0, 0.0, -2.0, 0.0], vec![0.0, 1.0, 0.0, 1.0], vec![-2.0, 0.0, 4.0, 0.0], vec![0.0, 1.0, 0.0, 1.0]]
    }

    #[test]
    fn a_level_rod_bounces_level() {
        let both = [partner(-1.0, 0.0, None, 0.5); 2];
        let found = found_by(&both, &level_rod()).unwrap();
        assert!(found.iter().all(|[normal, tangent]| (normal - 0.75).abs() < 1e-14 && *tangent == 0.0), "{found:?}");
    }

    #[test]
    fn an_end_that_rests_is_pressed_by_the_other_that_falls() {
        let found = found_by(&[partner(0.0, 0.0, None, 0.5), partner(-1.0, 0.0, None, 0.0)], &level_rod()).unwrap();
        // gap' = 0 for both ends after the impact
        assert!((found[0][0] - 1.0 / 6.0).abs() < 1e-14 && (found[1][0] - 1.0 / 3.0).abs() < 1e-14, "{found:?}");
    }

    #[test]
    fn ends_with_friction_stop_together_and_share_the_impulse_in_any_way() {
        let both = [partner(-1.0, 0.1, Some(0.5), 0.0); 2];
        let found = found_by(&both, &level_rod()).unwrap();
        let whole: f64 = found.iter().map(|[_, tangent]| tangent).sum();
        assert!((whole + 0.1).abs() < 1e-14, "{found:?}");
        // outside the friction cone both ends continue to slide
        let both = [partner(-1.0, 1.0, Some(0.5), 0.0); 2];
        let found = found_by(&both, &level_rod()).unwrap();
        assert!(found.iter().all(|[normal, tangent]| (tangent + 0.5 * normal).abs() < 1e-14), "{found:?}");
    }

    #[test]
    fn a_contact_that_would_open_has_no_impulse() {
        // a rod with a large moment of inertia: an impulse at one end opens the other
        let short: Vec<Vec<f64>> = vec![
            vec![1.5, 0.0, 0.5, 0.0],
            vec![0.0, 1.0, 0.0, 1.0],
            vec![0.5, 0.0, 1.5, 0.0],
            vec![0.0, 1.0, 0.0, 1.0],
        ];
        let found = found_by(&[partner(0.0, 0.0, None, 0.0), partner(-1.0, 0.0, None, 0.0)], &short).unwrap();
        assert!(found[0][0] == 0.0 && (found[1][0] - 1.0 / 1.5).abs() < 1e-14, "{found:?}");
    }

    #[test]
    fn one_contact_has_newtons_law() {
        let responses = vec![vec![2.0, -1.0], vec![-1.0, 2.0]];
        let found = found_by(&[partner(-1.0, 0.4, Some(0.3), 0.5)], &responses).unwrap();
        let impact = super::super::impact_law::Impact {
            law: model::Restitution::Newton,
            closing: -1.0,
            sliding: 0.4,
            responses: [[2.0, -1.0], [-1.0, 2.0]],
            friction: Some(0.3),
            restitution: 0.5,
        };
        let known = impact.impulses().unwrap();
        assert!((0..2).all(|k| (found[0][k] - known[k]).abs() < 1e-14), "{found:?} {known:?}");
    }
}
