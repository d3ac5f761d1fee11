//! Enumeration of the combinations of phases of contacts in which a motion may continue.
//!
//! The reactions of a combination are unique only if the conditions gap'' = 0 of each pressing contact and v' = 0 of each sticking
//! contact are independent; for example, at most two feet of a block in the plane press at once. Combinations are built contact by
//! contact; one with dependent normal conditions is dropped with all its extensions. The tangential conditions are added next. Contacts
//! that stick in space or on a wall may have more reactions than the motion determines. One of them then leans: its friction is
//! determined only along the tangents that the other contacts leave free. A contact that does not press, and whose gap depends on the
//! gaps of pressing contacts, is carried.

use super::contacts::{PARTS, unknown_parts};
use super::decision::Open;
use super::expansion::{Expansions, Instant, Kind};
use super::mode::Phase;
use super::touch::Touch;
use nalgebra::DMatrix;

/// A condition is independent of others if at least this part of its squared response remains after projection.
const RANK: f64 = 1e-11;

/// The largest number of combinations that are built.
const MOST: usize = 20_000;

/// All combinations of phases with independent conditions, one phase for each contact; `None` if there are more than [`MOST`].
pub(super) fn combinations(expansions: &Expansions, instant: &Instant<'_>, open: Open<'_>) -> Option<Vec<Vec<Phase>>> {
    let responses = expansions.responses_of_contacts(instant);
    let mut all = vec![(Vec::new(), Kept::default())];
    for (contact, (touch, kind)) in open.touches.iter().zip(&expansions.kinds).enumerate() {
        let mut next = Vec::new();
        for (phases, kept) in &all {
            for phase in touch.phases(*kind) {
                let presses = phase.face().is_some() && counts(*kind);
                let kept = if presses { kept.with(&responses, contact, &[0]) } else { Some(kept.clone()) };
                next.extend(kept.map(|kept| ([&phases[..], &[phase]].concat(), kept)));
            }
            if next.len() > MOST {
                return None;
            }
        }
        all = next;
    }
    let along_tangents = |(phases, kept)| along_tangents(&responses, expansions, open, (phases, kept));
    Some(all.into_iter().filter_map(along_tangents).collect())
}

/// True if the conditions of a contact may depend on those of others. A guide that the coordinates satisfy has its own force balance, and
/// contacts of algebraic speeds are decided with the whole mode.
fn counts(kind: Kind) -> bool {
    !kind.is_guide && !kind.is_direct
}

/// The phases with independent tangential conditions added; `None` if this is not possible.
fn along_tangents(
    responses: &DMatrix<f64>,
    expansions: &Expansions,
    open: Open<'_>,
    (mut phases, mut kept): (Vec<Phase>, Kept),
) -> Option<Vec<Phase>> {
    let kinds = || expansions.kinds.iter().zip(open.touches).enumerate().filter(|(_, (kind, _))| counts(**kind));
    for (contact, (kind, _)) in kinds() {
        let mut ways = [phases[contact]].into_iter().chain(leaning(phases[contact], kind.is_in_space));
        let found = ways.find_map(|phase| {
            let tangents: Vec<usize> =
                unknown_parts(phase, kind.is_in_space).iter().copied().filter(|part| *part > 0).collect();
            Some((phase, kept.with(responses, contact, &tangents)?))
        });
        (phases[contact], kept) = found?;
    }
    for (contact, (_, touch)) in kinds() {
        if phases[contact] == Phase::Apart && *touch != Touch::Open && kept.with(responses, contact, &[0]).is_none() {
            phases[contact] = Phase::Carried;
        }
    }
    Some(phases)
}

/// The leaning phases of a contact that sticks in space: other contacts hold it along one tangent or both.
pub(super) fn leaning(phase: Phase, is_in_space: bool) -> Vec<Phase> {
    match phase {
        Phase::Sticks(face) if is_in_space => {
            [[true, false], [false, true], [false, false]].map(|held| Phase::Leans { face, held }).to_vec()
        }
        _ => Vec::new(),
    }
}

/// Independent conditions: rows of the Cholesky factor of their response matrix.
#[derive(Clone, Debug, Default)]
struct Kept {
    places: Vec<usize>,
    rows: Vec<Vec<f64>>,
}

impl Kept {
    /// The set with conditions of a contact added; `None` if they depend on the others.
    fn with(&self, responses: &DMatrix<f64>, contact: usize, parts: &[usize]) -> Option<Self> {
        let mut kept = self.clone();
        parts.iter().all(|part| kept.add(responses, PARTS * contact + part)).then_some(kept)
    }

    /// Adds a condition and returns true, or returns false if it depends on the others.
    fn add(&mut self, responses: &DMatrix<f64>, place: usize) -> bool {
        let mut row: Vec<f64> = Vec::with_capacity(self.rows.len() + 1);
        for (own, &other) in self.rows.iter().zip(&self.places) {
            let known: f64 = row.iter().zip(own).map(|(a, b)| a * b).sum();
            row.push((responses[(place, other)] - known) / own[own.len() - 1]);
        }
        let response = responses[(place, place)];
        let rest = response - row.iter().map(|part| part * part).sum::<f64>();
        if rest.is_nan() || rest <= RANK * response {
            return false;
        }
        row.push(rest.sqrt());
        self.rows.push(row);
        self.places.push(place);
        true
    }
}
