//! The program `dalembert` with one paper more: `ledger` tells the verdict on each of its equations.

mod cart_pole;

use std::process::ExitCode;

fn main() -> ExitCode {
    dalembert::commands::run()
}

#[cfg(test)]
mod tests {
    use super::cart_pole::PAPER;

    #[test]
    fn every_entry_has_a_claim_and_every_claim_its_verdict() {
        // symbols live in the graph of one task
        dalembert::symbolic::apart(|| {
            let judged = (PAPER.page)().judge();
            for entry in PAPER.entries {
                assert!(judged.iter().any(|claim| claim.equation == *entry), "{entry}");
            }
            for claim in judged {
                assert_eq!(claim.sound(), Ok(()), "{}", claim.id);
            }
        });
    }
}
