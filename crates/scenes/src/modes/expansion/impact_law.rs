//! The impulses of an impact at one contact, by the laws of Newton or Poisson with Coulomb friction.
//!
//! The impulses N along the normal and T along the tangent change the rate of the gap by a N + b T and the sliding velocity v by c N + d
//! T. Coulomb's law holds for the impulses: |T| <= mu N for sticking, T = -mu N sign(v) for sliding.
//!
//! * Newton: the rate of the gap after the impact is -e gap'. Coulomb's law holds for the total impulses, with the v after the impact.
//! * Poisson: N in the restitution phase is e times the N of the compression phase, which ends at gap' = 0. Coulomb's law holds at every
//!   instant of the impact, so that sliding may stop or reverse during the impact (Routh 1860).
//!
//! Both laws may increase the energy with friction (Kane 1984, Stronge 1990); such an impact is refused.

use integrators::Real;
use model::Restitution;

/// A change of energy below this part of the work of the impulses is a rounding error.
const ROUNDING: f64 = 1e-12;

/// A determinant a d - b c below this part of a d counts as zero: the point can move along one line only.
const SINGULAR: f64 = 1e-12;

/// The largest number of phases of a Poisson impact: sliding, sticking or reversed sliding, in compression and in restitution.
const MOST_PIECES: usize = 8;

/// The reason for which an impact is not determined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in super::super) enum NotStruck {
    /// Other closed contacts take part in the impact.
    Together,
    /// No impulse satisfies the law, or several do.
    Undetermined,
    /// The energy would increase.
    AddsEnergy,
    /// The coefficient of restitution is not between 0 and 1.
    Restitution,
    /// The coefficient of friction is negative.
    Friction,
    /// Friction would change the direction of sliding in space.
    Turns,
}

/// An impact at one contact in the plane.
#[derive(Clone, Copy, Debug)]
pub(super) struct Impact<S> {
    pub law: Restitution,
    /// The rate gap' before the impact, m/s; it is negative.
    pub closing: S,
    /// The sliding velocity v before the impact, m/s.
    pub sliding: S,
    /// The rows (a, b) and (c, d): the changes of gap' and of v by unit impulses N and T, 1/kg.
    pub responses: [[S; 2]; 2],
    /// The coefficient of friction mu; `None` for a smooth contact.
    pub friction: Option<S>,
    /// The coefficient of restitution e.
    pub restitution: S,
}

impl<S: Real> Impact<S> {
    /// The impulses N and T, N s.
    ///
    /// # Errors
    /// [`NotStruck`] if the law does not determine the impulses, the energy would increase, or a coefficient is out of its range.
    pub fn impulses(&self) -> Result<[S; 2], NotStruck> {
        if !(0.0..=1.0).contains(&self.restitution.approx()) {
            return Err(NotStruck::Restitution);
        }
        if self.friction.is_some_and(|friction| friction.approx().is_nan() || friction < S::zero()) {
            return Err(NotStruck::Friction);
        }
        // a point that can move only along the normal: friction changes nothing
        let [[by_normal, _], [_, by_tangent]] = self.responses.map(|parts| parts.map(|part| part.approx().abs()));
        if by_tangent <= SINGULAR * by_normal && self.friction.is_some() {
            return Impact { friction: None, ..*self }.impulses();
        }
        let impulses = match self.law {
            Restitution::Newton | Restitution::Moreau => self.by_newton(),
            Restitution::Poisson => self.by_poisson(),
        }?;
        if self.adds_energy(impulses) { Err(NotStruck::AddsEnergy) } else { Ok(impulses) }
    }

    /// The rates gap' and v after impulses N and T.
    fn after(&self, [normal, tangent]: [S; 2]) -> [S; 2] {
        let [of_gap, of_slide] =
            self.responses.map(|[by_normal, by_tangent]| by_normal * normal + by_tangent * tangent);
        [self.closing + of_gap, self.sliding + of_slide]
    }

    /// True if the work N (gap' + gap'_after)/2 + T (v + v_after)/2 of the impulses is positive beyond rounding.
    fn adds_energy(&self, impulses: [S; 2]) -> bool {
        let after = self.after(impulses);
        let before = [self.closing, self.sliding];
        let works = [0, 1].map(|k| [impulses[k] * before[k], impulses[k] * after[k]].map(S::approx));
        let size: f64 = works.iter().flatten().map(|work| work.abs()).sum();
        works.iter().flatten().sum::<f64>() > ROUNDING * size
    }

    /// The impulses by Newton's law of restitution.
    fn by_newton(&self) -> Result<[S; 2], NotStruck> {
        let [[a, b], [c, d]] = self.responses;
        let (zero, one) = (S::zero(), S::one());
        let needed = -(one + self.restitution) * self.closing;
        let is_impulse = |normal: S| normal > zero && normal.finite();
        let Some(friction) = self.friction else {
            let normal = needed / a;
            return if is_impulse(normal) { Ok([normal, zero]) } else { Err(NotStruck::Undetermined) };
        };
        let determinant = a * d - b * c;
        let sticks = if determinant.approx().abs() > SINGULAR * (a * d).approx().abs() {
            Some([(needed * d + b * self.sliding) / determinant, (-a * self.sliding - c * needed) / determinant])
        } else {
            // for dependent responses N alone brings both gap' and v to zero
            self.restitution.is_zero().then_some([needed / a, zero])
        };
        let holds = sticks.filter(|&[normal, tangent]| is_impulse(normal) && tangent.magnitude() <= friction * normal);
        let slides = [one, -one].map(|way| {
            let normal = needed / (a - way * friction * b);
            let impulses = [normal, -way * friction * normal];
            (is_impulse(normal) && way * self.after(impulses)[1] > zero).then_some(impulses)
        });
        let mut found = holds.into_iter().chain(slides.into_iter().flatten());
        match (found.next(), found.next()) {
            (Some(impulses), None) => Ok(impulses),
            _ => Err(NotStruck::Undetermined),
        }
    }

    /// The impulses by Poisson's law, phase by phase: within a phase N grows, T changes in proportion to N, and v keeps its sign.
    fn by_poisson(&self) -> Result<[S; 2], NotStruck> {
        let zero = S::zero();
        let (mut impulses, mut end) = ([zero; 2], None);
        for _ in 0..MOST_PIECES {
            let [gap_rate, slide] = self.after(impulses);
            let is_at_rest =
                slide.approx().abs() <= ROUNDING * (self.sliding.approx().abs() + self.closing.approx().abs());
            let slide = if is_at_rest { zero } else { slide };
            let slope = self.slope(slide);
            let [gap_slope, slide_slope] = self.responses.map(|[by_normal, by_tangent]| by_normal + by_tangent * slope);
            // the growth of N until sliding stops, and until compression or restitution ends
            let stops = (slide * slide_slope < zero).then(|| -slide / slide_slope);
            let ends = match end {
                Some(end) => Some(end - impulses[0]),
                None => (gap_slope > zero).then(|| -gap_rate / gap_slope),
            };
            let is_stop = match (stops, ends) {
                (Some(stops), Some(ends)) => stops < ends,
                (stops, _) => stops.is_some(),
            };
            let Some(grows) = (if is_stop { stops } else { ends }) else { return Err(NotStruck::Undetermined) };
            impulses = [impulses[0] + grows, impulses[1] + slope * grows];
            if is_stop {
                // exactly at rest, without rounding error
                impulses[1] = self.holding(impulses[0]);
            } else if end.is_some() {
                return Ok(impulses);
            } else {
                end = Some((S::one() + self.restitution) * impulses[0]);
            }
        }
        Err(NotStruck::Undetermined)
    }

    /// The T for which v is zero at a given N.
    fn holding(&self, normal: S) -> S {
        let [_, [c, d]] = self.responses;
        -(self.sliding + c * normal) / d
    }

    /// The derivative dT/dN at a sliding velocity.
    fn slope(&self, slide: S) -> S {
        let zero = S::zero();
        let friction = self.friction.unwrap_or(zero);
        let against = |way: S| if way < zero { friction } else { -friction };
        let [_, [c, d]] = self.responses;
        if !slide.is_zero() {
            return against(slide);
        }
        if d.is_zero() {
            return zero;
        }
        let holds = -c / d;
        // otherwise the contact slides in the direction in which N alone accelerates it
        if holds.magnitude() <= friction { holds } else { against(c) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A rod of mass 1 and half length 1 at an angle (rad) to the floor: responses 1 + 3 cos^2, 1 + 3 sin^2, -3 sin cos.
    fn rod(angle: f64, closing: f64, sliding: f64, friction: f64, law: Restitution, restitution: f64) -> Impact<f64> {
        let (s, c) = angle.sin_cos();
        let responses = [[1.0 + 3.0 * c * c, -3.0 * s * c], [-3.0 * s * c, 1.0 + 3.0 * s * s]];
        Impact { law, closing, sliding, responses, friction: Some(friction), restitution }
    }

    fn close(found: [f64; 2], known: [f64; 2]) {
        (0..2).for_each(|k| assert!((found[k] - known[k]).abs() < 1e-13, "{found:?} and {known:?}"));
    }

    #[test]
    fn both_laws_agree_where_friction_does_not_couple_the_directions() {
        let ball = |law| Impact {
            law,
            closing: -2.0,
            sliding: 1.0,
            responses: [[1.0, 0.0], [0.0, 3.5]],
            friction: Some(0.1),
            restitution: 0.6,
        };
        let [newton, poisson] = [Restitution::Newton, Restitution::Poisson].map(|law| ball(law).impulses().unwrap());
        close(newton, [3.2, -1.0 / 3.5]);
        close(poisson, newton);
    }

    #[test]
    fn sliding_that_stops_in_compression_sticks_in_restitution() {
        let impact = rod(0.3, -1.0, 0.1, 2.0, Restitution::Poisson, 0.5);
        let impulses = impact.impulses().unwrap();
        let [gap_rate, slide] = impact.after(impulses);
        assert!(slide.abs() < 1e-15 && gap_rate > 0.0);
        // the compression ends where both velocities are zero
        let [[a, b], [c, d]] = impact.responses;
        let all = (d + b * 0.1) / (a * d - b * c);
        assert!((impulses[0] - 1.5 * all).abs() < 1e-13);
    }

    #[test]
    fn sliding_turns_round_where_friction_does_not_hold() {
        let impact = rod(0.8, -1.0, 0.05, 0.2, Restitution::Poisson, 0.0);
        let impulses = impact.impulses().unwrap();
        let [gap_rate, slide] = impact.after(impulses);
        assert!(gap_rate.abs() < 1e-15);
        // sliding is forwards at first and backwards at the end
        assert!(slide < 0.0);
        assert!(impulses[1].abs() < 0.2 * impulses[0]);
    }

    /// Kane's paradox (1984), here for a rod: an impact with friction increases the energy by Newton's law.
    #[test]
    fn an_impact_that_adds_energy_is_refused() {
        let of = |law| rod(1.0, -1.0, 0.5, 0.8, law, 1.0);
        assert_eq!(of(Restitution::Newton).impulses(), Err(NotStruck::AddsEnergy));
        assert!(of(Restitution::Poisson).impulses().is_ok());
    }

    #[test]
    fn coefficients_out_of_bounds_are_refused() {
        let of = |friction, restitution| rod(0.3, -1.0, 0.1, friction, Restitution::Newton, restitution).impulses();
        assert_eq!(of(0.1, 1.5), Err(NotStruck::Restitution));
        assert_eq!(of(0.1, f64::NAN), Err(NotStruck::Restitution));
        assert_eq!(of(-0.1, 0.5), Err(NotStruck::Friction));
    }

    #[test]
    fn a_point_that_moves_along_its_normal_alone_bounces_as_a_smooth_one() {
        for (law, restitution) in [(Restitution::Newton, 0.7), (Restitution::Poisson, 0.7), (Restitution::Newton, 0.0)]
        {
            let responses = [[0.5, 0.0], [0.0, 0.0]];
            let impact = Impact { law, closing: -2.0, sliding: 0.0, responses, friction: Some(0.3), restitution };
            close(impact.impulses().unwrap(), [4.0 * (1.0 + restitution), 0.0]);
        }
    }

    #[test]
    fn a_point_that_moves_along_one_line_is_stopped_by_the_normal_impulse() {
        let impact = |restitution| Impact {
            law: Restitution::Newton,
            closing: -1.0,
            sliding: 2.0,
            responses: [[1.0, -2.0], [-2.0, 4.0]],
            friction: Some(0.1),
            restitution,
        };
        close(impact(0.0).impulses().unwrap(), [1.0, 0.0]);
        // N = 1.5/0.8 and T = 0.1 N, since the contact slides backwards after the impact
        let [gap_rate, slide] = impact(0.5).after(impact(0.5).impulses().unwrap());
        assert!((gap_rate - 0.5).abs() < 1e-13 && (slide + 1.0).abs() < 1e-13);
    }
}
