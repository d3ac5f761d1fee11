//! Files of other programs: functional mock-up units of FMI 3.0, and archives of NumPy.
//!
//! # Overview
//! * [`fmu`]: a system in C as a unit for model exchange and co-simulation, as source and as a binary for this platform;
//! * [`npz`]: arrays that NumPy loads;
//! * [`archive`]: files as one zip archive, equal bytes for equal files.
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
