//! Files of other programs: functional mock-up units of FMI 3.0, and archives of NumPy.
//!
//! # Overview
//! * [`fmu`]: a system in C as a unit for model exchange and co-simulation, as source and as a binary for this platform;
//! * [`npz`]: arrays that NumPy loads;
//! * [`archive`]: files as one zip archive, the same bytes for the same files.

pub mod archive;
pub mod fmu;
pub mod npz;
