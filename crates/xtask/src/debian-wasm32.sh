#!/bin/sh
# Builds Rust's library for wasm32 from Debian's compiler and sources into the sysroot $1, if rustup cannot download it.
# $1/bin contains a rustc and a cargo that use the sysroot. System folders stay unchanged.
set -eu
at=$1
target=wasm32-unknown-unknown
rm -rf "$at"
mkdir -p "$at/bin" "$at/lib/rustlib/$target/lib" "$at/empty/src"

printf '[package]\nname = "empty"\nedition = "2024"\n[workspace]\n' > "$at/empty/Cargo.toml"
echo '#![no_std]' > "$at/empty/src/lib.rs"
(
  cd "$at/empty"
  unset RUSTUP_TOOLCHAIN RUSTFLAGS
  export RUSTC_BOOTSTRAP=1 RUSTC=/usr/bin/rustc CARGO_TARGET_DIR="$at/empty/target"
  /usr/bin/cargo build --release -Z build-std=std,panic_abort,test --target "$target"
  rm target/$target/release/deps/libempty-*
  cp target/$target/release/deps/*.rlib "$at/lib/rustlib/$target/lib"
)
rm -r "$at/empty"

# Host libraries for build scripts and procedural macros, and the linker.
for lib in /usr/lib/rustlib/*-linux-*/lib; do
  host="$at/lib/rustlib/$(basename "$(dirname "$lib")")"
  mkdir -p "$host/bin"
  ln -s "$lib" "$host/lib"
  ln -s /usr/bin/lld-22 "$host/bin/rust-lld"
done

# clippy-driver reads SYSROOT. cargo-clippy runs the clippy-driver in its own folder.
printf '#!/bin/sh\nexec /usr/bin/rustc --sysroot "%s" "$@"\n' "$at" > "$at/bin/rustc"
printf '#!/bin/sh\nexport RUSTC="%s/bin/rustc" SYSROOT="%s"\nexec /usr/bin/cargo "$@"\n' "$at" "$at" > "$at/bin/cargo"
chmod +x "$at/bin/rustc" "$at/bin/cargo"
for name in cargo-clippy clippy-driver rustdoc; do
  if [ -e "/usr/bin/$name" ]; then ln -s "/usr/bin/$name" "$at/bin/$name"; fi
done
