//! Needs of tasks.

/// A need of a task, in addition to Rust and Node.js.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Need {
    /// npm packages, face networks and the sample portrait.
    Assets,
    /// Trunk and a compiler for wasm32.
    Page,
    /// The WebAssembly tests' runner.
    WasmPack,
    /// Packages of the Python tests.
    Python,
    /// The newest Chromium, and its driver.
    Chromium,
    /// The oldest Chromium that the tests support.
    OldChromium,
    /// Firefox and WebKit.
    Engines,
    /// Programs that open exported files.
    Readers,
}

/// Needs of the page.
pub const PAGE: [Need; 2] = [Need::Assets, Need::Page];
/// Needs of the gate.
pub const GATE: [Need; 5] = [Need::Assets, Need::Page, Need::WasmPack, Need::Python, Need::Chromium];
