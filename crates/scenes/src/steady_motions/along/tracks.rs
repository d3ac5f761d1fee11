//! Motions that belong to each other at neighbouring values of a parameter.

use super::Sample;
use super::change::{distance, unstable};

/// The places of each motion of the first sample in all samples: the nearest one with as many unstable directions.
pub(super) fn tracks(stretch: &[&Sample]) -> Vec<Vec<usize>> {
    let count = stretch[0].found.motions.len();
    let mut all: Vec<Vec<usize>> = (0..count).map(|place| vec![place]).collect();
    for pair in stretch.windows(2) {
        let [before, after] = [&pair[0].found, &pair[1].found];
        let mut free: Vec<usize> = (0..after.motions.len()).collect();
        for track in &mut all {
            let Some(motion) = track.last().and_then(|&place| before.motions.get(place)) else { continue };
            let alike =
                free.iter().enumerate().filter(|&(_, &next)| unstable(&after.motions[next]) == unstable(motion));
            let far = |next: usize| distance(&after.unknowns, &motion.enclosure, &after.motions[next].enclosure);
            let nearest = alike.min_by(|a, b| far(*a.1).total_cmp(&far(*b.1))).map(|(at, _)| at);
            // alike samples have as many motions of each kind
            if let Some(at) = nearest {
                track.push(free.swap_remove(at));
            }
        }
    }
    all.retain(|track| track.len() == stretch.len());
    all
}
