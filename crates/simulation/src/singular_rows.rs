//! Rows of a run near singular positions of the constraints, where reactions are limits.

use super::problem::Row;

/// The largest relative difference between the polynomials through all nodes and through the inner ones, and between
/// the value at the nearest node and the polynomial through the others, for the interpolation to be accepted.
const INTERPOLATED: f64 = 1e-3;

/// The row near a singular position: the state itself, and the quantities computed from it by polynomial interpolation
/// between `nodes`, since reactions at the state itself are inaccurate. NaN where they have no limit, such as the
/// multiplier of a constraint whose gradient vanishes at the position.
pub(super) fn interpolated(row: &Row, (time, state): (f64, &[f64]), nodes: &[(f64, Vec<f64>)]) -> Vec<f64> {
    let mut own = row(time, state);
    let rows: Vec<Vec<f64>> = nodes.iter().map(|(time, state)| row(*time, state)).collect();
    let weight = |at: f64, place: usize, among: &[usize]| {
        let others = among.iter().filter(|other| **other != place);
        others.map(|&other| (at - nodes[other].0) / (nodes[place].0 - nodes[other].0)).product::<f64>()
    };
    let mut near: Vec<usize> = (0..nodes.len()).collect();
    near.sort_by(|&one, &other| (nodes[one].0 - time).abs().total_cmp(&(nodes[other].0 - time).abs()));
    let inner = &near[..near.len() - near.len() / 4];
    for (place, value) in own.iter_mut().enumerate().skip(state.len()) {
        let through = |at: f64, among: &[usize]| {
            among.iter().map(|&node| weight(at, node, among) * rows[node][place]).sum::<f64>()
        };
        let largest = rows.iter().fold(0.0, |largest: f64, row| largest.max(row[place].abs()));
        let [all, of_inner] = [through(time, &near), through(time, inner)];
        // for an odd pole, nodes on both sides give the polynomial zero, which none of the values satisfies
        let obeys = near.split_first().is_none_or(|(&nearest, others)| {
            (rows[nearest][place] - through(nodes[nearest].0, others)).abs() <= INTERPOLATED * largest
        });
        let has_limit = obeys && (all - of_inner).abs() <= INTERPOLATED * largest;
        *value = if has_limit { all } else { f64::NAN };
    }
    own
}

#[cfg(test)]
mod tests {
    use super::interpolated;

    /// Nodes at four times on either side of zero, with the time as state.
    fn nodes() -> Vec<(f64, Vec<f64>)> {
        (1..=4)
            .flat_map(|node| [-0.001, 0.001].map(|step| f64::from(node) * step))
            .map(|time| (time, vec![time]))
            .collect()
    }

    #[test]
    fn a_quantity_that_rounding_spoils_has_its_limit() {
        let sinc = |_: f64, state: &[f64]| vec![state[0], state[0].sin() / state[0]];
        let row = interpolated(&sinc, (0.0, &[0.0]), &nodes());
        assert!(row[0] == 0.0 && (row[1] - 1.0).abs() < 1e-12, "{row:?}");
    }

    #[test]
    fn a_quantity_without_a_limit_is_no_number() {
        let pole = |_: f64, state: &[f64]| vec![state[0], 1.0 / state[0]];
        assert!(interpolated(&pole, (1e-9, &[1e-9]), &nodes())[1].is_nan());
    }
}
