#!/usr/bin/env bash
# Runs fuzz targets one after the other: fuzz/run.sh SECONDS [TARGET ...]
# Each run adds a line to fuzz/counts.csv. A defect found ends the target's run; its input lies in fuzz/artifacts.
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1:?usage: fuzz/run.sh SECONDS [TARGET ...]}
shift
mapfile -t all < <(cd fuzz/fuzz_targets && ls -- *.rs | sed 's/\.rs$//')
targets=("$@")
[ ${#targets[@]} -gt 0 ] || targets=("${all[@]}")
version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -n 1)

# Shipped inputs are the first ones.
for target in "${all[@]}"; do mkdir -p "fuzz/corpus/$target"; done
find tcl-like-inputs validation/closed_form -name '*.tcl' -size -40k -exec cp -n {} fuzz/corpus/script/ \;
find tcl-like-inputs validation/recordings -name '*.toml' -exec cp -n {} fuzz/corpus/study/ \;
find tcl-like-inputs -name '*.csv' -size -40k -exec cp -n {} fuzz/corpus/recording/ \;
find tcl-like-inputs/ground_motions -name '*.txt' -size -40k -exec cp -n {} fuzz/corpus/ground_motion/ \;

for target in "${targets[@]}"; do
    echo "== $target"
    log=$(mktemp)
    status=0
    cargo +nightly fuzz run "$target" -- -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -max_len=4096 \
        -print_final_stats=1 2>&1 | tee "$log" || status=$?
    inputs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log" | tail -n 1)
    [ -z "$inputs" ] || echo "$target,$version,$seconds,$inputs,$((status != 0))" >> fuzz/counts.csv
    rm -f "$log"
done
