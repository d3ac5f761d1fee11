//! The current parts of the page, each with the version of its last change; open pages ask for newer parts.

use charts::page::live::{Part, Shown};
use serde_json::{Map, Value, json};
use std::borrow::Cow;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// The state of the page, shared by the session, which writes, and connections, which read.
#[derive(Default)]
pub struct Board {
    state: Mutex<State>,
    changed: Condvar,
}

#[derive(Default)]
struct State {
    version: u64,
    parts: [Entry; Part::ALL.len()],
    /// The values that sliders were moved to.
    values: Map<String, Value>,
    values_changed: u64,
    has_ended: bool,
}

/// A part with the versions in which its pieces changed.
#[derive(Default)]
struct Entry {
    shown: Shown,
    content_changed: u64,
    fault_changed: u64,
    changed: u64,
}

/// News for a page.
pub enum News {
    /// The parts that changed, as one object for the page's script, with the new version.
    Version(u64, Value),
    /// Nothing changed meanwhile.
    None,
    /// The session is over.
    End,
}

impl Board {
    fn locked(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Changes a part.
    pub fn change(&self, part: Part, change: impl FnOnce(&mut Shown)) {
        let mut state = self.locked();
        let next = state.version + 1;
        let Some(entry) = Part::ALL.iter().position(|own| *own == part).map(|place| &mut state.parts[place]) else {
            return;
        };
        let before = entry.shown.clone();
        change(&mut entry.shown);
        for text in [&mut entry.shown.content, &mut entry.shown.fault] {
            // texts of the file are made harmless
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

    /// The values that sliders were moved to.
    pub fn set_values(&self, values: Map<String, Value>) {
        let mut state = self.locked();
        if state.values != values {
            state.version += 1;
            (state.values, state.values_changed) = (values, state.version);
            self.changed.notify_all();
        }
    }

    /// Ends the session for every open page.
    pub fn end(&self) {
        self.locked().has_ended = true;
        self.changed.notify_all();
    }

    /// The values that sliders were moved to, which a page that opens later shows too.
    pub fn values(&self) -> Map<String, Value> {
        self.locked().values.clone()
    }

    /// All parts, and their version.
    pub fn shown(&self) -> (u64, Vec<(Part, Shown)>) {
        let state = self.locked();
        let parts = Part::ALL.iter().zip(&state.parts).map(|(part, entry)| (*part, entry.shown.clone()));
        (state.version, parts.collect())
    }

    /// The changes since a version, after waiting for one at most `patience`.
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
