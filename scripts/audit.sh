#!/bin/sh
# What the dependencies must hold beside the tests: licences, sources and duplicates (deny.toml), known vulnerabilities,
# and the minimum version of Rust that Cargo.toml declares.
#
#   cargo install cargo-deny
#   scripts/audit.sh             all checks; the advisories are fetched from the internet
#   scripts/audit.sh --offline   without the advisories
set -eu
cd "$(dirname "$0")/.."

if [ "${1:-}" = --offline ]; then
    cargo deny --offline check bans licenses sources
else
    cargo deny check
fi

# The declared version must build everything that a newcomer builds.
declared=$(sed -n 's/^rust-version = "\(.*\)"/\1/p' Cargo.toml)
cargo "+$declared" check --locked --all-targets --target-dir target/declared-rust
