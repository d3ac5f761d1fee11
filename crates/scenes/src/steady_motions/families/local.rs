//! Linearisation of underdetermined equations about the middle of a box, preconditioned for the dependent unknowns.

use super::columns::chosen;
use super::pieces::Underdetermined;
use field::Interval;
use nalgebra::DMatrix;

/// Equations f in a box with middle m, multiplied by an approximate inverse C of the derivatives by the dependent unknowns.
pub(super) struct Local {
    pub dependent: Vec<usize>,
    pub parameters: Vec<usize>,
    middle: Vec<f64>,
    /// C f(m).
    pub step: Vec<Interval>,
    /// C f' over the box, row by row, by all unknowns.
    slopes: Vec<Interval>,
    wide: usize,
}

impl Local {
    pub fn of(equations: &mut dyn Underdetermined, at: &[Interval]) -> Option<Self> {
        Self::made(equations, at, None)
    }

    pub fn with(equations: &mut dyn Underdetermined, at: &[Interval], parameters: &[usize]) -> Option<Self> {
        Self::made(equations, at, Some(parameters))
    }

    fn made(equations: &mut dyn Underdetermined, at: &[Interval], parameters: Option<&[usize]>) -> Option<Self> {
        let divided = equations.unknowns()[0];
        let (rows, wide) = (equations.rows(), at.len());
        let mut slopes = vec![Interval::EVERYTHING; rows * wide];
        equations.slopes(at, &mut slopes);
        if slopes.iter().any(|slope| !slope.size().is_finite()) {
            return None;
        }
        let middle: Vec<f64> = at.iter().map(|part| part.middle()).collect();
        let mut values = vec![Interval::EVERYTHING; rows];
        equations.values(&middle.iter().map(|&at| Interval::point(at)).collect::<Vec<_>>(), &mut values);
        let about = |row: usize, column: usize| slopes[row * wide + column].middle();
        let dependent = match parameters {
            Some(parameters) => (0..wide).filter(|k| !parameters.contains(k)).collect(),
            None => chosen([rows, wide], about, divided)?,
        };
        let parameters = (0..wide).filter(|k| !dependent.contains(k)).collect();
        let inverse = DMatrix::from_fn(rows, rows, |row, column| about(row, dependent[column])).try_inverse();
        let inverse = inverse.filter(|inverse| inverse.iter().all(|entry| entry.is_finite()))?;
        let product = |row: usize, of: &dyn Fn(usize) -> Interval| {
            (0..rows).fold(Interval::point(0.0), |sum, k| sum + Interval::point(inverse[(row, k)]) * of(k))
        };
        let step = (0..rows).map(|row| product(row, &|k| values[k])).collect();
        let slopes = (0..rows * wide).map(|at| product(at / wide, &|k| slopes[k * wide + at % wide])).collect();
        Some(Local { dependent, parameters, middle, step, slopes, wide })
    }

    pub fn entry(&self, row: usize, column: usize) -> Interval {
        self.slopes[row * self.wide + column]
    }

    /// The maximum norm of 1 - C f_x, with f_x the derivatives by the dependent unknowns.
    pub fn spread(&self) -> f64 {
        let each = |(row, &place): (usize, &usize)| {
            let entry = |&column: &usize| {
                let own = if column == place { 1.0 } else { 0.0 };
                (Interval::point(own) - self.entry(row, column)).size()
            };
            self.dependent.iter().map(entry).sum::<f64>()
        };
        self.dependent.iter().enumerate().map(each).fold(0.0, f64::max)
    }

    fn aside(&self, at: &[Interval], column: usize) -> Interval {
        at[column] - Interval::point(self.middle[column])
    }

    /// The part of a box that may contain solutions, by the interval Gauss-Seidel method; `None` if it contains none.
    pub fn narrowed(&self, at: &[Interval]) -> Option<Vec<Interval>> {
        let mut left = at.to_vec();
        for (row, &place) in self.dependent.iter().enumerate() {
            let others = (0..self.wide).filter(|&column| column != place);
            let rest =
                others.fold(self.step[row], |sum, column| sum + self.entry(row, column) * self.aside(&left, column));
            let own = self.entry(row, place);
            if !own.contains(0.0) {
                left[place] = left[place].and(Interval::point(self.middle[place]) - rest / own)?;
            } else if !(rest + own * self.aside(&left, place)).contains(0.0) {
                return None;
            }
        }
        Some(left)
    }

    /// The derivatives of all unknowns by each parameter along the solutions. With C f_x = 1 + E and e = |E| in the maximum norm, those of the
    /// dependent unknowns are -C f_t within e |C f_t| / (1 - e). `None` unless e < 1.
    pub fn tangents(&self) -> Option<Vec<Vec<Interval>>> {
        let spread = self.spread();
        let of = |&parameter: &usize| {
            let rows = 0..self.dependent.len();
            let most = rows.map(|row| self.entry(row, parameter).size()).fold(0.0, f64::max);
            let radius = (spread * most / (1.0 - spread)).next_up();
            let mut all = vec![Interval::point(0.0); self.wide];
            all[parameter] = Interval::point(1.0);
            for (row, &place) in self.dependent.iter().enumerate() {
                all[place] = Interval::new(-radius, radius) - self.entry(row, parameter);
            }
            all
        };
        (spread < 1.0).then(|| self.parameters.iter().map(of).collect())
    }

    /// Krawczyk's operator for the dependent unknowns.
    pub fn krawczyk(&self, at: &[Interval]) -> Vec<Interval> {
        let each = |(row, &place): (usize, &usize)| {
            let about = Interval::point(self.middle[place]) - self.step[row];
            (0..self.wide).fold(about, |sum, column| {
                let own = if column == place { Interval::point(1.0) } else { Interval::point(0.0) };
                sum + (own - self.entry(row, column)) * self.aside(at, column)
            })
        };
        self.dependent.iter().enumerate().map(each).collect()
    }
}
