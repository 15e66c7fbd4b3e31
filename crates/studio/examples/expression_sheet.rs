//! Every expression at 1, from the front and from the side, as one picture to look at: a PPM on the standard output.
//!
//! ```sh
//! cargo run --release -p rosto-studio --example expression_sheet > expressions.ppm
//! ```
//! From the left to the right and from the top down in the order of `Expression::ALL`, whose names are written to the standard error.

use std::io::Write;

use glam::{DQuat, DVec3};
use rosto_face::{Parted, Triangulation, canonical_positions_m};
use rosto_mesh::{Topology, vertex_normals};
use rosto_studio::{CoordinateFrame, Document, Expression, Rest};

const SIDE_PX: usize = 180;
const COLUMNS: usize = 6;
const DENSITY: u32 = 2;
/// Metres from the middle of a picture to its edge.
const HALF_M: f64 = 0.105;
const MIDDLE_M: DVec3 = DVec3::new(0.0, -0.015, 0.0);
const BACKGROUND: [u8; 3] = [40, 40, 46];
const YAWS: [f64; 2] = [0.0, 0.7];

type Picture = Vec<[u8; 3]>;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let rest = Rest::new(Triangulation::Canonical.topology(), canonical_positions_m(), CoordinateFrame::Model);
    let mut document = Document::new(rest)?;
    document.set_density(DENSITY)?;
    let parted = document.parted();
    let rest_m = parted.positions_m(document.rest());
    let mut cells: Vec<Picture> = Vec::new();
    for (expression, ways) in Expression::ALL.into_iter().zip(document.expressions()?) {
        eprintln!("{}", expression.id());
        let moved: Vec<DVec3> = rest_m.iter().zip(parted.ways(&ways)).map(|(at, way)| *at + way).collect();
        cells.extend(YAWS.map(|yaw| drawn(&parted, &moved, yaw)));
    }
    let rows = cells.len().div_ceil(2 * COLUMNS);
    let width = 2 * COLUMNS * SIDE_PX;
    let mut out = std::io::stdout().lock();
    writeln!(out, "P6 {width} {} 255", rows * SIDE_PX)?;
    for y in 0..rows * SIDE_PX {
        for x in 0..width {
            let cell = cells.get(y / SIDE_PX * 2 * COLUMNS + x / SIDE_PX);
            out.write_all(&cell.map_or(BACKGROUND, |cell| cell[y % SIDE_PX * SIDE_PX + x % SIDE_PX]))?;
        }
    }
    Ok(())
}

/// In clay, lit from the upper right; what turns its back is dark.
fn drawn(parted: &Parted, positions_m: &[DVec3], yaw: f64) -> Picture {
    let turn = DQuat::from_rotation_y(yaw);
    let topology: &Topology = parted.topology();
    let px = SIDE_PX as f64 / (2.0 * HALF_M);
    let to_px = |at: &DVec3| {
        let seen = turn * (*at - MIDDLE_M);
        DVec3::new((seen.x + HALF_M) * px, (HALF_M - seen.y) * px, seen.z)
    };
    let places: Vec<DVec3> = positions_m.iter().map(to_px).collect();
    let light = DVec3::new(0.3, 0.5, 0.8).normalize();
    let shades: Vec<f64> =
        vertex_normals(topology, positions_m).iter().map(|normal| (turn * *normal).dot(light).max(0.0)).collect();
    let (mut picture, mut depths) = (vec![BACKGROUND; SIDE_PX * SIDE_PX], vec![f64::NEG_INFINITY; SIDE_PX * SIDE_PX]);
    for corners in topology.triangles() {
        let [a, b, c] = corners.map(|corner| places[corner as usize]);
        let shade = corners.map(|corner| shades[corner as usize]);
        let area = (b - a).cross(c - a).z;
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        let last = SIDE_PX as f64 - 1.0;
        for y in low.y.max(0.0) as usize..=high.y.min(last).max(0.0) as usize {
            for x in low.x.max(0.0) as usize..=high.x.min(last).max(0.0) as usize {
                let at = DVec3::new(x as f64 + 0.5, y as f64 + 0.5, 0.0);
                let share =
                    [(c - b).cross(at - b).z / area, (a - c).cross(at - c).z / area, (b - a).cross(at - a).z / area];
                let depth = share[0] * a.z + share[1] * b.z + share[2] * c.z;
                let place = y * SIDE_PX + x;
                if share.iter().any(|share| *share < -1e-6 || share.is_nan()) || depth <= depths[place] {
                    continue;
                }
                depths[place] = depth;
                let lit = 0.25 + 0.75 * (share[0] * shade[0] + share[1] * shade[1] + share[2] * shade[2]);
                let clay = if area < 0.0 { [205.0, 190.0, 178.0] } else { [90.0, 40.0, 45.0] };
                picture[place] = clay.map(|channel| (channel * lit) as u8);
            }
        }
    }
    picture
}
