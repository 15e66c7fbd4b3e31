//! Programs of the system, as Debian's packages: installed only where they are missing.

use crate::run::{Run, announced, is_program};
use anyhow::{Context, Result, ensure};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

/// A program that the tests drive.
struct Program {
    name: &'static str,
    /// Any of them will do.
    programs: &'static [&'static str],
    /// Names the program where it is not on PATH.
    variable: &'static str,
    packages: &'static str,
    why: &'static str,
}

const PROGRAMS: [Program; 6] = [
    Program {
        name: "Chromium",
        programs: &[
            "chromium",
            "chromium-browser",
            "google-chrome",
            "google-chrome-stable",
            "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
            "/Applications/Chromium.app/Contents/MacOS/Chromium",
        ],
        variable: "ROSTO_BROWSER",
        packages: "chromium",
        why: "the tests visit the page in it",
    },
    Program {
        name: "Chromium's driver",
        programs: &["chromedriver"],
        variable: "CHROMEDRIVER",
        packages: "chromium-driver",
        why: "it runs the WebAssembly tests in Chromium",
    },
    Program {
        name: "Xvfb",
        programs: &["Xvfb"],
        variable: "",
        packages: "xvfb libgl1-mesa-dri libegl1",
        why: "Firefox and WebKit draw on it",
    },
    Program {
        name: "Firefox",
        programs: &["firefox-esr", "firefox"],
        variable: "",
        packages: "firefox-esr",
        why: "a test visits the page in it",
    },
    Program {
        name: "WebKit",
        programs: &["WebKitWebDriver"],
        variable: "",
        packages: "webkit2gtk-driver",
        why: "a test visits the page in it",
    },
    Program {
        name: "PrusaSlicer, 92 MB",
        programs: &["prusa-slicer"],
        variable: "",
        packages: "prusa-slicer",
        why: "a test has it slice the bodies for 3D printers",
    },
];

/// Installs the programs that are missing; returns why for each that could not be had, since the tests of the others run
/// all the same.
pub fn obtain() -> Vec<anyhow::Error> {
    PROGRAMS.iter().filter_map(|program| program.obtain().err()).collect()
}

impl Program {
    fn obtain(&self) -> Result<()> {
        if std::env::var_os(self.variable).is_some() || self.programs.iter().any(|name| is_program(name)) {
            return Ok(());
        }
        announced(self.name, self.why, || install(self.packages))
    }
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
