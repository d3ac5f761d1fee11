//! This crate contains only dependencies: the manifest selects one set of features of external crates for the whole workspace.
