//! Linear combinations of quantities: short ones, and long ones four at a time.

use super::products::Quantity;
use crate::plan::{Slot, Sums};
use field::Batch;

/// All sums of a stage, or all rates.
#[derive(Clone, Debug)]
pub(super) struct Rows<const L: usize> {
    twos: Vec<Bunch<L, 1, [Term<L, 1>; 2]>>,
    fours: Vec<Bunch<L, 1, [Term<L, 1>; 4]>>,
    long: Vec<Bunch<L, 1, Vec<Term<L, 1>>>>,
    long_pairs: Vec<Bunch<L, 2, Vec<Term<L, 2>>>>,
    long_fours: Vec<Bunch<L, 4, Vec<Term<L, 4>>>>,
}

/// R sums of common quantities.
#[derive(Clone, Debug)]
struct Bunch<const L: usize, const R: usize, T> {
    /// The places of the sums.
    places: [u16; R],
    constants: [Batch<L>; R],
    constant_of: [Option<u32>; R],
    terms: T,
}

/// A quantity with its coefficient in each sum; zero where a sum does not contain it.
#[derive(Clone, Copy, Debug)]
struct Term<const L: usize, const R: usize> {
    times: [Batch<L>; R],
    place: u16,
    /// The indices of the coefficients.
    times_of: [Option<u32>; R],
}

/// A sum of the plan.
struct Row {
    place: Slot,
    constant: Option<u32>,
    /// The terms, as (place, index of the coefficient).
    terms: Vec<(Slot, u32)>,
}

impl<const L: usize> Rows<L> {
    pub fn new(sums: &Sums, places: &[Slot]) -> Self {
        let row = |(number, place): (u32, &Slot)| Row {
            place: *place,
            constant: sums.constants.iter().find(|constant| constant.0 == number).map(|constant| constant.1),
            terms: sums.terms.iter().filter(|term| term.0 == number).map(|term| (term.1, term.2)).collect(),
        };
        let mut rows = Rows {
            twos: Vec::new(),
            fours: Vec::new(),
            long: Vec::new(),
            long_pairs: Vec::new(),
            long_fours: Vec::new(),
        };
        let (short, mut long): (Vec<Row>, Vec<Row>) = (0..).zip(places).map(row).partition(|row| row.terms.len() < 4);
        for row in &short {
            let (places, terms) = ([row.place as u16], terms(&[row]));
            let (constants, constant_of) = ([Batch::all(0.0)], [row.constant]);
            let term = |number: usize| terms.get(number).copied().unwrap_or(Term::NONE);
            if terms.len() <= 2 {
                rows.twos.push(Bunch { places, constants, constant_of, terms: [0, 1].map(term) });
            } else {
                rows.fours.push(Bunch { places, constants, constant_of, terms: [0, 1, 2, 3].map(term) });
            }
        }
        while !long.is_empty() {
            let mut own: Vec<Row> = alike(&long).into_iter().rev().map(|number| long.remove(number)).collect();
            if let [a, b, c, d] = &own[..] {
                rows.long_fours.push(Bunch::long([a, b, c, d]));
                continue;
            }
            // three are treated as two and one
            if own.len() == 3 {
                long.extend(own.pop());
            }
            if let [a, b] = &own[..] {
                rows.long_pairs.push(Bunch::long([a, b]));
            } else {
                rows.long.extend(own.iter().map(|row| Bunch::long([row])));
            }
        }
        rows
    }

    /// Sets the coefficients.
    pub fn take(&mut self, values: &[Batch<L>]) {
        self.twos.iter_mut().for_each(|bunch| bunch.take(values));
        self.fours.iter_mut().for_each(|bunch| bunch.take(values));
        self.long.iter_mut().for_each(|bunch| bunch.take(values));
        self.long_pairs.iter_mut().for_each(|bunch| bunch.take(values));
        self.long_fours.iter_mut().for_each(|bunch| bunch.take(values));
    }

    /// Computes each sum of the current order and passes it to `put` with its place; `FIRST` for order zero.
    #[inline(always)]
    pub fn sums<const FIRST: bool, const I: usize, const N: usize>(
        &self,
        quantities: &mut [Quantity<L>; N],
        mut put: impl FnMut(&mut [Quantity<L>; N], usize, Batch<L>),
    ) {
        for bunch in &self.long_fours {
            let [a, b, c, d] = bunch.long_sums::<FIRST, I, N>(quantities);
            put(quantities, usize::from(bunch.places[0]) % N, a);
            put(quantities, usize::from(bunch.places[1]) % N, b);
            put(quantities, usize::from(bunch.places[2]) % N, c);
            put(quantities, usize::from(bunch.places[3]) % N, d);
        }
        for bunch in &self.long_pairs {
            let [a, b] = bunch.long_sums::<FIRST, I, N>(quantities);
            put(quantities, usize::from(bunch.places[0]) % N, a);
            put(quantities, usize::from(bunch.places[1]) % N, b);
        }
        for bunch in &self.long {
            let [a] = bunch.long_sums::<FIRST, I, N>(quantities);
            put(quantities, usize::from(bunch.places[0]) % N, a);
        }
        for bunch in &self.twos {
            let mut sum = if FIRST { bunch.constants } else { [Batch::all(0.0)] };
            bunch.terms[0].add::<I, N>(&mut sum, quantities);
            bunch.terms[1].add::<I, N>(&mut sum, quantities);
            put(quantities, usize::from(bunch.places[0]) % N, sum[0]);
        }
        for bunch in &self.fours {
            let mut sum = if FIRST { bunch.constants } else { [Batch::all(0.0)] };
            bunch.terms[0].add::<I, N>(&mut sum, quantities);
            bunch.terms[1].add::<I, N>(&mut sum, quantities);
            bunch.terms[2].add::<I, N>(&mut sum, quantities);
            bunch.terms[3].add::<I, N>(&mut sum, quantities);
            put(quantities, usize::from(bunch.places[0]) % N, sum[0]);
        }
    }
}

impl<const L: usize, const R: usize> Term<L, R> {
    const NONE: Self = Term { times: [Batch([0.0; L]); R], place: 0, times_of: [None; R] };

    #[inline(always)]
    fn add<const I: usize, const N: usize>(&self, sums: &mut [Batch<L>; R], quantities: &[Quantity<L>; N]) {
        let x = quantities[usize::from(self.place) % N].newest[I];
        for (sum, times) in sums.iter_mut().zip(&self.times) {
            *sum = sum.plus_product(x, *times, true);
        }
    }
}

impl<const L: usize, const R: usize> Bunch<L, R, Vec<Term<L, R>>> {
    fn long(rows: [&Row; R]) -> Self {
        let mut terms = terms(&rows);
        terms.resize(terms.len().next_multiple_of(2), Term::NONE);
        let (places, constant_of) = (rows.map(|row| row.place as u16), rows.map(|row| row.constant));
        Bunch { places, constants: [Batch::all(0.0); R], constant_of, terms }
    }

    /// Alternate terms are summed separately, to reduce latency.
    #[inline(always)]
    fn long_sums<const FIRST: bool, const I: usize, const N: usize>(
        &self,
        quantities: &[Quantity<L>; N],
    ) -> [Batch<L>; R] {
        let [mut even, mut odd] = [if FIRST { self.constants } else { [Batch::all(0.0); R] }, [Batch::all(0.0); R]];
        for two in self.terms.as_chunks::<2>().0 {
            two[0].add::<I, N>(&mut even, quantities);
            two[1].add::<I, N>(&mut odd, quantities);
        }
        for (even, odd) in even.iter_mut().zip(odd) {
            *even += odd;
        }
        even
    }
}

impl<const L: usize, const R: usize, T: AsMut<[Term<L, R>]>> Bunch<L, R, T> {
    fn take(&mut self, values: &[Batch<L>]) {
        let value = |of: &Option<u32>| of.and_then(|of| values.get(of as usize)).copied().unwrap_or(Batch::all(0.0));
        self.constants.iter_mut().zip(&self.constant_of).for_each(|(to, of)| *to = value(of));
        for term in self.terms.as_mut() {
            term.times.iter_mut().zip(&term.times_of).for_each(|(to, of)| *to = value(of));
        }
    }
}

/// The terms of these rows, in the order in which they become known.
fn terms<const L: usize, const R: usize>(rows: &[&Row; R]) -> Vec<Term<L, R>> {
    let mut places: Vec<Slot> = rows.iter().flat_map(|row| row.terms.iter().map(|term| term.0)).collect();
    places.sort_unstable();
    places.dedup();
    let term = |place: Slot| {
        let coefficient = |row: &Row| row.terms.iter().find(|term| term.0 == place).map(|term| term.1);
        Term { place: place as u16, times_of: rows.map(coefficient), ..Term::NONE }
    };
    places.into_iter().map(term).collect()
}

/// The indices of sums to compute together with the first one, ascending: at most three more, each the one with the
/// fewest new quantities, as long as these are fewer than the common ones.
fn alike(rows: &[Row]) -> Vec<usize> {
    let mut places: Vec<Slot> = rows[0].terms.iter().map(|term| term.0).collect();
    let mut chosen = vec![0];
    while chosen.len() < 4 {
        let new = |number: usize| rows[number].terms.iter().filter(|term| !places.contains(&term.0)).count();
        let rest = (0..rows.len()).filter(|number| !chosen.contains(number));
        let Some(next) = rest.min_by_key(|&number| new(number)) else { break };
        if 2 * new(next) > rows[next].terms.len() {
            break;
        }
        chosen.push(next);
        places.extend(rows[next].terms.iter().map(|term| term.0));
    }
    chosen.sort_unstable();
    chosen
}
