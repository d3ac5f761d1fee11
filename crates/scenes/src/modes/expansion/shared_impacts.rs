//! The state after an impact in which several contacts take part.

use super::super::jet::Jet;
use super::super::mode::{Case, Mode, Phase};
use super::impact_law::NotStruck;
use super::letters::Quantity;
use super::simultaneous_impacts::{Partner, Struck, impulses};
use super::{Expansions, Instant, Kind};
use field::DoubleDouble;
use integrators::Real;
use model::{Restitution, Sides};
use num_traits::One;

/// Contacts whose closing times differ by less than this part of the time close simultaneously.
const AT_ONCE: f64 = 1e-9;

/// The state after an impact of several contacts.
pub(in super::super) struct AfterImpact {
    /// Coordinates, then speeds, after the impact.
    pub state: Vec<f64>,
    /// Indices of the contacts that the impact opens.
    pub opened: Vec<usize>,
    /// Indices of the contacts that remain closed (gap' is zero up to rounding), and of the contacts that do not slide.
    pub stay: Vec<usize>,
    pub stick: Vec<usize>,
}

/// The number of components of an impulse in a plane.
const IN_PLANE: usize = 2;

impl Expansions {
    /// True if the impact law of a contact includes impulses at other contacts.
    pub fn shares_impacts(&self, contact: usize) -> bool {
        self.kinds[contact].law == Restitution::Moreau
    }

    /// The state after an impact of the contacts `closing`, with the closed contacts `in_touch`.
    ///
    /// # Errors
    /// The impulses are not determined, or a contact has another impact law.
    pub fn struck_together(
        &self,
        instant: &Instant<'_>,
        (closing, in_touch): (&[usize], &[usize]),
        cases: &[Case],
    ) -> Result<AfterImpact, NotStruck> {
        let all = self.letters_in::<Jet<1>>(cases);
        let parts: Vec<Jet<1>> = instant.state.iter().map(|part| Jet::constant(*part, 0.0)).collect();
        let values = self.values(Jet::constant(instant.time, 0.0), &parts, &all, &[]);
        let values: Vec<f64> = values.iter().map(|value| value.terms[0]).collect();
        let contacts = [closing, in_touch].concat();
        let found = self.shared_impulses(&values, &contacts)?;
        let mut after = instant.state.to_vec();
        for (&contact, Struck { impulse, .. }) in contacts.iter().zip(&found) {
            let letters: [usize; IN_PLANE] = std::array::from_fn(|part| self.reaction([contact, part]));
            for (part, added) in
                impulse.iter().zip(self.responses(Jet::constant(instant.time, 0.0), &parts, &all, &letters))
            {
                after.iter_mut().zip(added).for_each(|(state, rate)| *state += part * rate);
            }
        }
        let (others, touched) = (self.contacts(&Instant { state: &after, ..*instant }, cases), closing.len());
        let opens = |(place, &contact): (usize, &usize)| {
            let is_free = found[touched + place].impulse[0] == 0.0 && self.kinds[contact].sides == Sides::One;
            (is_free && others.get(contact).is_some_and(|now| now.gap_rate.sign_of(0, OPENS) > 0.0)).then_some(contact)
        };
        let opened = in_touch.iter().enumerate().filter_map(opens).collect();
        let of = |is: fn(&Struck<f64>) -> bool| -> Vec<usize> {
            contacts.iter().zip(&found).filter(|(_, struck)| is(struck)).map(|(contact, _)| *contact).collect()
        };
        Ok(AfterImpact { stay: of(|struck| struck.stays), stick: of(|struck| struck.sticks), opened, state: after })
    }

    /// The state after an impact of several contacts in double-double arithmetic; `None` if the law does not determine it.
    pub fn struck_together_exactly(
        &self,
        time: DoubleDouble,
        state: &[DoubleDouble],
        (contacts, cases): (&[usize], &[Case]),
    ) -> Option<Vec<DoubleDouble>> {
        let all = self.letters_in::<DoubleDouble>(cases);
        let values = self.exact_values(time, state, &all);
        let mut after = state.to_vec();
        for (&contact, struck) in contacts.iter().zip(self.shared_impulses(&values, contacts).ok()?) {
            for (part, size) in struck.impulse.into_iter().enumerate() {
                let mut one = all.clone();
                one[self.reaction([contact, part])] = DoubleDouble::one();
                let moved = self.exact_values(time, state, &one);
                after
                    .iter_mut()
                    .zip(moved.iter().zip(&values))
                    .for_each(|(own, (moved, value))| *own += size * (*moved - *value));
            }
        }
        Some(after)
    }

    /// The contacts of an impact: first `contact` and those that close simultaneously, then the closed contacts.
    pub fn partners(&self, instant: &Instant<'_>, mode: &Mode, contact: usize, slack: f64) -> [Vec<usize>; 2] {
        let falling = self.contacts(instant, &mode.cases);
        let closes = |other: &usize| {
            let Some(at) = falling.get(*other) else { return false };
            let [gap, rate] = [at.gap, at.gap_rate].map(|of| of.terms[0]);
            let is_due = at.gap.sign_of(0, slack) == 0.0 || gap.abs() <= -rate * AT_ONCE * instant.time.abs();
            mode.phases[*other] == Phase::Apart
                && !self.kinds[*other].is_one_way
                && at.gap_rate.sign_of(0, slack) < 0.0
                && is_due
        };
        let others = (0..mode.phases.len()).filter(|other| *other != contact);
        let closing = [contact].into_iter().chain(others.clone().filter(closes)).collect();
        [closing, others.filter(|other| mode.phases[*other] != Phase::Apart).collect()]
    }

    fn shared_impulses<S: Real>(&self, values: &[S], contacts: &[usize]) -> Result<Vec<Struck<S>>, NotStruck> {
        let takes_part = |contact: &usize| {
            let Kind { law, is_guide, is_one_way, is_in_space, is_rough, .. } = self.kinds[*contact];
            // a guide without friction needs no impulse, since the coordinates satisfy it
            let is_other = is_one_way || is_rough && (is_in_space || is_guide);
            !is_other && (is_guide || law == Restitution::Moreau)
        };
        if !contacts.iter().all(takes_part) {
            return Err(NotStruck::Together);
        }
        let with_impulse: Vec<usize> =
            contacts.iter().copied().filter(|&contact| !self.kinds[contact].is_guide).collect();
        let letters: Vec<usize> = with_impulse
            .iter()
            .flat_map(|&contact| (0..IN_PLANE).map(move |part| self.reaction([contact, part])))
            .collect();
        let responses = self.slopes_by(values, &vec![None; self.kinds.len()], &letters, &letters);
        let partner = |&contact: &usize| {
            let of = |quantity: Quantity| self.of_contact(values, quantity, contact);
            Partner {
                closing: of(Quantity::GapRate),
                sliding: of(Quantity::Slide),
                friction: self.kinds[contact].is_rough.then(|| of(Quantity::Friction)),
                restitution: of(Quantity::Restitution),
                holds: self.kinds[contact].sides == Sides::Both,
            }
        };
        let partners: Vec<Partner<S>> = with_impulse.iter().map(partner).collect();
        let mut found = impulses(&partners, &responses)?.into_iter();
        let none = Struck { impulse: [S::zero(); IN_PLANE], stays: false, sticks: false };
        let of = |&contact: &usize| if self.kinds[contact].is_guide { none } else { found.next().unwrap_or(none) };
        Ok(contacts.iter().map(of).collect())
    }
}

/// The rate of a gap counts as positive if it exceeds its error bound by this factor.
const OPENS: f64 = 16.0;
