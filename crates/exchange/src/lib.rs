//! Export of systems and runs to other programs: functional mock-up units (FMI) and NumPy archives.
//!
//! # Overview
//! * [`fmu`]: a system in C as a unit for model exchange and co-simulation, as source and as a binary for this platform;
//! * [`npz`]: arrays that NumPy loads;
//! * [`archive`]: files as one zip archive; equal files give equal bytes.
//!
//! This crate is for programs that export a system or a run. The example writes an archive that `numpy.load` reads.
//!
//! # Example
//! ```
//! use dalembert_exchange::npz::{Array, write};
//!
//! let mut file = Vec::new();
//! let arrays = [("time".to_owned(), Array::Numbers(vec![0.0, 0.5, 1.0]))];
//! write(&mut file, &arrays).expect("memory takes it");
//! assert!(file.starts_with(b"PK"), "numpy.load reads a zip archive");
//! ```

pub mod archive;
pub mod fmu;
pub mod npz;
