//! Continuation of a fixed point in the step size, from short steps to long ones.
//!
//! Far from the law's motion a splitting may have several fixed points. The branch that begins at the law's motion for
//! short steps is continued: each search starts from the fixed point of the previous step size, with intermediate step
//! sizes if it fails, and ends where the branch is lost.

/// The largest number of halvings of the ratio of successive step sizes.
const HALVINGS: u32 = 4;

/// The results of `find` at ascending step sizes, s, and at some between them. `find` starts from the previous result,
/// if there is one.
pub fn followed<T>(steps: &[f64], find: impl Fn(f64, Option<&T>) -> Option<T>) -> Vec<(f64, T)> {
    let mut found = Vec::new();
    for step in steps {
        if !reached(&mut found, *step, HALVINGS, &find) {
            break;
        }
    }
    found
}

fn reached<T>(
    found: &mut Vec<(f64, T)>,
    step: f64,
    halvings: u32,
    find: &impl Fn(f64, Option<&T>) -> Option<T>,
) -> bool {
    let before = found.last();
    if let Some(own) = find(step, before.map(|(_, own)| own)) {
        found.push((step, own));
        return true;
    }
    let Some(middle) = before.map(|(at, _)| (at * step).sqrt()).filter(|_| halvings > 0) else { return false };
    reached(found, middle, halvings - 1, find) && reached(found, step, halvings - 1, find)
}

/// The last result up to a step size, s, or the first of all.
pub fn before<T>(found: &[(f64, T)], step: f64) -> Option<&T> {
    let up_to = found.partition_point(|(at, _)| *at <= step);
    found.get(up_to.saturating_sub(1)).map(|(_, own)| own)
}
