use glam::{DVec2, IVec2};

/// Points sorted into a grid of square cells, each with a value, for fast queries by distance and by box.
pub(crate) struct Cells<T> {
    from: DVec2,
    side: f64,
    count: IVec2,
    cells: Vec<Vec<(DVec2, T)>>,
}

impl<T: Copy> Cells<T> {
    /// An empty grid over a bounding box.
    pub(crate) fn over([low, high]: [DVec2; 2], side: f64) -> Self {
        let count = ((high - low) / side).as_ivec2() + IVec2::ONE;
        Self { from: low, side, count, cells: vec![Vec::new(); (count.x * count.y) as usize] }
    }

    pub(crate) fn add(&mut self, point: DVec2, value: T) {
        let cell = self.cell_inside(point);
        self.cells[(cell.y * self.count.x + cell.x) as usize].push((point, value));
    }

    /// Points and values in a box, including its border.
    pub(crate) fn in_box(&self, [low, high]: [DVec2; 2]) -> impl Iterator<Item = (DVec2, T)> + '_ {
        let [from, to] = [low, high].map(|corner| self.cell_inside(corner));
        let cells = (from.y..=to.y).flat_map(move |y| (from.x..=to.x).map(move |x| (y * self.count.x + x) as usize));
        let near = cells.flat_map(|cell| self.cells[cell].iter().copied());
        near.filter(move |(point, _)| point.cmpge(low).all() && point.cmple(high).all())
    }

    /// Distance to the nearest point; infinity if it is not below `within`.
    pub(crate) fn distance(&self, position: DVec2, within: f64) -> f64 {
        let centre = self.cell_of(position);
        let mut nearest = f64::INFINITY;
        for ring in 0..=(within / self.side) as i32 + 1 {
            // Points in this ring of cells and further ones are at least this far away.
            if nearest <= f64::from(ring - 1) * self.side {
                break;
            }
            nearest = self.ring(centre, ring).map(|point| point.distance(position)).fold(nearest, f64::min);
        }
        if nearest < within { nearest } else { f64::INFINITY }
    }

    fn ring(&self, centre: IVec2, ring: i32) -> impl Iterator<Item = DVec2> + '_ {
        let rows = (centre.y - ring).max(0)..=(centre.y + ring).min(self.count.y - 1);
        rows.flat_map(move |y| {
            let is_end = (y - centre.y).abs() == ring;
            let step = if is_end { 1 } else { (2 * ring).max(1) };
            let columns = (centre.x - ring..=centre.x + ring).step_by(step as usize);
            columns.filter(|x| (0..self.count.x).contains(x)).map(move |x| IVec2::new(x, y))
        })
        .flat_map(|cell| self.cells[(cell.y * self.count.x + cell.x) as usize].iter().map(|(point, _)| *point))
    }

    fn cell_inside(&self, position: DVec2) -> IVec2 {
        self.cell_of(position).clamp(IVec2::ZERO, self.count - IVec2::ONE)
    }

    fn cell_of(&self, position: DVec2) -> IVec2 {
        ((position - self.from) / self.side).floor().as_ivec2()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scattered() -> (Vec<DVec2>, Cells<usize>) {
        let points: Vec<DVec2> =
            (0..200).map(|i| DVec2::new(f64::from(i * 37 % 101), f64::from(i * 53 % 97))).collect();
        let mut cells = Cells::over([DVec2::ZERO, DVec2::splat(100.0)], 7.0);
        points.iter().enumerate().for_each(|(i, &point)| cells.add(point, i));
        (points, cells)
    }

    /// Positions inside and outside the box.
    fn positions() -> impl Iterator<Item = DVec2> {
        (0..400).map(|i| DVec2::new(f64::from(i * 29 % 173) - 36.0, f64::from(i * 71 % 167) - 33.0))
    }

    #[test]
    fn the_distance_is_that_of_the_nearest_point() {
        let (points, cells) = scattered();
        for position in positions() {
            let nearest = points.iter().map(|point| point.distance(position)).fold(f64::INFINITY, f64::min);
            let expected = if nearest < 25.0 { nearest } else { f64::INFINITY };
            assert_eq!(cells.distance(position, 25.0), expected, "{position}");
        }
    }

    #[test]
    fn a_box_returns_exactly_the_points_in_it() {
        let (points, cells) = scattered();
        for (low, size) in positions().zip(positions().skip(9)) {
            let high = low + size.abs();
            let mut found: Vec<usize> = cells.in_box([low, high]).map(|(_, i)| i).collect();
            found.sort_unstable();
            let is_inside = |i: &usize| points[*i].cmpge(low).all() && points[*i].cmple(high).all();
            assert_eq!(found, (0..points.len()).filter(is_inside).collect::<Vec<_>>(), "{low} to {high}");
        }
    }
}
