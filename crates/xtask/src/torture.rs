//! `cargo xtask torture`: what takes too long for the tests. Broken bytes for every reader, and visitors who do anything
//! in any order, natively and on the page.

mod parts;
mod table;

use crate::figures::Document;
use crate::setup;
use anyhow::{Result, bail, ensure};
use parts::Part;
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
pub fn run(arguments: &[&str]) -> Result<()> {
    let amounts = Amounts::read(arguments)?;
    let kit = setup::for_tests()?;
    let mut found_nothing = true;
    for part in parts::chosen(&amounts) {
        println!("▸ {} ({} {})", part.name, table::grouped(part.amount), part.what);
        if let Some(missing) = (part.missing)() {
            println!("  · left out: {missing}");
            continue;
        }
        let started = Instant::now();
        let ended = (part.run)(&kit, part.amount)?;
        if !ended.success {
            found_nothing = false;
            println!("{}", ended.output);
        }
        let table = table::of(part.title, part.amount, started.elapsed(), ended.success, &ended.output);
        println!("\n{table}");
        // At once: the next part takes hours.
        if amounts.write {
            part.document().update(&table)?;
        }
    }
    ensure!(found_nothing, "something was found: see above");
    Ok(())
}

impl Part {
    /// Where its figures go.
    fn document(&self) -> Document {
        Document { file: "docs/torture.md", task: "torture", figures: self.name }
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
                    bail!("unknown option {word}: {advice}");
                }
            };
            let number = words.next().and_then(|number| number.replace('_', "").parse().ok());
            *amount = number.ok_or_else(|| anyhow::anyhow!("{word} wants a whole number"))?;
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
