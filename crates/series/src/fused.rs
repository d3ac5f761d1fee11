//! Kernels compiled for several instruction sets, of which the best is chosen at run time.

#[cfg(target_arch = "x86_64")]
use super::permuting::Permuting;
use super::pick::{OneByOne, Pick};
use super::small::{Never, Small, SmallSeries};
use super::stored::{Parts, Stored};
use algebra::linear::Magnitude;
use field::{Analytic, Batch, DoubleDouble, Over, Tangent};
use std::marker::PhantomData;
use std::sync::OnceLock;

/// A scalar type with the fastest multiply-add of the processor.
pub trait Fused: Analytic + Magnitude + Over<f64> + From<f64> {
    /// Whether it has more digits than `f64`.
    const FINER: bool = false;

    /// Eight numbers in memory.
    #[doc(hidden)]
    #[allow(private_bounds)]
    type Stored: Stored<Self>;

    /// The implementation for small right-hand sides.
    #[doc(hidden)]
    #[allow(private_bounds)]
    type Small: SmallSeries<Self>;

    /// The nearest `f64`; for a dual number, of its value.
    fn rounded(self) -> f64;

    /// self + a b; rounded once if `_fused`.
    #[inline(always)]
    fn plus_product(self, a: Self, b: Self, _fused: bool) -> Self {
        self + a * b
    }

    /// Runs a task on groups of `_group` numbers.
    #[doc(hidden)]
    #[allow(private_bounds)]
    #[inline]
    fn run<T: Task<Self>>(task: T, _group: usize) {
        task.run(OneByOne::<false>);
    }
}

/// A task that is compiled for each instruction set.
pub(crate) trait Task<S: Fused> {
    fn run<P: Pick<S> + Pick<f64>>(self, pick: P);
}

impl Fused for DoubleDouble {
    const FINER: bool = true;
    type Stored = Parts;
    type Small = Small<DoubleDouble>;

    #[inline(always)]
    fn rounded(self) -> f64 {
        self.hi()
    }

    /// Products use fused multiply-add: a function call each on processors without the instruction.
    #[allow(private_bounds)]
    #[inline]
    fn run<T: Task<DoubleDouble>>(task: T, group: usize) {
        in_widest(task, group);
    }
}

/// Dual numbers with a derivative in each lane, for the series of a solution and of its derivatives with respect to the
/// initial state.
impl<const L: usize> Fused for Tangent<Batch<L>> {
    type Stored = [Self; 8];
    type Small = Never;

    #[inline(always)]
    fn rounded(self) -> f64 {
        self.value.0[0]
    }

    #[inline(always)]
    fn plus_product(self, a: Self, b: Self, fused: bool) -> Self {
        let slope = self.slope.plus_product(a.slope, b.value, fused).plus_product(a.value, b.slope, fused);
        Tangent::moving(self.value.plus_product(a.value, b.value, fused), slope)
    }

    #[allow(private_bounds)]
    #[inline]
    fn run<T: Task<Self>>(task: T, _group: usize) {
        if is_wide() {
            in_wide(With(task, OneByOne::<true>, PhantomData));
        } else {
            task.run(OneByOne::<false>);
        }
    }
}

impl Fused for f64 {
    type Stored = [f64; 8];
    type Small = Small<f64>;

    #[inline(always)]
    fn rounded(self) -> f64 {
        self
    }

    #[inline(always)]
    fn plus_product(self, a: Self, b: Self, fused: bool) -> Self {
        if fused { a.mul_add(b, self) } else { self + a * b }
    }

    #[allow(private_bounds)]
    #[inline]
    fn run<T: Task<f64>>(task: T, group: usize) {
        in_widest(task, group);
    }
}

#[cfg(target_arch = "x86_64")]
#[inline]
fn in_widest<S: Fused, T: Task<S>>(task: T, group: usize)
where
    Permuting: Pick<S>,
{
    match widest() {
        pulp::Arch::V4(widest) if group == 8 => {
            pulp::Simd::vectorize(widest, With(task, Permuting(widest), PhantomData));
        }
        other => otherwise(other, task),
    }
}

#[cfg(not(target_arch = "x86_64"))]
#[inline]
fn in_widest<S: Fused, T: Task<S>>(task: T, _group: usize) {
    otherwise(widest(), task);
}

/// A separate function, so that its stack frame is not needed for the widest registers.
#[inline(never)]
fn otherwise<S: Fused>(arch: pulp::Arch, task: impl Task<S>) {
    match arch {
        #[cfg(target_arch = "x86_64")]
        pulp::Arch::V3(wide) => pulp::Simd::vectorize(wide, With(task, OneByOne::<true>, PhantomData)),
        // a task that does not fill the widest registers needs no code for them
        #[cfg(target_arch = "x86_64")]
        pulp::Arch::V4(widest) => pulp::Simd::vectorize(*widest, With(task, OneByOne::<true>, PhantomData)),
        #[cfg(not(target_arch = "x86_64"))]
        wide if !matches!(wide, pulp::Arch::Scalar) => wide.dispatch(With(task, OneByOne::<true>, PhantomData)),
        _ => task.run(OneByOne::<false>),
    }
}

/// Whether the processor has SIMD registers with fused multiply-add.
pub(crate) fn is_wide() -> bool {
    !matches!(widest(), pulp::Arch::Scalar)
}

/// Runs work on a batch if the processor [has such registers](is_wide); otherwise does nothing.
#[inline]
pub(crate) fn in_wide(work: impl pulp::WithSimd<Output = ()>) {
    match widest() {
        #[cfg(target_arch = "x86_64")]
        pulp::Arch::V3(wide) => pulp::Simd::vectorize(wide, work),
        #[cfg(target_arch = "x86_64")]
        pulp::Arch::V4(widest) => pulp::Simd::vectorize(widest, work),
        #[cfg(not(target_arch = "x86_64"))]
        wide if !matches!(wide, pulp::Arch::Scalar) => wide.dispatch(work),
        _ => (),
    }
}

/// The widest SIMD level of the processor, determined once.
#[inline]
pub(crate) fn widest() -> pulp::Arch {
    static FOUND: OnceLock<pulp::Arch> = OnceLock::new();
    *FOUND.get_or_init(pulp::Arch::new)
}

struct With<T, P, S>(T, P, PhantomData<S>);

impl<S: Fused, T: Task<S>, P: Pick<S> + Pick<f64>> pulp::WithSimd for With<T, P, S> {
    type Output = ();

    #[inline(always)]
    fn with_simd<I: pulp::Simd>(self, _: I) {
        self.0.run(self.1);
    }
}
