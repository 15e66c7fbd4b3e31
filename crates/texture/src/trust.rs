use glam::Vec3;

use crate::atlas::Atlas;
use crate::filling::filled;
use crate::map::{AREA, CELLS, distances, mean_around};

/// So many cells from where the mesh ends, or is seen to end, its colours are held against those further inside.
const RIM: f32 = 26.0;
/// What is seen more directly than at this cosine is the mesh's own all the same.
const DIRECT: f32 = 0.6;
/// A blur that leaves what is as wide as a strand of hair: [`mean_around`]'s times.
const BLUR: u32 = 1;
/// One so wide that what is not the main colour does not count in it.
const WIDE: u32 = 6;
/// How often what differs from the main colour is left out of it.
const ROUNDS: usize = 2;
/// What is reached only through less than this, in cells to each side, is something else.
const NARROW: f32 = 3.0;
/// Levels added to both sides of a ratio, so that darkness is no colour.
const DARK: f32 = 10.0;
/// A colour may be so many times as bright as it is further inside, or as dark, and so many times as red or blue.
const BRIGHTER: f32 = 1.25;
const DARKER: f32 = 1.55;
const REDDER: f32 = 1.15;

/// What a photo shows in each cell.
pub(crate) struct Sight<'a> {
    pub(crate) colours: &'a [Vec3],
    pub(crate) cosine: &'a [f32],
    pub(crate) seen: &'a [bool],
    /// Whether nothing but the mesh is near it in the photo.
    pub(crate) surrounded: &'a [bool],
}

/// What is seen and is of the mesh. Beside its rim a photo may show what hangs over it or lies behind it: there, what differs
/// from the colours further inside by more than light explains is not used. What belongs to a whole is a colour of its own.
pub(crate) fn trusted(atlas: &Atlas, sight: &Sight<'_>, wholes: &[f32]) -> Vec<bool> {
    let Sight { colours, cosine, seen, surrounded } = *sight;
    let outside: Vec<bool> = (0..AREA).map(|cell| !atlas.is_inside(cell)).collect();
    let from_rim = distances(&outside);
    let depth = distances(&ends(atlas, seen));
    let weights: Vec<f32> = seen.iter().map(|is_seen| f32::from(u8::from(*is_seen))).collect();
    let colours = mean_around(colours, &weights, BLUR).0;
    let inner = |cell: usize| if seen[cell] && depth[cell] >= RIM { 1.0 - wholes[cell] } else { 0.0 };
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
    let is_own = |cell: usize| is_within(cell) || cosine[cell] >= DIRECT || wholes[cell] > 0.5;
    let trusted: Vec<bool> =
        (0..AREA).map(|cell| seen[cell] && (is_own(cell) || agree(colours[cell], expected[cell]))).collect();
    reached(atlas, &trusted, &|cell| is_own(cell))
}

/// What is reached from within without passing narrow places: an ear behind a lock of hair is not.
fn reached(atlas: &Atlas, trusted: &[bool], is_own: &dyn Fn(usize) -> bool) -> Vec<bool> {
    let lost: Vec<bool> = (0..AREA).map(|cell| atlas.is_inside(cell) && !trusted[cell]).collect();
    let wide: Vec<bool> = distances(&lost).iter().zip(trusted).map(|(far, is)| *is && *far >= NARROW).collect();
    let from = (0..AREA).filter(|&cell| trusted[cell] && is_own(cell));
    let reached = spread(from, |cell| wide[cell]);
    // What was too narrow to pass belongs to what it borders on.
    let near = distances(&reached);
    trusted.iter().zip(near).map(|(is, far)| *is && far < NARROW).collect()
}

/// What is not the mesh, and what of it is turned away or hidden beside that: there it is seen to end. What hides a part of the
/// mesh further inside is the mesh itself.
fn ends(atlas: &Atlas, seen: &[bool]) -> Vec<bool> {
    let outside = (0..AREA).filter(|&cell| !atlas.is_inside(cell));
    spread(outside, |cell| !seen[cell])
}

/// Cells, and all that are reached from them over others.
fn spread(from: impl Iterator<Item = usize>, is_open: impl Fn(usize) -> bool) -> Vec<bool> {
    let (mut reached, mut open) = (vec![false; AREA], from.collect::<Vec<usize>>());
    open.iter().for_each(|&cell| reached[cell] = true);
    while let Some(cell) = open.pop() {
        let (row, column) = (cell / CELLS, cell % CELLS);
        let beside = [
            (row > 0).then(|| cell - CELLS),
            (row + 1 < CELLS).then(|| cell + CELLS),
            (column > 0).then(|| cell - 1),
            (column + 1 < CELLS).then(|| cell + 1),
        ];
        for next in beside.into_iter().flatten().filter(|&next| is_open(next)) {
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
    let within = |value: f32, times: f32| value < times && value * times > 1.0;
    brightness < BRIGHTER && brightness * DARKER > 1.0 && within(red, REDDER) && within(blue, REDDER)
}
