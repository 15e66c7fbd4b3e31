//! Time against size as a picture: both axes logarithmic, a line a peer, and a dashed one of linear growth.

use super::Record;

const WIDTH: f64 = 720.0;
const HEIGHT: f64 = 440.0;
const LEFT: f64 = 84.0;
const RIGHT: f64 = 160.0;
const TOP: f64 = 48.0;
const BOTTOM: f64 = 56.0;
/// For Rosto first, then for its peers; distinct in shades of grey, too.
const COLOURS: [&str; 5] = ["#b8492f", "#1f5f99", "#5f8f2f", "#8a4fa3", "#6b6b6b"];

/// The figures of `task` as an SVG picture; none if it was not measured at two sizes at least.
pub fn growth(task: &str, title: &str, records: &[Record]) -> Option<String> {
    let mut lines: Vec<Line> = Vec::new();
    for record in records.iter().filter(|record| record.task == task) {
        let Some(vertices) = record.vertices else { continue };
        match lines.iter_mut().find(|line| line.peer == record.peer) {
            Some(line) => line.points.push((vertices as f64, record.figure.value())),
            None => {
                lines.push(Line { peer: record.peer.clone(), points: vec![(vertices as f64, record.figure.value())] })
            }
        }
    }
    let points = || lines.iter().flat_map(|line| &line.points).copied();
    let (x, y) = (Axis::around(points().map(|(x, _)| x)), Axis::around(points().map(|(_, y)| y)));
    if lines.iter().all(|line| line.points.len() < 2) {
        return None;
    }
    let plot = Plot { x, y };
    let mut shapes = plot.grid();
    shapes.extend(lines.first().and_then(|line| plot.linear_growth(line)));
    shapes.extend(lines.iter().zip(COLOURS).map(|(line, colour)| plot.line(line, colour)));
    shapes.extend(plot.names(&lines));
    Some(format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" font-family=\"sans-serif\" \
         font-size=\"13\">\n<title>{title}</title>\n<rect width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"#ffffff\"/>\n\
         {}\n{}\n</svg>\n",
        text(LEFT, TOP - 22.0, "start", "#303030", title),
        shapes.join("\n")
    ))
}

struct Line {
    peer: String,
    points: Vec<(f64, f64)>,
}

/// Decades from `first` to `last`, as powers of ten.
struct Axis {
    first: i32,
    last: i32,
}

impl Axis {
    fn around(values: impl Iterator<Item = f64> + Clone) -> Self {
        let least = values.clone().fold(f64::INFINITY, f64::min).log10().floor();
        let greatest = values.fold(0.0, f64::max).log10().ceil();
        Self { first: least as i32, last: greatest as i32 }
    }

    /// 0 at the first decade, 1 at the last.
    fn share(&self, value: f64) -> f64 {
        (value.log10() - f64::from(self.first)) / f64::from((self.last - self.first).max(1))
    }

    fn decades(&self) -> impl Iterator<Item = f64> {
        (self.first..=self.last).map(|power| 10f64.powi(power))
    }
}

struct Plot {
    x: Axis,
    y: Axis,
}

impl Plot {
    fn place(&self, (x, y): (f64, f64)) -> (f64, f64) {
        let right = LEFT + (WIDTH - LEFT - RIGHT) * self.x.share(x);
        (right, HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * self.y.share(y))
    }

    fn grid(&self) -> Vec<String> {
        let (bottom, end) = (HEIGHT - BOTTOM, WIDTH - RIGHT);
        let vertical = self.x.decades().map(|vertices| {
            let (x, _) = self.place((vertices, 1.0));
            let rule = format!("<path d=\"M{x:.1} {TOP}V{bottom}\" stroke=\"#e4e4e4\"/>");
            rule + &text(x, bottom + 20.0, "middle", "#303030", &format!("{vertices}"))
        });
        let horizontal = self.y.decades().map(|ms| {
            let (_, y) = self.place((1.0, ms));
            let rule = format!("<path d=\"M{LEFT} {y:.1}H{end}\" stroke=\"#e4e4e4\"/>");
            rule + &text(LEFT - 8.0, y + 4.0, "end", "#303030", &format!("{ms} ms"))
        });
        let name = text((LEFT + end) / 2.0, HEIGHT - 14.0, "middle", "#303030", "vertices");
        vertical.chain(horizontal).chain([name]).collect()
    }

    /// What the line would be if its time grew as its size does.
    fn linear_growth(&self, line: &Line) -> Option<String> {
        let (&(from, ms), &(to, _)) = (line.points.first()?, line.points.last()?);
        Some(self.path(&[(from, ms), (to, ms * to / from)], "#303030", "stroke-dasharray=\"4 4\" stroke-width=\"1\""))
    }

    fn line(&self, line: &Line, colour: &str) -> String {
        self.path(&line.points, colour, "stroke-width=\"2\"")
    }

    fn path(&self, points: &[(f64, f64)], colour: &str, style: &str) -> String {
        let places: Vec<String> =
            points.iter().map(|&point| self.place(point)).map(|(x, y)| format!("{x:.1} {y:.1}")).collect();
        format!("<path d=\"M{}\" fill=\"none\" stroke=\"{colour}\" {style}/>", places.join("L"))
    }

    /// Each line's name at its end, moved down where two would overlap.
    fn names(&self, lines: &[Line]) -> Vec<String> {
        let end = |line: &Line| line.points.last().map_or((0.0, 0.0), |&point| self.place(point));
        let mut named: Vec<(&Line, &str)> = lines.iter().zip(COLOURS).collect();
        named.sort_by(|(one, _), (other, _)| end(one).1.total_cmp(&end(other).1));
        let mut free_from = f64::NEG_INFINITY;
        let name = |(line, colour): (&Line, &str)| {
            let (x, y) = end(line);
            let y = y.max(free_from);
            free_from = y + 16.0;
            text(x + 8.0, y + 4.0, "start", colour, &line.peer)
        };
        named.into_iter().map(name).collect()
    }
}

fn text(x: f64, y: f64, anchor: &str, colour: &str, words: &str) -> String {
    format!("<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\" fill=\"{colour}\">{words}</text>")
}

#[cfg(test)]
mod tests {
    use super::super::record::Figure;
    use super::*;

    fn record(peer: &str, vertices: u64, ms: f64) -> Record {
        Record { task: "edit".into(), peer: peer.into(), vertices: Some(vertices), figure: Figure::Ms(ms), runs: 3 }
    }

    #[test]
    fn linear_growth_is_the_dashed_line_itself() {
        let records = [record("rosto", 100, 1.0), record("rosto", 1000, 10.0), record("libigl", 100, 2.0)];
        let svg = growth("edit", "Title", &records).unwrap();
        let ways: Vec<&str> = svg.split("<path d=\"").skip(1).filter_map(|part| part.split('"').next()).collect();
        let slanted: Vec<&&str> = ways.iter().filter(|way| way.contains('L')).collect();
        assert_eq!(slanted.len(), 2);
        assert_eq!(slanted[0], slanted[1]);
        assert!(svg.contains(">libigl</text>"));
    }

    #[test]
    fn one_size_makes_no_picture() {
        assert_eq!(growth("edit", "Title", &[record("rosto", 100, 1.0)]), None);
        assert_eq!(growth("edit", "Title", &[]), None);
    }
}
