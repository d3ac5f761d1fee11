//! An upper bound of the spectral radius of a matrix, by Gelfand's formula: |J^16|^(1/16) tends to it from above.

/// The number of squarings. Four give the largest eigenvalue closely; a plain norm would depend on the units of the
/// components.
const SQUARINGS: u32 = 4;

/// The buffers of the squarings.
pub(crate) struct SpectralRadius {
    size: usize,
    power: Vec<f64>,
    square: Vec<f64>,
}

impl SpectralRadius {
    pub fn new(size: usize) -> Self {
        SpectralRadius { size, power: vec![0.0; size * size], square: vec![0.0; size * size] }
    }

    /// An upper bound close to the spectral radius of an n x n matrix in row order. Every power is scaled to norm 1 against overflow.
    pub fn radius(&mut self, matrix: &[f64]) -> f64 {
        let n = self.size;
        self.power.copy_from_slice(matrix);
        self.cut_off();
        let mut logarithm = self.normalise().ln();
        for squaring in 1..=SQUARINGS {
            self.square.fill(0.0);
            for (out, row) in self.square.chunks_mut(n).zip(self.power.chunks(n)) {
                // many entries are zero in sparsely coupled systems
                for (factor, other) in row.iter().zip(self.power.chunks(n)).filter(|(factor, _)| **factor != 0.0) {
                    out.iter_mut().zip(other).for_each(|(out, entry)| *out += factor * entry);
                }
            }
            std::mem::swap(&mut self.power, &mut self.square);
            logarithm += self.normalise().ln() / f64::from(1_u32 << squaring);
        }
        logarithm.exp()
    }

    /// Removes the couplings of states on which no other state depends (such as the work done by a force), or which
    /// depend on no other: they do not change the eigenvalues, but enter the powers of the matrix.
    fn cut_off(&mut self) {
        let n = self.size;
        let mut is_open = true;
        while std::mem::take(&mut is_open) {
            for state in 0..n {
                let others = || (0..n).filter(|&other| other != state);
                let is_asked = others().any(|other| self.power[other * n + state] != 0.0);
                let asks = others().any(|other| self.power[state * n + other] != 0.0);
                if is_asked != asks {
                    is_open = true;
                    others().for_each(|other| {
                        self.power[other * n + state] = 0.0;
                        self.power[state * n + other] = 0.0;
                    });
                }
            }
        }
    }

    /// Divides the power by its largest row sum, and returns this sum.
    fn normalise(&mut self) -> f64 {
        let sums = self.power.chunks(self.size).map(|row| row.iter().map(|x| x.abs()).sum::<f64>());
        let norm = sums.fold(0.0, f64::max);
        if norm > 0.0 {
            self.power.iter_mut().for_each(|entry| *entry /= norm);
        }
        norm
    }
}

#[cfg(test)]
mod tests {
    use super::SpectralRadius;

    #[test]
    fn an_oscillator_has_its_frequency_for_radius_in_any_units() {
        let radius = SpectralRadius::new(2).radius(&[0.0, 1.0, -9e4, 0.0]);
        assert!((299.9..450.0).contains(&radius), "{radius}");
    }

    #[test]
    fn a_work_beside_the_motion_does_not_count() {
        // the last state is a work of size 1e76; no rate depends on it
        let radius = SpectralRadius::new(3).radius(&[0.0, 1.0, 0.0, -100.0, 0.2, 0.0, 0.0, 1e76, 0.0]);
        assert!((9.9..20.0).contains(&radius), "{radius}");
    }

    #[test]
    fn a_nilpotent_matrix_has_radius_zero() {
        assert_eq!(SpectralRadius::new(2).radius(&[0.0, 5.0, 0.0, 0.0]), 0.0);
    }
}
