//! `dalembert regimes`: every consistent regime of a scene with rough contacts at its start.

use crate::ending::{Ending, print};
use derivations::friction::log::{Names, describe};
use derivations::friction::{ForRough, RoughScene};
use derivations::scene::Family;
use mechanics::constrained::State;
use mechanics::constrained::contacts::Contacts;
use mechanics::regimes::{Dry, Found, Sizes, Touch, Verdict, conditions, consistent, touches, verdict};
use std::fmt::Write;
use std::path::Path;

/// Prints the consistent regimes at the start of a scene.
pub fn show(path: &Path) -> Result<Ending, Ending> {
    let scene = RoughScene::open(path)?;
    let (text, determined) = scene.apply(Regimes);
    print(&format!("{}\n{text}", scene.title))?;
    Ok(if determined { Ending::Done } else { Ending::Stopped })
}

struct Regimes;

impl ForRough for Regimes {
    type Output = (String, bool);

    fn apply<Q, const N: usize, const C: usize, const K: usize>(
        self,
        system: &Q,
        start: State<f64, N>,
        names: Names<K>,
    ) -> (String, bool)
    where
        Q: Contacts<N, C, K, Given = f64>,
    {
        let touch = match touches(system, &start, Sizes::of(&start)) {
            Ok(touch) => touch,
            Err(unfit) => return (format!("no regime: {unfit}\n"), false),
        };
        let dry = match Dry::<f64, K>::of(system, &start, system.force(&start)) {
            Ok(dry) => dry,
            Err(dependent) => return (format!("no regime: {dependent}\n"), false),
        };
        let mut text = String::new();
        consistent(&dry, &touch, |found| {
            // writing to a String cannot fail
            let _ = writeln!(text, "\n{}", describe(&names, &found.regime));
            margins(&mut text, &dry, &touch, &names, &found);
        });
        let verdict = verdict(&dry, &touch);
        let said = match verdict {
            Verdict::Unique(found) if found.tie.is_some() => "one motion, on the boundary of its regime",
            Verdict::Unique(_) => "one motion",
            Verdict::None => "no motion",
            Verdict::Several(..) => "several motions",
            Verdict::Continuum(_) => "motions without end",
            Verdict::Undefined => "the state or the force is not finite",
        };
        let _ = writeln!(text, "\nverdict: {said}");
        (text, matches!(verdict, Verdict::Unique(_)))
    }
}

fn margins<const K: usize>(
    text: &mut String,
    dry: &Dry<f64, K>,
    touch: &[Touch; K],
    names: &Names<K>,
    found: &Found<f64, K>,
) {
    for (k, of_contact) in conditions(dry, touch, &found.regime).iter().enumerate() {
        for (condition, form) in of_contact.iter().flatten() {
            let _ = writeln!(text, "  {:<8} {condition:<28} {:>14.6}", names[k], form.at(&found.reactions));
        }
    }
    if !found.determined {
        let _ = writeln!(text, "  the reactions are not determined by the motion: these are possible ones");
    }
}
