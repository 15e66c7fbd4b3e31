//! Documents with figures that a task writes.

use crate::failure::{Failure, Result};
use crate::{cache, machine, workspace};

/// A document, and the task that writes its figures.
pub struct Document {
    /// Below the root of the workspace.
    pub file: &'static str,
    /// As on the command line.
    pub task: &'static str,
    /// Which of the document's figures, as they are called in the mark before them.
    pub figures: &'static str,
}

const END: &str = "<!-- end of figures -->\n";

impl Document {
    /// Replaces the figures, and says on what machine they were taken.
    pub fn update(&self, tables: &str) -> Result {
        let file = workspace::root().join(self.file);
        let empty = || format!("# {}\n\n{}{END}", self.task, self.begin());
        let present = std::fs::read_to_string(&file).unwrap_or_else(|_| empty());
        cache::write(&file, self.with_figures(&present, &format!("{}\n\n{tables}\n", machine::describe()))?)?;
        println!("{} is up to date.", self.file);
        Ok(())
    }

    fn begin(&self) -> String {
        format!("<!-- {}: written by `cargo xtask {} --write` -->\n", self.figures, self.task)
    }

    /// The document with what stands between its two marks replaced.
    fn with_figures(&self, document: &str, figures: &str) -> Result<String> {
        let begin = self.begin();
        let missing = || Failure::new(format!("{} has lost the marks between which the figures stand", self.file));
        let (before, rest) = document.split_once(&begin).ok_or_else(missing)?;
        let (_, after) = rest.split_once(END).ok_or_else(missing)?;
        Ok(format!("{before}{begin}{figures}{END}{after}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const DOCUMENT: Document = Document { file: "docs/bench.md", task: "bench", figures: "figures" };

    #[test]
    fn only_the_figures_are_replaced() {
        let begin = DOCUMENT.begin();
        let others = Document { figures: "others", ..DOCUMENT }.begin();
        let document = |figures: &str| format!("# Title\n{others}1\n{END}prose\n{begin}{figures}{END}more\n");
        let updated = DOCUMENT.with_figures(&document("old\n"), "new\n").unwrap();
        assert_eq!(updated, document("new\n"));
        assert!(DOCUMENT.with_figures("no marks", "new").is_err());
    }

    #[test]
    fn every_document_with_figures_has_its_marks() {
        for document in [crate::bench::DOCUMENT, crate::readers::DOCUMENT, crate::robustness::DOCUMENT] {
            let present = std::fs::read_to_string(workspace::root().join(document.file)).unwrap();
            assert!(document.with_figures(&present, "").is_ok(), "{}: {}", document.file, document.figures);
        }
    }
}
