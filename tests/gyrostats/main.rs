//! Properties that hold for every gyrostat, tested on random ones composed of mass points.

mod existence;
mod models;
#[path = "../physical/mod.rs"]
mod physical;
mod points;
mod power;
mod routes;
mod steady;
mod tensors;
