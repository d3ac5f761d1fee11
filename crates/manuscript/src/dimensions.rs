//! Physical dimensions of a printed formula: within each side, also in parts that cancel, and between both sides of each relation.

use crate::claim_text::Kind;
use crate::finding::Finding;
use crate::letters::Letters;
use claims::Verdict;
use latex::{Statement, Value, value};
use symbolic::{Mismatch, Sym, dimension};

/// Adds mixed dimensions to a finding: to the reasons of a refutation, and to the objections unless the file expects the refutation. Claims about printed
/// numbers are left out, since their numbers are in SI units.
pub(crate) fn object_to_dimensions(
    kind: Kind,
    statement: &Statement,
    letters: &Letters<'_, '_>,
    finding: &mut Finding,
) {
    if kind == Kind::Number {
        return;
    }
    let Some(mismatch) = mismatch(statement, letters).map(|mismatch| mismatch.to_string()) else { return };
    let is_refuted = finding.judged.verdict == Verdict::Refuted;
    if is_refuted {
        finding.judged.evidence += &format!("; {mismatch}");
    }
    if !is_refuted || finding.expected != Some(Verdict::Refuted) {
        finding.judged.objections.push(mismatch);
    }
}

/// The first mismatch of dimensions within a side or between adjacent sides.
fn mismatch(statement: &Statement, letters: &Letters<'_, '_>) -> Option<Mismatch> {
    let of = |name: &str| letters.dimension(name);
    // the name of a derivative has no dimension, which is not a mismatch
    let mixed = |own: Sym| dimension(own, &of).err().filter(|mismatch| !matches!(mismatch, Mismatch::Unknown(_)));
    let entries = |side| value(side, &letters.in_paper()).map(|own: Value| own.entries()).unwrap_or_default();
    statement.chains.iter().find_map(|chain| {
        let sides: Vec<Vec<Sym>> = chain.sides.iter().map(entries).collect();
        let differences = sides
            .windows(2)
            .flat_map(|pair| pair[0].iter().zip(&pair[1]).map(|(left, right)| *left - *right).collect::<Vec<Sym>>());
        sides.iter().flatten().copied().find_map(mixed).or_else(|| differences.into_iter().find_map(mixed))
    })
}
