//! Whole motions, minutes of them: the atlas, the catalogue of failures, mechanisms, reduced models, synchronism.

mod atlas;
mod failures;
mod governors;
mod knowledge;
mod ladder;
mod mechanisms;
mod synchronism;
