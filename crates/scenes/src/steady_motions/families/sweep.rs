//! Pairs of touching boxes by a sweep along one unknown (sweep and prune), which is fast for many thousand pieces.

use std::f64::consts::TAU;

/// The intervals of boxes along the unknown of the sweep.
pub(super) struct Sweep {
    /// Lower and upper end of each interval with the index of its box, in ascending order of the lower ends.
    entries: Vec<([f64; 2], usize)>,
    boxes: usize,
}

impl Sweep {
    /// A sweep along the unknown in which the boxes are narrowest relative to the range of all. Angles (`is_circle`) are compared up to whole turns.
    pub fn of(boxes: &[Vec<[f64; 2]>], is_circle: impl Fn(usize) -> bool) -> Self {
        let spread = |k: usize| {
            let [low, high] = boxes
                .iter()
                .fold([f64::INFINITY, f64::NEG_INFINITY], |all, at| [all[0].min(at[k][0]), all[1].max(at[k][1])]);
            let widths: f64 = boxes.iter().map(|at| at[k][1] - at[k][0]).sum();
            if widths > 0.0 { (high - low) / widths } else { high - low }
        };
        let sides = boxes.first().map_or(0, Vec::len);
        let along = (0..sides).max_by(|&a, &b| spread(a).total_cmp(&spread(b)));
        let mut entries: Vec<([f64; 2], usize)> = Vec::new();
        for (own, at) in boxes.iter().enumerate() {
            match along {
                None => entries.push(([0.0; 2], own)),
                Some(k) if is_circle(k) => {
                    let low = at[k][0].rem_euclid(TAU);
                    let ends = [low - ROUNDING, low + at[k][1] - at[k][0] + ROUNDING];
                    entries.push((ends, own));
                    // a part beyond a turn touches the first boxes
                    entries.extend((ends[1] >= TAU - ROUNDING).then_some((ends.map(|end| end - TAU), own)));
                }
                Some(k) => entries.push((at[k], own)),
            }
        }
        entries.sort_by(|a, b| a.0[0].total_cmp(&b.0[0]));
        Sweep { entries, boxes: boxes.len() }
    }

    /// Whether `accepts` is true for some pair of boxes whose intervals meet.
    pub fn any_pair(&self, mut accepts: impl FnMut(usize, usize) -> bool) -> bool {
        let mut open: Vec<([f64; 2], usize)> = Vec::new();
        self.entries.iter().any(|&(ends, own)| {
            open.retain(|(known, _)| known[1] >= ends[0]);
            let is_found = open.iter().any(|&(_, other)| other != own && accepts(other, own));
            open.push((ends, own));
            is_found
        })
    }

    /// For each box the number of its group; boxes connected by a chain of touching ones form a group.
    pub fn groups(&self, touch: impl Fn(usize, usize) -> bool) -> Vec<usize> {
        let mut of: Vec<usize> = (0..self.boxes).collect();
        self.any_pair(|one, other| {
            let [one_root, other_root] = [root(&mut of, one), root(&mut of, other)];
            if one_root != other_root && touch(one, other) {
                of[one_root.max(other_root)] = one_root.min(other_root);
            }
            false
        });
        (0..self.boxes).map(|own| root(&mut of, own)).collect()
    }
}

/// Tolerance for the rounding of whole turns.
const ROUNDING: f64 = 1e-9;

/// The first box of the group, with path compression (union-find).
fn root(of: &mut [usize], mut own: usize) -> usize {
    while of[own] != own {
        of[own] = of[of[own]];
        own = of[own];
    }
    own
}

#[cfg(test)]
mod tests {
    use super::Sweep;

    fn groups(boxes: &[Vec<[f64; 2]>], is_circle: bool) -> Vec<usize> {
        let touch = |one: usize, other: usize| {
            boxes[one]
                .iter()
                .zip(&boxes[other])
                .enumerate()
                .all(|(k, (a, b))| (is_circle && k == 0) || a[0] <= b[1] && b[0] <= a[1])
        };
        Sweep::of(boxes, |k| is_circle && k == 0).groups(touch)
    }

    #[test]
    fn two_chains_of_many_boxes_are_two_groups() {
        let chain = |y: f64| (0..4_000).map(move |k| vec![[f64::from(k), f64::from(k + 1)], [y, y + 1.0]]);
        let boxes: Vec<Vec<[f64; 2]>> = chain(0.0).chain(chain(5.0)).collect();
        let found = groups(&boxes, false);
        assert!(found[..4_000].iter().all(|own| *own == 0) && found[4_000..].iter().all(|own| *own == 4_000));
    }

    #[test]
    fn boxes_on_both_sides_of_the_cut_of_a_circle_touch() {
        let boxes = vec![vec![[-3.2, -3.0]], vec![[1.0, 1.5]], vec![[2.9, 3.1]]];
        assert_eq!(groups(&boxes, true), [0, 1, 0]);
        // the cut of the sweep itself, at zero
        let boxes = vec![vec![[-0.5, 0.0]], vec![[0.0, 0.5]], vec![[2.0, 2.5]]];
        assert_eq!(groups(&boxes, true), [0, 0, 2]);
    }
}
