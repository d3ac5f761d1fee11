//! Writes the specimen page: `cargo run -p dalembert-charts --example specimen -- page.html`.

mod report;

use std::process::ExitCode;

fn main() -> ExitCode {
    let path = std::env::args().nth(1).unwrap_or_else(|| "specimen.html".to_owned());
    let page = dalembert_charts::page::render(&report::specimen());
    for unset in &page.unset {
        eprintln!("{}: {} in `{}`", unset.place, unset.reason, unset.latex);
    }
    match std::fs::write(&path, &page.html) {
        Ok(()) => {
            println!("{path}: {} kB", page.html.len() / 1000);
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("cannot write {path}: {error}");
            ExitCode::FAILURE
        }
    }
}
