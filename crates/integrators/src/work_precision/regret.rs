//! The regret of a choice of method, its cost over that of the best: over many problems, for one method that serves
//! them all.
//!
//! The cost of a method at an error is read off its measured points, straight between neighbours where both axes are
//! logarithms, and never beyond them: a method that was not seen to reach an error has no cost there. Its regret on a
//! problem is its cost over the least of all methods; the best single choice serves most problems, with the least of the
//! largest regrets.

/// A measured run: its cost and its error, or none if it failed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trial {
    pub cost: f64,
    pub error: Option<f64>,
}

/// The least cost of an error by the trials of one method.
pub fn cost(trials: &[Trial], error: f64) -> Option<f64> {
    let known =
        |trial: &Trial| Some((trial.cost, trial.error?)).filter(|(cost, error)| cost.is_finite() && *error >= 0.0);
    let mut points: Vec<(f64, f64)> = trials.iter().filter_map(known).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let reached = points.iter().position(|(_, found)| *found <= error)?;
    let (dear, exact) = points[reached];
    let Some(&(cheap, rough)) = reached.checked_sub(1).and_then(|before| points.get(before)) else { return Some(dear) };
    // the better point may have an error of zero: nothing is read between
    if exact <= 0.0 {
        return Some(dear);
    }
    let share = (rough / error).ln() / (rough / exact).ln();
    Some(cheap * (dear / cheap).powf(share))
}

/// Costs of methods (rows) on problems (columns); none where the error was not reached.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Regrets {
    /// Cost over the least cost in the column.
    pub rows: Vec<Vec<Option<f64>>>,
    /// The cheapest method of each column.
    pub best: Vec<Option<usize>>,
}

impl Regrets {
    /// The regrets by costs.
    pub fn of(costs: &[Vec<Option<f64>>]) -> Self {
        let columns = costs.iter().map(Vec::len).max().unwrap_or(0);
        let entry = |row: usize, column: usize| costs[row].get(column).copied().flatten();
        let best: Vec<Option<usize>> = (0..columns)
            .map(|column| {
                let known = (0..costs.len()).filter(|&row| entry(row, column).is_some());
                known.min_by(|&a, &b| {
                    entry(a, column).partial_cmp(&entry(b, column)).unwrap_or(std::cmp::Ordering::Equal)
                })
            })
            .collect();
        let regret = |row: usize, column: usize| Some(entry(row, column)? / entry(best[column]?, column)?);
        let rows = (0..costs.len()).map(|row| (0..columns).map(|column| regret(row, column)).collect()).collect();
        Regrets { rows, best }
    }

    /// The number of problems on which a method reached the error.
    pub fn served(&self, row: usize) -> usize {
        self.rows[row].iter().flatten().count()
    }

    /// The largest regret of a method where it reached the error; none where it never did.
    pub fn largest(&self, row: usize) -> Option<f64> {
        self.rows[row].iter().flatten().copied().reduce(f64::max)
    }

    /// The method that serves most problems, and of these the one with the least of the largest regrets.
    pub fn best_single_choice(&self) -> Option<usize> {
        let all = (0..self.rows.len()).filter_map(|row| Some((row, self.served(row), self.largest(row)?)));
        all.min_by(|a, b| b.1.cmp(&a.1).then(a.2.total_cmp(&b.2))).map(|(row, ..)| row)
    }
}
