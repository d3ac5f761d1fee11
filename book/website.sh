#!/usr/bin/env bash
# The website in one folder: the book, under api/ the documentation of the crates, under report/ the report.
# It needs mdBook: cargo install mdbook --locked
set -euo pipefail
cd "$(dirname "$0")/.."
command -v mdbook >/dev/null || { echo "mdbook is not found; cargo install mdbook --locked installs it" >&2; exit 1; }
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
# mdBook empties the folder that it writes to, so it is no folder of the caller's choice
site=$target/site
mdbook build book --dest-dir "$site"
RUSTDOCFLAGS="-D warnings" cargo doc --workspace --no-deps --quiet
rm -rf "$site/api"
cp -r "$target/doc" "$site/api"
cargo run --release --quiet -- --quiet --out "$site/report/index.html"
printf '%s\n' "$site/index.html" "$site/api/dalembert/index.html" "$site/report/index.html"
