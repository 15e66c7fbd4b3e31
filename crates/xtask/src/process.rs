//! Running other programs: with a log, a time limit, and a message when the program is not there.

use crate::failure::{Doing, Failure, Result};
use crate::progress::Ticker;
use std::ffi::{OsStr, OsString};
use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

const POLL: Duration = Duration::from_millis(50);
const TAIL_LINES: usize = 30;

/// A program to run.
pub struct Run {
    command: Command,
    shown: String,
    limits: Limits,
    log: Option<PathBuf>,
}

/// When a program is given up.
#[derive(Default)]
struct Limits {
    total: Option<Duration>,
    /// Given up when neither its output nor this folder has grown for so long.
    stall: Option<(Duration, PathBuf)>,
}

/// How a program ended, with all it printed.
pub struct Ended {
    /// Exit status 0 within the limits.
    pub success: bool,
    /// Set when it was given up.
    pub given_up: Option<String>,
    /// Standard output and error as they came.
    pub output: String,
    /// Wall-clock time it took.
    pub took: Duration,
    shown: String,
    status: Option<ExitStatus>,
}

impl Run {
    /// A program by name (looked up on PATH) or path.
    pub fn new(program: impl AsRef<OsStr>) -> Self {
        let shown = Path::new(program.as_ref()).file_name().unwrap_or(program.as_ref()).to_string_lossy().into_owned();
        let mut command = Command::new(program);
        command.stdin(Stdio::null());
        Self { command, shown, limits: Limits::default(), log: None }
    }

    /// Adds one argument.
    pub fn arg(mut self, arg: impl AsRef<OsStr>) -> Self {
        self.shown.push(' ');
        self.shown.push_str(&arg.as_ref().to_string_lossy());
        self.command.arg(arg);
        self
    }

    /// Adds arguments.
    pub fn args<S: AsRef<OsStr>>(self, args: impl IntoIterator<Item = S>) -> Self {
        args.into_iter().fold(self, Self::arg)
    }

    /// Sets an environment variable.
    pub fn env(mut self, name: &str, value: impl AsRef<OsStr>) -> Self {
        self.command.env(name, value);
        self
    }

    /// Sets several.
    pub fn envs(mut self, variables: &[(String, OsString)]) -> Self {
        self.command.envs(variables.iter().map(|(name, value)| (name, value)));
        self
    }

    /// Takes an environment variable away.
    pub fn without_env(mut self, name: &str) -> Self {
        self.command.env_remove(name);
        self
    }

    /// Sets the working directory.
    pub fn current_dir(mut self, folder: impl AsRef<Path>) -> Self {
        self.command.current_dir(folder);
        self
    }

    /// Gives the program up after this long.
    pub fn within(mut self, limit: Duration) -> Self {
        self.limits.total = Some(limit);
        self
    }

    /// Gives the program up when neither its output nor the bytes in `folder` have changed for this long.
    pub fn unless_stalled(mut self, limit: Duration, folder: impl Into<PathBuf>) -> Self {
        self.limits.stall = Some((limit, folder.into()));
        self
    }

    /// Keeps the output in this file instead of a temporary one.
    pub fn log_to(mut self, file: impl Into<PathBuf>) -> Self {
        self.log = Some(file.into());
        self
    }

    /// Runs it, showing its last line now and then. `Err` only if it could not be started.
    pub fn run(self) -> Result<Ended> {
        let mut ticker = Ticker::new();
        self.run_with(|log| ticker.tick(|| last_line(log)))
    }

    /// Runs it without showing anything. `Err` only if it could not be started.
    pub fn quietly(self) -> Result<Ended> {
        self.run_with(|_| ())
    }

    /// Starts it beside this program, with this program's output.
    pub fn spawn(mut self) -> Result<Child> {
        self.command.spawn().map_err(|error| not_started(&self.shown, &error))
    }

    fn run_with(mut self, mut show: impl FnMut(&Path)) -> Result<Ended> {
        let kept = self.log.take();
        let log = kept.clone().unwrap_or_else(temporary_log);
        let file = File::create(&log).doing(format!("creating {}", log.display()))?;
        let copy = file.try_clone().doing("sharing the log of a program")?;
        let started = Instant::now();
        let mut child =
            self.command.stdout(file).stderr(copy).spawn().map_err(|error| not_started(&self.shown, &error))?;
        let mut watch = Watch::new(&self.limits, &log);
        let (status, given_up) = loop {
            if let Some(status) = child.try_wait().doing(format!("waiting for {}", self.shown))? {
                break (Some(status), None);
            }
            if let Some(reason) = watch.expired() {
                // Both fail only when the program has just ended by itself.
                let _ = child.kill();
                let _ = child.wait();
                break (None, Some(reason));
            }
            show(&log);
            std::thread::sleep(POLL);
        };
        let output = String::from_utf8_lossy(&std::fs::read(&log).doing("reading a program's log")?).into_owned();
        if kept.is_none() {
            // A log left behind in the temporary folder does no harm.
            let _ = std::fs::remove_file(&log);
        }
        let success = status.is_some_and(|status| status.success());
        Ok(Ended { success, given_up, output, took: started.elapsed(), shown: self.shown, status })
    }
}

impl Ended {
    /// The output if it succeeded, else a failure with the last lines.
    pub fn checked(self) -> Result<String> {
        if self.success { Ok(self.output) } else { Err(Failure::new(self.describe())) }
    }

    /// How it failed, with the last lines of what it printed.
    pub fn describe(&self) -> String {
        let end = match (&self.given_up, self.status) {
            (Some(reason), _) => reason.clone(),
            (None, Some(status)) => format!("ended with {status}"),
            (None, None) => "ended".to_owned(),
        };
        let lines: Vec<&str> = self.output.lines().collect();
        let tail = lines[lines.len().saturating_sub(TAIL_LINES)..].join("\n");
        format!("`{}` {end} after {}\n{tail}", self.shown, crate::progress::elapsed(self.took))
    }
}

/// Finds a program on PATH, or `None`.
pub fn find_program(name: &str) -> Option<PathBuf> {
    let path = std::env::var_os("PATH")?;
    let file_name = format!("{name}{}", std::env::consts::EXE_SUFFIX);
    std::env::split_paths(&path).map(|folder| folder.join(&file_name)).find(|file| file.is_file())
}

struct Watch<'a> {
    limits: &'a Limits,
    log: &'a Path,
    started: Instant,
    changed: Instant,
    bytes: u64,
}

impl<'a> Watch<'a> {
    fn new(limits: &'a Limits, log: &'a Path) -> Self {
        let now = Instant::now();
        Self { limits, log, started: now, changed: now, bytes: 0 }
    }

    fn expired(&mut self) -> Option<String> {
        if let Some(limit) = self.limits.total.filter(|limit| self.started.elapsed() > *limit) {
            return Some(format!("was given up at its limit of {} s", limit.as_secs()));
        }
        let (limit, folder) = self.limits.stall.as_ref()?;
        let bytes = size_of(self.log) + folder_size(folder);
        if bytes != self.bytes {
            (self.bytes, self.changed) = (bytes, Instant::now());
        }
        (self.changed.elapsed() > *limit).then(|| format!("was given up: nothing arrived for {} s", limit.as_secs()))
    }
}

fn not_started(shown: &str, error: &std::io::Error) -> Failure {
    let program = shown.split(' ').next().unwrap_or(shown);
    if error.kind() == std::io::ErrorKind::NotFound {
        Failure::new(format!("the program `{program}` is not on this machine"))
    } else {
        Failure::new(format!("`{shown}` could not be started: {error}"))
    }
}

fn temporary_log() -> PathBuf {
    use std::sync::atomic::{AtomicUsize, Ordering};
    static NEXT: AtomicUsize = AtomicUsize::new(0);
    let number = NEXT.fetch_add(1, Ordering::Relaxed);
    std::env::temp_dir().join(format!("rosto-xtask-{}-{number}.log", std::process::id()))
}

fn last_line(log: &Path) -> String {
    let bytes = std::fs::read(log).unwrap_or_default();
    let text = String::from_utf8_lossy(&bytes);
    text.split(['\n', '\r']).rev().find(|line| !line.trim().is_empty()).unwrap_or("").to_owned()
}

fn size_of(file: &Path) -> u64 {
    std::fs::metadata(file).map_or(0, |data| data.len())
}

fn folder_size(folder: &Path) -> u64 {
    std::fs::read_dir(folder).map_or(0, |entries| entries.flatten().map(|entry| size_of(&entry.path())).sum())
}
