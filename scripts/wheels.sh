#!/bin/sh
# Builds the wheels of the Python package, one for each platform and for all of CPython from 3.10 on. They go to target/wheels.
#
#   scripts/wheels.sh            all platforms below
#   scripts/wheels.sh TARGET...  some of them, by the name of Rust's target
#
# It needs maturin, cargo-zigbuild and zig (pip install maturin cargo-zigbuild ziglang), which links for all of them. A platform
# whose tools are missing is left out, and the last lines say so. A wheel may have at most 10 MB. The wheel of this machine is
# installed in an empty environment and analyses a model there.
#
#   x86_64-unknown-linux-gnu     glibc 2.17 and later
#   aarch64-unknown-linux-gnu    likewise
#   x86_64-unknown-linux-musl    musl 1.2 and later
#   aarch64-unknown-linux-musl   likewise
#   x86_64-apple-darwin          macOS
#   aarch64-apple-darwin         likewise
#   x86_64-pc-windows-gnu        Windows
set -eu

all="x86_64-unknown-linux-gnu aarch64-unknown-linux-gnu x86_64-unknown-linux-musl aarch64-unknown-linux-musl \
x86_64-apple-darwin aarch64-apple-darwin x86_64-pc-windows-gnu"
limit=10000000

cd "$(dirname "$0")/.."
out=$(pwd)/target/wheels
native=$(rustc -vV | sed -n 's/^host: //p')
report=""
status=0
mkdir -p "$out"

note() { report="$report$1
"; }

# The policy of the platform, by which installers know where the wheel runs.
compatibility() {
    case $1 in
    *-linux-gnu) echo "--compatibility manylinux2014" ;;
    *-linux-musl) echo "--compatibility musllinux_1_2" ;;
    esac
}

build() {
    if ! rustup target list --installed | grep -qx "$1"; then
        rustup target add "$1" || return 1
    fi
    # Zig refuses the date in the version text of mimalloc.
    # shellcheck disable=SC2046
    CFLAGS="${CFLAGS:-} -Wno-date-time" maturin build --release --compression-level 9 --zig --target "$1" $(compatibility "$1") --manifest-path bindings/python/Cargo.toml --out "$out/$1"
}

# The wheel in an environment of its own: a spring gives under its load.
try() {
    python3 -m venv "$out/environment"
    "$out/environment/bin/pip" install --quiet "$1"
    (cd "$out" && environment/bin/python - << 'END'
import hysteron.opensees as ops

ops.model("basic", "-ndm", 1, "-ndf", 1)
ops.node(1, 0.0)
ops.node(2, 0.0)
ops.fix(1, 1)
ops.uniaxialMaterial("Elastic", 1, 4.0)
ops.element("zeroLength", 1, 1, 2, "-mat", 1, "-dir", 1)
ops.timeSeries("Linear", 1)
ops.pattern("Plain", 1, 1)
ops.load(2, 2.0)
ops.analysis("Static")
assert ops.analyze(1) == 0 and abs(ops.nodeDisp(2, 1) - 0.5) < 1e-12
print("the wheel analyses a model")
END
    )
    rm -rf "$out/environment"
}

for target in ${*:-$all}; do
    rm -rf "${out:?}/$target"
    if build "$target"; then
        wheel=$(find "$out/$target" -name '*.whl')
        size=$(wc -c < "$wheel" | tr -d ' ')
        note "$target: $(basename "$wheel"), $size bytes"
        if [ "$size" -gt $limit ]; then
            note "$target: over $limit bytes"
            status=1
        fi
        if [ "$target" = "$native" ]; then try "$wheel"; fi
    else
        note "$target: left out, its tools are missing or failed (see above)"
    fi
done
printf '\n%s' "$report"
exit $status
