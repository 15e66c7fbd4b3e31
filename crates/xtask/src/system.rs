//! Programs of the system, as Debian's packages: installed only where they are missing.

use crate::run::{Run, announced, find, is_program};
use anyhow::{Context, Result, ensure};
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

/// A program that the tests drive: its name, what it is called of which any will do (`$NAME` is a variable that names it),
/// Debian's packages, and why it is needed.
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
    ("Chromium", &CHROMIUM, "chromium", "tests visit the page in it"),
    ("Chromium's driver", &["$CHROMEDRIVER", "chromedriver"], "chromium-driver", "it runs the WebAssembly tests"),
    ("Xvfb", &["Xvfb"], SCREEN, "Firefox and WebKit draw on it"),
    ("Firefox", &["firefox-esr", "firefox"], "firefox-esr", "a test visits the page in it"),
    ("WebKit", &["WebKitWebDriver"], "webkit2gtk-driver", "a test visits the page in it"),
    ("PrusaSlicer, 92 MB", &["prusa-slicer"], "prusa-slicer", "a test slices the bodies for 3D printers with it"),
];

/// Installs the programs that are missing; returns why for each that could not be had, since the tests of the others run
/// all the same.
pub fn obtain() -> Vec<anyhow::Error> {
    let is_here = |name: &&str| match name.strip_prefix('$') {
        Some(variable) => std::env::var_os(variable).is_some(),
        None => is_program(name),
    };
    let missing = PROGRAMS.iter().filter(|(_, names, ..)| !names.iter().any(is_here));
    missing.filter_map(|(name, _, packages, why)| announced(name, why, || install(packages)).err()).collect()
}

/// The Chromium or Chrome that the tests visit the page in.
pub fn chromium() -> Option<PathBuf> {
    let named = std::env::var_os("ROSTO_BROWSER").map(PathBuf::from);
    named.or_else(|| CHROMIUM.into_iter().find_map(find))
}

/// Installs packages with apt-get, as root or through `sudo -n`.
pub fn install(packages: &str) -> Result<()> {
    // apt-get waits for dpkg's lock, but not for that of its own lists.
    static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());
    let _guard = ONE_AT_A_TIME.lock().unwrap_or_else(PoisonError::into_inner);
    let installed = apt_get("install", packages).or_else(|_| {
        // The package lists may be missing or old.
        apt_get("update", "")?;
        apt_get("install", packages)
    });
    installed.with_context(|| format!("install it yourself, on Debian: apt-get install {packages}"))
}

fn apt_get(verb: &str, packages: &str) -> Result<()> {
    ensure!(is_program("apt-get"), "this machine has no apt-get");
    let is_root = Run::new("id").arg("-u").checked()?.trim() == "0";
    // -n: a prompt for a password in the middle of a set-up would look like a hang.
    let sudo = if is_root { "" } else { "sudo -n " };
    let options = "-y -o DPkg::Lock::Timeout=120 --no-install-recommends";
    let command = format!("{sudo}env DEBIAN_FRONTEND=noninteractive apt-get {verb} {options} {packages}");
    Run::new("sh").arg("-c").arg(command).log("apt-get").within(Duration::from_secs(900)).checked().map(|_| ())
}

/// Python with pip and virtual environments, which Debian has in packages of their own.
pub fn with_pip() -> Result<()> {
    match Run::new("python3").arg("-c").arg("import ensurepip, pip").checked() {
        Ok(_) => Ok(()),
        Err(_) => announced("pip", "it installs Python packages", || install("python3-pip python3-venv")),
    }
}
