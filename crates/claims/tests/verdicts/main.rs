//! How claims are judged, and what a review reads from pages.

mod judging;
mod review;
