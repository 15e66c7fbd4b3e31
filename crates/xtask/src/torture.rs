//! `cargo xtask torture`: what takes too long for the tests. Broken bytes for every reader, and visitors who do anything
//! in any order, natively and on the page.

mod parts;
mod table;

use crate::failure::{Failure, Result};
use crate::figures::Document;
use crate::{progress, setup};
use parts::Part;
use std::process::ExitCode;
use std::time::Instant;

/// How much of each part is done.
#[derive(Clone, Debug, PartialEq)]
struct Amounts {
    inputs: u64,
    actions: u64,
    page_actions: u64,
    write: bool,
}

/// Runs all parts, or those whose amount is not 0, and fails if one of them found something.
pub fn run(arguments: &[&str]) -> Result<ExitCode> {
    let amounts = Amounts::read(arguments)?;
    let kit = setup::for_tests()?;
    let mut found_nothing = true;
    for part in parts::chosen(&amounts) {
        progress::announce(part.name, &format!("{} {}", table::grouped(part.amount), part.what));
        if let Some(missing) = (part.missing)() {
            progress::note(&format!("left out: {missing}"));
            continue;
        }
        let started = Instant::now();
        let ended = (part.run)(&kit, part.amount)?;
        if !ended.success {
            found_nothing = false;
            println!("{}", ended.describe());
        }
        let table = part.table(&ended);
        println!("\n{table}");
        // At once: the next part takes hours.
        if amounts.write {
            part.document().update(&table)?;
        }
        progress::done(part.name, started);
    }
    Ok(if found_nothing { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

impl Part {
    /// Where its figures go.
    fn document(&self) -> Document {
        Document { file: "docs/torture.md", task: "torture", figures: self.name }
    }

    fn table(&self, ended: &crate::process::Ended) -> String {
        table::of(self.title, self.amount, ended.took, ended.success, &ended.output)
    }
}

/// Where the figures of all parts go.
#[cfg(test)]
pub fn documents() -> impl Iterator<Item = Document> {
    let all = Amounts { inputs: 1, actions: 1, page_actions: 1, write: true };
    parts::chosen(&all).into_iter().map(|part| part.document())
}

impl Amounts {
    fn read(arguments: &[&str]) -> Result<Self> {
        let mut amounts = Self { inputs: 10_000_000, actions: 10_000_000, page_actions: 20_000, write: false };
        let mut words = arguments.iter();
        while let Some(&word) = words.next() {
            let amount = match word {
                "--inputs" => &mut amounts.inputs,
                "--actions" => &mut amounts.actions,
                "--page-actions" => &mut amounts.page_actions,
                "--write" => {
                    amounts.write = true;
                    continue;
                }
                _ => {
                    let advice =
                        "the options are --inputs, --actions and --page-actions, each with a number, and --write";
                    return Err(Failure::new(format!("unknown option {word}")).advice(advice));
                }
            };
            let number = words.next().and_then(|number| number.replace('_', "").parse().ok());
            *amount = number.ok_or_else(|| Failure::new(format!("{word} wants a whole number")))?;
        }
        Ok(amounts)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn amounts_are_read_and_anything_else_is_refused() {
        let read = |words: &[&str]| Amounts::read(words);
        let given = read(&["--inputs", "5_000", "--write", "--page-actions", "0"]).unwrap();
        assert_eq!(given, Amounts { inputs: 5000, actions: 10_000_000, page_actions: 0, write: true });
        assert!(read(&["--inputs"]).is_err() && read(&["--inputs", "many"]).is_err() && read(&["bytes"]).is_err());
    }
}
