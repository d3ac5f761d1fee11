//! Rows of a run beside singular positions of the constraints, where reactions are limits.

use super::problem::Row;

/// The part of the largest value at nodes by which polynomials through all of them and through the inner ones may differ, and by which the
/// value at the nearest node may differ from the polynomial through the others.
const INTERPOLATED: f64 = 1e-3;

/// The row beside a singular position: the state as it is, and the quantities computed from it by the polynomial through their values at
/// nodes, since reactions at the state itself are not accurate. NaN where they have no limit, as the multiplier of a constraint whose
/// gradient is zero at the position.
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
        // an odd pole has the polynomial zero through nodes on both sides, which none of its values obeys
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

    /// Nodes at four times on either side of zero, of a state that is the time.
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
