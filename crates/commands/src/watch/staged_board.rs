//! Changes of the board by stages: the parts of each stage, and their states when the stage begins, ends or fails.

use super::board::Board;
use super::stage::Stage;
use super::values::{ABOUT, ChangedText, Datum};
use charts::page::live::{self, Freshness, Part, Shown};
use serde_json::{Map, Value};
use std::sync::Arc;

/// The board with the changes that stages make.
pub struct StagedBoard(Arc<Board>);

/// The parts that a stage computes; faults of the stage are shown in the first part.
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

    /// Marks the parts of a stage as being computed: the first part, and those with content of an earlier text.
    pub fn begin(&self, stage: Stage) {
        for (place, part) in parts(stage).iter().enumerate() {
            self.0.change(*part, |shown| {
                if place == 0 || !shown.content.is_empty() {
                    shown.freshness = Freshness::Working;
                }
            });
        }
    }

    /// Replaces the content of the part with this id.
    pub fn tell(&self, stage: Stage, id: &str, content: String) {
        let Some(part) = Part::ALL.into_iter().find(|part| part.id() == id) else { return };
        let freshness = match stage {
            _ if content.is_empty() => Freshness::Absent,
            // more claims follow
            Stage::Claims => Freshness::Working,
            _ => Freshness::Current,
        };
        self.0.change(part, |shown| *shown = Shown { content, fault: String::new(), freshness });
    }

    /// Marks the parts of a completed stage as current; warnings are shown in the heading.
    pub fn succeed(&self, stage: Stage, warnings: &str) {
        for part in parts(stage) {
            self.turn(*part, Freshness::Current);
        }
        if stage == Stage::System {
            let fault = live::message("warning", warnings.trim_end());
            self.0.change(Part::Heading, |shown| shown.fault = fault);
        }
    }

    /// Shows the fault of a stage that did not complete. Content that it reported stays; older content is marked as belonging to an earlier text.
    pub fn fail(&self, stage: Stage, why: &str) {
        let fault = live::message("error", why);
        let [first, others @ ..] = parts(stage) else { return };
        self.0.change(*first, |shown| {
            // without content, the part shows only the fault, which belongs to the present text
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

    /// Shows that the text is not acceptable; the last contents stay and are marked as belonging to an earlier text.
    pub fn refuse(&self, why: &str) {
        let fault = live::message("error", why);
        self.0.change(Part::Heading, |shown| (shown.fault, shown.freshness) = (fault, Freshness::Earlier));
        for part in Part::ALL.into_iter().filter(|part| *part != Part::Heading) {
            // faults of single stages are removed, since the whole text has a fault
            self.0.change(part, |shown| shown.fault.clear());
            self.turn(part, Freshness::Earlier);
        }
    }

    /// Clears the parts of a stage that does not apply to the text.
    pub fn leave_out(&self, stage: Stage) {
        parts(stage).iter().for_each(|part| self.0.change(*part, |shown| *shown = Shown::default()));
    }

    /// Shows sliders for these numbers at their values in the text.
    pub fn show_sliders(&self, data: &[Datum]) {
        let sliders: Vec<_> = data.iter().map(Datum::slider).collect();
        self.0.set_ranges(sliders.iter().map(|slider| (slider.id.clone(), slider.range)).collect());
        self.show(Part::Values, live::sliders(&sliders, ABOUT));
        self.show_moved(Map::new(), &ChangedText::default());
    }

    /// Stores the values of moved sliders, and shows the lines that would give these values to the file.
    pub fn show_moved(&self, values: Map<String, Value>, changed: &ChangedText) {
        self.0.set_values(values);
        self.show(Part::Lines, live::lines(&changed.lines));
    }

    /// Whether no part has a fault, apart from the heading, which may show warnings.
    pub fn is_whole(&self) -> bool {
        let (_, parts) = self.0.shown();
        parts.iter().all(|(part, shown)| *part == Part::Heading || shown.fault.is_empty())
    }

    fn show(&self, part: Part, content: String) {
        let freshness = if content.is_empty() { Freshness::Absent } else { Freshness::Current };
        self.0.change(part, |shown| *shown = Shown { content, fault: String::new(), freshness });
    }

    /// Sets the freshness of a part; an empty part is absent.
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
