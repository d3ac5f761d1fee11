//! Scene files: what they hold, what a wrong one is told, what they bound.

mod bounds_of_data;
mod files;
mod fuzz;
mod messages;
mod units;
