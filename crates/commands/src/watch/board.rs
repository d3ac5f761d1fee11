//! The current parts of the page, each with the version of its last change. Open pages request newer parts.

use charts::page::live::{Part, Shown};
use serde_json::{Map, Value, json};
use std::borrow::Cow;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// The largest rounding error of a slider's value, as a fraction of the length of the slider.
const ROUNDED: f64 = 0.01;

/// The state of the page, which the session writes and connections read.
#[derive(Default)]
pub struct Board {
    state: Mutex<State>,
    changed: Condvar,
}

#[derive(Default)]
struct State {
    /// The version of the last change of anything.
    version: u64,
    parts: [Entry; Part::ALL.len()],
    /// The values to which sliders were moved, by the ids of the sliders.
    values: Map<String, Value>,
    /// The version of the last change of the values.
    values_changed: u64,
    /// The ends of each slider, with its id.
    ranges: Vec<(String, [f64; 2])>,
    has_ended: bool,
}

/// A part with the versions at which its content, its fault and anything in it changed.
#[derive(Default)]
struct Entry {
    shown: Shown,
    content_changed: u64,
    fault_changed: u64,
    changed: u64,
}

/// News for an open page.
pub enum News {
    /// The new version, and the changed parts as an object for the script of the page.
    Version(u64, Value),
    /// No change within the waiting time.
    None,
    /// The session has ended.
    End,
}

impl Board {
    fn locked(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Changes a part. Its version increases only if the part differs afterwards.
    pub fn change(&self, part: Part, change: impl FnOnce(&mut Shown)) {
        let mut state = self.locked();
        let next = state.version + 1;
        let Some(entry) = Part::ALL.iter().position(|own| *own == part).map(|place| &mut state.parts[place]) else {
            return;
        };
        let before = entry.shown.clone();
        change(&mut entry.shown);
        for text in [&mut entry.shown.content, &mut entry.shown.fault] {
            // texts of the file may contain control characters
            if let Cow::Owned(visible) = charts::visible(text) {
                *text = visible;
            }
        }
        if entry.shown == before {
            return;
        }
        if entry.shown.content != before.content {
            entry.content_changed = next;
        }
        if entry.shown.fault != before.fault {
            entry.fault_changed = next;
        }
        entry.changed = next;
        state.version = next;
        self.changed.notify_all();
    }

    /// Stores the values to which sliders were moved.
    pub fn set_values(&self, values: Map<String, Value>) {
        let mut state = self.locked();
        if state.values != values {
            state.version += 1;
            (state.values, state.values_changed) = (values, state.version);
            self.changed.notify_all();
        }
    }

    /// Stores the ends of each slider, with its id.
    pub fn set_ranges(&self, ranges: Vec<(String, [f64; 2])>) {
        self.locked().ranges = ranges;
    }

    /// The reason for which sliders cannot have these values; `None` where they can.
    pub fn objection(&self, values: &Map<String, Value>) -> Option<String> {
        let state = self.locked();
        let of_one = |(id, value): (&String, &Value)| {
            let known = state.ranges.iter().find(|(known, _)| known == id);
            let Some((_, [low, high])) = known else {
                let known: Vec<&str> = state.ranges.iter().map(|(id, _)| id.as_str()).collect();
                let known = if known.is_empty() { "none".to_owned() } else { known.join(", ") };
                return Some(format!("no slider is called `{id}`; sliders of the present text: {known}"));
            };
            // a value that was rounded to a step of its slider may lie slightly beyond the end
            let room = ROUNDED * (high - low);
            let value = value.as_f64().unwrap_or(f64::NAN);
            let is_within = (low - room..=high + room).contains(&value);
            (!is_within).then(|| format!("{id}: {value}; a number from {low} to {high} is accepted"))
        };
        values.iter().find_map(of_one)
    }

    /// Ends the session of all open pages.
    pub fn end(&self) {
        self.locked().has_ended = true;
        self.changed.notify_all();
    }

    /// The values to which sliders were moved; a page that is opened later shows them too.
    pub fn values(&self) -> Map<String, Value> {
        self.locked().values.clone()
    }

    /// The present version and all parts.
    pub fn shown(&self) -> (u64, Vec<(Part, Shown)>) {
        let state = self.locked();
        let parts = Part::ALL.iter().zip(&state.parts).map(|(part, entry)| (*part, entry.shown.clone()));
        (state.version, parts.collect())
    }

    /// The changes since a version; waits for a change for at most `patience`.
    pub fn since(&self, version: u64, patience: Duration) -> News {
        let state = self.locked();
        let waits = |state: &mut State| state.version <= version && !state.has_ended;
        let waited = self.changed.wait_timeout_while(state, patience, waits);
        let (state, _) = waited.unwrap_or_else(PoisonError::into_inner);
        match () {
            () if state.version > version => News::Version(state.version, state.news(version)),
            () if state.has_ended => News::End,
            () => News::None,
        }
    }
}

impl State {
    fn news(&self, version: u64) -> Value {
        let changed = Part::ALL.iter().zip(&self.parts).filter(|(_, entry)| entry.changed > version);
        let parts: Vec<Value> = changed
            .map(|(part, entry)| {
                let mut told = json!({ "part": part.id(), "state": entry.shown.freshness.name() });
                if entry.content_changed > version {
                    told["content"] = json!(entry.shown.content);
                }
                if entry.fault_changed > version {
                    told["fault"] = json!(entry.shown.fault);
                }
                told
            })
            .collect();
        let mut news = json!({ "parts": parts });
        if self.values_changed > version {
            news["values"] = self.values.clone().into();
        }
        news
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use charts::page::live::Freshness;

    fn news(board: &Board, version: u64) -> (u64, Value) {
        match board.since(version, Duration::ZERO) {
            News::Version(version, news) => (version, news),
            News::None => (version, Value::Null),
            News::End => (u64::MAX, Value::Null),
        }
    }

    #[test]
    fn unknown_sliders_and_values_beyond_their_ends_are_refused() {
        let board = Board::default();
        board.set_ranges(vec![("parameters.m".into(), [0.02, 2.0])]);
        let objection = |id: &str, value: f64| board.objection(&Map::from_iter([(id.to_owned(), json!(value))]));
        assert_eq!(objection("parameters.m", 2.0), None);
        assert!(objection("parameters.m", -1.0).is_some_and(|why| why.contains("from 0.02 to 2")));
        assert!(
            objection("parameters.x", 1.0)
                .is_some_and(|why| why.contains("`parameters.x`") && why.contains("parameters.m"))
        );
    }

    #[test]
    fn a_page_is_told_what_changed_since_its_version_alone() {
        let board = Board::default();
        board.change(Part::Motion, |shown| shown.content = "a".into());
        let (first, told) = news(&board, 0);
        assert_eq!(told["parts"], json!([{ "part": "motion", "state": "absent", "content": "a" }]));
        board.change(Part::Motion, |shown| shown.freshness = Freshness::Earlier);
        let (second, told) = news(&board, first);
        assert_eq!(told["parts"], json!([{ "part": "motion", "state": "earlier" }]));
        board.change(Part::Motion, |shown| shown.freshness = Freshness::Earlier);
        assert_eq!(news(&board, second), (second, Value::Null));
        board.end();
        assert_eq!(news(&board, second).0, u64::MAX);
    }
}
