//! A progress bar for work that takes long.

use crate::ending::is_quiet;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::time::{Duration, Instant};

/// Below this nobody wants to see a bar.
const PATIENCE: Duration = Duration::from_millis(700);
const MARKS: u64 = 1000;

/// Appears on a terminal once the work has taken longer than a moment, and leaves nothing behind.
pub struct Progress {
    bar: ProgressBar,
    start: Instant,
    shown: u64,
}

impl Progress {
    /// Of the work that begins now.
    pub fn new(label: &str) -> Self {
        let bar = ProgressBar::with_draw_target(Some(MARKS), ProgressDrawTarget::hidden());
        if let Ok(style) = ProgressStyle::with_template("{msg} {wide_bar} {percent} % {eta}") {
            bar.set_style(style);
        }
        bar.set_message(label.to_owned());
        Progress { bar, start: Instant::now(), shown: 0 }
    }

    /// So much is done. Cheap: nothing happens between two marks of the bar.
    pub fn set(&mut self, fraction: f64) {
        let mark = (fraction * MARKS as f64) as u64;
        if mark > self.shown {
            self.shown = mark;
            if self.start.elapsed() > PATIENCE {
                if self.bar.is_hidden() && !is_quiet() {
                    // indicatif draws on terminals only
                    self.bar.set_draw_target(ProgressDrawTarget::stderr());
                }
                self.bar.set_position(mark);
            }
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
