//! What the measuring programs print: one JSON object a line,
//! `{"task": TASK, "peer": PEER, "vertices": N, "ms": MEDIAN, "runs": R}`; `vertices` where it has a meaning, and `px` in
//! place of `ms` where a length is told.

use serde_json::Value;

/// One figure.
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    /// What was done.
    pub task: String,
    /// By whom; Rosto's own names begin with `rosto`.
    pub peer: String,
    /// On a mesh of this size.
    pub vertices: Option<u64>,
    /// The median.
    pub figure: Figure,
    /// How often it was measured.
    pub runs: u64,
}

/// What was found, by what it is measured in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Figure {
    /// A time in milliseconds.
    Ms(f64),
    /// A length in a picture.
    Px(f64),
}

impl Figure {
    /// In its own unit.
    pub fn value(self) -> f64 {
        match self {
            Self::Ms(value) | Self::Px(value) => value,
        }
    }

    fn from_object(object: &Value) -> Option<Self> {
        object["ms"].as_f64().map(Self::Ms).or_else(|| object["px"].as_f64().map(Self::Px))
    }
}

impl Record {
    /// Whether this is Rosto's own figure.
    pub fn is_own(&self) -> bool {
        self.peer.starts_with("rosto")
    }

    fn from_line(line: &str) -> Option<Self> {
        let value: Value = serde_json::from_str(line).ok()?;
        Some(Self {
            task: value["task"].as_str()?.to_owned(),
            peer: value["peer"].as_str()?.to_owned(),
            vertices: value["vertices"].as_u64(),
            figure: Figure::from_object(&value)?,
            runs: value["runs"].as_u64()?,
        })
    }
}

/// The figures in what a program printed; other lines are passed over.
pub fn read(output: &str) -> Vec<Record> {
    output.lines().filter_map(Record::from_line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_figures_between_other_lines() {
        let output = "Compiling\n{\"task\": \"solve\", \"peer\": \"rosto\", \"vertices\": 468, \"ms\": 0.5, \"runs\": 9}\n{}\n\
                      {\"task\": \"jitter\", \"peer\": \"rosto\", \"px\": 0.25, \"runs\": 1}\n";
        let solve = Record {
            task: "solve".into(),
            peer: "rosto".into(),
            vertices: Some(468),
            figure: Figure::Ms(0.5),
            runs: 9,
        };
        let jitter =
            Record { task: "jitter".into(), peer: "rosto".into(), vertices: None, figure: Figure::Px(0.25), runs: 1 };
        assert_eq!(read(output), [solve, jitter]);
    }
}
