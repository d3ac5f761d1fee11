//! Changes of the board by stages: the parts of each stage, and their states when the stage begins, ends, or fails.

use super::board::Board;
use super::stage::Stage;
use super::values::{ABOUT, ChangedText, Datum};
use charts::page::live::{self, Freshness, Part, Shown};
use serde_json::{Map, Value};
use std::sync::Arc;

/// The board with the changes that stages make.
pub struct StagedBoard(Arc<Board>);

/// The parts that a stage computes; the first one shows its faults.
fn parts(stage: Stage) -> &'static [Part] {
    match stage {
        Stage::System => &[Part::Equations, Part::Vectors],
        Stage::Verdicts => &[Part::Verdicts],
        Stage::Motion => &[Part::Motion, Part::Sketch],
        Stage::Claims => &[Part::Claims],
    }
}

impl StagedBoard {
    pub fn new(board: Arc<Board>) -> Self {
        StagedBoard(board)
    }

    /// A stage is at work; parts that show nothing yet wait for their content, but the first, which says so.
    pub fn begin(&self, stage: Stage) {
        for (place, part) in parts(stage).iter().enumerate() {
            self.0.change(*part, |shown| {
                if place == 0 || !shown.content.is_empty() {
                    shown.freshness = Freshness::Working;
                }
            });
        }
    }

    /// The content of a part, by its id.
    pub fn tell(&self, stage: Stage, id: &str, content: String) {
        let Some(part) = Part::ALL.into_iter().find(|part| part.id() == id) else { return };
        let freshness = match stage {
            _ if content.is_empty() => Freshness::Absent,
            // more of it is to come
            Stage::Claims => Freshness::Working,
            _ => Freshness::Current,
        };
        self.0.change(part, |shown| *shown = Shown { content, fault: String::new(), freshness });
    }

    /// A stage came to its end; what it warned of stands above its parts.
    pub fn succeed(&self, stage: Stage, warnings: &str) {
        for part in parts(stage) {
            self.turn(*part, Freshness::Current);
        }
        if stage == Stage::System {
            let fault = live::message("warning", warnings.trim_end());
            self.0.change(Part::Heading, |shown| shown.fault = fault);
        }
    }

    /// A stage did not come to its end: what it told stays, and what it showed before stays as of an earlier text.
    pub fn fail(&self, stage: Stage, why: &str) {
        let fault = live::message("error", why);
        let [first, others @ ..] = parts(stage) else { return };
        self.0.change(*first, |shown| {
            // a fault alone is one of the present text
            shown.freshness = if shown.content.is_empty() { Freshness::Current } else { Freshness::Earlier };
            shown.fault = fault;
        });
        for part in others {
            self.0.change(*part, |shown| {
                if shown.freshness == Freshness::Working {
                    shown.freshness = Freshness::Earlier;
                }
            });
        }
    }

    /// The text is not acceptable: the last good state stays.
    pub fn refuse(&self, why: &str) {
        let fault = live::message("error", why);
        self.0.change(Part::Heading, |shown| (shown.fault, shown.freshness) = (fault, Freshness::Earlier));
        for part in Part::ALL.into_iter().filter(|part| *part != Part::Heading) {
            // faults of a run are of no use beside one of the whole text
            self.0.change(part, |shown| shown.fault.clear());
            self.turn(part, Freshness::Earlier);
        }
    }

    /// The text has no such stage.
    pub fn leave_out(&self, stage: Stage) {
        parts(stage).iter().for_each(|part| self.0.change(*part, |shown| *shown = Shown::default()));
    }

    /// Sliders for these numbers, none of them moved.
    pub fn show_sliders(&self, data: &[Datum]) {
        let sliders: Vec<_> = data.iter().map(Datum::slider).collect();
        self.0.set_ranges(sliders.iter().map(|slider| (slider.id.clone(), slider.range)).collect());
        self.show(Part::Values, live::sliders(&sliders, ABOUT));
        self.show_moved(Map::new(), &ChangedText::default());
    }

    /// Sliders that were moved, and the lines of the text that would have their values.
    pub fn show_moved(&self, values: Map<String, Value>, changed: &ChangedText) {
        self.0.set_values(values);
        self.show(Part::Lines, live::lines(&changed.lines));
    }

    /// Whether no part but the heading, which may show warnings, has a fault.
    pub fn is_whole(&self) -> bool {
        let (_, parts) = self.0.shown();
        parts.iter().all(|(part, shown)| *part == Part::Heading || shown.fault.is_empty())
    }

    fn show(&self, part: Part, content: String) {
        let freshness = if content.is_empty() { Freshness::Absent } else { Freshness::Current };
        self.0.change(part, |shown| *shown = Shown { content, fault: String::new(), freshness });
    }

    /// A part that shows nothing is of no text.
    fn turn(&self, part: Part, freshness: Freshness) {
        self.0.change(part, |shown| {
            let is_empty = shown.content.is_empty() && shown.fault.is_empty();
            shown.freshness = if is_empty { Freshness::Absent } else { freshness };
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn freshness(board: &Board, part: Part) -> (Freshness, String) {
        let (_, parts) = board.shown();
        let found = parts.into_iter().find(|(own, _)| *own == part);
        found.map(|(_, shown)| (shown.freshness, shown.content + &shown.fault)).unwrap_or_default()
    }

    #[test]
    fn the_last_good_state_stays_beside_a_fault_and_goes_with_what_the_text_leaves_out() {
        let board = Arc::new(Board::default());
        let staged = StagedBoard::new(Arc::clone(&board));
        staged.begin(Stage::Motion);
        assert_eq!(freshness(&board, Part::Motion).0, Freshness::Working);
        assert_eq!(freshness(&board, Part::Sketch).0, Freshness::Absent);
        staged.tell(Stage::Motion, "motion", "run".into());
        staged.succeed(Stage::Motion, "");
        assert_eq!(freshness(&board, Part::Motion), (Freshness::Current, "run".to_owned()));
        staged.refuse("wrong");
        assert_eq!(freshness(&board, Part::Motion), (Freshness::Earlier, "run".to_owned()));
        assert!(freshness(&board, Part::Heading).1.contains("wrong"));
        assert_eq!(freshness(&board, Part::Verdicts).0, Freshness::Absent);
        staged.fail(Stage::Motion, "late");
        assert!(freshness(&board, Part::Motion).1.contains("late") && !staged.is_whole());
        staged.leave_out(Stage::Motion);
        assert!(freshness(&board, Part::Motion) == (Freshness::Absent, String::new()) && staged.is_whole());
    }
}
