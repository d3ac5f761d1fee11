//! The regret of a choice of method: its cost divided by that of the best method, over many problems.
//!
//! The cost of a method at a given error is interpolated linearly between its measured points in logarithmic axes, and
//! never extrapolated. The regret on a problem is the cost divided by the smallest cost of all methods. The best single
//! choice solves the most problems and among those choices has the smallest maximum regret.

/// A measured run: its cost and its error, `None` if it failed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trial {
    pub cost: f64,
    pub error: Option<f64>,
}

/// The smallest cost of an error by the runs of one method; `None` where the error was not reached.
pub fn cost(trials: &[Trial], error: f64) -> Option<f64> {
    let known =
        |trial: &Trial| Some((trial.cost, trial.error?)).filter(|(cost, error)| cost.is_finite() && *error >= 0.0);
    let mut points: Vec<(f64, f64)> = trials.iter().filter_map(known).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let reached = points.iter().position(|(_, found)| *found <= error)?;
    let (dear, exact) = points[reached];
    let Some(&(cheap, rough)) = reached.checked_sub(1).and_then(|before| points.get(before)) else { return Some(dear) };
    // no interpolation to a point with the error zero
    if exact <= 0.0 {
        return Some(dear);
    }
    let share = (rough / error).ln() / (rough / exact).ln();
    Some(cheap * (dear / cheap).powf(share))
}

/// The regrets of methods (rows) on problems (columns); `None` where the error was not reached.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Regrets {
    /// The cost divided by the smallest cost in the column.
    pub rows: Vec<Vec<Option<f64>>>,
    /// The index of the cheapest method of each column.
    pub best: Vec<Option<usize>>,
}

impl Regrets {
    /// The regrets from the costs `costs[method][problem]`; `None` where the error was not reached.
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

    /// The largest regret of a method; `None` where it never reached the error.
    pub fn largest(&self, row: usize) -> Option<f64> {
        self.rows[row].iter().flatten().copied().reduce(f64::max)
    }

    /// The method that solves the most problems, and of these the one with the smallest maximum regret, by its
    /// row; `None` if no method solves a problem.
    pub fn best_single_choice(&self) -> Option<usize> {
        let all = (0..self.rows.len()).filter_map(|row| Some((row, self.served(row), self.largest(row)?)));
        all.min_by(|a, b| b.1.cmp(&a.1).then(a.2.total_cmp(&b.2))).map(|(row, ..)| row)
    }
}
