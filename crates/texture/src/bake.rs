use rosto_photo::Photo;

use crate::atlas::Atlas;
use crate::blend::{Blend, Shares};
use crate::draw::drawn;
use crate::layer::{Layer, PreparedShot, Side};
use crate::map::{CELLS, blurred};
use crate::subject::check;
use crate::{Shot, Subject, TextureError};

/// A texture and the sources of its texels.
#[derive(Debug, Clone, PartialEq)]
pub struct Texture {
    /// The square picture. Texels outside the mesh continue its colours, so that texture filtering at the rim stays
    /// correct.
    pub picture: Photo,
    /// Shares of the sources.
    pub shares: Shares,
}

/// Bakes a square texture of `side_px` from photos of a mesh.
///
/// Colours are sRGB levels; exposure is matched by ratios of levels. The first photo sets the brightness. The result is
/// the same on each machine, because the computation uses only sums, products, quotients and square roots.
///
/// # Errors
/// [`TextureError`] if the side is not a power of two within [`SIDES_PX`](crate::SIDES_PX), if there is no photo or
/// more than [`MAX_SHOTS`](crate::MAX_SHOTS), if the number of values differs from the number of vertices or a value is
/// not finite, if the mesh covers no texel, or if no photo shows any of it.
pub fn texture(subject: &Subject<'_>, shots: &[Shot<'_>], side_px: u32) -> Result<Texture, TextureError> {
    check(subject, shots, side_px)?;
    let atlas = Atlas::new(subject)?;
    let features: Vec<Vec<f32>> =
        subject.features.iter().map(|feature| spread_feature(subject, &atlas, feature)).collect();
    let any_feature: Vec<f32> = features.iter().fold(vec![0.0; CELLS * CELLS], |any, feature| {
        any.iter().zip(feature).map(|(any, feature): (&f32, &f32)| any.max(*feature)).collect()
    });
    let seen: Vec<PreparedShot<'_>> = shots.iter().map(|shot| PreparedShot::new(subject, shot, side_px)).collect();
    let layers_of = |side| seen.iter().map(move |seen| (seen, side));
    let all = layers_of(Side::Own).chain(layers_of(Side::Mirrored));
    let layers: Vec<Layer> = all.map(|(seen, side)| seen.layer(&atlas, side, &any_feature)).collect();
    if layers.iter().all(|layer| layer.presence.iter().all(|presence| *presence == 0.0)) {
        return Err(TextureError::NothingSeen { shots: shots.len() });
    }
    let blend = Blend::new(&atlas, &layers, &features);
    let picture = Photo::from_rgb(side_px, side_px, drawn(subject, &seen, &layers, &blend, side_px))?;
    Ok(Texture { picture, shares: blend.shares })
}

/// Membership of each cell in a feature: 1 among its vertices, fading around them.
fn spread_feature(subject: &Subject<'_>, atlas: &Atlas, feature: &[u32]) -> Vec<f32> {
    let mut marks = vec![0.0; subject.topology.vertex_count()];
    feature.iter().for_each(|&vertex| marks[vertex as usize] = 1.0);
    let spread: Vec<f32> =
        atlas.spread(&marks).into_iter().map(|mark: Option<f64>| mark.unwrap_or_default() as f32).collect();
    blurred(&spread, 2, CELLS).into_iter().map(|mark| (2.0 * mark).min(1.0)).collect()
}
