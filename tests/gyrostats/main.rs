//! Properties of every gyrostat, tested on random ones made of mass points.

mod existence;
mod models;
#[path = "../physical/mod.rs"]
mod physical;
mod points;
mod power;
mod routes;
mod steady;
mod tensors;
