use super::DEGREES;

/// A task that Table 1 of the paper times.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Task {
    /// Photo to landmarks.
    Extraction,
    /// Landmarks to the coloured mesh.
    Generation,
    /// Moving a vertex.
    Edit {
        /// Number of neighbours of the vertex.
        degree: usize,
        /// Index into [`OFFSETS`](super::OFFSETS).
        round: usize,
    },
}

/// A row of Table 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TableRow {
    /// The timed task.
    pub task: Task,
    /// Name in the paper.
    pub name: &'static str,
    /// Seconds in the first and the second test.
    pub seconds: [f64; 2],
}

/// Table 1 of the paper.
pub const TABLE_1: [TableRow; 8] = [
    row(Task::Extraction, "Landmark Extract", [0.218, 0.214]),
    row(Task::Generation, "Initial Generation", [0.003, 0.007]),
    row(edit(0, 0), "Degree 3 edit", [0.399, 0.362]),
    row(edit(1, 0), "Degree 6 edit", [0.364, 0.389]),
    row(edit(2, 0), "Degree 8 edit", [0.366, 0.401]),
    row(edit(0, 1), "2nd Degree 3 edit", [0.393, 0.363]),
    row(edit(1, 1), "2nd Degree 6 edit", [0.387, 0.374]),
    row(edit(2, 1), "2nd Degree 8 edit", [0.384, 0.584]),
];

const fn row(task: Task, name: &'static str, seconds: [f64; 2]) -> TableRow {
    TableRow { task, name, seconds }
}

const fn edit(degree: usize, round: usize) -> Task {
    Task::Edit { degree: DEGREES[degree], round }
}
