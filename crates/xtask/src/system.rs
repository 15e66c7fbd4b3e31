//! System programs, installed from Debian packages if they are missing.

use crate::need::Need;
use crate::places::{cache, remove_folder};
use crate::run::{Run, announced, causes, find, is_program};
use anyhow::{Context, Result, ensure};
use fs_err as fs;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

/// A program that a need consists of: its name, alternative executables (`$NAME` is an environment variable), Debian
/// packages, and its purpose.
type Program = (Need, &'static str, &'static [&'static str], &'static str, &'static str);

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
    (Need::Chromium, "Chromium", &CHROMIUM, "chromium", "runs the end-to-end tests"),
    (
        Need::Chromium,
        "Chromium's driver",
        &["$CHROMEDRIVER", "chromedriver"],
        "chromium-driver",
        "runs the WebAssembly tests",
    ),
    (Need::Engines, "Xvfb", &["Xvfb"], SCREEN, "display for Firefox and WebKit"),
    (Need::Engines, "Firefox", &["firefox-esr", "firefox"], "firefox-esr", "runs a test of the page"),
    (Need::Engines, "WebKit", &["WebKitWebDriver"], "webkit2gtk-driver", "runs a test of the page"),
    (Need::Readers, "PrusaSlicer, 92 MB", &["prusa-slicer"], "prusa-slicer", "slices printable bodies in a test"),
];
/// Age at which package lists are refreshed; older ones install an older browser.
const LISTS_LAST: Duration = Duration::from_secs(24 * 3600);
/// Packages whose newest version the tests use.
const NEWEST: &str = "chromium chromium-driver";

/// Installs missing programs; returns the errors, because tests without those programs still run.
pub fn obtain(needs: &[Need]) -> Vec<anyhow::Error> {
    if needs.contains(&Need::Chromium) {
        refresh();
    }
    let is_here = |name: &&str| match name.strip_prefix('$') {
        Some(variable) => std::env::var_os(variable).is_some(),
        None => is_program(name),
    };
    let wanted = PROGRAMS.iter().filter(|(need, ..)| needs.contains(need));
    let missing = wanted.filter(|(_, _, names, ..)| !names.iter().any(is_here));
    missing.filter_map(|(_, name, _, packages, why)| announced(name, why, || install(packages)).err()).collect()
}

/// Updates old package lists, and an installed Chromium. Without apt-get or its rights, the tests use the installed one.
fn refresh() {
    let is_chosen = std::env::var_os("ROSTO_BROWSER").is_some();
    if is_chosen || !is_program("apt-get") || lists_are_new().unwrap_or(false) {
        return;
    }
    let refreshed = announced("package lists", "older than a day; the tests use the newest browser", || {
        update()?;
        apt_get("install --only-upgrade", NEWEST)
    });
    if let Err(why) = refreshed {
        println!("  · {}", causes(&why));
    }
}

/// File that marks the time of the last update.
fn lists_stamp() -> Result<PathBuf> {
    Ok(cache()?.join("package-lists"))
}

fn lists_are_new() -> Result<bool> {
    Ok(fs::metadata(lists_stamp()?)?.modified()?.elapsed()? < LISTS_LAST)
}

fn update() -> Result<()> {
    apt_get("update", "")?;
    fs::create_dir_all(cache()?)?;
    Ok(fs::write(lists_stamp()?, "")?)
}

/// Path of Chromium or Chrome; prints its version.
pub fn chromium() -> Option<PathBuf> {
    let named = std::env::var_os("ROSTO_BROWSER").map(PathBuf::from);
    let program = named.or_else(|| CHROMIUM.into_iter().find_map(find))?;
    let version = Run::new(&program).arg("--version").log("browser").checked().unwrap_or_default();
    // After the warnings of a start script.
    let version = version.trim().lines().last().unwrap_or("unknown version");
    println!("  · browser of the tests: {version} ({})", program.display());
    Some(program)
}

/// The oldest Chromium that Debian offers, unpacked into the cache; or `$ROSTO_OLDEST_BROWSER`.
pub fn oldest_chromium() -> Result<PathBuf> {
    if let Some(named) = std::env::var_os("ROSTO_OLDEST_BROWSER") {
        return Ok(named.into());
    }
    let offers = Run::new("apt-cache").words("madison chromium").checked().context("set ROSTO_OLDEST_BROWSER")?;
    let last = offers.lines().last().and_then(|line| line.split('|').nth(1));
    let version = last.context("Debian offers no Chromium; set ROSTO_OLDEST_BROWSER")?.trim();
    let folder = cache()?.join(format!("chromium-{version}"));
    let program = folder.join("usr/lib/chromium/chromium");
    if !program.is_file() {
        announced(&format!("Chromium {version}"), "the oldest browser of the tests", || unpack(version, &folder))?;
    }
    Ok(program)
}

fn unpack(version: &str, folder: &Path) -> Result<()> {
    remove_folder(folder)?;
    fs::create_dir_all(folder)?;
    for package in ["chromium", "chromium-common"] {
        Run::new("apt-get").arg("download").arg(format!("{package}={version}")).current_dir(folder).checked()?;
    }
    let packages = "for package in *.deb; do dpkg-deb -x \"$package\" . && rm \"$package\"; done";
    Run::new("sh").args(["-c", packages]).current_dir(folder).checked().map(|_| ())
}

/// Installs packages with apt-get, as root or through `sudo -n`.
pub fn install(packages: &str) -> Result<()> {
    let installed = apt_get("install", packages).or_else(|_| {
        // The package lists may be missing.
        update()?;
        apt_get("install", packages)
    });
    installed.with_context(|| format!("install it by hand (on Debian: apt-get install {packages})"))
}

fn apt_get(verb: &str, packages: &str) -> Result<()> {
    ensure!(is_program("apt-get"), "apt-get not found");
    // apt-get waits for dpkg's lock, but not for the lock of its package lists.
    static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());
    let _guard = ONE_AT_A_TIME.lock().unwrap_or_else(PoisonError::into_inner);
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
