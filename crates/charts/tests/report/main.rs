//! The report's page, as text and in a browser.

mod browser;
mod page;
#[path = "../../examples/specimen/report/mod.rs"]
mod report;
