//! Figures as Markdown: one table a task, Rosto first, and how many times longer each peer takes.

use super::record::{Figure, Record};

/// What the tasks are called for a reader.
const TITLES: [(&str, &str); 50] = [
    ("paper-edit", "One edit of the paper with the factor at hand, from the choice of the vertex to the moved mesh"),
    ("paper-edit-bare", "One edit of the paper from nothing: operator, factor, response, moved mesh"),
    ("system", "What is done once per mesh: from triangles to factor"),
    ("tick", "One slider tick: the mesh moved with the response at hand"),
    ("factor", "Factorisation of the normal equations, ordering included"),
    ("solve", "One right-hand side with the factor at hand"),
    ("edit", "Factorisation and one solve together"),
    ("select", "Choosing a vertex: its response over the whole mesh"),
    ("paper-edit-chrome", "One edit of the paper with the factor at hand, in headless Chrome"),
    ("paper-edit-bare-chrome", "One edit of the paper from nothing, in headless Chrome"),
    ("tick-chrome", "One slider tick, in headless Chrome"),
    ("select-chrome", "Choosing a vertex, in headless Chrome"),
    ("system-chrome", "What is done once per mesh, in headless Chrome"),
    ("preview-chrome", "One slider tick of a landmark, carried over to a denser mesh, in headless Chrome"),
    ("select-page", "Choosing a landmark on the page, up to the GPU, in headless Chrome"),
    ("tick-page", "One slider tick on the page, up to the GPU, in headless Chrome"),
    (
        "tick-listeners",
        "One slider tick all in: from the input event to the last listener, with 40 entries, in headless Chrome",
    ),
    (
        "drag-listeners",
        "One move of a drag all in: from the pointer's event to the last listener, with 40 entries, in headless Chrome",
    ),
    ("networks-start-native", "Loading the networks, natively"),
    ("photo-to-landmarks-native", "Photo (512×512 PNG) to landmarks, natively, one thread"),
    (
        "photo-to-landmarks-once-native",
        "The same with one look and one pass, as MediaPipe does it: `rosto landmarks --mediapipe --refine`",
    ),
    (
        "many-one",
        "Many photos (512×512 JPEG) to 468 landmarks, as MediaPipe does it, in Python: a photo's time in one process",
    ),
    ("many-one-processor", "The same, in time of processors"),
    ("many-one-refined", "The same with refined lips, eyes and irises, 478 landmarks, by the clock"),
    ("many-one-refined-processor", "The same, in time of processors"),
    ("many-two", "Many photos to 468 landmarks with two workers at once: a photo's time by the clock"),
    ("many-two-processor", "The same, in time of processors"),
    ("photo-warp", "A photo of 12 megapixels made ready to follow its face, natively"),
    ("photo-tick", "One slider tick in the photo, natively"),
    ("photo-tick-folds", "One slider tick in the photo where it is limited, so that nothing folds, natively"),
    ("photo-drawn", "The edited photo's 12 megapixels drawn for its file, natively"),
    ("texture-1024", "A face's whole texture of 1024×1024 from one photo of 1024×1024, natively, one thread"),
    ("texture-2048", "The same of 2048×2048"),
    ("texture-4096", "The same of 4096×4096"),
    ("photo-page-tick", "A slider's tick with a photo of 12 megapixels on the stage, all in on the page's thread"),
    ("photo-file-jpeg", "The edited photo of 12 megapixels as a JPEG on the page, from the press to the download"),
    ("photo-file-png", "The same as a PNG"),
    ("networks-start-chrome", "Loading program and networks, in headless Chrome"),
    ("first-landmarks-chrome", "The first photo to landmarks, in headless Chrome"),
    ("photo-to-landmarks-chrome", "Photo (512×512 PNG) to landmarks, in headless Chrome, one thread"),
    ("networks-make-chrome", "Both networks from file to ready, the program being there, in headless Chrome"),
    ("detector-network-chrome", "The detector network alone, in headless Chrome, one thread"),
    ("detector-network-least-chrome", "The detector network alone, the quickest run"),
    ("landmark-network-chrome", "The landmark network alone, in headless Chrome, one thread"),
    ("landmark-network-least-chrome", "The landmark network alone, the quickest run"),
    ("film-frame-chrome", "Following a film at 640×480: a frame to its 478 landmarks, in headless Chrome"),
    ("film-frame-least-chrome", "Following a film, the quickest frame"),
    ("film-frame-95th-chrome", "Following a film, the frame that 95 of 100 are quicker than"),
    ("film-jitter-chrome", "How much the landmarks of a face that rests tremble under a camera's noise (RMS)"),
    ("film-lag-chrome", "How far the landmarks of a face that moves at 200 px/s are behind it, or ahead"),
];

/// All figures, in the order in which their tasks first appear.
pub fn all(records: &[Record]) -> String {
    let mut tasks: Vec<&str> = Vec::new();
    for record in records {
        if !tasks.contains(&record.task.as_str()) {
            tasks.push(&record.task);
        }
    }
    tasks.into_iter().map(|task| of_task(task, records)).collect::<Vec<_>>().join("\n")
}

/// What is measured in the browser stands beside the native peers, where there are some.
fn of_task(task: &str, records: &[Record]) -> String {
    let title = TITLES.iter().find(|(name, _)| *name == task).map_or(task, |(_, title)| title);
    // However Rosto's own time is taken, the peers' is one.
    let natively = task.strip_suffix("-chrome").unwrap_or(task);
    let of_peers = natively.strip_suffix("-bare").unwrap_or(natively);
    let belongs = |record: &&Record| record.task == task || (!record.is_own() && record.task == of_peers);
    let mut rows: Vec<&Record> = records.iter().filter(belongs).collect();
    rows.sort_by_key(|record| (record.vertices, !record.is_own()));
    let sized = rows.iter().any(|record| record.vertices.is_some());
    let (size, rule) = if sized { ("vertices | ", "---:|") } else { ("", "") };
    let what = if rows.iter().any(|row| matches!(row.figure, Figure::Px(_))) { "length" } else { "time" };
    let mut lines = vec![format!("### {title}\n"), format!("| {size}by | {what} | times Rosto's | runs |")];
    lines.push(format!("|{rule}---|---:|---:|---:|"));
    for row in &rows {
        let own = rows.iter().find(|other| other.is_own() && other.vertices == row.vertices);
        let size = row.vertices.map_or_else(String::new, |vertices| format!("{vertices} | "));
        let ratio = own.map_or_else(|| "–".to_owned(), |own| ratio(row.figure.value() / own.figure.value()));
        lines.push(format!("| {size}{} | {} | {ratio} | {} |", row.peer, readable(row.figure), row.runs));
    }
    lines.join("\n") + "\n"
}

fn ratio(ratio: f64) -> String {
    let digits = if ratio < 10.0 { 2 } else { 0 };
    format!("{ratio:.digits$} ×")
}

/// In the unit that reads best, with three significant digits.
fn readable(figure: Figure) -> String {
    let (value, unit) = match figure {
        Figure::Px(px) => (px, "px"),
        Figure::Ms(ms) => duration(ms),
    };
    let digits = if value < 10.0 { 2 } else { usize::from(value < 100.0) };
    format!("{value:.digits$} {unit}")
}

fn duration(ms: f64) -> (f64, &'static str) {
    match ms {
        ms if ms < 1e-3 => (ms * 1e6, "ns"),
        ms if ms < 1.0 => (ms * 1e3, "µs"),
        ms if ms < 1e3 => (ms, "ms"),
        ms => (ms / 1e3, "s"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(peer: &str, vertices: Option<u64>, ms: f64) -> Record {
        Record { task: "solve".into(), peer: peer.into(), vertices, figure: Figure::Ms(ms), runs: 9 }
    }

    #[test]
    fn peers_stand_behind_rosto_with_their_ratio() {
        let table = all(&[record("libigl", Some(468), 1.0), record("rosto", Some(468), 0.25)]);
        let rows: Vec<&str> = table.lines().skip(4).collect();
        assert_eq!(rows, ["| 468 | rosto | 250 µs | 1.00 × | 9 |", "| 468 | libigl | 1.00 ms | 4.00 × | 9 |"]);
    }

    #[test]
    fn in_the_browser_the_native_peers_are_named_again() {
        let in_chrome = Record { task: "solve-chrome".into(), ..record("rosto in Chrome", Some(468), 0.5) };
        let table = all(&[record("rosto", Some(468), 0.25), record("libigl", Some(468), 1.0), in_chrome]);
        assert!(
            table.contains("| 468 | rosto in Chrome | 500 µs | 1.00 × | 9 |\n| 468 | libigl | 1.00 ms | 2.00 × | 9 |")
        );
    }

    #[test]
    fn without_rosto_there_is_no_ratio() {
        assert!(all(&[record("libigl", None, 1500.0)]).contains("| libigl | 1.50 s | – | 9 |"));
    }

    #[test]
    fn times_and_lengths_keep_three_digits() {
        assert_eq!(readable(Figure::Ms(0.000_25)), "250 ns");
        assert_eq!(readable(Figure::Ms(0.001_234)), "1.23 µs");
        assert_eq!(readable(Figure::Ms(45.67)), "45.7 ms");
        assert_eq!(readable(Figure::Px(0.123)), "0.12 px");
    }

    #[test]
    fn a_table_of_lengths_says_so() {
        let of = |peer: &str, px| Record { figure: Figure::Px(px), ..record(peer, None, 0.0) };
        let table = all(&[of("rosto", 0.1), of("libigl", 0.3)]);
        assert!(table.contains("| by | length | times Rosto's | runs |"), "{table}");
        assert!(table.contains("| libigl | 0.30 px | 3.00 × | 9 |"), "{table}");
    }
}
