//! The browsers the tests drive: Chromium or Chrome with the driver of the same version for all of them, and Firefox and
//! WebKit for the way through the page that has to work in every engine.

use crate::failure::{Failure, Result};
use crate::process::{Run, find_program};
use crate::{apt, progress, versions};
use std::ffi::OsString;
use std::path::PathBuf;
use std::time::Instant;

const BROWSERS: [&str; 5] = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"];
const ELSEWHERE: [&str; 2] = [
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    "/Applications/Chromium.app/Contents/MacOS/Chromium",
];
const DRIVER: &str = "chromedriver";

/// What the journey through the other engines needs: the programs that do, under any of their names, and what to install.
const ENGINES: [Engine; 3] = [
    Engine {
        name: "Xvfb",
        programs: &["Xvfb"],
        packages: &versions::DEBIAN_SCREEN,
        why: "Firefox and WebKit draw on it",
    },
    Engine {
        name: "Firefox",
        programs: &["firefox-esr", "firefox"],
        packages: &versions::DEBIAN_FIREFOX,
        why: "a test runs the page in it",
    },
    Engine {
        name: "WebKit",
        programs: &["WebKitWebDriver"],
        packages: &versions::DEBIAN_WEBKIT,
        why: "a test runs the page in it",
    },
];

struct Engine {
    name: &'static str,
    programs: &'static [&'static str],
    packages: &'static [&'static str],
    why: &'static str,
}

/// Installs the engines beside Chromium that are missing, and says which of them could not be had.
///
/// Each comes by itself: where one cannot be had, the others are tested all the same.
pub fn obtain_engines() -> Vec<Failure> {
    let missing: Vec<Failure> = ENGINES.iter().filter_map(|engine| engine.obtain().err()).collect();
    missing.iter().for_each(|failure| progress::note(&failure.to_string()));
    missing
}

impl Engine {
    fn obtain(&self) -> Result {
        if self.is_here() {
            return Ok(());
        }
        progress::announce(self.name, self.why);
        let started = Instant::now();
        let installed = apt::install(self.packages);
        if !self.is_here() {
            let missing = Failure::new(format!("{} cannot be had, so the page is not tested in it", self.name));
            return Err(installed.as_ref().err().iter().fold(missing, |missing, cause| missing.because(cause)));
        }
        progress::done(self.name, started);
        Ok(())
    }

    fn is_here(&self) -> bool {
        self.programs.iter().any(|program| find_program(program).is_some())
    }
}

/// Chooses the browser by hand.
pub const BROWSER_VARIABLE: &str = "ROSTO_BROWSER";
/// Chooses its driver by hand; wasm-pack reads it too.
pub const DRIVER_VARIABLE: &str = "CHROMEDRIVER";

/// A browser and its driver.
#[derive(Clone, Debug)]
pub struct Browser {
    /// The browser's program.
    pub program: PathBuf,
    /// The driver's program; without one, wasm-pack fetches its own.
    pub driver: Option<PathBuf>,
}

impl Browser {
    /// Finds one, or installs Debian's.
    pub fn obtain() -> Result<Self> {
        if let Some(found) = Self::find().filter(|browser| browser.driver.is_some()) {
            return Ok(found);
        }
        progress::announce("Chromium and its driver", "the tests run the page in it");
        let started = Instant::now();
        let installed = apt::install(&versions::DEBIAN_BROWSER);
        let found = Self::find().ok_or_else(|| {
            let none = Failure::new("the tests need Chromium or Chrome, and there is none");
            let none = installed.as_ref().err().iter().fold(none, |none, cause| none.because(cause));
            none.advice(format!("install one, or name it in {BROWSER_VARIABLE} (and its driver in {DRIVER_VARIABLE})"))
        })?;
        progress::done("Chromium", started);
        if found.driver.is_none() {
            progress::note("no chromedriver of its version was found; wasm-pack will look for one itself");
        }
        Ok(found)
    }

    /// What the environment of the journeys and of wasm-pack needs to use it.
    pub fn variables(&self) -> Vec<(String, OsString)> {
        let browser = (BROWSER_VARIABLE.to_owned(), self.program.clone().into_os_string());
        let driver = self.driver.clone().map(|driver| (DRIVER_VARIABLE.to_owned(), driver.into_os_string()));
        std::iter::once(browser).chain(driver).collect()
    }

    fn find() -> Option<Self> {
        let program = named(BROWSER_VARIABLE)
            .or_else(|| BROWSERS.into_iter().find_map(find_program))
            .or_else(|| ELSEWHERE.into_iter().map(PathBuf::from).find(|file| file.is_file()))?;
        let driver = named(DRIVER_VARIABLE).or_else(|| find_program(DRIVER));
        let driver = driver.filter(|driver| major_version(driver) == major_version(&program));
        Some(Self { program, driver })
    }
}

fn named(variable: &str) -> Option<PathBuf> {
    std::env::var_os(variable).map(PathBuf::from).filter(|file| file.is_file())
}

/// What stands before the first dot of the version that `--version` prints; `None` if it prints none.
fn major_version(program: &PathBuf) -> Option<u32> {
    let printed = Run::new(program).arg("--version").quietly().ok()?.checked().ok()?;
    major_version_in(&printed)
}

fn major_version_in(printed: &str) -> Option<u32> {
    // A start script may print complaints of its own around the version.
    let mut versions = printed.split_whitespace().filter(|word| word.split('.').count() == 4);
    versions.find_map(|version| version.split('.').next()?.parse().ok())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_the_major_version_of_browser_and_driver() {
        let browser = "/usr/bin/chromium: 9: [: 252: unexpected operator\nChromium 156.0.8078.79 built on Debian\n";
        assert_eq!(major_version_in(browser), Some(156));
        assert_eq!(major_version_in("ChromeDriver 155.0.1.2 (a21ce95)"), Some(155));
        assert_eq!(major_version_in("no such thing"), None);
    }
}
