//! Papers, each a page of claims in the paper's own order and letters.

pub mod konosevich2022;

use claims::Page;

/// Every paper's page, made in the calling thread.
pub fn pages() -> Vec<Page> {
    vec![konosevich2022::page()]
}
