//! The choice of the mode after an event: all combinations of cases of the conditions at zero, and of phases of contacts, are tried, and
//! the consistent one is taken.
//!
//! Just after an instant with g = 0 the condition g is on if the first nonzero derivative among g', g'', ... is positive, and off if it
//! is negative. It is held at zero if the switch value s for which g remains zero lies between 0 and 1; for s at a bound the first
//! nonzero derivative of s decides. The sign of a value counts only if the value exceeds its error bound; if two cases differ only by
//! rounding, the next derivative decides.

use super::combinations::combinations;
use super::consistency::{Standing, is_possible, of_contacts, standing};
use super::continuum::is_continuum;
use super::expansion::{Expansion, Expansions, Instant};
use super::headings::headings;
use super::mode::{Case, Face, Heading, Mode, Phase};
use super::pivots::{NotFound, pivoted};
use super::rests::rests_beside;
use super::shares::shares;
use super::touch::{Touch, at_rest};

/// The largest number of conditions at zero whose combinations are all tried; for more conditions one consistent combination is searched for.
pub(super) const MOST_OPEN: usize = 6;

/// The largest number of combinations of cases and phases that are tried.
pub(super) const MOST_TRIED: usize = 20_000;

/// The number of Taylor terms by which combinations are excluded, and the number by which the remaining combinations are decided.
pub(super) const FEW: usize = 2;
pub(super) const TERMS: usize = 6;

/// Multiples of the error bound that a term must exceed to count. The next multiple is used if the last one gives no case, or several: a
/// force may exceed friction by so little, or for so short a time, that the speed remains within its rounding error.
pub(super) const SLACKS: [f64; 7] = [16.0, 256.0, 4096.0, 65_536.0, 1_048_576.0, 16_777_216.0, 268_435_456.0];

/// The result of a decision.
#[derive(Debug)]
pub(super) enum Decided {
    One {
        mode: Mode,
        expansion: Box<Expansion<TERMS>>,
        slack: f64,
    },
    /// No combination is consistent; `not_held` is true if a condition cannot be held at zero.
    None {
        not_held: bool,
    },
    /// Several consistent combinations with different motions.
    Several,
    /// A continuum of motions.
    Continuum,
    /// There are more combinations than [`MOST_TRIED`].
    TooMany,
    /// No combination that was tried is consistent. Several contacts in space are closed, at least one of them at rest; not all their
    /// combinations are tried.
    RestTogether,
}

/// The conditions and contacts that must be decided at an instant.
#[derive(Clone, Copy, Debug)]
pub(super) struct Open<'a> {
    /// Indices of the conditions at zero.
    pub switches: &'a [usize],
    /// The state of each contact.
    pub touches: &'a [Touch],
    /// The value of every condition of the model where its expression is zero; `None` where that is not defined.
    pub at_zero: &'a [Option<bool>],
}

impl Open<'_> {
    /// The contacts in space, as pairs of index and state.
    fn in_space(&self, expansions: &Expansions) -> impl Iterator<Item = (usize, Touch)> {
        let kinds = self.touches.iter().zip(&expansions.kinds).enumerate();
        kinds.filter_map(|(contact, (touch, kind))| kind.is_in_space.then_some((contact, *touch)))
    }

    /// True if several contacts in space are closed and one of them is at rest.
    fn rest_together(&self, expansions: &Expansions) -> bool {
        let in_touch = self.in_space(expansions).filter(|(_, touch)| *touch != Touch::Open).count();
        in_touch > 1 && self.in_space(expansions).any(|(_, touch)| touch == Touch::Rest)
    }

    /// True if fewer than two contacts are closed.
    pub(super) fn is_alone(&self) -> bool {
        self.touches.iter().filter(|touch| **touch != Touch::Open).count() < 2
    }
}

/// Decides the cases of the open conditions and the phases of contacts. Other conditions keep the case that they have in `mode`.
pub(super) fn decided(expansions: &Expansions, instant: &Instant<'_>, mode: &Mode, open: Open<'_>) -> Decided {
    let alone = without_shares(mode, open);
    let Some(phases) = combinations(expansions, instant, open) else { return Decided::TooMany };
    let found = if open.switches.len() > MOST_OPEN {
        many(expansions, instant, (&alone, &phases), open)
    } else if phases.len() * 3_usize.pow(open.switches.len() as u32) > MOST_TRIED {
        Decided::TooMany
    } else {
        tried(expansions, instant, (&alone, &phases), open)
    };
    match found {
        Decided::One { mode, expansion, slack } => {
            match shares(expansions, instant, (&mode, &expansion), open.switches, slack) {
                Some((mode, expansion)) => Decided::One { mode, expansion: Box::new(expansion), slack },
                None => Decided::One { mode, expansion, slack },
            }
        }
        none => none,
    }
}

/// The mode with every open condition on, off or held.
fn without_shares(mode: &Mode, open: Open<'_>) -> Mode {
    let mut alone = mode.clone();
    for &switch in open.switches {
        alone.cases[switch] = match mode.cases[switch] {
            Case::Shared => Case::Off,
            Case::Spent { on: true } => Case::On,
            Case::Spent { on: false } => Case::Off,
            case => case,
        };
    }
    alone
}

/// Decides many open conditions by a pivoting method instead of trying all combinations.
fn many(
    expansions: &Expansions,
    instant: &Instant<'_>,
    (mode, phases): (&Mode, &[Vec<Phase>]),
    open: Open<'_>,
) -> Decided {
    let mut not_held = false;
    for slack in SLACKS {
        let modes = phases.iter().map(|phases| Mode { phases: phases.clone(), ..mode.clone() });
        for mode in modes.flat_map(|mode| directed(expansions, instant, mode, open)) {
            match pivoted(expansions, instant, &mode, open.switches, slack) {
                Ok((mode, expansion)) if of_contacts(&expansion, &mode, open, slack).is_some() => {
                    return Decided::One { mode, expansion: Box::new(expansion), slack };
                }
                Ok(_) => {}
                Err(NotFound { is_held }) => not_held |= !is_held,
            }
        }
    }
    Decided::None { not_held }
}

/// Decides cases and phases by trying all combinations.
fn tried(
    expansions: &Expansions,
    instant: &Instant<'_>,
    (mode, phases): (&Mode, &[Vec<Phase>]),
    open: Open<'_>,
) -> Decided {
    let Candidates { mut all, not_held, rest_together, is_continuum } =
        Candidates::of(expansions, instant, (mode, phases), open);
    if is_continuum {
        return Decided::Continuum;
    }
    let mut several = false;
    for slack in SLACKS {
        let Some((best, agreeing)) = best(&all, open, slack) else { continue };
        let differs = |place: &usize| differ(&all[agreeing[0]].1, &all[*place].1, slack);
        let rests = rests_beside(&all, (best, agreeing[0]), open, slack);
        several =
            matches!(best, Standing::Moves | Standing::Carries) && agreeing.iter().skip(1).chain(&rests).any(differs);
        if !several {
            let (mut mode, expansion) = all.swap_remove(agreeing[0]);
            mode.rest(&expansion, open, slack);
            return Decided::One { mode, expansion: Box::new(expansion), slack };
        }
    }
    match (several, rest_together) {
        (true, _) => Decided::Several,
        (false, true) => Decided::RestTogether,
        (false, false) => Decided::None { not_held },
    }
}

/// The combinations that the first terms do not exclude.
pub(super) struct Candidates {
    pub all: Vec<(Mode, Expansion<TERMS>)>,
    /// Whether a combination cannot be held.
    not_held: bool,
    /// True if combinations were left out, in which several contacts in space are at rest or begin to slide.
    rest_together: bool,
    /// True if a combination with undetermined reactions has a continuum of motions.
    is_continuum: bool,
}

impl Candidates {
    pub fn of(
        expansions: &Expansions,
        instant: &Instant<'_>,
        (mode, phases): (&Mode, &[Vec<Phase>]),
        open: Open<'_>,
    ) -> Self {
        // order of the trials: the case after the event comes first
        let cases = |switch: usize| match mode.cases[switch] {
            Case::On => [Case::On, Case::Off, Case::Held],
            Case::Off => [Case::Off, Case::On, Case::Held],
            _ => [Case::Held, Case::On, Case::Off],
        };
        let rest_together = open.rest_together(expansions);
        let mut candidates = Candidates { all: Vec::new(), not_held: false, rest_together, is_continuum: false };
        let widest = SLACKS[SLACKS.len() - 1];
        for combination in 0..phases.len() * 3_usize.pow(open.switches.len() as u32) {
            let mut candidate = Mode { phases: phases[combination % phases.len()].clone(), ..mode.clone() };
            let mut rest = combination / phases.len();
            for &switch in open.switches {
                candidate.cases[switch] = cases(switch)[rest % 3];
                rest /= 3;
            }
            expansions.mirror(&mut candidate);
            for candidate in directed(expansions, instant, candidate, open) {
                let Some(sifted) = expansions.at::<FEW>(instant, &candidate) else {
                    // with algebraic speeds, some mode may not determine them although another mode is consistent
                    candidates.not_held |= !expansions.has_algebraic();
                    candidates.is_continuum |= is_continuum(expansions, instant, &candidate, open.touches);
                    continue;
                };
                if is_possible(&sifted, &candidate, open, widest)
                    && let Some(expansion) = expansions.at::<TERMS>(instant, &candidate)
                {
                    candidates.all.push((candidate, expansion));
                }
            }
        }
        candidates
    }
}

/// The mode with each possible direction in which its contacts at rest in space may begin to slide.
fn directed(expansions: &Expansions, instant: &Instant<'_>, mode: Mode, open: Open<'_>) -> Vec<Mode> {
    let begins = |(contact, touch): (usize, Touch)| {
        let phase = mode.phases[contact];
        (touch == Touch::Rest && phase.moves()).then_some((contact, phase.face()?))
    };
    let beginning: Vec<(usize, Face)> = open.in_space(expansions).filter_map(begins).collect();
    if beginning.is_empty() {
        return vec![mode];
    }
    let with = |headings: Vec<Heading>| {
        let mut mode = mode.clone();
        for (&(contact, face), heading) in beginning.iter().zip(headings) {
            mode.phases[contact] = Phase::Glides { face, begins: Some(heading) };
        }
        mode
    };
    headings(expansions, instant, &mode, &beginning).into_iter().map(with).collect()
}

/// The highest degree of agreement, and the candidates that reach it; none if all are contradictory.
pub(super) fn best(all: &[(Mode, Expansion<TERMS>)], open: Open<'_>, slack: f64) -> Option<(Standing, Vec<usize>)> {
    let standings: Vec<Option<Standing>> =
        all.iter().map(|(mode, expansion)| standing(expansion, mode, open, slack)).collect();
    let best = standings.iter().copied().max().flatten()?;
    Some((best, (0..all.len()).filter(|&place| standings[place] == Some(best)).collect()))
}

impl Mode {
    /// Sets the phase of contacts that should leave zero, but remain there, to rest.
    pub(super) fn rest(&mut self, expansion: &Expansion<TERMS>, open: Open<'_>, slack: f64) {
        for ((phase, contact), touch) in self.phases.iter_mut().zip(&expansion.contacts).zip(open.touches) {
            *phase = at_rest(contact, *phase, (*touch, open.is_alone()), slack);
        }
    }
}

/// True if two motions differ by more than rounding errors.
pub(super) fn differ<const N: usize>(a: &Expansion<N>, b: &Expansion<N>, slack: f64) -> bool {
    a.rates.iter().zip(&b.rates).any(|(a, b)| (*a - *b).sign(slack) != 0.0)
}
