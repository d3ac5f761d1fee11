//! Papers as pages of claims, in the papers' order and notation.
//!
//! # Overview
//! * [`konosevich2022`]: gyrostats driven by an electric motor;
//! * [`manglieva2022`]: systems with rolling, servo constraints and friction;
//! * [`mukharlyamov2007`]: programmed constraints and their stabilisation.
//!
//! # Example
//! ```
//! let page = (dalembert_papers::mukharlyamov2007::PAPER.page)();
//! assert!(page.claims().len() > 100, "a claim for each statement of the paper");
//! ```

pub mod konosevich2022;
pub mod manglieva2022;
pub mod mukharlyamov2007;

claims::submit! {
    claims::Catalogue {
        name: "papers",
        papers: &[&konosevich2022::PAPER, &manglieva2022::PAPER, &mukharlyamov2007::PAPER],
    }
}
