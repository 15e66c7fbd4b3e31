use glam::{DVec2, Vec3};
use rosto_photo::Sampler;

use crate::Subject;
use crate::blend::Blend;
use crate::grain::add_grain;
use crate::layer::{Layer, PreparedShot};
use crate::map::{AREA, CELLS, bytes};
use crate::raster::{Span, spans};
use crate::sampling::{Sample, in_row, row_of};

/// Renders the texture as RGB bytes, row by row from the top.
pub(crate) fn drawn(
    subject: &Subject<'_>,
    seen: &[PreparedShot<'_>],
    layers: &[Layer],
    blend: &Blend,
    side_px: u32,
) -> Vec<u8> {
    let side = side_px as usize;
    let samplers =
        layers.iter().enumerate().map(|(index, _)| Sampler::new(&seen[index % seen.len()].picture)).collect();
    let positions = Sample::all(side);
    let mut canvas = Canvas {
        layers,
        samplers,
        blend,
        columns: &positions,
        active: active(blend),
        base: Vec::new(),
        rest: Vec::new(),
        factors: vec![Vec::new(); layers.len()],
    };
    let mut pixels = vec![0; side * side * 3];
    for ((row, spans), pixels) in positions.iter().zip(by_rows(subject, side)).zip(pixels.chunks_mut(side * 3)) {
        canvas.begin(*row);
        canvas.draw_base(pixels);
        spans.iter().for_each(|(span, corners)| canvas.draw(row.cell, span, *corners, pixels));
    }
    add_grain(&mut pixels, blend, &positions);
    pixels
}

/// Spans of the triangles in each row of texels.
fn by_rows(subject: &Subject<'_>, side: usize) -> Vec<Vec<(Span, [u32; 3])>> {
    let mut rows: Vec<Vec<(Span, [u32; 3])>> = vec![Vec::new(); side];
    for &corners in subject.topology.triangles() {
        let positions = corners.map(|corner| subject.atlas_uvs[corner as usize] * side as f64);
        spans(positions, [side; 2]).for_each(|span| rows[span.row].push((span, corners)));
    }
    rows
}

struct Canvas<'a> {
    layers: &'a [Layer],
    samplers: Vec<Sampler<'a>>,
    blend: &'a Blend,
    columns: &'a [Sample],
    /// Bit mask per cell of the layers with a non-zero factor in it or in its right and lower neighbours.
    active: Vec<u16>,
    /// Maps interpolated at the current row.
    base: Vec<Vec3>,
    rest: Vec<Vec3>,
    factors: Vec<Vec<Vec3>>,
}

impl Canvas<'_> {
    fn begin(&mut self, row: Sample) {
        row_of(&self.blend.base, row, &mut self.base);
        row_of(&self.blend.rest, row, &mut self.rest);
        let active = self.active[row.cell * CELLS..(row.cell + 1) * CELLS].iter().fold(0, |all, cell| all | cell);
        for (layer, factors) in self.factors.iter_mut().enumerate().filter(|(layer, _)| active >> layer & 1 != 0) {
            row_of(&self.blend.factors[layer], row, factors);
        }
    }

    /// Draws the low frequencies, also outside the mesh.
    fn draw_base(&self, pixels: &mut [u8]) {
        for (column, pixel) in self.columns.iter().zip(pixels.as_chunks_mut::<3>().0) {
            *pixel = bytes(in_row(&self.base, *column));
        }
    }

    fn draw(&self, row: usize, span: &Span, corners: [u32; 3], pixels: &mut [u8]) {
        let pixels = &mut pixels.as_chunks_mut::<3>().0[span.columns.clone()];
        for (((_, shares), column), pixel) in span.pixels().zip(&self.columns[span.columns.clone()]).zip(pixels) {
            let mut colour = in_row(&self.rest, *column);
            let mut active = self.active[row * CELLS + column.cell];
            while active != 0 {
                let layer = active.trailing_zeros() as usize;
                active &= active - 1;
                let [a, b, c] = corners.map(|corner| self.layers[layer].positions_px[corner as usize]);
                let from: DVec2 = a * shares.x + b * shares.y + c * shares.z;
                colour += in_row(&self.factors[layer], *column) * Vec3::from(self.samplers[layer].at(from));
            }
            *pixel = bytes(colour);
        }
    }
}

fn active(blend: &Blend) -> Vec<u16> {
    let mut active = vec![0; AREA];
    for (layer, factors) in blend.factors.iter().enumerate() {
        for (cell, active) in active.iter_mut().enumerate() {
            let (row, column) = (cell / CELLS, cell % CELLS);
            let (below, right) = ((row + 1).min(CELLS - 1), (column + 1).min(CELLS - 1));
            let four = [cell, row * CELLS + right, below * CELLS + column, below * CELLS + right];
            *active |= u16::from(four.iter().any(|&cell| factors[cell] != Vec3::ZERO)) << layer;
        }
    }
    active
}
