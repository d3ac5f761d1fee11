//! All stationary motions: of a thousand random gyrostats against an independent search, in closed form, for every motor.

mod closed;
mod momentum;
mod motors;
mod search;
mod thousand;
