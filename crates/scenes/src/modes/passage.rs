//! The mode that holds at a state, and after an event.

use super::signals::Fall;
use super::{Case, Moded, Modes};
use crate::compiled_system::NotCompiled;
use crate::start::breaks;
use integrators::Event;
use model::Direction;
use std::sync::Arc;

/// Conditions that may be at zero together: every combination of their cases is tried.
const MOST_OPEN: usize = 6;

const NO_LAW: &str =
    "no law holds after a condition changes: it would have to be kept at zero, and nothing keeps it there";
const NONE: &str = "no case of its conditions agrees with the motion that it gives";
const SEVERAL: &str = "several motions go on from here, each by another case of its conditions";
const TOO_MANY: &str = "more than six conditions are at zero together";
const BROKEN: &str = "an event leaves a state that breaks a constraint";

impl Modes {
    /// The mode at a state that no mode has led to.
    pub(super) fn at(&self, time: f64, state: &[f64]) -> Result<Arc<Moded>, &'static str> {
        let mut mode = vec![Case::Off; self.model.switches.len()];
        // a condition may depend on the cases of those before it
        for switch in 0..mode.len() {
            let conditions = self.moded(&mode).map_err(refused)?.signals.conditions(time, state);
            mode[switch] = if conditions[switch][0] > 0.0 { Case::On } else { Case::Off };
        }
        let conditions = self.moded(&mode).map_err(refused)?.signals.conditions(time, state);
        let open: Vec<usize> = (0..mode.len()).filter(|&switch| conditions[switch][0] == 0.0).collect();
        self.settled(time, state, mode, &open, &[])
    }

    /// The mode after an event, and the state, which the event may set; none where the motion ends with it.
    pub(super) fn after(
        &self,
        before: &Moded,
        sides: &[f64],
        event: &Event,
        state: &mut [f64],
    ) -> Result<Option<Arc<Moded>>, &'static str> {
        let mut mode = before.system.mode.clone();
        let mut open: Vec<usize> = (0..mode.len()).filter(|&switch| mode[switch] == Case::Held).collect();
        let mut closed = Vec::new();
        match before.signals.falls[event.signal] {
            Fall::Event { event: number } => {
                let [_, rate] = before.signals.events(event.time, state)[number];
                let counts = match self.model.events[number].direction {
                    Direction::Down => sides[number] > 0.0,
                    Direction::Up => sides[number] < 0.0,
                    Direction::Both => true,
                };
                // one that has not left zero since it was set there does not come back to it
                if !counts || rate * sides[number] > 0.0 {
                    return self.moded(&mode).map(Some).map_err(refused);
                }
                state.copy_from_slice(&before.signals.set_by(number, event.time, state));
                if self.model.events[number].ends {
                    return Ok(None);
                }
                if breaks(&self.model, event.time, state) {
                    return Err(BROKEN);
                }
                return self.at(event.time, state).map(Some);
            }
            Fall::Passes { switch } => {
                mode[switch] = if mode[switch] == Case::On { Case::Off } else { Case::On };
                open.push(switch);
            }
            Fall::Leaves { switch, to } => {
                mode[switch] = to;
                closed.push(switch);
            }
        }
        self.settled(event.time, state, mode, &open, &closed).map(Some)
    }

    /// The one mode with these cases whose open conditions move as it says; closed ones are not held.
    fn settled(
        &self,
        time: f64,
        state: &[f64],
        mut mode: Vec<Case>,
        open: &[usize],
        closed: &[usize],
    ) -> Result<Arc<Moded>, &'static str> {
        if open.is_empty() {
            return self.moded(&mode).map_err(refused);
        }
        if open.len() > MOST_OPEN {
            return Err(TOO_MANY);
        }
        // of cases that rest the one that the event led to comes first
        let first = mode.clone();
        let cases = |switch: usize| match first[switch] {
            Case::On => [Case::On, Case::Off, Case::Held],
            Case::Off => [Case::Off, Case::On, Case::Held],
            Case::Held => [Case::Held, Case::On, Case::Off],
        };
        let (mut agreeing, mut resting, mut reason) = (Vec::new(), None, NONE);
        for combination in 0..3_usize.pow(open.len() as u32) {
            let mut rest = combination;
            for &switch in open {
                mode[switch] = cases(switch)[rest % 3];
                rest /= 3;
            }
            if closed.iter().any(|switch| mode[*switch] == Case::Held) {
                continue;
            }
            match self.moded(&mode) {
                Ok(moded) => match agreement(&moded, time, state, open) {
                    Some(true) => agreeing.push(moded),
                    Some(false) => resting = resting.or(Some(moded)),
                    None => {}
                },
                Err(NotCompiled::NotHeld { .. }) => reason = NO_LAW,
                Err(other) => return Err(refused(other)),
            }
        }
        match agreeing.len() {
            0 => resting.ok_or(reason),
            1 => Ok(agreeing.remove(0)),
            _ => Err(SEVERAL),
        }
    }
}

/// Whether open conditions move as their cases say: each away from zero, by its rate or where that is zero by the next one, or held
/// between its cases; or, otherwise, at rest where it should move; none where one contradicts its case.
fn agreement(moded: &Moded, time: f64, state: &[f64], open: &[usize]) -> Option<bool> {
    let conditions = moded.signals.conditions(time, state);
    let signals = moded.signals.at(time, state);
    let mut moves = true;
    for &switch in open {
        match moded.system.mode[switch] {
            case @ (Case::On | Case::Off) => {
                let side = if case == Case::On { 1.0 } else { -1.0 };
                let [_, first, second] = conditions[switch];
                let rate = side * if first == 0.0 { second } else { first };
                if rate.is_nan() || rate < 0.0 {
                    return None;
                }
                moves &= rate > 0.0;
            }
            Case::Held => {
                let own = |fall: &Fall| matches!(fall, Fall::Leaves { switch: own, .. } if *own == switch);
                let margins = moded.signals.falls.iter().zip(&signals).filter(|(fall, _)| own(fall));
                if margins.map(|(_, [value, _])| *value).any(|margin| margin.is_nan() || margin < 0.0) {
                    return None;
                }
            }
        }
    }
    Some(moves)
}

fn refused(reason: NotCompiled) -> &'static str {
    match reason {
        NotCompiled::NotHeld { .. } => NO_LAW,
        NotCompiled::Massless { .. } => "in this case nothing with inertia moves with a coordinate",
        NotCompiled::Redundant { .. } => "in this case its constraints depend on each other",
        _ => "the law of this case cannot be written down",
    }
}
