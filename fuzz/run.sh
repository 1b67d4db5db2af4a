#!/usr/bin/env bash
# Runs fuzz targets one after the other: fuzz/run.sh SECONDS [TARGET ...]
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1:?usage: fuzz/run.sh SECONDS [TARGET ...]}
shift
targets=("$@")
[ ${#targets[@]} -gt 0 ] || targets=(script commands study recording ground_motion)

# Shipped inputs are the first ones.
mkdir -p fuzz/corpus/{script,commands,study,recording,ground_motion}
find tcl-like-inputs validation/closed_form -name '*.tcl' -size -40k -exec cp -n {} fuzz/corpus/script/ \;
find tcl-like-inputs validation/recordings -name '*.toml' -exec cp -n {} fuzz/corpus/study/ \;
find tcl-like-inputs -name '*.csv' -size -40k -exec cp -n {} fuzz/corpus/recording/ \;
find tcl-like-inputs/ground_motions -name '*.txt' -size -40k -exec cp -n {} fuzz/corpus/ground_motion/ \;

for target in "${targets[@]}"; do
    echo "== $target"
    cargo +nightly fuzz run "$target" -- -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -max_len=4096 -print_final_stats=1
done
