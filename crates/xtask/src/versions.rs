//! Every third-party thing that set-up fetches, its version and its sha256, in this one place.
//!
//! Two kinds of versions stand elsewhere, because Cargo and npm already write them down: wasm-bindgen's command line
//! follows `Cargo.lock` (see [`crate::workspace::locked_version`]); the npm package with the networks and what
//! the page's tests use follow `package-lock.json`.

/// Builds the page: runs cargo and wasm-bindgen over `index.html`.
pub const TRUNK: &str = "0.22.1";

/// Runs the wasm tests in headless Chrome.
pub const WASM_PACK: &str = "0.15.1";

/// Checks licences, bans and sources of what is compiled.
pub const CARGO_DENY: &str = "0.20.2";

/// Compares the published crates with their last release.
pub const CARGO_SEMVER_CHECKS: &str = "0.51.0";

/// Runs the fuzz targets with libFuzzer.
pub const CARGO_FUZZ: &str = "0.13.2";

/// A file of which only the one with this sha256 is accepted.
pub struct PinnedFile {
    /// Path below the folder that holds it.
    pub path: &'static str,
    /// Lower-case hexadecimal sha256.
    pub sha256: &'static str,
}

/// The npm package that publishes the two face networks.
pub const NETWORKS_PACKAGE: &str = "@mediapipe/face_mesh";

/// The packed networks inside it.
pub const PACKED_NETWORKS: PinnedFile = PinnedFile {
    path: "face_mesh_solution_packed_assets.data",
    sha256: "dbe5905c582c0462cdaea17e7e6ecea92edaa8cccc515c5e2e7291f2cbb5fb99",
};

/// The Python package whose wheel carries the sample portrait.
pub const PORTRAIT_PACKAGE: &str = "scikit-image";

/// Its version.
pub const PORTRAIT_PACKAGE_VERSION: &str = "0.25.2";

/// The interpreter and platform whose wheel is asked for, so that every machine downloads the same file.
pub const PORTRAIT_WHEEL_TAGS: [&str; 2] = ["--python-version=3.11", "--platform=manylinux2014_x86_64"];

/// That wheel.
pub const PORTRAIT_WHEEL: PinnedFile = PinnedFile {
    path: "scikit_image-0.25.2-cp311-cp311-manylinux_2_17_x86_64.manylinux2014_x86_64.whl",
    sha256: "24cc986e1f4187a12aa319f777b36008764e856e5013666a4a83f8df083c2641",
};

/// The portrait inside the wheel: 512×512 px, NASA, public domain.
pub const PORTRAIT: PinnedFile = PinnedFile {
    path: "skimage/data/astronaut.png",
    sha256: "88431cd9653ccd539741b555fb0a46b61558b301d4110412b5bc28b5e3ea6cb5",
};

/// Debian's package with pip, for machines without Python.
pub const DEBIAN_PIP: [&str; 1] = ["python3-pip"];

/// Debian's packages with a compiler and the library sources, for machines where rustup cannot add a target.
pub const DEBIAN_TOOLCHAIN: [&str; 5] = ["rustc-web", "cargo-web", "rust-web-src", "rust-web-clippy", "lld-22"];

/// Debian's packages with a browser and its driver.
pub const DEBIAN_BROWSER: [&str; 2] = ["chromium", "chromium-driver"];

/// Debian's packages with a screen that nobody sees, and what draws on it in software.
pub const DEBIAN_SCREEN: [&str; 3] = ["xvfb", "libgl1-mesa-dri", "libegl1"];

/// Debian's package with Firefox.
pub const DEBIAN_FIREFOX: [&str; 1] = ["firefox-esr"];

/// Debian's package with WebKitGTK, a small browser around it and its driver.
pub const DEBIAN_WEBKIT: [&str; 1] = ["webkit2gtk-driver"];

/// Debian's package with a slicer for 3D printers.
pub const DEBIAN_SLICER: [&str; 1] = ["prusa-slicer"];
