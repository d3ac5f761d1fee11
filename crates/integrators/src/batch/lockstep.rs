//! The classical Runge-Kutta method with constant steps on a batch of systems of one kind, one system in each lane.

use crate::Ode;
use field::Batch;
use pulp::{Arch, Simd, WithSimd};

/// Buffers of the method. Each step uses the widest SIMD registers of the processor. Lanes are independent.
///
/// `FUSED` selects numbers with a fused multiply-add, which are faster where [`fuses`] is true; elsewhere numbers
/// without it are faster. The law must be `#[inline(always)]` throughout: otherwise it is compiled for narrow registers
/// and runs six times slower.
#[derive(Clone, Debug)]
pub struct BatchRungeKutta4<const L: usize, const FUSED: bool> {
    /// k1, k2, k3, k4. They are stored until the step is complete: this takes fewer stores than a running sum.
    slopes: [Vec<Batch<L, FUSED>>; 4],
    stage: Vec<Batch<L, FUSED>>,
}

/// Whether this processor has a fused multiply-add instruction.
pub fn fuses() -> bool {
    !matches!(Arch::new(), Arch::Scalar)
}

impl<const L: usize, const FUSED: bool> BatchRungeKutta4<L, FUSED> {
    /// Buffers for a system with `dimension` states.
    pub fn new(dimension: usize) -> Self {
        let room = || vec![Batch::all(0.0); dimension];
        BatchRungeKutta4 { slopes: std::array::from_fn(|_| room()), stage: room() }
    }

    /// Makes `steps` steps of size `step` from the time `start` (s), and overwrites `state`. Allocates no memory.
    /// States beyond the dimension of the buffers are unchanged.
    pub fn steps(
        &mut self,
        law: &impl Ode<Batch<L, FUSED>>,
        start: f64,
        step: f64,
        steps: usize,
        state: &mut [Batch<L, FUSED>],
    ) {
        Arch::new().dispatch(Steps { law, start, step, steps, state, room: self });
    }
}

struct Steps<'a, O, const L: usize, const FUSED: bool> {
    law: &'a O,
    start: f64,
    step: f64,
    steps: usize,
    state: &'a mut [Batch<L, FUSED>],
    room: &'a mut BatchRungeKutta4<L, FUSED>,
}

impl<O: Ode<Batch<L, FUSED>>, const L: usize, const FUSED: bool> WithSimd for Steps<'_, O, L, FUSED> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let BatchRungeKutta4 { slopes, stage } = self.room;
        let (n, h) = (self.state.len().min(stage.len()), self.step);
        let (state, stage) = (&mut self.state[..n], &mut stage[..n]);
        stage.copy_from_slice(state);
        for number in 0..self.steps {
            let begin = self.start + number as f64 * h;
            let mut time = begin;
            // a single call of the law: it is compiled once
            for (slope, reach) in slopes.iter_mut().zip([h / 2.0, h / 2.0, h, 0.0]) {
                self.law.rates(Batch::all(time), stage, slope);
                time = begin + reach;
                if reach != 0.0 {
                    for ((stage, state), slope) in stage.iter_mut().zip(&*state).zip(&*slope) {
                        *stage = plus(simd, state, reach, slope);
                    }
                }
            }
            let [k1, k2, k3, k4] = &*slopes;
            let inner = k2.iter().zip(k3);
            for ((((state, stage), k1), (k2, k3)), k4) in state.iter_mut().zip(&mut *stage).zip(k1).zip(inner).zip(k4) {
                let outer = plus(simd, k1, 1.0, k4);
                let slope = plus(simd, &plus(simd, &outer, 2.0, k2), 2.0, k3);
                *state = plus(simd, state, h / 6.0, &slope);
                *stage = *state;
            }
        }
    }
}

/// y + h k, by whole registers. A plain loop over lanes would be compiled as a loop over states with slow gather
/// instructions.
#[inline(always)]
fn plus<S: Simd, const L: usize, const FUSED: bool>(
    simd: S,
    y: &Batch<L, FUSED>,
    h: f64,
    k: &Batch<L, FUSED>,
) -> Batch<L, FUSED> {
    let mut sum = *y;
    let (wide, rest) = S::as_mut_simd_f64s(&mut sum.0);
    let (slopes, others) = S::as_simd_f64s(&k.0);
    for (sum, slope) in wide.iter_mut().zip(slopes) {
        let h = simd.splat_f64s(h);
        *sum = if FUSED { simd.mul_add_f64s(h, *slope, *sum) } else { simd.add_f64s(*sum, simd.mul_f64s(h, *slope)) };
    }
    for (sum, slope) in rest.iter_mut().zip(others) {
        *sum = if FUSED { h.mul_add(*slope, *sum) } else { *sum + h * slope };
    }
    sum
}
