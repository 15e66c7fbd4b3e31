use super::experiment::{DEGREES, TimedEdit, Trial};
use super::report::of_kind;

const WIDTH: f64 = 640.0;
const HEIGHT: f64 = 400.0;
const LEFT: f64 = 64.0;
const RIGHT: f64 = 24.0;
const TOP: f64 = 48.0;
const BOTTOM: f64 = 56.0;

/// What stands for the small offset and for the large one.
const ROUNDS: [(&str, &str); 2] = [("#2f6db5", "small offset"), ("#c2571a", "large offset")];

/// Time against degree and offset as an SVG picture: every edit a dot, a bar from quartile to quartile, a line at the
/// median.
pub fn svg(trials: &[Trial]) -> String {
    let edits: Vec<&TimedEdit> = trials.iter().flat_map(|trial| &trial.edits).collect();
    let greatest_ms = edits.iter().map(|edit| edit.time.as_secs_f64() * 1e3).fold(0.0, f64::max);
    let scale = Scale { top_ms: round_up(greatest_ms) };
    let mut shapes = axes(&scale);
    for (column, degree) in DEGREES.into_iter().enumerate() {
        shapes.push(text(column_x(column, None), HEIGHT - BOTTOM + 22.0, "middle", &format!("degree {degree}")));
        for (round, (colour, _)) in ROUNDS.iter().enumerate() {
            let of_cell = edits.iter().filter(|edit| edit.degree == degree && edit.round == round);
            shapes.extend(of_cell.enumerate().map(|(index, edit)| dot(column, round, index, edit, &scale, colour)));
            shapes.push(bar(column, round, &edits, degree, &scale, colour));
        }
    }
    shapes.extend(legend());
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" font-family=\"sans-serif\" \
         font-size=\"13\">\n<title>Time per edit against degree and offset</title>\n\
         <rect width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"#ffffff\"/>\n{}\n</svg>\n",
        shapes.join("\n")
    )
}

struct Scale {
    top_ms: f64,
}

impl Scale {
    fn y(&self, ms: f64) -> f64 {
        HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * ms / self.top_ms
    }
}

/// The next of 1, 2 and 5 times a power of ten.
fn round_up(value: f64) -> f64 {
    let power = 10f64.powf(value.max(1e-6).log10().floor());
    [1.0, 2.0, 5.0, 10.0].map(|step| step * power).into_iter().find(|&step| step >= value).unwrap_or(value)
}

/// Middle of a degree's column, or of one offset's half of it.
fn column_x(column: usize, round: Option<usize>) -> f64 {
    let width = (WIDTH - LEFT - RIGHT) / DEGREES.len() as f64;
    let aside = round.map_or(0.0, |round| (round as f64 - 0.5) * width * 0.4);
    LEFT + width * (column as f64 + 0.5) + aside
}

fn axes(scale: &Scale) -> Vec<String> {
    let mut shapes = vec![text(LEFT, TOP - 24.0, "start", "Time per edit, from nothing (ms)")];
    for tick in 0..=4 {
        let ms = scale.top_ms * f64::from(tick) / 4.0;
        let y = scale.y(ms);
        let end = WIDTH - RIGHT;
        shapes.push(format!("<path d=\"M{LEFT} {y:.1}H{end}\" stroke=\"#d8d8d8\"/>"));
        shapes.push(text(LEFT - 8.0, y + 4.0, "end", &format!("{ms}")));
    }
    shapes
}

fn dot(column: usize, round: usize, index: usize, edit: &TimedEdit, scale: &Scale, colour: &str) -> String {
    // Spread sideways by a fixed pattern, so that dots of equal height do not hide each other.
    let aside = (index % 7) as f64 * 4.0 - 12.0;
    let (x, y) = (column_x(column, Some(round)) + aside, scale.y(edit.time.as_secs_f64() * 1e3));
    format!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"2.5\" fill=\"{colour}\" fill-opacity=\"0.5\"/>")
}

fn bar(column: usize, round: usize, edits: &[&TimedEdit], degree: usize, scale: &Scale, colour: &str) -> String {
    let spread = of_kind(edits, Some(degree), Some(round));
    let x = column_x(column, Some(round));
    let [lower, median, upper] = [spread.lower, spread.median, spread.upper].map(|ms| scale.y(ms));
    format!(
        "<path d=\"M{x:.1} {lower:.1}V{upper:.1}\" stroke=\"{colour}\" stroke-width=\"3\"/>\n\
         <path d=\"M{:.1} {median:.1}h28\" stroke=\"{colour}\" stroke-width=\"3\"/>",
        x - 14.0
    )
}

fn legend() -> Vec<String> {
    let entry = |(index, (colour, name)): (usize, &(&str, &str))| {
        let x = LEFT + 150.0 * index as f64;
        let y = HEIGHT - 14.0;
        let square = format!("<rect x=\"{x}\" y=\"{}\" width=\"11\" height=\"11\" fill=\"{colour}\"/>", y - 10.0);
        [square, text(x + 18.0, y, "start", name)].join("\n")
    };
    ROUNDS.iter().enumerate().map(entry).collect()
}

fn text(x: f64, y: f64, anchor: &str, words: &str) -> String {
    format!("<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\" fill=\"#303030\">{words}</text>")
}
