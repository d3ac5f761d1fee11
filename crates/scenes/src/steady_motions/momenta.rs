//! Momenta of cyclic coordinates and the mass matrix at steady motions, symbolically.

use super::rows::without_idle;
use crate::letters::Letters;
use model::Trace;
use symbolic::{Sym, substitute_all};

/// The derivatives of the momenta of cyclic coordinates, with all other speeds zero: by `letters`, then by the cyclic speeds; and the mass matrix, row by
/// row.
pub(super) fn momenta(
    trace: &Trace<'_>,
    is_cyclic: &[bool],
    (letters, known): (&[Sym], &[(Sym, Sym)]),
) -> [Vec<Sym>; 2] {
    let chosen = |cyclic: bool| -> Vec<Sym> {
        trace.speeds.iter().zip(is_cyclic).filter(|(_, own)| **own == cyclic).map(|(speed, _)| *speed).collect()
    };
    let (speeds, others) = (chosen(true), chosen(false));
    let state = [&trace.coordinates[..], &trace.speeds].concat();
    let energy = Letters::with_decimals(trace.time, &state).put_into(trace, &[trace.kinetic_energy()])[0];
    let by = |energy: Sym, of: &[Sym], all: &[Sym]| -> Vec<Sym> {
        of.iter().flat_map(|&speed| all.iter().map(move |&by| energy.diff(speed).diff(by))).collect()
    };
    let rests: Vec<(Sym, Sym)> = others.iter().map(|speed| (*speed, Sym::ZERO)).collect();
    let moving = energy.substitute(&rests);
    let of_cyclic = [by(moving, &speeds, letters), by(moving, &speeds, &speeds)].concat();
    let all = [of_cyclic, by(energy, &trace.speeds, &trace.speeds)];
    let cyclic = trace.coordinates.iter().zip(is_cyclic).filter(|(_, own)| **own).map(|(symbol, _)| *symbol);
    let idle: Vec<Sym> = cyclic.chain([trace.time]).collect();
    all.map(|all| substitute_all(&all, known).into_iter().map(|own| without_idle(own, &idle)).collect())
}
