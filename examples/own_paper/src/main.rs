//! A paper judged in a crate of one's own: each of its equations with a verdict, and what holds instead where one fails.

mod cart_pole;

use std::process::ExitCode;

fn main() -> ExitCode {
    let mut is_sound = true;
    // symbols live in the graph of one task
    symbolic::apart(|| {
        for claim in (cart_pole::PAPER.page)().judge() {
            println!("{} {}: {}", claim.verdict.sign(), claim.id, claim.verdict.name());
            println!("    {}", claim.statement());
            if let Some(correct) = &claim.correction {
                println!("  {} {}: {}", correct.verdict.sign(), correct.id, correct.verdict.name());
                println!("    {}", correct.statement());
            }
            if let Err(why) = claim.sound() {
                println!("  {why}");
                is_sound = false;
            }
        }
    });
    if is_sound { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

#[cfg(test)]
mod tests {
    use super::cart_pole::PAPER;

    #[test]
    fn every_entry_has_a_claim_and_every_claim_its_verdict() {
        symbolic::apart(|| {
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
