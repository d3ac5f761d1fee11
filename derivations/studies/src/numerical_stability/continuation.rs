//! Something that depends on a step, followed from short steps to long ones.
//!
//! Far from the law's motion a splitting may have several of its own. The one that is meant is that which comes out of the law's as
//! the step grows: each is looked for from that of the step before, over steps between where it is not found at once, and none is
//! looked for beyond the step at which it is lost.

/// Halvings of the way from one step to the next, as ratios.
const HALVINGS: u32 = 4;

/// What is found at steps, s, in ascending order, at some between them too. `find` begins with what was found before, if anything was.
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

/// The last up to a step, s; the first where there is none.
pub fn before<T>(found: &[(f64, T)], step: f64) -> Option<&T> {
    let up_to = found.partition_point(|(at, _)| *at <= step);
    found.get(up_to.saturating_sub(1)).map(|(_, own)| own)
}
