//! Counts of ensemble members that reached the end of their run, and of members that stopped, by reason.

use crate::exit::is_quiet;
use simulation::RunFailure;
use simulation::ensemble::Stopped;
use std::collections::BTreeMap;
use std::path::Path;

/// Counts of members that reached the end and of members that stopped.
#[derive(Default)]
pub struct Fates {
    /// The number of members, whether they stopped or not.
    pub members: u64,
    /// Counts of stopped members by the kind of reason.
    stopped: BTreeMap<String, Counted>,
}

/// The count of members that stopped for reasons of one kind.
struct Counted {
    count: u64,
    /// The number of the first such member.
    member: u64,
    why: String,
}

impl Fates {
    /// Adds a member by its number; `stopped` is the reason for which it stopped, if it did.
    pub fn add(&mut self, member: u64, stopped: Option<&str>) {
        self.members += 1;
        if let Some(why) = stopped {
            let first = || Counted { count: 0, member, why: why.to_owned() };
            self.stopped.entry(Stopped::kind_in(why).to_owned()).or_insert_with(first).count += 1;
        }
    }

    fn stopped(&self) -> u64 {
        self.stopped.values().map(|stopped| stopped.count).sum()
    }

    /// The number of members that reached the end.
    pub fn reached(&self) -> u64 {
        self.members - self.stopped()
    }

    /// The counts as text, with the failures of the first stopped member of each kind. `before` is the number of members of earlier runs.
    pub fn text(&self, path: &Path, before: u64, failures: impl Fn(u64) -> Vec<RunFailure>) -> String {
        let (reached, stopped) = (self.reached(), self.stopped());
        let mut text = format!("{} members: {reached} reached the end, {stopped} did not\n", self.members);
        for Counted { count, member, why } in self.stopped.values() {
            text += &format!("  {count:>8}  such as member {member}: {why}\n");
            for failure in failures(*member) {
                text += &format!("            failure: {failure}\n            remedy: {}\n", failure.remedy);
            }
        }
        if before > 0 {
            text += &format!("the first {before} were there already\n");
        }
        // --quiet prints only results, and the name of the file is not one
        if is_quiet() { text } else { text + &format!("{}\n", path.display()) }
    }
}

#[cfg(test)]
mod tests {
    use super::{Fates, Stopped};
    use integrators::Failure;
    use std::path::Path;

    #[test]
    fn reasons_are_whole_and_counted_by_their_kind() {
        let mut told = Fates::default();
        let [first, second] =
            [2.0, 1.5].map(|value| Stopped::Impossible(format!("A' > 0 is broken: it is {}", -value)).to_string());
        let late = Stopped::Run(Failure::OutOfTime { at: 3.0 }).to_string();
        for (member, why) in (1..).zip([None, Some(first.as_str()), Some(&second), Some(&late)]) {
            told.add(member, why);
        }
        assert_eq!(told.reached(), 1);
        let text = told.text(Path::new("t.csv"), 0, |_| Vec::new());
        assert!(text.starts_with("4 members: 1 reached the end, 3 did not\n"), "{text}");
        assert!(text.contains("2  such as member 2: no such bodies exist: A' > 0 is broken: it is -2\n"), "{text}");
        assert!(text.contains("1  such as member 4: out of time: "), "{text}");
    }
}
