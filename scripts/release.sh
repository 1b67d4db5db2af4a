#!/bin/sh
# Builds what is delivered: a static binary with models, examples and documents as an archive for each platform, a .deb,
# the notes of the release from CHANGELOG.md, and SHA256SUMS. The files go to target/delivery.
#
#   scripts/release.sh            all platforms below
#   scripts/release.sh TARGET...  some of them, by the name of Rust's target
#
# A platform whose tools are missing is left out. The last lines say for each platform what was built and tried, or why not.
# Only the first one is required.
#
#   x86_64-unknown-linux-gnu     static with glibc, whose mathematics give the numbers of the validation; needs libc6-dev
#   x86_64-pc-windows-gnu        needs gcc-mingw-w64-x86-64, or cargo-zigbuild
#   aarch64-unknown-linux-musl   needs cargo-zigbuild and zig (pip install cargo-zigbuild ziglang)
#   x86_64-apple-darwin          likewise
#   aarch64-apple-darwin         likewise
set -eu

native=x86_64-unknown-linux-gnu
platforms="$native x86_64-pc-windows-gnu aarch64-unknown-linux-musl x86_64-apple-darwin aarch64-apple-darwin"
targets=${*:-$platforms}

cd "$(dirname "$0")/.."
version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -n 1)
built=${CARGO_TARGET_DIR:-target}
out=$built/delivery
report=""
rm -rf "$out"
mkdir -p "$out"

note() { report="$report$1
"; }

has() { command -v "$1" > /dev/null 2>&1; }

# The tool that a target lacks here; nothing if it has all.
lacks() {
    case $1 in
    "$native") ;;
    x86_64-pc-windows-gnu)
        has x86_64-w64-mingw32-gcc || has cargo-zigbuild || echo "there is no gcc-mingw-w64-x86-64 and no cargo-zigbuild" ;;
    *) has cargo-zigbuild || echo "there is no cargo-zigbuild" ;;
    esac
}

# Builds one target; the status says whether there is a binary.
build() {
    if has rustup && ! rustup target list --installed | grep -qx "$1"; then
        rustup target add "$1" || return 1
    fi
    case $1 in
    x86_64-unknown-linux-gnu)
        RUSTFLAGS="-C target-feature=+crt-static" cargo build --profile dist --locked --bin hysteron --target "$1" ;;
    x86_64-pc-windows-gnu)
        if has x86_64-w64-mingw32-gcc; then
            RUSTFLAGS="-C target-feature=+crt-static" cargo build --profile dist --locked --bin hysteron --target "$1"
        else
            zigbuild "$1"
        fi ;;
    *) zigbuild "$1" ;;
    esac
}

# Zig refuses the date in the version text of mimalloc, which the program does not print.
zigbuild() { CFLAGS="${CFLAGS:-} -Wno-date-time" cargo zigbuild --profile dist --locked --bin hysteron --target "$1"; }

# Completions and manual pages, which the program itself writes.
helpers() {
    mkdir -p "$out/helpers/completions"
    for shell in bash zsh fish powershell elvish; do
        "$1" completions $shell > "$out/helpers/completions/hysteron.$shell"
    done
    "$1" man "$out/helpers/man"
}

# A folder with all that an archive holds.
stage() {
    folder=$out/hysteron-$version-$1
    mkdir -p "$folder"
    cp "$2" "$folder/"
    cp -R README.md CHANGELOG.md LICENSE-MIT LICENSE-APACHE docs models "$folder/"
    cp -R tcl-like-inputs "$folder/tcl-like-inputs"
    cp -R "$out/helpers/completions" "$out/helpers/man" "$folder/"
}

pack() {
    name=hysteron-$version-$1
    case $1 in
    *windows*)
        if has zip; then (cd "$out" && zip -qr "$name.zip" "$name")
        else (cd "$out" && python3 -m zipfile -c "$name.zip" "$name"); fi ;;
    *) tar -czf "$out/$name.tar.gz" -C "$out" "$name" ;;
    esac
}

# The Debian package of the native binary.
debian() {
    if ! has dpkg-deb; then
        note "no .deb: there is no dpkg-deb"
        return
    fi
    root=$out/debian
    doc=$root/usr/share/doc/hysteron
    mkdir -p "$root/DEBIAN" "$root/usr/bin" "$root/usr/share/man/man1" "$root/usr/share/hysteron" "$doc" \
        "$root/usr/share/bash-completion/completions" "$root/usr/share/zsh/vendor-completions" \
        "$root/usr/share/fish/vendor_completions.d"
    cp "$1" "$root/usr/bin/hysteron"
    cp "$out"/helpers/man/*.1 "$root/usr/share/man/man1/"
    gzip -9n "$root"/usr/share/man/man1/*.1
    cp "$out/helpers/completions/hysteron.bash" "$root/usr/share/bash-completion/completions/hysteron"
    cp "$out/helpers/completions/hysteron.zsh" "$root/usr/share/zsh/vendor-completions/_hysteron"
    cp "$out/helpers/completions/hysteron.fish" "$root/usr/share/fish/vendor_completions.d/hysteron.fish"
    cp -R models tcl-like-inputs "$root/usr/share/hysteron/"
    cp -R README.md docs "$doc/"
    gzip -9nc CHANGELOG.md > "$doc/changelog.gz"
    {
        echo "hysteron is licensed under either of the following licences, at your option."
        echo "The ground motions in /usr/share/hysteron keep the terms of their sources, which stand beside them."
        echo
        cat LICENSE-MIT
        echo
        cat LICENSE-APACHE
    } > "$doc/copyright"
    find "$root" -type d -exec chmod 755 {} +
    find "$root/usr/share" -type f -exec chmod 644 {} +
    chmod 755 "$root/usr/bin/hysteron"
    cat > "$root/DEBIAN/control" <<CONTROL
Package: hysteron
Version: $version
Architecture: amd64
Maintainer: ${DEB_MAINTAINER:-hysteron developers <hysteron@example.org>}
Installed-Size: $(du -sk "$root/usr" | cut -f 1)
Section: science
Priority: optional
Description: structural analysis of buildings and bridges on seismic isolation
 Runs OpenSees Tcl scripts, designs seismic isolation, calibrates models to
 recordings, and finds the physics that a model lacks.
CONTROL
    dpkg-deb --root-owner-group --build "$root" "$out/hysteron_${version}_amd64.deb"
    rm -rf "$root"
}

# The changes of this version, for the page of the release.
notes() {
    awk -v version="$version" '/^## \[/ { on = index($0, "[" version "]") } on' CHANGELOG.md > "$out/hysteron-$version-notes.md"
    [ -s "$out/hysteron-$version-notes.md" ] || { echo "CHANGELOG.md has no version $version" >&2; exit 1; }
}

# The archive is unpacked. Its program analyses a model, writes and checks the first example, runs it, and calibrates another,
# all in an empty folder.
try() {
    begun=$(date +%s)
    place=$out/trial
    mkdir -p "$place/unpacked" "$place/empty"
    tar -xzf "$out/hysteron-$version-$native.tar.gz" -C "$place/unpacked"
    home=$(cd "$place/unpacked/hysteron-$version-$native" && pwd)
    (cd "$place/empty" && env -i PATH=/usr/bin:/bin "$home/hysteron" init --new building &&
        env -i PATH=/usr/bin:/bin "$home/hysteron" check isolated_building.tcl &&
        env -i PATH=/usr/bin:/bin "$home/hysteron" run isolated_building.tcl &&
        env -i PATH=/usr/bin:/bin "$home/hysteron" run "$home/tcl-like-inputs/isolated_building.tcl" &&
        env -i PATH=/usr/bin:/bin "$home/hysteron" init --new study &&
        env -i PATH=/usr/bin:/bin "$home/hysteron" calibrate study.toml)
    case $(ldd "$home/hysteron" 2>&1 || true) in
    *"statically linked"* | *"not a dynamic executable"*) echo "the binary is static" ;;
    *)
        echo "the binary is not static" >&2
        exit 1 ;;
    esac
    rm -rf "$place"
    note "$native: unpacked and tried in an empty folder in $(($(date +%s) - begun)) s"
}

for target in $targets; do
    missing=$(lacks "$target")
    if [ -n "$missing" ]; then
        note "$target: not built, $missing"
        continue
    fi
    case $target in *windows*) file=hysteron.exe ;; *) file=hysteron ;; esac
    if build "$target"; then
        binary=$built/$target/dist/$file
        if [ "$target" = $native ]; then
            helpers "$binary"
            debian "$binary"
        elif [ ! -d "$out/helpers" ]; then
            echo "the first target must be $native: it writes the completions and manual pages" >&2
            exit 1
        fi
        stage "$target" "$binary"
        pack "$target"
        note "$target: $(wc -c < "$binary" | tr -d ' ') bytes"
        if [ "$target" = $native ]; then try; else note "$target: not tried, this machine is of another kind"; fi
    elif [ "$target" = $native ]; then
        exit 1
    else
        note "$target: not built, the compiler failed (see above)"
    fi
done
for target in $platforms; do
    case " $targets " in *" $target "*) ;; *) note "$target: not built, it was not asked for" ;; esac
done
note "wheels for Python: not built here, scripts/wheels.sh makes them"
rm -rf "$out/helpers" "$out"/hysteron-"$version"-*/
notes
if has sha256sum; then sum="sha256sum"; else sum="shasum -a 256"; fi
(cd "$out" && $sum hysteron* > SHA256SUMS)
printf '\n%s' "$report"
ls -l "$out"
