use rosto_photo::Photo;

use crate::atlas::Atlas;
use crate::blend::{Blend, Shares};
use crate::draw::drawn;
use crate::layer::{Layer, Seen, Side};
use crate::map::{CELLS, blurred};
use crate::subject::check;
use crate::{Shot, Subject, TextureError};

/// A texture, and where it comes from.
#[derive(Debug, Clone, PartialEq)]
pub struct Texture {
    /// The picture, as wide as high, filled to its edges: what lies around the mesh goes on from it, so that a filter at its
    /// rim finds its colours.
    pub picture: Photo,
    /// Where its texels come from.
    pub shares: Shares,
}

/// Makes a texture of `side_px` by `side_px` from photos of a mesh.
///
/// Colours are sRGB levels throughout; light is matched by ratios of them. The first photo says how bright the texture is. The
/// same values give the same bytes on every machine: nothing is used but sums, products, quotients and square roots.
///
/// # Errors
/// [`TextureError`] if the side is no power of two within [`SIDES_PX`](crate::SIDES_PX), if there is no photo or more than
/// [`MOST_SHOTS`](crate::MOST_SHOTS), if there is not one finite value for each vertex, if the mesh covers nothing of its
/// texture, or if no photo shows anything of it.
pub fn texture(subject: &Subject<'_>, shots: &[Shot<'_>], side_px: u32) -> Result<Texture, TextureError> {
    check(subject, shots, side_px)?;
    let atlas = Atlas::new(subject)?;
    let wholes: Vec<Vec<f32>> = subject.wholes.iter().map(|whole| spread_whole(subject, &atlas, whole)).collect();
    let any_whole: Vec<f32> = wholes.iter().fold(vec![0.0; CELLS * CELLS], |any, whole| {
        any.iter().zip(whole).map(|(any, whole): (&f32, &f32)| any.max(*whole)).collect()
    });
    let seen: Vec<Seen<'_>> = shots.iter().map(|shot| Seen::new(subject, shot, side_px)).collect();
    let layers_of = |side| seen.iter().map(move |seen| (seen, side));
    let all = layers_of(Side::Own).chain(layers_of(Side::Mirrored));
    let layers: Vec<Layer> = all.map(|(seen, side)| seen.layer(&atlas, side, &any_whole)).collect();
    if layers.iter().all(|layer| layer.presence.iter().all(|presence| *presence == 0.0)) {
        return Err(TextureError::NothingSeen { shots: shots.len() });
    }
    let blend = Blend::new(&atlas, &layers, &wholes);
    let picture = Photo::from_rgb(side_px, side_px, drawn(subject, &seen, &layers, &blend, side_px))?;
    Ok(Texture { picture, shares: blend.shares })
}

/// How far each cell belongs to a whole: 1 among its vertices, and less around them.
fn spread_whole(subject: &Subject<'_>, atlas: &Atlas, whole: &[u32]) -> Vec<f32> {
    let mut marks = vec![0.0; subject.topology.vertex_count()];
    whole.iter().for_each(|&vertex| marks[vertex as usize] = 1.0);
    let spread: Vec<f32> =
        atlas.spread(&marks).into_iter().map(|mark: Option<f64>| mark.unwrap_or_default() as f32).collect();
    blurred(&spread, 2, CELLS).into_iter().map(|mark| (2.0 * mark).min(1.0)).collect()
}
