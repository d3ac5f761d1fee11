//! Momenta of cyclic coordinates and mass matrix at steady motions.

use crate::letters::Letters;
use model::Trace;
use model::equations::vanishes;
use symbolic::{Sym, substitute_all};

/// Derivatives of the momenta of cyclic coordinates, all other speeds being zero: by letters, then by their speeds; and the mass matrix.
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
    let energy = Letters::with_data(trace.time, &state).put_into(trace, &[trace.kinetic_energy()])[0];
    let by = |energy: Sym, of: &[Sym], all: &[Sym]| -> Vec<Sym> {
        of.iter().flat_map(|&speed| all.iter().map(move |&by| energy.diff(speed).diff(by))).collect()
    };
    let rests: Vec<(Sym, Sym)> = others.iter().map(|speed| (*speed, Sym::ZERO)).collect();
    let moving = energy.substitute(&rests);
    let of_cyclic = [by(moving, &speeds, letters), by(moving, &speeds, &speeds)].concat();
    let all = [of_cyclic, by(energy, &trace.speeds, &trace.speeds)];
    all.map(|all| substitute_all(&all, known).into_iter().map(|own| at_any_time(trace.time, own)).collect())
}

/// An expression without the time, where its value does not depend on it, as of a frame that turns steadily about an axis of symmetry.
pub(super) fn at_any_time(time: Sym, own: Sym) -> Sym {
    match own.symbols_of().contains(&time) && vanishes(own.diff(time)) {
        true => own.substitute(&[(time, Sym::ZERO)]),
        false => own,
    }
}
