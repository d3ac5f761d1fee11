//! Long tests of whole motions: work-precision study, catalogue of failures, mechanisms, model reduction, synchronism.

mod atlas;
mod crank_drive;
mod failures;
mod governors;
mod knowledge;
mod model_reduction;
mod synchronism;
