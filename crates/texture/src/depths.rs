use glam::{DVec2, DVec3};
use rosto_mesh::Topology;

use crate::raster::spans;

/// Pixels along the longer side of the depth buffer.
pub(crate) const LONGER_SIDE: f64 = 512.0;

/// Distance of the neighbours checked by [`Depths::is_surrounded`], in its pixels; about 4 mm on a face.
const AROUND: f64 = 10.0;

/// Low-resolution depth buffer of the surface seen by a camera.
pub(crate) struct Depths {
    low: DVec2,
    per_px: f64,
    size: [usize; 2],
    nearest: Vec<f64>,
}

impl Depths {
    /// Draws the surface. `positions_px` are in px of the photo; a larger `nearness` is nearer.
    pub(crate) fn new(topology: &Topology, positions_px: &[DVec2], nearness: &[f64]) -> Self {
        let low = positions_px.iter().copied().reduce(DVec2::min).unwrap_or_default();
        let extent = positions_px.iter().copied().reduce(DVec2::max).unwrap_or_default() - low;
        let per_px = LONGER_SIDE / extent.max_element().max(f64::MIN_POSITIVE);
        let size = [extent.x, extent.y].map(|side| (side * per_px) as usize + 1);
        let mut depths = Self { low, per_px, size, nearest: vec![f64::NEG_INFINITY; size[0] * size[1]] };
        for corners in topology.triangles() {
            let near = DVec3::from(corners.map(|corner| nearness[corner as usize]));
            depths.draw(corners.map(|corner| (positions_px[corner as usize] - low) * per_px), near);
        }
        depths
    }

    fn draw(&mut self, positions: [DVec2; 3], near: DVec3) {
        for span in spans(positions, self.size) {
            for (column, shares) in span.pixels() {
                let nearest = &mut self.nearest[span.row * self.size[0] + column];
                *nearest = nearest.max(shares.dot(near));
            }
        }
    }

    /// Depth of a point below the nearest surface; negative infinity where there is no surface.
    pub(crate) fn behind(&self, position_px: DVec2, nearness: f64) -> f64 {
        let at = (position_px - self.low) * self.per_px;
        let column = (at.x.max(0.0) as usize).min(self.size[0] - 1);
        let row = (at.y.max(0.0) as usize).min(self.size[1] - 1);
        self.nearest[row * self.size[0] + column] - nearness
    }

    /// Whether the surface surrounds the position, so that no background is close to it.
    pub(crate) fn is_surrounded(&self, position_px: DVec2) -> bool {
        let at = (position_px - self.low) * self.per_px;
        let directions = [-1.0, 0.0, 1.0].into_iter().flat_map(|y| [-1.0, 0.0, 1.0].map(|x| DVec2::new(x, y)));
        directions.into_iter().all(|direction| {
            let near = at + direction * AROUND;
            let [column, row] = [near.x, near.y].map(|at| at as usize);
            let is_inside = near.min_element() >= 0.0 && column < self.size[0] && row < self.size[1];
            is_inside && self.nearest[row * self.size[0] + column] > f64::NEG_INFINITY
        })
    }
}
