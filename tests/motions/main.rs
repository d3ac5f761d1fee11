//! Long tests on whole motions: work-precision study, catalogue of failure, mechanisms, model reduction, synchronism.

mod atlas;
mod crank_drive;
mod failures;
mod governors;
mod knowledge;
mod model_reduction;
mod synchronism;
