//! Scene files: their content, messages about mistakes, bounds on data.

mod bounds_of_data;
mod files;
mod fuzz;
mod messages;
mod units;
