//! Newton's matrix for the stages of a collocation method, I - h A (x) J, and its factorisation.
//!
//! In double precision evaluations are cheap and elimination is expensive: one Jacobian serves all stages and several
//! steps, and the matrix decouples into one block for each eigenvalue of A ([`stage_modes`]). With s stages and n
//! states elimination then costs n^3 for each real eigenvalue and 4 n^3 for each complex pair, instead of (s n)^3. In a
//! finer scalar type an evaluation costs more than the elimination, which remains in double precision: each stage has
//! its own Jacobian, and fewer corrections are needed.

use super::stage_modes::{StageMode, stage_modes};
use crate::newton::{ComplexLu, Condensation, Lu, Shifted};

/// The factorisation of (lambda / h) I - J.
enum Factors {
    Real(Lu),
    Complex(ComplexLu),
}

/// The decoupled matrices, one for each eigenvalue, with buffers.
struct Uncoupled {
    condensation: Condensation,
    /// Whether the Jacobian has not been condensed yet.
    renewed: bool,
    modes: Vec<(StageMode, Factors)>,
    real: Vec<f64>,
    imaginary: Vec<f64>,
    /// Right-hand sides and solutions of the condensed equations.
    left: [Vec<f64>; 2],
    sum: Vec<f64>,
}

pub(crate) struct StageMatrix {
    n: usize,
    matrix: Vec<Vec<f64>>,
    step: f64,
    /// J of the step, or J_j of every stage, row by row.
    jacobians: Vec<f64>,
    uncoupled: Option<Uncoupled>,
    /// The matrix of all stages, where every stage has its own Jacobian.
    whole: Option<Lu>,
    /// The matrix 1/(h g) I - J of the error estimate, for methods without a real eigenvalue.
    filter: Option<Shifted>,
    own_pole: f64,
}

impl StageMatrix {
    /// The matrix for a law with n states. `fine`: every stage has its own Jacobian. The defect is filtered with the
    /// pole 1 / g of a real eigenvalue, or with g = `own_pole` if there is none.
    pub fn new(matrix: Vec<Vec<f64>>, n: usize, fine: bool, own_pole: f64) -> Self {
        let stages = matrix.len();
        let modes = if fine { None } else { stage_modes(&matrix) };
        let one_real = modes.iter().flatten().any(StageMode::is_real);
        let uncoupled = modes.map(|modes| {
            let factors = |mode: StageMode| {
                let real = mode.is_real();
                (mode, if real { Factors::Real(Lu::new(n)) } else { Factors::Complex(ComplexLu::new(n)) })
            };
            Uncoupled {
                condensation: Condensation::new(n),
                renewed: true,
                modes: modes.into_iter().map(factors).collect(),
                real: vec![0.0; n],
                imaginary: vec![0.0; n],
                left: [vec![0.0; n], vec![0.0; n]],
                sum: vec![0.0; stages * n],
            }
        });
        StageMatrix {
            n,
            step: 0.0,
            jacobians: vec![0.0; if uncoupled.is_some() { n * n } else { stages * n * n }],
            whole: if uncoupled.is_some() { None } else { Some(Lu::new(stages * n)) },
            filter: if one_real { None } else { Some(Shifted::new(n)) },
            own_pole,
            matrix,
            uncoupled,
        }
    }

    /// Whether one Jacobian serves all stages, with decoupled equations.
    pub fn is_uncoupled(&self) -> bool {
        self.uncoupled.is_some()
    }

    /// The buffers of the Jacobians, row by row: one, or one for each stage.
    pub fn jacobians(&mut self) -> std::slice::ChunksMut<'_, f64> {
        self.uncoupled.iter_mut().for_each(|uncoupled| uncoupled.renewed = true);
        self.jacobians.chunks_mut(self.n * self.n)
    }

    /// J, or the Jacobian of the first stage.
    pub fn jacobian(&self) -> &[f64] {
        &self.jacobians[..self.n * self.n]
    }

    pub fn is_finite(&self) -> bool {
        self.jacobians.iter().all(|slope| slope.is_finite())
    }

    /// Factorises the matrices for a step size. Returns false if one is singular.
    pub fn factorise(&mut self, step: f64) -> bool {
        self.step = step;
        let n = self.n;
        let whole = self.whole.as_mut().is_none_or(|whole| {
            for (row, entries) in whole.rows().enumerate() {
                let (i, c) = (row / n, row % n);
                for (j, (part, jacobian)) in entries.chunks_mut(n).zip(self.jacobians.chunks(n * n)).enumerate() {
                    let factor = -step * self.matrix[i][j];
                    part.iter_mut().zip(&jacobian[c * n..]).for_each(|(entry, slope)| *entry = factor * slope);
                }
                entries[row] += 1.0;
            }
            whole.factorise()
        });
        let jacobian = &self.jacobians[..n * n];
        let modes = self.uncoupled.as_mut().is_none_or(|Uncoupled { condensation, renewed, modes, .. }| {
            if std::mem::take(renewed) {
                condensation.take(jacobian);
            }
            modes.iter_mut().all(|(mode, factors)| {
                let shift = mode.eigenvalue / step;
                match factors {
                    Factors::Real(lu) => lu.factorise_shifted(shift.re, condensation),
                    Factors::Complex(lu) => lu.factorise(shift, condensation),
                }
            })
        });
        let filter = self.filter.as_mut().is_none_or(|filter| {
            filter.take(jacobian);
            filter.factorise((step * self.own_pole).recip())
        });
        whole && modes && filter
    }

    /// Replaces the residuals of the stages by the corrections; stage j has the entries j n to j n + n - 1.
    pub fn solve(&mut self, residual: &mut [f64]) {
        if let Some(whole) = &mut self.whole {
            whole.solve(residual);
        }
        let n = self.n;
        let Some(Uncoupled { condensation, modes, real, imaginary, left, sum, .. }) = &mut self.uncoupled else {
            return;
        };
        let [left, left_imaginary] = left.each_mut().map(|each| &mut each[..condensation.size()]);
        sum.fill(0.0);
        for (mode, factors) in modes {
            let shift = mode.eigenvalue / self.step;
            real.fill(0.0);
            imaginary.fill(0.0);
            for (part, residual) in mode.part.iter().zip(residual.chunks_exact(n)) {
                let part = part * shift;
                real.iter_mut().zip(residual).for_each(|(sum, residual)| *sum += part.re * residual);
                imaginary.iter_mut().zip(residual).for_each(|(sum, residual)| *sum += part.im * residual);
            }
            match factors {
                Factors::Real(lu) => lu.solve_shifted(shift.re, condensation, left, real),
                Factors::Complex(lu) => {
                    let inverse = shift.inv();
                    condensation.condense_complex([real, imaginary], inverse, [left, left_imaginary]);
                    lu.solve(left, left_imaginary);
                    condensation.expand_complex([left, left_imaginary], inverse, [real, imaginary]);
                }
            }
            for (shape, sum) in mode.shape.iter().zip(sum.chunks_exact_mut(n)) {
                let parts = real.iter().zip(imaginary.iter());
                sum.iter_mut().zip(parts).for_each(|(sum, (re, im))| *sum += shape.re * re - shape.im * im);
            }
        }
        residual.copy_from_slice(sum);
    }

    /// The pole parameter g of [`Self::filter`].
    pub fn pole(&self) -> f64 {
        let real = self.uncoupled.iter().flat_map(|uncoupled| &uncoupled.modes).find(|(mode, _)| mode.is_real());
        real.map_or(self.own_pole, |(mode, _)| mode.eigenvalue.re.recip())
    }

    /// Replaces a defect d by (I - h g J)^-1 d.
    pub fn filter(&mut self, defect: &mut [f64]) {
        if let Some(filter) = &mut self.filter {
            defect.iter_mut().for_each(|entry| *entry /= self.step * self.own_pole);
            return filter.solve(defect);
        }
        let Some(Uncoupled { condensation, modes, left, .. }) = &mut self.uncoupled else { return };
        let real = modes.iter_mut().find_map(|(mode, factors)| match factors {
            Factors::Real(lu) => Some((mode.eigenvalue.re / self.step, lu)),
            Factors::Complex(_) => None,
        });
        if let Some((shift, lu)) = real {
            defect.iter_mut().for_each(|entry| *entry *= shift);
            lu.solve_shifted(shift, condensation, &mut left[0], defect);
        }
    }
}
