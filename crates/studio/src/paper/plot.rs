use super::{DEGREES, TimedEdit, Trial, spread_ms};

const LEFT: f64 = 44.0;
const RIGHT: f64 = 12.0;
const TOP: f64 = 36.0;
const BOTTOM: f64 = 56.0;

/// CSS class and fallback colour of the small and the large offset.
const ROUNDS: [(&str, &str); 2] = [("small", "#2f6db5"), ("large", "#c2571a")];

/// Texts of the plot.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PlotWords {
    /// Title, with the unit.
    pub title: String,
    /// Label in front of each degree.
    pub degree: String,
    /// Legend of the small offset.
    pub small: String,
    /// Legend of the large offset.
    pub large: String,
}

/// SVG plot of time against degree and offset: a dot for each edit, a bar between the quartiles, and a line at the
/// median.
pub fn svg(trials: &[Trial], size_px: [f64; 2], words: &PlotWords) -> String {
    let edits: Vec<&TimedEdit> = trials.iter().flat_map(Trial::edits).collect();
    let greatest_ms = edits.iter().map(|edit| edit.time.as_secs_f64() * 1e3).fold(0.0, f64::max);
    let [width, height] = size_px;
    let axes = Axes { width, height, top_ms: round_up(greatest_ms) };
    let mut shapes = axes.axes(words);
    for (round, (class, colour)) in ROUNDS.into_iter().enumerate() {
        let marks: Vec<String> = DEGREES
            .into_iter()
            .enumerate()
            .flat_map(|(column, degree)| {
                let of_cell = edits.iter().filter(move |edit| edit.plan.degree == degree && edit.plan.round == round);
                let dots = of_cell.enumerate().map(|(index, edit)| axes.dot(column, round, index, edit));
                dots.chain([axes.bar(column, round, &edits, degree)]).collect::<Vec<_>>()
            })
            .chain([axes.legend(round, words)])
            .collect();
        shapes.push(format!("<g class=\"{class}\" color=\"{colour}\">\n{}\n</g>", marks.join("\n")));
    }
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" \
         font-size=\"12\">\n<title>{}</title>\n\
         <rect class=\"ground\" width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n{}\n</svg>\n",
        escaped(&words.title),
        shapes.join("\n")
    )
}

struct Axes {
    width: f64,
    height: f64,
    top_ms: f64,
}

impl Axes {
    fn y(&self, ms: f64) -> f64 {
        self.height - BOTTOM - (self.height - TOP - BOTTOM) * ms / self.top_ms
    }

    /// Middle of a degree's column, or of one offset's half of the column.
    fn x(&self, column: usize, round: Option<usize>) -> f64 {
        let width = (self.width - LEFT - RIGHT) / DEGREES.len() as f64;
        let aside = round.map_or(0.0, |round| (round as f64 - 0.5) * width * 0.46);
        LEFT + width * (column as f64 + 0.5) + aside
    }

    fn axes(&self, words: &PlotWords) -> Vec<String> {
        let mut shapes = vec![text(0.0, TOP - 20.0, "start", &words.title)];
        for tick in 0..=4 {
            let ms = self.top_ms * f64::from(tick) / 4.0;
            let (y, end) = (self.y(ms), self.width - RIGHT);
            shapes.push(format!("<path class=\"grid\" d=\"M{LEFT} {y:.1}H{end}\" stroke=\"#d8d8d8\"/>"));
            shapes.push(text(LEFT - 8.0, y + 4.0, "end", &format!("{ms}")));
        }
        for (column, degree) in DEGREES.into_iter().enumerate() {
            let label = format!("{} {degree}", words.degree);
            shapes.push(text(self.x(column, None), self.height - BOTTOM + 20.0, "middle", &label));
        }
        shapes
    }

    fn dot(&self, column: usize, round: usize, index: usize, edit: &TimedEdit) -> String {
        // Jitter by a fixed pattern, so that dots of equal height do not hide each other.
        let aside = (index % 7) as f64 * 3.0 - 9.0;
        let (x, y) = (self.x(column, Some(round)) + aside, self.y(edit.time.as_secs_f64() * 1e3));
        format!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"2.5\" fill=\"currentColor\" fill-opacity=\"0.5\"/>")
    }

    fn bar(&self, column: usize, round: usize, edits: &[&TimedEdit], degree: usize) -> String {
        let spread = spread_ms(edits, Some(degree), Some(round));
        let x = self.x(column, Some(round));
        let [lower, median, upper] = [spread.lower, spread.median, spread.upper].map(|ms| self.y(ms));
        format!(
            "<path d=\"M{x:.1} {lower:.1}V{upper:.1}M{:.1} {median:.1}h24\" stroke=\"currentColor\" stroke-width=\"2\"/>",
            x - 12.0
        )
    }

    fn legend(&self, round: usize, words: &PlotWords) -> String {
        let x = LEFT + (self.width - LEFT - RIGHT) / 2.0 * round as f64;
        let y = self.height - 12.0;
        let square = format!("<rect x=\"{x:.1}\" y=\"{}\" width=\"10\" height=\"10\" fill=\"currentColor\"/>", y - 9.0);
        let name = if round == 0 { &words.small } else { &words.large };
        [square, text(x + 16.0, y, "start", name)].join("\n")
    }
}

/// Rounds up to 1, 2 or 5 times a power of ten.
fn round_up(value: f64) -> f64 {
    let power = 10f64.powf(value.max(1e-6).log10().floor());
    [1.0, 2.0, 5.0, 10.0].map(|step| step * power).into_iter().find(|&step| step >= value).unwrap_or(value)
}

fn text(x: f64, y: f64, anchor: &str, words: &str) -> String {
    let words = escaped(words);
    format!("<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\" fill=\"#303030\">{words}</text>")
}

fn escaped(words: &str) -> String {
    words.replace('&', "&amp;").replace('<', "&lt;")
}
