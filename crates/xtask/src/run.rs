//! Running other programs: with a log, a time limit and signs of life.

use crate::places::{logs, root};
use anyhow::{Context, Result, anyhow, bail};
use fs_err as fs;
use std::ffi::OsStr;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

const POLL: Duration = Duration::from_millis(50);
const SIGN_OF_LIFE: Duration = Duration::from_secs(15);
const SHOWN_CHARACTERS: usize = 100;
const SHOWN_LINES: usize = 40;

/// A program to run, by default in the root of the workspace and for up to an hour.
pub struct Run {
    /// What the program runs as.
    pub command: Command,
    name: String,
    limit: Duration,
}

/// How a program ended.
pub struct Ended {
    /// Exit status 0 within the limit.
    pub success: bool,
    /// Standard output and error in the order in which they came.
    pub output: String,
    name: String,
}

impl Run {
    /// A program by its name on PATH, or by its path.
    pub fn new(program: impl AsRef<OsStr>) -> Self {
        let mut command = Command::new(&program);
        // cargo names its own toolchain here, which need not be the one that the program is meant to use.
        command.current_dir(root()).stdin(Stdio::null()).env_remove("CARGO");
        let name = Path::new(&program).file_name().unwrap_or_default().to_string_lossy().into_owned();
        Self { command, name, limit: Duration::from_secs(3600) }
    }

    /// Adds one argument.
    pub fn arg(mut self, argument: impl AsRef<OsStr>) -> Self {
        self.command.arg(argument);
        self
    }

    /// Adds arguments.
    pub fn args(mut self, arguments: impl IntoIterator<Item = impl AsRef<OsStr>>) -> Self {
        self.command.args(arguments);
        self
    }

    /// Adds arguments that are separated by spaces.
    pub fn words(self, arguments: &str) -> Self {
        self.args(arguments.split_whitespace())
    }

    /// Sets an environment variable.
    pub fn env(mut self, name: &str, value: impl AsRef<OsStr>) -> Self {
        self.command.env(name, value);
        self
    }

    /// Sets the working directory.
    pub fn current_dir(mut self, folder: impl AsRef<Path>) -> Self {
        self.command.current_dir(folder.as_ref());
        self
    }

    /// Stops the program after this long.
    pub fn within(mut self, limit: Duration) -> Self {
        self.limit = limit;
        self
    }

    /// Names the log after something other than the program.
    pub fn log(mut self, name: &str) -> Self {
        self.name = name.to_owned();
        self
    }

    /// Runs the program, shows the last line of its output now and then, and keeps the output in a log.
    pub fn run(mut self) -> Result<Ended> {
        let file = logs()?.join(format!("{}.log", self.name));
        let log = fs::File::create(&file)?.into_file();
        self.command.stdout(log.try_clone()?).stderr(log);
        let success = self.wait(&file)?;
        let output = String::from_utf8_lossy(&fs::read(&file)?).into_owned();
        Ok(Ended { success, output, name: self.name })
    }

    /// Runs the program and returns its output; fails unless it exits with status 0.
    pub fn checked(self) -> Result<String> {
        self.run()?.checked()
    }

    fn wait(&mut self, log: &Path) -> Result<bool> {
        let mut child = self.command.spawn().map_err(|error| match error.kind() {
            ErrorKind::NotFound => anyhow!("the program `{}` is not on this machine", self.name),
            _ => anyhow!("`{}` does not start: {error}", self.name),
        })?;
        let (started, mut signs) = (Instant::now(), 0);
        while started.elapsed() < self.limit {
            if let Some(status) = child.try_wait()? {
                return Ok(status.success());
            }
            if started.elapsed() > SIGN_OF_LIFE * (signs + 1) {
                signs += 1;
                println!("    {}, {}: {}", self.name, elapsed(started.elapsed()), last_line(log));
            }
            std::thread::sleep(POLL);
        }
        child.kill()?;
        child.wait()?;
        println!("    {} is stopped at its limit of {}", self.name, elapsed(self.limit));
        Ok(false)
    }
}

impl Ended {
    /// The output if the program succeeded, else an error with its last lines.
    pub fn checked(self) -> Result<String> {
        if self.success {
            return Ok(self.output);
        }
        bail!("`{}` failed; the last lines of its output:\n{}", self.name, last_lines(&self.output, SHOWN_LINES))
    }
}

/// The last lines of a text.
pub fn last_lines(text: &str, count: usize) -> String {
    let lines: Vec<&str> = text.trim_end().lines().collect();
    lines[lines.len().saturating_sub(count)..].join("\n")
}

/// Announces what takes a while and why it is needed, does it, and reports how long it took.
pub fn announced<T>(what: &str, why: &str, work: impl FnOnce() -> Result<T>) -> Result<T> {
    println!("▸ {what} ({why})");
    let started = Instant::now();
    let done = work().with_context(|| format!("{what} failed"))?;
    println!("  ✓ {what}, {}", elapsed(started.elapsed()));
    Ok(done)
}

/// An error with its causes, a line each, and without a backtrace.
pub fn causes(error: &anyhow::Error) -> String {
    error.chain().map(ToString::to_string).collect::<Vec<_>>().join("\n  ")
}

/// A duration as people say it: `0.4 s`, `12 s`, `3 min 05 s`.
pub fn elapsed(duration: Duration) -> String {
    match duration.as_secs() {
        0..10 => format!("{:.1} s", duration.as_secs_f64()),
        seconds @ 10..120 => format!("{seconds} s"),
        seconds => format!("{} min {:02} s", seconds / 60, seconds % 60),
    }
}

/// Whether a program is on this machine.
pub fn is_program(name: &str) -> bool {
    find(name).is_some()
}

/// Finds a program on PATH or, given its absolute path, in its place.
pub fn find(name: &str) -> Option<PathBuf> {
    let path = std::env::var_os("PATH")?;
    let file = format!("{name}{}", std::env::consts::EXE_SUFFIX);
    std::env::split_paths(&path).map(|folder| folder.join(&file)).find(|file| file.is_file())
}

fn last_line(log: &Path) -> String {
    let bytes = fs::read(log).unwrap_or_default();
    let text = String::from_utf8_lossy(&bytes);
    let line = text.rsplit(['\n', '\r']).find(|line| !line.trim().is_empty()).unwrap_or_default();
    line.trim().chars().take(SHOWN_CHARACTERS).collect()
}
