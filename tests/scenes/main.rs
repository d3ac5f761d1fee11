//! Scene files: their content, messages on mistakes, bounds of data.

mod bounds_of_data;
mod files;
mod fuzz;
mod messages;
mod units;
