use glam::{DVec3, IVec3};

/// Largest number of cells along an axis; a finer grid costs more than it saves.
const MAX_CELLS: f64 = 96.0;

/// Uniform grid over the bounding boxes of triangles.
pub(super) struct Grid {
    low: DVec3,
    cell: f64,
    counts: IVec3,
    boxes: Vec<[DVec3; 2]>,
    /// Start of each cell's triangles in `members`, and the end of the last.
    starts: Vec<u32>,
    members: Vec<u32>,
}

impl Grid {
    /// The cells are about as large as the average triangle.
    pub(super) fn new(triangles: &[[u32; 3]], positions: &[DVec3]) -> Self {
        let boxes: Vec<[DVec3; 2]> = triangles.iter().map(|corners| bounds(corners, positions)).collect();
        let low = boxes.iter().map(|[low, _]| *low).reduce(DVec3::min).unwrap_or_default();
        let high = boxes.iter().map(|[_, high]| *high).reduce(DVec3::max).unwrap_or_default();
        let sides: f64 = boxes.iter().map(|[low, high]| (*high - *low).max_element()).sum();
        let longest = (high - low).max_element().max(f64::MIN_POSITIVE);
        let cell = (sides / boxes.len().max(1) as f64).max(longest / MAX_CELLS);
        let counts = ((high - low) / cell).floor().as_ivec3() + 1;
        let mut grid = Self { low, cell, counts, boxes, starts: Vec::new(), members: Vec::new() };
        grid.sort_in();
        grid
    }

    fn sort_in(&mut self) {
        let mut starts = vec![0; (self.counts.x * self.counts.y * self.counts.z) as usize + 1];
        for triangle in 0..self.boxes.len() {
            self.each_cell(triangle, |cell| starts[cell + 1] += 1);
        }
        for cell in 1..starts.len() {
            starts[cell] += starts[cell - 1];
        }
        let mut members = vec![0; starts.last().copied().unwrap_or(0) as usize];
        let mut next = starts.clone();
        for triangle in 0..self.boxes.len() {
            self.each_cell(triangle, |cell| {
                members[next[cell] as usize] = triangle as u32;
                next[cell] += 1;
            });
        }
        (self.starts, self.members) = (starts, members);
    }

    /// Calls `each` once for each pair of triangles with overlapping bounding boxes, if one of the two is selected.
    pub(super) fn near_pairs(&self, is_selected: impl Fn(u32) -> bool, mut each: impl FnMut(u32, u32)) {
        let selected: Vec<bool> = (0..self.boxes.len() as u32).map(is_selected).collect();
        for cell in 0..self.starts.len() - 1 {
            let members = &self.members[self.starts[cell] as usize..self.starts[cell + 1] as usize];
            for (at, &one) in members.iter().enumerate() {
                for &other in &members[at + 1..] {
                    if !selected[one as usize] && !selected[other as usize] {
                        continue;
                    }
                    let ([low, high], [other_low, other_high]) = (self.boxes[one as usize], self.boxes[other as usize]);
                    let near = low.cmple(other_high).all() && other_low.cmple(high).all();
                    // Overlapping boxes share several cells; only the cell with the overlap's lowest corner reports the
                    // pair.
                    if near && self.index(self.cell_of(low.max(other_low))) == cell {
                        each(one, other);
                    }
                }
            }
        }
    }

    fn each_cell(&self, triangle: usize, mut each: impl FnMut(usize)) {
        let [low, high] = self.boxes[triangle].map(|corner| self.cell_of(corner));
        for z in low.z..=high.z {
            for y in low.y..=high.y {
                for x in low.x..=high.x {
                    each(self.index(IVec3::new(x, y, z)));
                }
            }
        }
    }

    fn cell_of(&self, position: DVec3) -> IVec3 {
        ((position - self.low) / self.cell).floor().as_ivec3().clamp(IVec3::ZERO, self.counts - 1)
    }

    fn index(&self, cell: IVec3) -> usize {
        ((cell.z * self.counts.y + cell.y) * self.counts.x + cell.x) as usize
    }
}

fn bounds(corners: &[u32; 3], positions: &[DVec3]) -> [DVec3; 2] {
    let [a, b, c] = corners.map(|corner| positions[corner as usize]);
    [a.min(b).min(c), a.max(b).max(c)]
}
