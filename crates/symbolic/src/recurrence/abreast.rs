//! The series of many systems of one kind at once, each with data of its own.
//!
//! All numbers are lanes, and every quantity is computed by itself. What costs is bringing the numbers to the processor,
//! so the series of a factor is held once for all its products, near the processor, and a product is formed for two
//! orders at a time: each number that is brought is used twice.

use super::Recurrence;
use super::layout::Implicit;
use super::plan::{Place, Stage, Sums};
use crate::tape::Program;
use field::Lanes;
use pulp::{Arch, Simd, WithSimd};

/// L systems that differ in their parameters, states and times, one in each lane. Nothing is allocated, and what one lane
/// holds does not depend on another. `N` is a power of two above the number of quantities, so that no index needs a
/// check.
#[derive(Clone, Debug)]
pub struct Abreast<'a, const L: usize, const N: usize = 256> {
    order: usize,
    states: usize,
    time: bool,
    stages: Vec<Side<L>>,
    rates: Rows<L>,
    /// The coefficients of the order at hand of all quantities.
    now: Box<[Lanes<L>; N]>,
    /// The coefficients of all orders of what has a rate; so long is one order.
    series: Vec<Lanes<L>>,
    width: usize,
    /// The series of all factors, one after the other; so long is one.
    factors: Vec<Lanes<L>>,
    length: usize,
    points: Program<'a, Lanes<L>>,
    inputs: Vec<Lanes<L>>,
    circle: Vec<Lanes<L>>,
    /// From the parameters of one system to its coefficients.
    coefficients: Program<'a, f64>,
    values: Vec<f64>,
}

/// Sums, then products, then what is solved for.
#[derive(Clone, Debug)]
struct Side<const L: usize> {
    sums: Rows<L>,
    /// Which quantities are factors that are known by now, and where their series are.
    factors: Vec<(u16, u16)>,
    products: Vec<Product<L>>,
    reciprocals: Vec<Implicit<Lanes<L>>>,
    roots: Vec<Implicit<Lanes<L>>>,
}

/// The product of two factors, and what is known of its next order.
#[derive(Clone, Copy, Debug)]
struct Product<const L: usize> {
    place: u16,
    a: u16,
    b: u16,
    next: Lanes<L>,
}

/// Sums one after the other: where each goes and of how many terms it is made.
#[derive(Clone, Debug)]
struct Rows<const L: usize> {
    rows: Vec<(u16, u16)>,
    constants: Vec<Lanes<L>>,
    /// What is added, and how often.
    places: Vec<u16>,
    times: Vec<Lanes<L>>,
    /// Which coefficients these are.
    constant_of: Vec<Option<u32>>,
    times_of: Vec<u32>,
}

impl Recurrence {
    /// Readies the recurrence for L systems; `None` where it has more than `N` quantities. Until a lane is [set], all its
    /// coefficients are zero.
    ///
    /// [set]: Abreast::set
    pub fn abreast<const L: usize, const N: usize>(&self, order: usize) -> Option<Abreast<'_, L, N>> {
        const { assert!(N.is_power_of_two() && N <= 1 << 16) };
        let plan = &self.plan;
        let last = plan.stages.iter().flat_map(Stage::places).max().unwrap_or(0);
        if plan.moving.max(last as usize + 1) > N {
            return None;
        }
        let zero = Lanes::all(0.0);
        let inputs = plan.states + usize::from(plan.time);
        let mut slots = Slots { of: vec![None; N], next: 0 };
        let stages: Vec<Side<L>> = plan.stages.iter().map(|stage| Side::new(stage, order, &mut slots)).collect();
        Some(Abreast {
            order,
            states: plan.states,
            time: plan.time,
            stages,
            rates: Rows::new(&plan.rates, &(0..plan.moving as Place).collect::<Vec<_>>()),
            now: Box::new([zero; N]),
            series: vec![zero; plan.moving.next_multiple_of(CHAINS) * (order + 1)],
            width: plan.moving.next_multiple_of(CHAINS),
            factors: vec![zero; slots.next * (order + 2)],
            length: order + 2,
            points: self.points.over(),
            inputs: vec![zero; self.points.inputs()],
            circle: vec![zero; plan.moving - inputs],
            coefficients: self.coefficients.over(),
            values: vec![0.0; self.coefficients.outputs()],
        })
    }

    /// How many parameters a system has.
    pub fn parameters(&self) -> usize {
        self.coefficients.inputs()
    }
}

/// Places for the series of factors.
struct Slots {
    of: Vec<Option<u16>>,
    next: usize,
}

impl<const L: usize> Side<L> {
    fn new(stage: &Stage, order: usize, slots: &mut Slots) -> Self {
        let mut factors = Vec::new();
        let mut slot = |place: Place| {
            *slots.of[place as usize].get_or_insert_with(|| {
                let slot = slots.next as u16;
                slots.next += 1;
                factors.push((place as u16, slot));
                slot
            })
        };
        let products = stage.products.iter();
        let products = products.map(|product| Product {
            place: product.place as u16,
            a: slot(product.a),
            b: slot(product.b),
            next: Lanes::all(0.0),
        });
        let products = products.collect();
        let implicit = |pairs: &[(Place, Place)]| {
            let one = |&(place, of): &(Place, Place)| Implicit {
                column: place as usize,
                of: of as usize,
                series: vec![[Lanes::all(0.0); 2]; order + 1],
            };
            pairs.iter().map(one).collect()
        };
        let (reciprocals, roots) = (implicit(&stage.reciprocals), implicit(&stage.roots));
        Side { sums: Rows::new(&stage.sums, &stage.sum_places), factors, products, reciprocals, roots }
    }
}

impl<const L: usize> Rows<L> {
    fn new(sums: &Sums, places: &[Place]) -> Self {
        let mut terms = sums.terms.clone();
        terms.sort_by_key(|(row, ..)| *row);
        let count = |row: u32| terms.iter().filter(|term| term.0 == row).count() as u16;
        let constant = |row: u32| sums.constants.iter().find(|constant| constant.0 == row).map(|constant| constant.1);
        let numbers = 0..sums.rows as u32;
        Rows {
            rows: numbers.clone().zip(places).map(|(row, place)| (*place as u16, count(row))).collect(),
            constants: vec![Lanes::all(0.0); sums.rows],
            places: terms.iter().map(|term| term.1 as u16).collect(),
            times: vec![Lanes::all(0.0); terms.len()],
            constant_of: numbers.map(constant).collect(),
            times_of: terms.iter().map(|term| term.2).collect(),
        }
    }

    fn set(&mut self, lane: usize, values: &[f64]) {
        let constants = self.constants.iter_mut().zip(&self.constant_of).filter_map(|(to, of)| Some((to, (*of)?)));
        for (to, of) in self.times.iter_mut().zip(self.times_of.iter().copied()).chain(constants) {
            to.0[lane] = values.get(of as usize).copied().unwrap_or(0.0);
        }
    }

    /// Each sum of order k, given to `put` with its place.
    #[inline(always)]
    fn sums<const FUSED: bool, const N: usize>(
        &self,
        k: usize,
        now: &mut [Lanes<L>; N],
        mut put: impl FnMut(&mut [Lanes<L>; N], usize, Lanes<L>),
    ) {
        let (mut places, mut times) = (&self.places[..], &self.times[..]);
        for ((place, count), constant) in self.rows.iter().zip(&self.constants) {
            let mut sum = if k == 0 { *constant } else { Lanes::all(0.0) };
            let (own, more) = places.split_at(usize::from(*count).min(places.len()));
            let (own_times, more_times) = times.split_at(usize::from(*count).min(times.len()));
            for (of, often) in own.iter().zip(own_times) {
                sum = sum.plus_product(now[usize::from(*of) % N], *often, FUSED);
            }
            (places, times) = (more, more_times);
            put(now, usize::from(*place) % N, sum);
        }
    }
}

impl<const L: usize, const N: usize> Abreast<'_, L, N> {
    /// Gives the system in a lane its parameters.
    pub fn set(&mut self, lane: usize, parameters: &[f64]) {
        self.coefficients.evaluate(parameters, &mut self.values);
        let inputs = &mut self.inputs[self.states + usize::from(self.time)..];
        inputs.iter_mut().zip(parameters).for_each(|(input, value)| input.0[lane] = *value);
        let stages = self.stages.iter_mut().map(|stage| &mut stage.sums);
        stages.chain([&mut self.rates]).for_each(|sums| sums.set(lane, &self.values));
    }

    /// Expands the solutions through these states, each at its time.
    pub fn expand(&mut self, states: &[Lanes<L>], time: Lanes<L>) {
        match Arch::new() {
            Arch::Scalar => Expand::<L, N, false> { abreast: self, states, time }.run(),
            wide => wide.dispatch(Expand::<L, N, true> { abreast: self, states, time }),
        }
    }

    /// The coefficients a_k of the states.
    #[inline]
    pub fn coefficients(&self, k: usize) -> &[Lanes<L>] {
        &self.series[k * self.width..][..self.states]
    }

    /// The sums of the series, each at its h, by Horner's scheme.
    pub fn sum(&self, h: Lanes<L>, out: &mut [Lanes<L>]) {
        let (series, width) = (&self.series[..], self.width);
        match Arch::new() {
            Arch::Scalar => Sum::<L, false> { series, width, h, out }.run(),
            wide => wide.dispatch(Sum::<L, true> { series, width, h, out }),
        }
    }
}

/// All orders, compiled once for each set of instructions.
struct Expand<'a, 'b, 'c, const L: usize, const N: usize, const FUSED: bool> {
    abreast: &'a mut Abreast<'b, L, N>,
    states: &'c [Lanes<L>],
    time: Lanes<L>,
}

impl<const L: usize, const N: usize, const FUSED: bool> Expand<'_, '_, '_, L, N, FUSED> {
    #[inline(always)]
    fn run(self) {
        let Abreast { order, stages, rates, now, series, width, factors, length, points, inputs, circle, .. } =
            self.abreast;
        let n = self.abreast.states.min(self.states.len());
        inputs[..n].copy_from_slice(&self.states[..n]);
        let mut moving = self.abreast.states;
        if self.abreast.time {
            inputs[moving] = self.time;
            moving += 1;
        }
        series[..moving].copy_from_slice(&inputs[..moving]);
        if !circle.is_empty() {
            points.evaluate(inputs, circle);
            series[moving..][..circle.len()].copy_from_slice(circle);
        }
        for k in 0..*order {
            let (known, next) = series.split_at_mut((k + 1) * *width);
            now[..*width].copy_from_slice(&known[k * *width..]);
            for stage in &mut *stages {
                stage.sums.sums::<FUSED, N>(k, now, |now, place, sum| now[place] = sum);
                for (place, slot) in &stage.factors {
                    let factor = &mut factors[usize::from(*slot) * *length..][..*length];
                    // nothing is known of what is newer
                    (factor[k], factor[k + 1]) = (now[usize::from(*place) % N], Lanes::all(0.0));
                }
                for product in &mut stage.products {
                    let [a, b] = [product.a, product.b].map(|slot| &factors[usize::from(slot) * *length..][..k + 2]);
                    let value = if k % 2 == 0 {
                        let [value, next] = two_orders::<L, FUSED>(a, &b[..=k]);
                        product.next = next;
                        value
                    } else {
                        product.next.plus_product(a[0], b[k], FUSED).plus_product(a[k], b[0], FUSED)
                    };
                    now[usize::from(product.place) % N] = value;
                }
                stage.reciprocals.iter_mut().for_each(|each| each.reciprocal(k, &mut now[..]));
                stage.roots.iter_mut().for_each(|each| each.root(k, &mut now[..]));
            }
            // x_(k+1) = (x')_k / (k + 1)
            let reciprocal = Lanes::all(1.0 / (k + 1) as f64);
            let next = &mut next[..*width];
            rates.sums::<FUSED, N>(k, now, |_, place, sum| next[place] = sum * reciprocal);
        }
    }
}

/// Sums that run side by side: none waits for the addition before.
const CHAINS: usize = 4;

/// sum_j a_j b_(k-j), and of the next order what the same numbers give: sum_j a_(j+1) b_(k-j), where a_(k+1) is zero.
#[inline(always)]
fn two_orders<const L: usize, const FUSED: bool>(a: &[Lanes<L>], b: &[Lanes<L>]) -> [Lanes<L>; 2] {
    let zero = Lanes::all(0.0);
    let (mut sums, mut nexts) = ([zero; CHAINS], [zero; CHAINS]);
    let mut newer = a[1..=b.len()].chunks_exact(CHAINS);
    let mut older = b.rchunks_exact(CHAINS);
    let mut first = a[0];
    for (x, y) in (&mut newer).zip(&mut older) {
        let before = [first, x[0], x[1], x[2]];
        for chain in 0..CHAINS {
            sums[chain] = sums[chain].plus_product(before[chain], y[CHAINS - 1 - chain], FUSED);
            nexts[chain] = nexts[chain].plus_product(x[chain], y[CHAINS - 1 - chain], FUSED);
        }
        first = x[CHAINS - 1];
    }
    // the few that are left: an index that is not known beforehand would bring all sums into memory
    for (x, y) in newer.remainder().iter().zip(older.remainder().iter().rev()) {
        sums[0] = sums[0].plus_product(first, *y, FUSED);
        nexts[0] = nexts[0].plus_product(*x, *y, FUSED);
        first = *x;
    }
    let together = |[a, b, c, d]: [Lanes<L>; CHAINS]| (a + b) + (c + d);
    [together(sums), together(nexts)]
}

impl<const L: usize, const N: usize> WithSimd for Expand<'_, '_, '_, L, N, true> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        self.run();
    }
}

struct Sum<'a, const L: usize, const FUSED: bool> {
    series: &'a [Lanes<L>],
    width: usize,
    h: Lanes<L>,
    out: &'a mut [Lanes<L>],
}

impl<const L: usize, const FUSED: bool> Sum<'_, L, FUSED> {
    #[inline(always)]
    fn run(self) {
        for (block, out) in self.out.chunks_mut(CHAINS).enumerate() {
            let mut sums = [Lanes::all(0.0); CHAINS];
            for row in self.series.chunks_exact(self.width).rev() {
                let terms = &row[block * CHAINS..][..CHAINS];
                for chain in 0..CHAINS {
                    sums[chain] = terms[chain].plus_product(sums[chain], self.h, FUSED);
                }
            }
            out.iter_mut().zip(sums).for_each(|(out, sum)| *out = sum);
        }
    }
}

impl<const L: usize> WithSimd for Sum<'_, L, true> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        self.run();
    }
}
