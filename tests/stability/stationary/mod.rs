//! All stationary motions: of a thousand random gyrostats beside an independent search, in closed cases, for every motor.

mod closed;
mod momentum;
mod motors;
mod search;
mod thousand;
