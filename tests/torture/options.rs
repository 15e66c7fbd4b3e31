//! The command line.

use std::path::PathBuf;
use std::time::Duration;

use crate::kinds::Kind;
use crate::run::Plan;

/// What to do and where.
pub struct Options {
    pub task: Task,
    /// Where findings go.
    pub folder: PathBuf,
    /// Where the networks and the sample portrait are.
    pub assets: PathBuf,
}

pub enum Task {
    Run(Plan),
    /// One input of a run.
    Again {
        seed: u64,
        kind: Kind,
        number: u64,
    },
    /// A file.
    File {
        kind: Kind,
        path: PathBuf,
    },
}

const USAGE: &str = "usage: torture [--inputs N] [--seed N] [--seconds N] [--only KIND] [--number N | --file FILE] \
                     [--folder DIR] [--assets DIR]";

impl Options {
    pub fn read(mut words: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut plan = Plan { seed: 1, inputs: 1_000_000, time: None, only: None };
        let (mut folder, mut assets) = (PathBuf::from("target/torture"), PathBuf::from("web/assets"));
        let (mut number, mut file) = (None, None);
        while let Some(word) = words.next() {
            let value = words.next().ok_or(USAGE)?;
            let whole = || value.parse::<u64>().map_err(|_| format!("{word} {value}: not a whole number"));
            match word.as_str() {
                "--inputs" => plan.inputs = whole()?,
                "--seed" => plan.seed = whole()?,
                "--seconds" => plan.time = Some(Duration::from_secs(whole()?)),
                "--only" => plan.only = Some(kind(&value)?),
                "--number" => number = Some(whole()?),
                "--file" => file = Some(PathBuf::from(value)),
                "--folder" => folder = PathBuf::from(value),
                "--assets" => assets = PathBuf::from(value),
                _ => return Err(USAGE.to_owned()),
            }
        }
        let task = match (plan.only, number, file) {
            (Some(kind), Some(number), None) => Task::Again { seed: plan.seed, kind, number },
            (Some(kind), None, Some(path)) => Task::File { kind, path },
            (_, None, None) => Task::Run(plan),
            _ => return Err(format!("--number and --file want --only KIND\n{USAGE}")),
        };
        Ok(Self { task, folder, assets })
    }
}

fn kind(name: &str) -> Result<Kind, String> {
    let found = Kind::ALL.into_iter().find(|kind| kind.name() == name);
    found.ok_or_else(|| format!("{name}: there are {}", Kind::ALL.map(Kind::name).join(", ")))
}
