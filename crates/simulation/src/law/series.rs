//! Taylor series of the solutions of a law, for Taylor's method.

use crate::law::compiled_law::SymbolicLaw;
use crate::law::exponents::{Expandable, Room};
use crate::law::trace::{TracedOde, traced};
use field::DoubleDouble;
use integrators::{TaylorSeries, Variations};
use series::{Equations, Expansion, Fused};
use std::fmt;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// The Taylor recurrence of the right-hand side of a law, with the data of the law as exact constants.
pub struct LawSeries {
    record: Box<Record>,
    /// Recorded when first needed; `None` where the law has no Taylor recurrence: Taylor's method is then unavailable.
    recurrence: OnceLock<Option<Expandable>>,
    spare: Spare<f64, WIDTH>,
    directed: Spare<Variations, 1>,
    finer: Spare<DoubleDouble, WIDTH>,
}

impl fmt::Debug for LawSeries {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("LawSeries").field("recurrence", &self.recurrence).finish_non_exhaustive()
    }
}

type Record = dyn Fn() -> Option<Expandable> + Send + Sync;

/// Buffers of expansions of earlier runs, for reuse.
type Spare<S, const W: usize> = Mutex<Vec<Expansion<S, W, FEW>>>;

impl LawSeries {
    /// The series of a law, which may depend on time.
    pub fn of(law: Arc<dyn SymbolicLaw>) -> Self {
        LawSeries::by(move || LawSeries::written(&*law))
    }

    /// The Taylor recurrence of the expressions of the rates; `None` where they have no Taylor series.
    pub fn written(law: &dyn SymbolicLaw) -> Option<Expandable> {
        traced(law, |TracedOde { state, time, rates }| {
            let moves = rates.iter().any(|rate| rate.symbols_of().contains(time));
            let equations = Equations { state, time: moves.then_some(*time), parameters: &[], rates, solve: None };
            Expandable::record(&equations).ok()
        })
    }

    /// The Taylor series by a recurrence that `record` computes; it returns `None` if the law has no such recurrence.
    pub fn by(record: impl Fn() -> Option<Expandable> + Send + Sync + 'static) -> Self {
        LawSeries {
            record: Box::new(record),
            recurrence: OnceLock::new(),
            spare: Spare::default(),
            directed: Spare::default(),
            finer: Spare::default(),
        }
    }

    /// The Taylor series in `f64`; `None` if the law has no recurrence.
    pub fn plain(&self) -> Option<Box<dyn TaylorSeries<f64> + '_>> {
        self.kept(&self.spare)
    }

    /// The Taylor series with derivatives in eight directions; `None` if the law has no recurrence.
    pub fn directed(&self) -> Option<Box<dyn TaylorSeries<Variations> + '_>> {
        self.kept(&self.directed)
    }

    /// The Taylor series in double-double; `None` if the law has no recurrence.
    pub fn exact(&self) -> Option<Box<dyn TaylorSeries<DoubleDouble> + '_>> {
        self.kept(&self.finer)
    }

    fn recurrence(&self) -> Option<&Expandable> {
        self.recurrence.get_or_init(|| (self.record)()).as_ref()
    }

    /// An expansion whose buffers are reused between runs, if its size is usual.
    fn kept<'a, S: Fused, const W: usize>(&'a self, spare: &'a Spare<S, W>) -> Option<Box<dyn TaylorSeries<S> + 'a>> {
        match self.recurrence() {
            Some(law) if law.recurrence.columns::<W>() <= FEW => {
                Some(Box::new(Kept { series: Series::of(law), spare }))
            }
            _ => self.series::<S, W>(),
        }
    }

    fn series<S: Fused, const W: usize>(&self) -> Option<Box<dyn TaylorSeries<S> + '_>> {
        let law = self.recurrence()?;
        match law.recurrence.columns::<W>() {
            columns if columns <= FEW => Some(Box::new(Series::<S, W, FEW>::of(law))),
            columns if columns <= MANY => Some(Box::new(Series::<S, W, MANY>::of(law))),
            _ => None,
        }
    }
}

/// The number of quantities computed together: eight `f64` fill the widest SIMD registers; scalar types that fill a
/// register have one.
const WIDTH: usize = 8;

/// The largest numbers of columns: for usual systems, which then fit into the cache, and for the largest systems.
const FEW: usize = 256;
const MANY: usize = 1 << 16;

/// The Taylor series by a recurrence, with buffers for the requested order.
struct Series<'a, S: Fused, const W: usize, const N: usize> {
    law: &'a Expandable,
    expansion: Option<Expansion<S, W, N>>,
    /// The values of the arguments of exponentials, and the state followed by buffers for their series.
    exponents: Room,
    extended: Vec<S>,
}

impl<'a, S: Fused, const W: usize, const N: usize> Series<'a, S, W, N> {
    fn of(law: &'a Expandable) -> Self {
        Series { law, expansion: None, exponents: Room::default(), extended: Vec::new() }
    }
}

impl<S: Fused, const W: usize, const N: usize> TaylorSeries<S> for Series<'_, S, W, N> {
    fn expand(&mut self, t: S, y: &[S], order: usize) {
        self.expand_rounding(t, y, order, order);
    }

    fn expand_rounding(&mut self, t: S, y: &[S], order: usize, fine: usize) -> usize {
        if self.expansion.as_ref().is_none_or(|expansion| expansion.order() != order) {
            self.expansion = self.law.recurrence.expansion(&[], order);
        }
        let Some(expansion) = &mut self.expansion else { return order };
        let Some(exponents) = &self.law.exponents else { return expansion.expand_rounding(y, t, fine) };
        exponents.evaluate(&mut self.exponents, y.iter().map(|value| value.rounded()), t.rounded(), &[]);
        self.extended.clear();
        self.extended.extend_from_slice(y);
        self.extended.resize(y.len() + exponents.count(), S::zero());
        expansion.expand_rounding(&self.extended, t, fine)
    }

    fn coefficients(&self, k: usize) -> &[S] {
        self.expansion.as_ref().map_or(&[], |expansion| &expansion.coefficients(k)[..self.law.states()])
    }

    fn sum(&self, h: S, out: &mut [S]) {
        if let Some(expansion) = &self.expansion {
            expansion.sum(h, out);
        }
    }

    fn shown(&self) -> f64 {
        let (Some(expansion), Some(exponents)) = (&self.expansion, &self.law.exponents) else { return f64::INFINITY };
        let first = self.law.states();
        let term = |place: usize, k: usize| expansion.coefficients(k)[first + place].rounded();
        exponents.longest(&self.exponents.values, expansion.order(), S::FINER, term)
    }

    fn has_branches(&self) -> bool {
        self.law.has_branches
    }
}

/// A Taylor series whose buffers are reused between runs.
struct Kept<'a, S: Fused, const W: usize> {
    series: Series<'a, S, W, FEW>,
    spare: &'a Spare<S, W>,
}

impl<S: Fused, const W: usize> TaylorSeries<S> for Kept<'_, S, W> {
    fn expand(&mut self, t: S, y: &[S], order: usize) {
        self.expand_rounding(t, y, order, order);
    }

    fn expand_rounding(&mut self, t: S, y: &[S], order: usize, fine: usize) -> usize {
        if self.series.expansion.is_none() {
            let mut spare = self.spare.lock().unwrap_or_else(PoisonError::into_inner);
            let fitting = spare.iter().position(|expansion| expansion.order() == order);
            self.series.expansion = fitting.map(|place| spare.swap_remove(place));
        }
        self.series.expand_rounding(t, y, order, fine)
    }

    fn coefficients(&self, k: usize) -> &[S] {
        self.series.coefficients(k)
    }

    fn sum(&self, h: S, out: &mut [S]) {
        self.series.sum(h, out);
    }

    fn shown(&self) -> f64 {
        self.series.shown()
    }

    fn has_branches(&self) -> bool {
        self.series.has_branches()
    }
}

impl<S: Fused, const W: usize> Drop for Kept<'_, S, W> {
    fn drop(&mut self) {
        let mut spare = self.spare.lock().unwrap_or_else(PoisonError::into_inner);
        spare.extend(self.series.expansion.take());
    }
}
