//! System programs, installed from Debian packages if they are missing.

use crate::run::{Run, announced, find, is_program};
use anyhow::{Context, Result, ensure};
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

/// A program that the tests use: its name, alternative executables (`$NAME` is an environment variable), Debian
/// packages, and its purpose.
type Program = (&'static str, &'static [&'static str], &'static str, &'static str);

const CHROMIUM: [&str; 7] = [
    "$ROSTO_BROWSER",
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    "/Applications/Chromium.app/Contents/MacOS/Chromium",
];
const SCREEN: &str = "xvfb libgl1-mesa-dri libegl1";
const PROGRAMS: [Program; 6] = [
    ("Chromium", &CHROMIUM, "chromium", "runs the end-to-end tests"),
    ("Chromium's driver", &["$CHROMEDRIVER", "chromedriver"], "chromium-driver", "runs the WebAssembly tests"),
    ("Xvfb", &["Xvfb"], SCREEN, "display for Firefox and WebKit"),
    ("Firefox", &["firefox-esr", "firefox"], "firefox-esr", "runs a test of the page"),
    ("WebKit", &["WebKitWebDriver"], "webkit2gtk-driver", "runs a test of the page"),
    ("PrusaSlicer, 92 MB", &["prusa-slicer"], "prusa-slicer", "slices printable bodies in a test"),
];

/// Installs missing programs; returns the errors, because tests without those programs still run.
pub fn obtain() -> Vec<anyhow::Error> {
    let is_here = |name: &&str| match name.strip_prefix('$') {
        Some(variable) => std::env::var_os(variable).is_some(),
        None => is_program(name),
    };
    let missing = PROGRAMS.iter().filter(|(_, names, ..)| !names.iter().any(is_here));
    missing.filter_map(|(name, _, packages, why)| announced(name, why, || install(packages)).err()).collect()
}

/// Path of Chromium or Chrome.
pub fn chromium() -> Option<PathBuf> {
    let named = std::env::var_os("ROSTO_BROWSER").map(PathBuf::from);
    named.or_else(|| CHROMIUM.into_iter().find_map(find))
}

/// Installs packages with apt-get, as root or through `sudo -n`.
pub fn install(packages: &str) -> Result<()> {
    // apt-get waits for dpkg's lock, but not for the lock of its package lists.
    static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());
    let _guard = ONE_AT_A_TIME.lock().unwrap_or_else(PoisonError::into_inner);
    let installed = apt_get("install", packages).or_else(|_| {
        // The package lists may be missing or outdated.
        apt_get("update", "")?;
        apt_get("install", packages)
    });
    installed.with_context(|| format!("install it by hand (on Debian: apt-get install {packages})"))
}

fn apt_get(verb: &str, packages: &str) -> Result<()> {
    ensure!(is_program("apt-get"), "apt-get not found");
    let is_root = Run::new("id").arg("-u").checked()?.trim() == "0";
    // -n, because a password prompt would look like a hang.
    let sudo = if is_root { "" } else { "sudo -n " };
    let options = "-y -o DPkg::Lock::Timeout=120 --no-install-recommends";
    let command = format!("{sudo}env DEBIAN_FRONTEND=noninteractive apt-get {verb} {options} {packages}");
    Run::new("sh").arg("-c").arg(command).log("apt-get").within(Duration::from_secs(900)).checked().map(|_| ())
}

/// Installs pip and venv, which Debian packages separately from Python.
pub fn with_pip() -> Result<()> {
    match Run::new("python3").arg("-c").arg("import ensurepip, pip").checked() {
        Ok(_) => Ok(()),
        Err(_) => announced("pip", "installs Python packages", || install("python3-pip python3-venv")),
    }
}
