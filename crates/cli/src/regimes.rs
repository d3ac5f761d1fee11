//! `dalembert regimes`: every consistent regime of a scene with rough contacts at its start.

use crate::arguments::Format;
use crate::ending::{Ending, print};
use clap::Args;
use derivations::friction::log::{Names, describe};
use derivations::friction::{ForRough, RoughScene};
use derivations::scene::Family;
use mechanics::constrained::State;
use mechanics::constrained::contacts::Contacts;
use mechanics::regimes::{Dry, Found, Touch, Verdict, conditions, consistent, posed, verdict};
use serde_json::{Value, json};
use std::fmt::{Display, Write};
use std::path::PathBuf;

/// Whose regimes are to be found.
#[derive(Args, Debug)]
pub struct Asked {
    /// The scene, a TOML file; the folder `scenes/friction` holds examples
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// How to print them
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// Prints the consistent regimes at the start of a scene.
pub fn show(asked: &Asked) -> Result<Ending, Ending> {
    let scene = RoughScene::open(&asked.scene)?;
    let answer = scene.apply(Start);
    print(&match asked.format {
        Format::Text => format!("{}\n{}", scene.title, answer.text()),
        Format::Json => format!("{:#}\n", answer.object(&scene.title)),
    })?;
    Ok(if answer.determined { Ending::Done } else { Ending::Stopped })
}

/// What is consistent at the start.
struct Answer {
    regimes: Vec<Regime>,
    verdict: String,
    determined: bool,
}

/// A regime with its conditions: the contact, what is asked, and by how much it is met.
struct Regime {
    name: String,
    margins: Vec<(String, String, f64)>,
    reactions_determined: bool,
}

impl Answer {
    fn none(reason: &impl Display) -> Self {
        Answer { regimes: Vec::new(), verdict: format!("no regime: {reason}"), determined: false }
    }

    fn text(&self) -> String {
        let mut text = String::new();
        // writing to a String cannot fail
        for Regime { name, margins, reactions_determined } in &self.regimes {
            let _ = writeln!(text, "\n{name}");
            for (contact, condition, margin) in margins {
                let _ = writeln!(text, "  {contact:<8} {condition:<28} {margin:>14.6}");
            }
            if !reactions_determined {
                let _ = writeln!(text, "  the reactions are not determined by the motion: these are possible ones");
            }
        }
        let _ = writeln!(text, "\nverdict: {}", self.verdict);
        text
    }

    fn object(&self, title: &str) -> Value {
        let regimes = self.regimes.iter().map(|regime| {
            let margins = regime.margins.iter().map(
                |(contact, condition, margin)| json!({ "contact": contact, "condition": condition, "margin": margin }),
            );
            json!({
                "regime": regime.name, "margins": margins.collect::<Vec<_>>(),
                "reactions_determined": regime.reactions_determined,
            })
        });
        json!({
            "title": title, "regimes": regimes.collect::<Vec<_>>(), "verdict": self.verdict, "determined": self.determined,
        })
    }
}

struct Start;

impl ForRough for Start {
    type Output = Answer;

    fn apply<Q, const N: usize, const C: usize, const K: usize>(
        self,
        system: &Q,
        start: State<f64, N>,
        names: Names<K>,
    ) -> Answer
    where
        Q: Contacts<N, C, K, Given = f64>,
    {
        let (dry, touch) = match posed(system, &start) {
            Ok(posed) => posed,
            Err(unposed) => return Answer::none(&unposed),
        };
        let mut regimes = Vec::new();
        consistent(&dry, &touch, |found| {
            let name = describe(&names, &found.regime);
            let margins = margins(&dry, &touch, &names, &found);
            regimes.push(Regime { name, margins, reactions_determined: found.determined });
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
        Answer { regimes, verdict: said.to_owned(), determined: matches!(verdict, Verdict::Unique(_)) }
    }
}

/// What is asked at each contact, and by how much it is met.
fn margins<const K: usize>(
    dry: &Dry<f64, K>,
    touch: &[Touch; K],
    names: &Names<K>,
    found: &Found<f64, K>,
) -> Vec<(String, String, f64)> {
    let conditions = conditions(dry, touch, &found.regime);
    let of_contacts =
        conditions.iter().enumerate().flat_map(|(k, all)| all.iter().flatten().map(move |each| (k, each)));
    of_contacts
        .map(|(k, (condition, form))| (names[k].to_string(), condition.to_string(), form.at(&found.reactions)))
        .collect()
}
