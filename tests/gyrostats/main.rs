//! The laws of every gyrostat that exists, at random ones made of mass points.

mod existence;
mod models;
#[path = "../physical/mod.rs"]
mod physical;
mod points;
mod power;
mod routes;
mod steady;
mod tensors;
