//! Whole motions, minutes of them: the atlas, the catalogue of failures, friction, mechanisms, reduced models, synchronism.

mod atlas;
mod failures;
mod friction;
mod governors;
mod ladder;
mod mechanisms;
mod synchronism;
