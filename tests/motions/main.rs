//! Whole motions, minutes of them: the atlas, the catalogue of failures, mechanisms, reduced models, synchronism.

mod atlas;
mod crank_drive;
mod failures;
mod governors;
mod knowledge;
mod model_reduction;
mod synchronism;
