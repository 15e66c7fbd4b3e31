//! Writes a PNG of each expression at weight 1, as clay renderings from the front and the side, to a folder.
//!
//! ```sh
//! cargo run --release -p rosto-studio --example expression_sheet -- expressions
//! ```

use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::PathBuf;

use glam::{DQuat, DVec3};
use rosto_face::{SplitFace, Triangulation, canonical_positions_m};
use rosto_mesh::{Topology, vertex_normals};
use rosto_studio::{CoordinateFrame, Document, Expression, Rest};

/// Side of each rendering.
const SIDE_PX: usize = 180;
const DENSITY: u32 = 2;
/// Metres from the centre of a rendering to its edge.
const HALF_M: f64 = 0.105;
const MIDDLE_M: DVec3 = DVec3::new(0.0, -0.015, 0.0);
const BACKGROUND: [u8; 3] = [40, 40, 46];
const YAWS: [f64; 2] = [0.0, 0.7];

type Picture = Vec<[u8; 3]>;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = PathBuf::from(std::env::args().nth(1).ok_or("give a folder")?);
    std::fs::create_dir_all(&folder)?;
    let rest = Rest::of_landmarks(Triangulation::Canonical.topology(), canonical_positions_m(), CoordinateFrame::Model);
    let mut document = Document::new(rest)?;
    document.set_density(DENSITY)?;
    let split_face = document.split_face();
    let rest_m = split_face.positions_m(document.rest());
    for (index, (expression, displacements)) in Expression::ALL.into_iter().zip(document.expressions()?).enumerate() {
        let moved: Vec<DVec3> = rest_m
            .iter()
            .zip(split_face.displacements(&displacements))
            .map(|(at, displacement)| *at + displacement)
            .collect();
        let file = folder.join(format!("{index:02}-{}.png", expression.id()));
        write(BufWriter::new(File::create(file)?), &YAWS.map(|yaw| drawn(&split_face, &moved, yaw)))?;
    }
    Ok(())
}

/// Writes the pictures side by side.
fn write(to: impl Write, pictures: &[Picture]) -> Result<(), png::EncodingError> {
    let row =
        |y: usize| pictures.iter().flat_map(move |picture| picture[y * SIDE_PX..(y + 1) * SIDE_PX].as_flattened());
    let pixels: Vec<u8> = (0..SIDE_PX).flat_map(row).copied().collect();
    let mut encoder = png::Encoder::new(to, (pictures.len() * SIDE_PX) as u32, SIDE_PX as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.write_header()?.write_image_data(&pixels)
}

/// Clay rendering, lit from the upper right; back faces are dark.
fn drawn(split_face: &SplitFace, positions_m: &[DVec3], yaw: f64) -> Picture {
    let turn = DQuat::from_rotation_y(yaw);
    let topology: &Topology = split_face.topology();
    let px = SIDE_PX as f64 / (2.0 * HALF_M);
    let to_px = |at: &DVec3| {
        let seen = turn * (*at - MIDDLE_M);
        DVec3::new((seen.x + HALF_M) * px, (HALF_M - seen.y) * px, seen.z)
    };
    let projected: Vec<DVec3> = positions_m.iter().map(to_px).collect();
    let light = DVec3::new(0.3, 0.5, 0.8).normalize();
    let shades: Vec<f64> =
        vertex_normals(topology, positions_m).iter().map(|normal| (turn * *normal).dot(light).max(0.0)).collect();
    let (mut picture, mut depths) = (vec![BACKGROUND; SIDE_PX * SIDE_PX], vec![f64::NEG_INFINITY; SIDE_PX * SIDE_PX]);
    for corners in topology.triangles() {
        let [a, b, c] = corners.map(|corner| projected[corner as usize]);
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
                let index = y * SIDE_PX + x;
                if share.iter().any(|share| *share < -1e-6 || share.is_nan()) || depth <= depths[index] {
                    continue;
                }
                depths[index] = depth;
                let lit = 0.25 + 0.75 * (share[0] * shade[0] + share[1] * shade[1] + share[2] * shade[2]);
                let clay = if area < 0.0 { [205.0, 190.0, 178.0] } else { [90.0, 40.0, 45.0] };
                picture[index] = clay.map(|channel| (channel * lit) as u8);
            }
        }
    }
    picture
}
