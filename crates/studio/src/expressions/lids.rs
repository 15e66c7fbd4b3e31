use glam::DVec3;

/// Landmarks of the right upper lid's edge and those of the lower one below them, from the outer corner to the inner.
const EDGES: [[u32; 2]; 7] = [[246, 7], [161, 163], [160, 144], [159, 145], [158, 153], [157, 154], [173, 155]];
/// The corners between them.
const CORNERS: [u32; 2] = [33, 133];
/// Where the lids meet, from the lower one up to the upper.
const MEET_AT: f64 = 0.12;
/// How far the closed lids lie before their edges in the middle, where the eyeball is, in mm of the canonical face.
const FORWARD_MM: f64 = 0.8;

/// The way in metres that takes a landmark of either lid's edge to where it meets the other's; nothing for others.
pub(super) fn way_m(at: impl Fn(u32) -> DVec3, landmark: u32, unit_m: f64) -> DVec3 {
    let Some([upper, lower]) = EDGES.into_iter().find(|pair| pair.contains(&landmark)) else { return DVec3::ZERO };
    let meeting = at(lower).lerp(at(upper), MEET_AT);
    let [outer, inner] = CORNERS.map(&at);
    let across = inner - outer;
    let along = ((meeting - outer).dot(across) / across.length_squared()).clamp(0.0, 1.0);
    let forward = DVec3::Z * (4.0 * along * (1.0 - along) * FORWARD_MM * unit_m);
    meeting + forward - at(landmark)
}
