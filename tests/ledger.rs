//! Every claim of every paper is a test of its own: `cargo test konosevich2022/eq5.3` runs those of one equation.
//!
//! This is the first check: the verdict is the expected one, the correction has its expected verdict, and the
//! cross-examination finds no objection. The second check, the snapshot, is in `pages.rs`.

use claims::Judged;
use claims::catalogue::{pages, papers};
use dalembert_derivations as _;
use libtest_mimic::{Arguments, Failed, Trial};

fn main() {
    let arguments = Arguments::from_args();
    let mut trials = Vec::new();
    for (paper, page) in papers().into_iter().zip(pages()) {
        let judged = page.judge();
        for &entry in paper.entries {
            let covered = judged.iter().any(|claim| claim.equation == entry);
            trials.push(Trial::test(format!("{}/{entry} is covered", paper.key), move || {
                if covered { Ok(()) } else { Err(Failed::from("no claim stands for this entry of the paper")) }
            }));
        }
        trials.extend(judged.into_iter().map(trial));
    }
    libtest_mimic::run(&arguments, trials).exit();
}

fn trial(claim: Judged) -> Trial {
    Trial::test(claim.id.clone(), move || claim.sound().map_err(Failed::from))
}
