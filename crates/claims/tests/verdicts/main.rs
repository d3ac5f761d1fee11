//! Tests of verdicts on claims, and of reviews of pages.

mod judging;
mod review;
