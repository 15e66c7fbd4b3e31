//! `rosto paper`: report and figures.

use crate::common::*;

#[test]
fn the_report_has_three_tables_and_the_figures_are_written() {
    let folder = scratch("paper");
    let run = rosto(["paper", portrait().to_str().unwrap(), "-o", folder.to_str().unwrap(), "--runs", "2"]);
    assert_eq!(code(&run), 0, "{}", said(&run));
    let text = String::from_utf8(run.stdout).unwrap();
    let tables: Vec<Vec<Vec<&str>>> = text.split("\n\n").filter(|part| part.starts_with('|')).map(rows).collect();
    let [rows, times, methods] = tables.as_slice() else { panic!("expected three tables, found {}", tables.len()) };
    assert_eq!((rows.len(), times.len(), methods.len()), (9, 4, 13), "headings and rows");
    assert_eq!(rows[1][1..4], ["Landmark Extract", "0.218", "0.214"]);
    assert_eq!(rows[8][1..4], ["2nd Degree 8 edit", "0.384", "0.584"]);
    for row in &rows[1..] {
        let seconds: f64 = row[4].parse().unwrap();
        assert!(seconds > 0.0 && seconds < 60.0, "{row:?}");
    }
    let topology = rosto_face::Triangulation::Tessellation.topology();
    for (row, degree) in rows[3..].iter().zip([3, 6, 8, 3, 6, 8]) {
        assert_eq!(topology.degree(row[5].parse().unwrap()), degree, "{row:?}");
    }
    let figures: Vec<Vec<u8>> =
        (3..=5).map(|number| std::fs::read(folder.join(format!("figure-{number}.glb"))).unwrap()).collect();
    assert!(figures.iter().all(|file| file.starts_with(b"glTF")));
    assert!(figures[0] != figures[1] && figures[1] != figures[2]);
    let plot = std::fs::read_to_string(folder.join("times.svg")).unwrap();
    assert_eq!(plot.matches("<circle").count(), 12, "one dot per edit of the paper's method");
}

/// Cells of a Markdown table, without the delimiter row.
fn rows(table: &str) -> Vec<Vec<&str>> {
    let lines = table.lines().filter(|line| !line.starts_with("|--"));
    lines.map(|line| line.split('|').map(str::trim).collect()).collect()
}
