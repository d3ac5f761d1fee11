#!/usr/bin/env bash
# All that snapshots hold, on another processor and at another level of optimisation: aarch64, emulated.
# It needs `rustup target add aarch64-unknown-linux-gnu`, and of Debian gcc-aarch64-linux-gnu and qemu-user.
set -euo pipefail
cd "$(dirname "$0")/.."
export CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER=aarch64-linux-gnu-gcc
export DALEMBERT_RUNNER="qemu-aarch64 -L /usr/aarch64-linux-gnu"
export CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_RUNNER="$DALEMBERT_RUNNER"
export CARGO_PROFILE_DEV_OPT_LEVEL="${1:-1}" CARGO_PROFILE_DEV_DEBUG=0 INSTA_UPDATE=no
tests=(motions pages scenes stability)
# of the scenes what wrong ones are told, of the motions what the atlas and the failures lock
cargo test --target aarch64-unknown-linux-gnu --package dalembert-derivations --no-fail-fast "${tests[@]/#/--test=}" -- \
  --skip files:: --skip fuzz:: --skip units:: --skip bounds_of_data:: --skip stabilisation:: \
  --skip friction:: --skip mechanisms:: --skip governors:: --skip ladder:: --skip synchronism::
cargo test --target aarch64-unknown-linux-gnu --package dalembert-cli --test program refusals
