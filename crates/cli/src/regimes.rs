//! Scenes with rough contacts: `dalembert regimes`, and `dalembert run` with its log.

use crate::arguments::{Format, Run as Asked};
use crate::ending::{Ending, print};
use derivations::friction::log::{Names, describe};
use derivations::friction::run::Plan;
use derivations::friction::{Ending as End, ForRough, RoughScene, Run, run as follow};
use integrators::Tolerance;
use mechanics::constrained::State;
use mechanics::constrained::contacts::Contacts;
use mechanics::regimes::{Dry, Found, Sizes, Touch, Verdict, conditions, consistent, touches, verdict};
use serde_json::json;
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

/// Runs a scene and prints its log.
pub fn run(scene: &RoughScene, asked: &Asked) -> Result<Ending, Ending> {
    if asked.model.is_some() || asked.out.is_some() {
        return Err(Ending::refused(
            "a scene with rough contacts has no machine and no table; leave out --model and --out",
        ));
    }
    let own = &scene.plan;
    let plan = Plan {
        method: asked.method.unwrap_or(own.method),
        tolerance: asked.tolerance.map_or(own.tolerance.clone(), Tolerance::both),
        ..own.clone()
    };
    let (text, done) = scene.apply(Follow { plan, title: &scene.title, format: asked.format });
    print(&text)?;
    Ok(if done { Ending::Done } else { Ending::Stopped })
}

struct Follow<'a> {
    plan: Plan,
    title: &'a str,
    format: Format,
}

impl ForRough for Follow<'_> {
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
        let run = follow(system, &start, &self.plan, &mut ());
        let text = match self.format {
            Format::Text => self.text(&run, &names),
            Format::Json => self.json(&run, &names),
        };
        (text, run.ending == End::Reached)
    }
}

impl Follow<'_> {
    fn text<const N: usize, const K: usize>(&self, run: &Run<N, K>, names: &Names<K>) -> String {
        let mut text = format!("{}\n{}\n", self.title, self.plan.method);
        for entry in &run.entries {
            let _ = writeln!(text, "t = {:>12.9} s  {}", entry.time, entry.cause.describe(names));
            let _ = writeln!(text, "{:>20}-> {}", "", describe(names, &entry.regime));
        }
        let _ = writeln!(text, "t = {:>12.9} s  {}", run.state.time, run.ending.describe(names));
        let _ = writeln!(
            text,
            "work of friction {:.9} J; energy balance open by {:.1e} J",
            run.friction_work, run.imbalance
        );
        text
    }

    fn json<const N: usize, const K: usize>(&self, run: &Run<N, K>, names: &Names<K>) -> String {
        let entries = run.entries.iter().map(|entry| {
            json!({
                "time": entry.time, "cause": entry.cause.describe(names), "regime": describe(names, &entry.regime),
                "place": entry.place, "velocity": entry.velocity, "reactions": entry.reactions.to_vec(),
            })
        });
        let object = json!({
            "time": run.state.time,
            "state": { "place": run.state.place.to_vec(), "velocity": run.state.velocity.to_vec() },
            "work": { "rates": run.work.rates, "steps": run.work.steps },
            "invariants": { "energy_balance": run.imbalance },
            "friction_work": run.friction_work,
            "method": self.plan.method.to_string(),
            "log": entries.collect::<Vec<_>>(),
            "ending": run.ending.describe(names),
        });
        format!("{object:#}\n")
    }
}
