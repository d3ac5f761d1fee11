//! Static condensation of mu I - J: states whose rate is a multiple of a single other state are eliminated in advance.
//!
//! The coordinates of a mechanism have rates q' = u. Their rows of the Jacobian J have a single entry, so that half of
//! the equations (mu I - J) x = r can be solved at once: x_i = (r_i + c_i x_j) / mu, where the rate of state i is c_i
//! times state j. The other equations are
//!
//!   (mu I - J_kk - J_ke C / mu) x_k = r_k + J_ke r_e / mu,
//!
//! with the states k that are kept and those e that are eliminated (Hairer and Wanner, Solving ODE II, IV.8). If half
//! of the states are eliminated, the remaining elimination costs an eighth. The set e is reused for every J with such
//! rows.

use nalgebra::Complex;

/// A Jacobian, with its rows divided into those of eliminated and of kept states.
#[derive(Clone, Debug)]
pub(crate) struct Condensation {
    states: usize,
    /// Whether a state may be eliminated; false once its row has had other entries.
    allowed: Vec<bool>,
    kept: Vec<usize>,
    eliminated: Vec<Follower>,
    /// J_kk, row by row.
    own: Vec<f64>,
    /// J_ke C, row by row.
    through: Vec<f64>,
    /// J_ke, column by column.
    columns: Vec<f64>,
}

/// An eliminated state: its rate is `factor` times one kept state.
#[derive(Clone, Copy, Debug)]
struct Follower {
    state: usize,
    /// The index of that state among the kept states.
    place: usize,
    /// The factor c.
    factor: f64,
}

impl Condensation {
    pub fn new(states: usize) -> Self {
        Condensation {
            states,
            allowed: vec![true; states],
            kept: Vec::new(),
            eliminated: Vec::new(),
            own: Vec::new(),
            through: Vec::new(),
            columns: Vec::new(),
        }
    }

    /// The number of the remaining equations.
    pub fn size(&self) -> usize {
        self.kept.len()
    }

    /// Sets J, given row by row. The choice of eliminated states is kept from the previous Jacobian where possible.
    pub fn take(&mut self, jacobian: &[f64]) {
        let n = self.states;
        let mut fits = self.kept.len() + self.eliminated.len() == n;
        for follower in &mut self.eliminated {
            let (row, leader) = (&jacobian[follower.state * n..][..n], self.kept[follower.place]);
            follower.factor = row[leader];
            let alone = row.iter().enumerate().all(|(column, entry)| *entry == 0.0 || column == leader);
            self.allowed[follower.state] &= alone;
            fits &= alone;
        }
        if !fits {
            self.part(jacobian);
        }
        let m = self.kept.len();
        for (i, &row) in self.kept.iter().enumerate() {
            let entries = &jacobian[row * n..][..n];
            for (own, &column) in self.own[i * m..].iter_mut().zip(&self.kept) {
                *own = entries[column];
            }
            self.through[i * m..][..m].fill(0.0);
            for (column, follower) in self.columns.chunks_exact_mut(m).zip(&self.eliminated) {
                let entry = entries[follower.state];
                column[i] = entry;
                self.through[i * m + follower.place] += entry * follower.factor;
            }
        }
    }

    /// Chooses the states to eliminate: none of them depends on another.
    fn part(&mut self, jacobian: &[f64]) {
        let n = self.states;
        let (mut leaders, mut leads) = (vec![None; n], vec![false; n]);
        for (state, row) in jacobian.chunks_exact(n.max(1)).enumerate() {
            let mut entries = row.iter().enumerate().filter(|(_, entry)| **entry != 0.0);
            let (Some((leader, _)), None) = (entries.next(), entries.next()) else { continue };
            if self.allowed[state] && leader != state && !leads[state] && leaders[leader].is_none() {
                (leaders[state], leads[leader]) = (Some(leader), true);
            }
        }
        self.kept = (0..n).filter(|state| leaders[*state].is_none()).collect();
        let kept = &self.kept;
        let follower = |(state, leader): (usize, &Option<usize>)| {
            let leader = (*leader)?;
            let place = kept.binary_search(&leader).ok()?;
            Some(Follower { state, place, factor: jacobian[state * n + leader] })
        };
        self.eliminated = leaders.iter().enumerate().filter_map(follower).collect();
        let m = kept.len();
        (self.own, self.through) = (vec![0.0; m * m], vec![0.0; m * m]);
        self.columns = vec![0.0; m * self.eliminated.len()];
    }

    /// The entries of J_kk and of J_ke C as pairs, row by row.
    pub fn entries(&self) -> impl Iterator<Item = (f64, f64)> {
        self.own.iter().copied().zip(self.through.iter().copied())
    }

    /// The right-hand side of the condensed equations, with one entry for each kept state, from `right` with one entry for
    /// each state; `inverse` is 1 / mu.
    pub fn condense(&self, right: &[f64], inverse: f64, condensed: &mut [f64]) {
        condensed.iter_mut().zip(&self.kept).for_each(|(to, &from)| *to = right[from]);
        for (column, follower) in self.columns.chunks_exact(self.size().max(1)).zip(&self.eliminated) {
            let known = inverse * right[follower.state];
            condensed.iter_mut().zip(column).for_each(|(to, entry)| *to += entry * known);
        }
    }

    /// Computes the full solution from the solution of the condensed equations. `right` contains the right-hand side, and is
    /// replaced by the solution; `inverse` is 1 / mu.
    pub fn expand(&self, condensed: &[f64], inverse: f64, right: &mut [f64]) {
        for &Follower { state, place, factor } in &self.eliminated {
            right[state] = inverse * (right[state] + factor * condensed[place]);
        }
        self.kept.iter().zip(condensed).for_each(|(&to, from)| right[to] = *from);
    }

    /// [`Self::condense`] for a complex mu; each pair has the real and the imaginary part.
    pub fn condense_complex(&self, [re, im]: [&[f64]; 2], inverse: Complex<f64>, [to_re, to_im]: [&mut [f64]; 2]) {
        for ((to_re, to_im), &from) in to_re.iter_mut().zip(to_im.iter_mut()).zip(&self.kept) {
            (*to_re, *to_im) = (re[from], im[from]);
        }
        for (column, follower) in self.columns.chunks_exact(self.size().max(1)).zip(&self.eliminated) {
            let known = inverse * Complex::new(re[follower.state], im[follower.state]);
            for ((to_re, to_im), entry) in to_re.iter_mut().zip(to_im.iter_mut()).zip(column) {
                *to_re += entry * known.re;
                *to_im += entry * known.im;
            }
        }
    }

    /// [`Self::expand`] for a complex mu; each pair has the real and the imaginary part.
    pub fn expand_complex(&self, [from_re, from_im]: [&[f64]; 2], inverse: Complex<f64>, [re, im]: [&mut [f64]; 2]) {
        for &Follower { state, place, factor } in &self.eliminated {
            let right = Complex::new(re[state] + factor * from_re[place], im[state] + factor * from_im[place]);
            let solved = inverse * right;
            (re[state], im[state]) = (solved.re, solved.im);
        }
        for (&to, (from_re, from_im)) in self.kept.iter().zip(from_re.iter().zip(from_im)) {
            (re[to], im[to]) = (*from_re, *from_im);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two oscillators coupled by a spring and by friction; coordinates and speeds have different units.
    const COUPLED: [f64; 16] = [0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0, 1.0, -9.0, 4.0, -0.5, 0.25, 3.0, -7.0, 0.125, 0.0];

    #[test]
    fn coordinates_leave_the_equations_of_an_oscillator() {
        let mut condensation = Condensation::new(4);
        condensation.take(&COUPLED);
        assert_eq!(condensation.kept, [2, 3]);
        let states: Vec<usize> = condensation.eliminated.iter().map(|follower| follower.state).collect();
        assert_eq!(states, [0, 1]);
    }

    #[test]
    fn a_row_that_gains_an_entry_stays_in_the_equations() {
        let mut condensation = Condensation::new(4);
        condensation.take(&COUPLED);
        let mut turned = COUPLED;
        turned[0] = 0.1;
        condensation.take(&turned);
        assert_eq!(condensation.kept, [0, 2, 3]);
        condensation.take(&COUPLED);
        assert_eq!(condensation.kept, [0, 2, 3]);
    }

    /// x'' = -x with q' = u, u' = -q: each row has a single entry, but only one of the two states can be eliminated.
    #[test]
    fn rows_that_follow_each_other_do_not_both_go() {
        let mut condensation = Condensation::new(2);
        condensation.take(&[0.0, 1.0, -1.0, 0.0]);
        assert_eq!(condensation.kept, [1]);
    }
}
