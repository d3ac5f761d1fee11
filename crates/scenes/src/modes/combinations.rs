//! Combinations of phases of contacts in which a motion may continue.
//!
//! The reactions of a combination are unique only if the conditions gap'' = 0 of each pressing contact and v' = 0 of each sticking contact
//! are independent. In the plane at most two feet of a block press at once. Combinations are built contact by contact; a combination with
//! dependent gaps is left out with all its extensions. The tangents are added next. Contacts at rest in space or on a wall may have more
//! reactions than the motion determines. Then one of them leans: its friction acts only along the directions that the others leave free. A
//! contact that does not press, and whose gap depends on the gaps of pressing contacts, is carried.

use super::contacts::{PARTS, unknown_parts};
use super::decision::Open;
use super::expansion::{Expansions, Instant, Kind};
use super::mode::Phase;
use super::touch::Touch;
use nalgebra::DMatrix;

/// A condition is independent of others where it keeps at least this part of its own response.
const RANK: f64 = 1e-11;

/// The largest number of combinations that are built.
const MOST: usize = 20_000;

/// All combinations of phases with independent conditions; `None` where they are too many.
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

/// Whether the conditions of a contact may depend on those of others. A guide that the coordinates satisfy has a balance of its own, and
/// currents without inertia are decided by the whole mode.
fn counts(kind: Kind) -> bool {
    !kind.is_guide && !kind.is_direct
}

/// Phases with independent tangents, in addition to the independent normals; none if this is not possible.
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

/// The phases of a contact in space that would stick, if others hold it along one or both tangents.
pub(super) fn leaning(phase: Phase, is_in_space: bool) -> Vec<Phase> {
    match phase {
        Phase::Sticks(face) if is_in_space => {
            [[true, false], [false, true], [false, false]].map(|held| Phase::Leans { face, held }).to_vec()
        }
        _ => Vec::new(),
    }
}

/// Independent conditions, as directions in the space of motions: rows of Cholesky's factor of their responses.
#[derive(Clone, Debug, Default)]
struct Kept {
    places: Vec<usize>,
    rows: Vec<Vec<f64>>,
}

impl Kept {
    /// With the conditions of a contact added; none if they depend on these.
    fn with(&self, responses: &DMatrix<f64>, contact: usize, parts: &[usize]) -> Option<Self> {
        let mut kept = self.clone();
        parts.iter().all(|part| kept.add(responses, PARTS * contact + part)).then_some(kept)
    }

    /// Adds a condition; whether it is independent of the others.
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
