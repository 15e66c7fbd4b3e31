use glam::Vec3;

use crate::atlas::Atlas;
use crate::filling::filled;
use crate::map::{AREA, CELLS, distances, mean_around};

/// Distance from the rim, actual or apparent, within which colours are compared with those further inside; in cells.
const RIM: f32 = 26.0;
/// Above this cosine, a visible cell is accepted without the comparison.
const DIRECT: f32 = 0.6;
/// Levels of [`mean_around`] that preserve strands of hair.
const BLUR: u32 = 1;
/// Levels of a blur that is dominated by the main colour.
const WIDE: u32 = 6;
/// Iterations that exclude outliers from the main colour.
const ROUNDS: usize = 2;
/// Areas connected only through gaps narrower than this, in cells to each side, are separate.
const NARROW: f32 = 3.0;
/// Offset of both levels of a ratio, to limit the effect of noise in dark areas.
const DARK: f32 = 10.0;
/// Limits on the ratio to the colour further inside: brighter, darker, and red or blue to green.
const BRIGHTER: f32 = 1.25;
const DARKER: f32 = 1.55;
const REDDER: f32 = 1.15;

/// Colours and visibility of a layer's cells.
pub(crate) struct Observation<'a> {
    pub(crate) colours: &'a [Vec3],
    pub(crate) cosine: &'a [f32],
    pub(crate) seen: &'a [bool],
    /// Whether only the mesh is close to the cell in the photo.
    pub(crate) surrounded: &'a [bool],
}

/// Visible cells that show the mesh. Near the rim, a photo may show an occluder or the background, so cells whose
/// colour differs from the inner ones by more than lighting explains are rejected. Features may have any colour.
pub(crate) fn trusted(atlas: &Atlas, observation: &Observation<'_>, features: &[f32]) -> Vec<bool> {
    let Observation { colours, cosine, seen, surrounded } = *observation;
    let outside: Vec<bool> = (0..AREA).map(|cell| !atlas.is_inside(cell)).collect();
    let from_rim = distances(&outside);
    let depth = distances(&apparent_outside(atlas, seen));
    let weights: Vec<f32> = seen.iter().map(|is_seen| f32::from(u8::from(*is_seen))).collect();
    let colours = mean_around(colours, &weights, BLUR).0;
    let inner = |cell: usize| if seen[cell] && depth[cell] >= RIM { 1.0 - features[cell] } else { 0.0 };
    let mut known: Vec<f32> = (0..AREA).map(inner).collect();
    for _ in 0..ROUNDS {
        let main = mean_around(&colours, &known, WIDE).0;
        let others = (0..AREA).filter(|&cell| !agree(colours[cell], main[cell]));
        others.for_each(|cell| known[cell] = 0.0);
    }
    if known.iter().all(|known| *known == 0.0) {
        return seen.to_vec();
    }
    let expected = filled(&colours, &known);
    let is_within = |cell: usize| depth[cell] >= RIM || surrounded[cell] && from_rim[cell] >= RIM;
    let is_own = |cell: usize| is_within(cell) || cosine[cell] >= DIRECT || features[cell] > 0.5;
    let trusted: Vec<bool> =
        (0..AREA).map(|cell| seen[cell] && (is_own(cell) || agree(colours[cell], expected[cell]))).collect();
    reached(atlas, &trusted, &|cell| is_own(cell))
}

/// Cells connected to the inside without narrow gaps; excludes, for example, an ear behind a lock of hair.
fn reached(atlas: &Atlas, trusted: &[bool], is_own: &dyn Fn(usize) -> bool) -> Vec<bool> {
    let lost: Vec<bool> = (0..AREA).map(|cell| atlas.is_inside(cell) && !trusted[cell]).collect();
    let wide: Vec<bool> = distances(&lost).iter().zip(trusted).map(|(far, is)| *is && *far >= NARROW).collect();
    let from = (0..AREA).filter(|&cell| trusted[cell] && is_own(cell));
    let reached = flood_fill(from, |cell| wide[cell]);
    // Narrow areas count with the ones they touch.
    let near = distances(&reached);
    trusted.iter().zip(near).map(|(is, far)| *is && far < NARROW).collect()
}

/// Cells outside the mesh, and hidden cells connected to them, where the mesh appears to end. Hidden cells further
/// inside are occluded by the mesh itself.
fn apparent_outside(atlas: &Atlas, seen: &[bool]) -> Vec<bool> {
    let outside = (0..AREA).filter(|&cell| !atlas.is_inside(cell));
    flood_fill(outside, |cell| !seen[cell])
}

/// Flood fill from cells over open cells.
fn flood_fill(from: impl Iterator<Item = usize>, is_open: impl Fn(usize) -> bool) -> Vec<bool> {
    let (mut reached, mut open) = (vec![false; AREA], from.collect::<Vec<usize>>());
    open.iter().for_each(|&cell| reached[cell] = true);
    while let Some(cell) = open.pop() {
        let (row, column) = (cell / CELLS, cell % CELLS);
        let neighbours = [
            (row > 0).then(|| cell - CELLS),
            (row + 1 < CELLS).then(|| cell + CELLS),
            (column > 0).then(|| cell - 1),
            (column + 1 < CELLS).then(|| cell + 1),
        ];
        for next in neighbours.into_iter().flatten().filter(|&next| is_open(next)) {
            if !std::mem::replace(&mut reached[next], true) {
                open.push(next);
            }
        }
    }
    reached
}

fn agree(found: Vec3, expected: Vec3) -> bool {
    let ratio = (found + DARK) / (expected + DARK);
    let brightness = (ratio.x + ratio.y + ratio.z) / 3.0;
    let (red, blue) = (ratio.x / ratio.y, ratio.z / ratio.y);
    let within = |value: f32, limit: f32| value < limit && value * limit > 1.0;
    brightness < BRIGHTER && brightness * DARKER > 1.0 && within(red, REDDER) && within(blue, REDDER)
}
