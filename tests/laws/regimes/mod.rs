//! Every consistent regime of rough contacts: textbook values, exactly.

mod ladders;
mod laws;
mod rods;
mod sliders;
mod verdicts;
