//! Test meshes and photos.

use glam::{DQuat, DVec2, DVec3};
use rosto_mesh::Topology;
use rosto_photo::Photo;
use rosto_texture::{Eye, Shot, Subject, Texture, texture};

pub const SIDE_PX: u32 = 512;
/// Side of the photos.
pub const PHOTO_PX: u32 = 400;
const COLUMNS: u32 = 24;

/// A square sheet over −1..=1 in x and y, bent towards the viewer and symmetric about x = 0.
pub struct Sheet {
    pub topology: Topology,
    pub positions: Vec<DVec3>,
    pub atlas_uvs: Vec<DVec2>,
    pub partners: Vec<u32>,
    pub features: Vec<Vec<u32>>,
}

impl Sheet {
    /// A sheet whose centre has the height `bulge`.
    pub fn bent(bulge: f64) -> Self {
        let at = |column: u32, row: u32| row * (COLUMNS + 1) + column;
        let squares = (0..COLUMNS).flat_map(|row| (0..COLUMNS).map(move |column| (column, row)));
        // The diagonals are mirrored, too.
        let cut = |(c, r): (u32, u32)| match c < COLUMNS / 2 {
            true => [[at(c, r), at(c, r + 1), at(c + 1, r + 1)], [at(c, r), at(c + 1, r + 1), at(c + 1, r)]],
            false => [[at(c, r), at(c, r + 1), at(c + 1, r)], [at(c + 1, r), at(c, r + 1), at(c + 1, r + 1)]],
        };
        let triangles = squares.flat_map(cut).collect();
        let grid: Vec<DVec2> = (0..=COLUMNS)
            .flat_map(|row| (0..=COLUMNS).map(move |column| DVec2::new(column.into(), row.into())))
            .map(|position| position / f64::from(COLUMNS))
            .collect();
        let lifted = |uv: &DVec2| {
            let [x, y] = [2.0 * uv.x - 1.0, 1.0 - 2.0 * uv.y];
            DVec3::new(x, y, bulge * (1.0 - x * x) * (1.0 - 0.5 * y * y))
        };
        Self {
            topology: Topology::new(grid.len(), triangles).unwrap(),
            positions: grid.iter().map(lifted).collect(),
            atlas_uvs: grid.iter().map(|uv| DVec2::splat(0.05) + *uv * 0.9).collect(),
            partners: (0..=COLUMNS).flat_map(|row| (0..=COLUMNS).map(move |c| at(COLUMNS - c, row))).collect(),
            features: Vec::new(),
        }
    }

    pub fn subject(&self) -> Subject<'_> {
        Subject {
            topology: &self.topology,
            positions: &self.positions,
            atlas_uvs: &self.atlas_uvs,
            partners: &self.partners,
            features: &self.features,
        }
    }

    /// View of a distant camera, with the sheet turned to its own left.
    pub fn seen(&self, yaw_deg: f64) -> View {
        let turn = DQuat::from_rotation_y(yaw_deg.to_radians());
        let position = |position: &DVec3| {
            let seen = turn * *position;
            DVec2::new(0.5 + 0.36 * seen.x, 0.5 - 0.36 * seen.y)
        };
        let uvs = self.positions.iter().map(position).collect();
        View { uvs, eye: Eye::Towards(turn.inverse() * DVec3::Z) }
    }

    pub fn baked(&self, views: &[(&View, &Photo)]) -> Texture {
        let shots: Vec<Shot<'_>> = views.iter().map(|(view, picture)| view.shot(picture)).collect();
        texture(&self.subject(), &shots, SIDE_PX).unwrap()
    }
}

/// Vertex positions in a photo, and its viewpoint.
pub struct View {
    pub uvs: Vec<DVec2>,
    pub eye: Eye,
}

impl View {
    pub fn shot<'a>(&'a self, picture: &'a Photo) -> Shot<'a> {
        Shot { picture, uvs: &self.uvs, eye: self.eye }
    }
}

/// A photo sampled from a function of the position, 0..=1.
pub fn painted(colour: impl Fn(DVec2) -> [f64; 3]) -> Photo {
    let at = |pixel: u32| DVec2::new((pixel % PHOTO_PX).into(), (pixel / PHOTO_PX).into()) + 0.5;
    let levels = (0..PHOTO_PX * PHOTO_PX).flat_map(|pixel| colour(at(pixel) / f64::from(PHOTO_PX)));
    Photo::from_rgb(PHOTO_PX, PHOTO_PX, levels.map(|level| (level + 0.5) as u8).collect()).unwrap()
}

/// Smooth colours with waves.
pub fn waves(at: DVec2) -> [f64; 3] {
    let wave = 14.0 * (at.x * 90.0).sin() * (at.y * 70.0).cos();
    [150.0 + 40.0 * at.x + wave, 120.0 + 30.0 * at.y + wave, 110.0 - 30.0 * at.x + wave]
}

/// Texels with their positions, 0..=1.
pub fn texels(texture: &Texture) -> impl Iterator<Item = (DVec2, [u8; 3])> {
    let side = texture.picture.width();
    let at = move |texel: usize| DVec2::new(f64::from(texel as u32 % side) + 0.5, f64::from(texel as u32 / side) + 0.5);
    texture
        .picture
        .pixels()
        .as_chunks::<3>()
        .0
        .iter()
        .enumerate()
        .map(move |(i, colour)| (at(i) / f64::from(side), *colour))
}

/// Largest difference of two colours in a channel.
pub fn apart(a: [u8; 3], b: [u8; 3]) -> u8 {
    (0..3).map(|channel| a[channel].abs_diff(b[channel])).max().unwrap()
}
