//! Runs other programs with a log, a time limit and progress lines.

use crate::places::{logs, root};
use anyhow::{Context, Result, anyhow, bail};
use fs_err as fs;
use std::ffi::OsStr;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

const POLL: Duration = Duration::from_millis(50);
const PROGRESS: Duration = Duration::from_secs(15);
const SHOWN_CHARACTERS: usize = 100;
const SHOWN_LINES: usize = 40;

/// A program to run, by default in the workspace's root and for up to one hour.
pub struct Run {
    /// Underlying command.
    pub command: Command,
    name: String,
    limit: Duration,
}

/// How a program ended.
pub struct Ended {
    /// Whether it exited with status 0 within the limit.
    pub success: bool,
    /// Standard output and error, interleaved.
    pub output: String,
    name: String,
}

impl Run {
    /// Takes a name on PATH or a path.
    pub fn new(program: impl AsRef<OsStr>) -> Self {
        let mut command = Command::new(&program);
        // CARGO would force the toolchain that runs xtask.
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

    /// Adds arguments separated by spaces.
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

    /// Sets the name of the log; the default is the program's name.
    pub fn log(mut self, name: &str) -> Self {
        self.name = name.to_owned();
        self
    }

    /// Runs the program, logs its output, and prints the last line of it every 15 s.
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
            ErrorKind::NotFound => anyhow!("program `{}` not found", self.name),
            _ => anyhow!("cannot start `{}`: {error}", self.name),
        })?;
        let (started, mut lines) = (Instant::now(), 0);
        while started.elapsed() < self.limit {
            if let Some(status) = child.try_wait()? {
                return Ok(status.success());
            }
            if started.elapsed() > PROGRESS * (lines + 1) {
                lines += 1;
                println!("    {}, {}: {}", self.name, elapsed(started.elapsed()), last_line(log));
            }
            std::thread::sleep(POLL);
        }
        stop(&mut child)?;
        println!("    stopped {} at its time limit of {}", self.name, elapsed(self.limit));
        Ok(false)
    }
}

/// Kills a program and those that it started, such as npm's browsers. Without `ps` and `kill`, only the program itself.
fn stop(child: &mut Child) -> Result<()> {
    let started = descendants(child.id());
    child.kill()?;
    child.wait()?;
    if !started.is_empty() {
        // Some end by themselves.
        let _ = Command::new("kill").arg("-KILL").args(started).stderr(Stdio::null()).status();
    }
    Ok(())
}

/// Ids of the programs that a program started, directly or not.
fn descendants(of: u32) -> Vec<String> {
    let listed = Command::new("ps").args(["-A", "-o", "pid=,ppid="]).stderr(Stdio::null()).output();
    let listed = listed.map_or_else(|_| String::new(), |listed| String::from_utf8_lossy(&listed.stdout).into_owned());
    let rows: Vec<(&str, &str)> = listed.lines().filter_map(|row| row.trim().split_once(char::is_whitespace)).collect();
    let mut found = vec![of.to_string()];
    let mut next = 0;
    while let Some(parent) = found.get(next).cloned() {
        found.extend(rows.iter().filter(|(_, of)| of.trim() == parent).map(|(id, _)| (*id).to_owned()));
        next += 1;
    }
    found.split_off(1)
}

impl Ended {
    /// Returns the output if the program succeeded, else an error with its last lines.
    pub fn checked(self) -> Result<String> {
        if self.success {
            return Ok(self.output);
        }
        bail!("`{}` failed; last lines of its output:\n{}", self.name, last_lines(&self.output, SHOWN_LINES))
    }
}

/// Last lines of a text.
pub fn last_lines(text: &str, count: usize) -> String {
    let lines: Vec<&str> = text.trim_end().lines().collect();
    lines[lines.len().saturating_sub(count)..].join("\n")
}

/// Prints a title and a reason, does the work, and prints how long it took.
pub fn announced<T>(what: &str, why: &str, work: impl FnOnce() -> Result<T>) -> Result<T> {
    println!("▸ {what} ({why})");
    let started = Instant::now();
    let done = work().with_context(|| format!("{what} failed"));
    println!("  {} {what}, {}", if done.is_ok() { '✓' } else { '✗' }, elapsed(started.elapsed()));
    done
}

/// An error and its causes, one per line, without a backtrace.
pub fn causes(error: &anyhow::Error) -> String {
    error.chain().map(ToString::to_string).collect::<Vec<_>>().join("\n  ")
}

/// Formats a duration: `0.4 s`, `12 s`, `3 min 05 s`.
pub fn elapsed(duration: Duration) -> String {
    match duration.as_secs() {
        0..10 => format!("{:.1} s", duration.as_secs_f64()),
        seconds @ 10..120 => format!("{seconds} s"),
        seconds => format!("{} min {:02} s", seconds / 60, seconds % 60),
    }
}

/// Whether a program is on PATH.
pub fn is_program(name: &str) -> bool {
    find(name).is_some()
}

/// Finds a program on PATH, or by its absolute path.
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

#[cfg(all(test, unix))]
#[allow(clippy::unwrap_used, reason = "a test fails by panicking")]
mod tests {
    use super::*;

    #[test]
    fn a_program_at_its_limit_ends_with_those_that_it_started() {
        let run = Run::new("sh").arg("-c").arg("sh -c 'sleep 600; true' & echo $!; wait").log("limit-test");
        let ended = run.within(Duration::from_secs(1)).run().unwrap();
        let ps = Command::new("ps").args(["-o", "stat=", "-p", ended.output.trim()]).output().unwrap();
        let state = String::from_utf8(ps.stdout).unwrap();
        // A killed program stays as a zombie until its new parent notices.
        assert!(!ended.success && (state.is_empty() || state.starts_with('Z')), "{state}");
    }
}
