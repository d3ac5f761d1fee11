//! What became of the members of an ensemble.

use std::collections::BTreeMap;
use std::path::Path;

/// What became of the members.
#[derive(Default)]
pub struct Told {
    pub members: u64,
    /// By their reasons, whatever the numbers in them.
    stopped: BTreeMap<String, Stopped>,
}

/// Members that stopped for one reason.
struct Stopped {
    count: u64,
    /// The first of them, and its reason with its numbers.
    member: u64,
    why: String,
}

impl Told {
    /// One more member, with the reason for which it stopped, where it did.
    pub fn add(&mut self, stopped: Option<&str>) {
        self.members += 1;
        if let Some(why) = stopped {
            let first = || Stopped { count: 0, member: self.members, why: why.to_owned() };
            self.stopped.entry(words(why)).or_insert_with(first).count += 1;
        }
    }

    /// For reading.
    pub fn text(&self, path: &Path, before: u64) -> String {
        let stopped: u64 = self.stopped.values().map(|stopped| stopped.count).sum();
        let reached = self.members - stopped;
        let mut text = format!("{} members: {reached} reached the end, {stopped} did not\n", self.members);
        for Stopped { count, member, why } in self.stopped.values() {
            text += &format!("  {count:>8}  such as member {member}: {why}\n");
        }
        if before > 0 {
            text += &format!("the first {before} were there already\n");
        }
        text + &format!("{}\n", path.display())
    }
}

/// A reason without its numbers.
fn words(why: &str) -> String {
    let is_number = |word: &str| word.trim_matches([',', ';', ':', '(', ')']).parse::<f64>().is_ok();
    why.split_whitespace().filter(|word| !is_number(word)).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::Told;
    use std::path::Path;

    #[test]
    fn reasons_are_whole_and_counted_whatever_their_numbers() {
        let mut told = Told::default();
        for why in [None, Some("A' < 3: it is 2"), Some("A' < 3: it is 1.5"), Some("out of time at t = 3")] {
            told.add(why);
        }
        let text = told.text(Path::new("t.csv"), 0);
        assert!(text.starts_with("4 members: 1 reached the end, 3 did not\n"), "{text}");
        assert!(text.contains("2  such as member 2: A' < 3: it is 2\n"), "{text}");
        assert!(text.contains("1  such as member 4: out of time at t = 3\n"), "{text}");
    }
}
