//! All steady motions: of a thousand random gyrostats, compared with an independent search; in closed form; and for
//! every motor.

mod closed;
mod momentum;
mod motors;
mod search;
mod thousand;
