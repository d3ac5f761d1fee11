//! The board as a page: served, or saved in a file.

use super::board::Board;
use crate::output::Maker;
use charts::page::live::LivePage;
use std::sync::Arc;

/// The title of the page, which is the name of the file.
pub type PageTitle = Arc<str>;

/// The page that the server sends; its script carries this nonce.
pub fn served(board: &Board, title: &str, nonce: &str) -> String {
    with_page(board, title, |page| page.served(nonce))
}

/// The page as a file, which can be read without the program.
pub fn saved(board: &Board, title: &str) -> String {
    with_page(board, title, |page| page.saved())
}

fn with_page(board: &Board, title: &str, write: impl FnOnce(&LivePage<'_>) -> String) -> String {
    let (version, parts) = board.shown();
    write(&LivePage { title, generator: &Maker("watch").generator(), parts: &parts, version })
}
