//! Maps of when motion with friction is determined, over the angle and the friction.
//!
//! # Overview
//! * [`maps`]: the verdicts, beside the critical curves of [`critical`].
//!
//! The theorems behind them are a page of claims of their own.

pub mod critical;
pub mod maps;
