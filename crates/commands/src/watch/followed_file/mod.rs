//! Repeated checks of a file, and of the files that it names, for changes.

use reader::{SceneError, read_text};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

/// The age of a file from which on it is read again only if its time or length has changed.
const YOUNG: Duration = Duration::from_secs(2);

/// The number of successive checks for which a file may be empty or missing, since an editor may be writing it.
const LOOKS: u32 = 3;

/// The content of a file, or the reason for which it cannot be read.
type Content = Result<String, SceneError>;

/// A file that is checked for changes. An editor may save it in place, or replace it by another file.
pub struct FollowedFile {
    path: PathBuf,
    stamp: Option<Stamp>,
    content: Option<Content>,
    /// The number of checks since the file was found empty or missing.
    looks: u32,
    /// The further files, each with its stamp and its last content.
    beside: Vec<(PathBuf, Option<Stamp>, Option<Content>)>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
struct Stamp {
    modified: SystemTime,
    /// The length in bytes.
    length: u64,
}

impl Stamp {
    fn of(path: &Path) -> Option<Self> {
        let data = std::fs::metadata(path).ok()?;
        Some(Stamp { modified: data.modified().ok()?, length: data.len() })
    }

    fn is_young(&self) -> bool {
        // a time in the future counts as young
        self.modified.elapsed().map_or(true, |age| age < YOUNG)
    }
}

/// The content of the file if it may have changed since `stamp`, otherwise `None`. A young file is always read, since it may be saved again within
/// one tick of the clock, with an equal stamp.
fn read_again(path: &Path, stamp: &mut Option<Stamp>) -> Option<Content> {
    let now = Stamp::of(path);
    if now.is_some() && now == *stamp && !now.is_some_and(|stamp| stamp.is_young()) {
        return None;
    }
    *stamp = now;
    Some(read_text(path))
}

impl FollowedFile {
    /// A file that has not been read yet.
    pub fn new(path: &Path) -> Self {
        FollowedFile { path: path.to_owned(), stamp: None, content: None, looks: 0, beside: Vec::new() }
    }

    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Replaces the list of further files that are checked.
    pub fn follow(&mut self, paths: Vec<PathBuf>) {
        let one = |path: PathBuf| {
            let known = self.beside.iter().position(|(own, ..)| *own == path);
            known.map(|place| self.beside.swap_remove(place)).unwrap_or_else(|| {
                let mut stamp = None;
                let content = read_again(&path, &mut stamp);
                (path, stamp, content)
            })
        };
        self.beside = paths.into_iter().map(one).collect();
    }

    /// The content of the file if it or one of the further files has changed since the last check.
    pub fn change(&mut self) -> Option<Content> {
        let mut is_new = false;
        for (path, stamp, known) in &mut self.beside {
            if let Some(now) = read_again(path, stamp)
                && known.as_ref() != Some(&now)
            {
                (*known, is_new) = (Some(now), true);
            }
        }
        let now = match read_again(&self.path, &mut self.stamp) {
            Some(now) if self.content.as_ref() != Some(&now) => now,
            _ => {
                self.looks = 0;
                return self.content.clone().filter(|_| is_new);
            }
        };
        let is_between = self.content.is_some() && now.as_ref().map_or(true, |text| text.trim().is_empty());
        if is_between && self.looks < LOOKS {
            (self.looks, self.stamp) = (self.looks + 1, None);
            return None;
        }
        self.looks = 0;
        self.content = Some(now);
        self.content.clone()
    }
}

#[cfg(test)]
mod tests;
