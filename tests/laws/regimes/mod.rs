//! All consistent contact regimes with friction, compared exactly with textbook values.

mod ladders;
mod laws;
mod rods;
mod sliders;
mod verdicts;
