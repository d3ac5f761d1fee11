//! The equations of steady motions of a model: residuals of its equations of motion without accelerations, with all speeds zero but those of
//! cyclic coordinates, and its constraints,
//!
//!   J^T lambda - h(q, w) = 0 ,    f(q) = 0 .

use super::circles::is_periodic;
use super::determinacy::Wanted;
use super::energy_row::implied;
use super::rows::Rows;
use super::{Asked, NoSteadyMotions, Range};
use crate::changing_laws::changes;
use crate::compiled_system::has_values;
use crate::letters::Letters;
use model::equations::vanishes;
use model::{Model, Trace};
use symbolic::{Sym, Tape, substitute_all};

/// An unknown of the search: a coordinate, or the constant speed of a cyclic one.
#[derive(Clone, Debug, PartialEq)]
pub struct Unknown {
    /// As states call it: theta, or phi'.
    pub name: String,
    /// Its place in the state.
    pub place: usize,
    /// Whether it goes around a circle: its range is a whole turn.
    pub is_circle: bool,
    pub range: Range,
}

/// A system that is ready for the search.
#[derive(Debug)]
pub(super) struct SteadyEquations {
    pub unknowns: Vec<Unknown>,
    /// Numbers in the state that are no unknowns: what is fixed, and speeds of cyclic coordinates.
    pub given: Vec<(String, f64)>,
    /// Coordinates that occur nowhere.
    pub cyclic: Vec<String>,
    /// Their places.
    pub cyclic_places: Vec<usize>,
    /// Those of them whose momenta are kept.
    pub kept_momenta: Vec<(usize, String)>,
    /// The state with the numbers that are given.
    pub state: Vec<f64>,
    /// The number of reactions that the positions determine.
    pub reactions: usize,
    /// Whether the loads have a potential energy.
    pub have_potential: bool,
    /// Whether an equation has no unknowns, and is not met.
    pub is_unbalanced: bool,
    /// Coordinates that are unknowns.
    pub coordinates: usize,
    /// Residuals by unknowns, then multipliers.
    pub values: Tape,
    /// Their derivatives, row after row.
    pub slopes: Tape,
    /// J^T, row after row, then -h, by unknowns alone.
    pub loads: Tape,
    /// Derivatives of the momenta of cyclic coordinates by the unknowns, row after row, then by their speeds; none where these depend on
    /// anything else, and where constraints hold speeds.
    pub momenta: Option<Tape>,
    /// The mass matrix, row after row, by the unknowns; none where it depends on anything else.
    pub masses: Option<Tape>,
    /// Places in the state of speeds that constraints of speeds determine, and these by the unknowns.
    pub determined: (Vec<usize>, Tape),
}

impl SteadyEquations {
    pub fn of(model: &Model, asked: &Asked) -> Result<Self, NoSteadyMotions> {
        Self::checked(model)?;
        symbolic::apart(|| Self::written(model, asked, None, false))
    }

    /// For the motion of a state where that is one identically, but for reactions; else for motions near it, whose speeds of cyclic
    /// coordinates are kept where no equation asks for them.
    pub fn near(model: &Model, state: &[f64]) -> Result<Self, NoSteadyMotions> {
        Self::checked(model)?;
        let written = |is_pinned| Self::written(model, &Asked::default(), Some(state), is_pinned);
        symbolic::apart(|| written(true).ok().filter(|own| !own.is_unbalanced).map_or_else(|| written(false), Ok))
    }

    fn checked(model: &Model) -> Result<(), NoSteadyMotions> {
        has_values(model).map_err(NoSteadyMotions::NotCompiled)?;
        if changes(model) || !model.algebraic_speeds.is_empty() {
            return Err(NoSteadyMotions::Changes);
        }
        if model.positions() != model.speeds() {
            return Err(NoSteadyMotions::FreeFrame);
        }
        Ok(())
    }

    fn written(model: &Model, asked: &Asked, near: Option<&[f64]>, is_pinned: bool) -> Result<Self, NoSteadyMotions> {
        let trace = Trace::of(model);
        let n = trace.speeds.len();
        let names: Vec<String> = model.state_names().into_iter().map(|(name, _)| name).collect();
        let is_asked = |k: &usize| asked.ranges.iter().any(|(name, _)| *name == names[n + *k]);
        let rows = Rows::of(model, &trace, &Wanted { free: (0..n).filter(is_asked).collect(), near })?;
        let all = [&rows.residuals[..], &rows.zeros].concat();
        if all.iter().any(|row| row.symbols_of().contains(&trace.time)) {
            return Err(NoSteadyMotions::OfTime);
        }
        let is_cyclic = &rows.is_cyclic;
        let is_determined = |k: usize| rows.determined.iter().any(|(place, _)| *place == k);
        asked.checked(
            (0..n)
                .filter(|&k| !(is_cyclic[k] && is_determined(k)))
                .map(|k| names[if is_cyclic[k] { n + k } else { k }].as_str()),
        )?;
        let at_rest: Vec<(Sym, Sym)> =
            (0..n).filter(|&k| !is_cyclic[k]).map(|k| (trace.speeds[k], Sym::ZERO)).collect();
        let plain = |row: Sym| if vanishes(row) { Sym::ZERO } else { row };
        let mut residuals: Vec<Sym> = substitute_all(&rows.residuals, &at_rest).into_iter().map(plain).collect();
        let speed = |k: usize| near.map(|state| state[n + k]).or_else(|| asked.speed(&names[n + k]));
        if let Some(k) = implied(model, &trace, &rows, speed) {
            residuals[k] = Sym::ZERO;
        }
        // the speed of a cyclic coordinate is sought where its own equation asks for it, else it is what the start, or somebody, says
        let mut state = near.map_or_else(|| model.start_state(), <[f64]>::to_vec);
        state[..n].iter_mut().zip(is_cyclic).filter(|(_, cyclic)| **cyclic).for_each(|(value, _)| *value = 0.0);
        let (mut unknowns, mut given, mut known) = (Vec::new(), Vec::new(), Vec::new());
        let (mut without_range, mut valued) = (Vec::new(), Vec::new());
        for k in (0..n).filter(|&k| !(is_cyclic[k] && is_determined(k))) {
            let (symbol, place, is_sought) = match is_cyclic[k] {
                false => (trace.coordinates[k], k, !is_pinned),
                true => {
                    // its own equation asks for speeds, or for something that the others give by this one
                    let asks = residuals[k].symbols_of().iter().any(|symbol| trace.speeds.contains(symbol))
                        || residuals[k] != Sym::ZERO
                            && residuals.iter().any(|row| row.symbols_of().contains(&trace.speeds[k]));
                    (trace.speeds[k], n + k, asks && !is_pinned && asked.speed(&names[n + k]).is_none())
                }
            };
            let name = names[place].clone();
            if is_cyclic[k] {
                state[place] = asked.speed(&name).unwrap_or(state[place]);
            } else {
                state[n + k] = 0.0;
            }
            let is_circle = near.is_none() && !is_cyclic[k] && all.iter().all(|row| is_periodic(*row, symbol));
            let beside = near.filter(|_| is_sought).map(|state| Range::about(state[place]));
            match asked.range(&name).or(beside) {
                Some(range) if range.is_point() => {
                    state[place] = range.from;
                    valued.push((symbol, name.clone(), range.from));
                    known.push((symbol, Sym::constant(field::Rational::exactly(range.from))));
                    given.push((name, range.from));
                }
                Some(_) if !is_sought => return Err(NoSteadyMotions::AnyValue { name }),
                Some(range) => unknowns.push((symbol, Unknown { name, place, is_circle: false, range })),
                None if is_sought && is_circle => {
                    unknowns.push((symbol, Unknown { name, place, is_circle, range: Range::TURN }));
                }
                None if is_sought => without_range.push(name),
                _ => {
                    known.push((symbol, Sym::constant(field::Rational::exactly(state[place]))));
                    given.push((name, state[place]));
                }
            }
        }
        if !without_range.is_empty() {
            return Err(NoSteadyMotions::WithoutRange { names: without_range });
        }
        let (letters, unknowns): (Vec<Sym>, Vec<Unknown>) = unknowns.into_iter().unzip();
        let multipliers: Vec<Sym> = rows.constraints.iter().map(|one| one.multiplier).collect();
        let put = |rows: &[Sym]| -> Vec<Sym> {
            let rows = substitute_all(rows, &known);
            if is_pinned { rows.into_iter().map(plain).collect() } else { rows }
        };
        let asking_all = [&residuals[..], &rows.zeros].concat();
        let (residuals, zeros) = (put(&residuals), put(&rows.zeros));
        let is_open = |row: &Sym| *row != Sym::ZERO && row.as_constant().is_some();
        let open = asking_all.iter().zip(residuals.iter().chain(&zeros)).filter(|(_, row)| is_open(row));
        let letters_of: Vec<Sym> = open.flat_map(|(row, _)| row.symbols_of()).collect();
        if let Some((_, name, value)) = valued.into_iter().find(|(symbol, ..)| letters_of.contains(symbol)) {
            return Err(NoSteadyMotions::Sought { name, value });
        }
        let asking: Vec<usize> = (0..n).filter(|&k| residuals[k] != Sym::ZERO).collect();
        let zeros: Vec<Sym> = zeros.into_iter().filter(|zero| *zero != Sym::ZERO).collect();
        // a load that nothing balances
        let is_unbalanced = residuals.iter().any(|row| *row != Sym::ZERO && row.as_constant().is_some());
        let equations = asking.len() + zeros.len();
        if equations != unknowns.len() + multipliers.len() && !is_unbalanced {
            let idle =
                (0..n).filter(|&k| !is_cyclic[k] && residuals[k] == Sym::ZERO).map(|k| names[k].clone()).collect();
            let counts = [equations, unknowns.len() + multipliers.len()];
            return Err(NoSteadyMotions::Unequal { counts, idle });
        }
        let residuals: Vec<Sym> = asking.into_iter().map(|k| residuals[k]).collect();
        let without: Vec<(Sym, Sym)> = multipliers.iter().map(|letter| (*letter, Sym::ZERO)).collect();
        let reactions = residuals.iter().flat_map(|row| multipliers.iter().map(|&by| row.diff(by)));
        let loads: Vec<Sym> = reactions.chain(substitute_all(&residuals, &without)).collect();
        let values = [residuals, zeros].concat();
        let inputs = [&letters[..], &multipliers].concat();
        let slopes: Vec<Sym> = values.iter().flat_map(|row| inputs.iter().map(|&by| row.diff(by))).collect();
        let recorded = |inputs: &[Sym], outputs: &[Sym]| {
            Tape::record(inputs, outputs).map_err(|why| NoSteadyMotions::Undefined { why: why.to_string() })
        };
        let [momenta, masses] = match rows.determined.is_empty() {
            true => momenta(&trace, is_cyclic, (&letters, &known)).map(|all| Tape::record(&letters, &all).ok()),
            false => [None, None],
        };
        let (places, rates): (Vec<usize>, Vec<Sym>) = rows.determined.iter().copied().unzip();
        let rates = substitute_all(&substitute_all(&rates, &at_rest), &known);
        let cyclic_places: Vec<usize> = (0..n).filter(|&k| is_cyclic[k]).collect();
        let cyclic = cyclic_places.iter().map(|&k| names[k].clone()).collect();
        let kept_momenta = rows.kept_momenta.iter().map(|&k| (k, names[k].clone())).collect();
        Ok(SteadyEquations {
            coordinates: unknowns.iter().filter(|unknown| unknown.place < n).count(),
            unknowns,
            given,
            cyclic,
            cyclic_places,
            kept_momenta,
            state,
            reactions: multipliers.len(),
            is_unbalanced,
            have_potential: rows.have_potential,
            values: recorded(&inputs, &values)?,
            slopes: recorded(&inputs, &slopes)?,
            loads: recorded(&letters, &loads)?,
            momenta,
            masses,
            determined: (places.into_iter().map(|k| n + k).collect(), recorded(&letters, &rates)?),
        })
    }
}

/// Derivatives of the momenta of cyclic coordinates, all other speeds being zero: by letters, then by their speeds; and the mass matrix.
fn momenta(trace: &Trace<'_>, is_cyclic: &[bool], (letters, known): (&[Sym], &[(Sym, Sym)])) -> [Vec<Sym>; 2] {
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
    [of_cyclic, by(energy, &trace.speeds, &trace.speeds)].map(|all| substitute_all(&all, known))
}
