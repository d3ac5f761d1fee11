//! Pages for review: the ledger's pages and rows, the verdicts on motors.

mod errata;
mod ledger;
mod ledger_rows;
mod manuscripts;
mod motors;
