use glam::DVec3;

/// Landmarks on the edge of the right upper lid, paired with those of the lower lid, from the outer to the inner
/// corner.
const EDGES: [[u32; 2]; 7] = [[246, 7], [161, 163], [160, 144], [159, 145], [158, 153], [157, 154], [173, 155]];
/// Outer and inner corner of the eye.
const CORNERS: [u32; 2] = [33, 133];
/// Meeting height of the lids, as a share from the lower lid to the upper.
const MEET_AT: f64 = 0.12;
/// Bulge of the closed lids over the eyeball at their middle, in mm of the canonical face.
const FORWARD_MM: f64 = 0.8;

/// Displacement in metres that brings a landmark of a lid's edge to where the lids meet; zero for other landmarks.
pub(super) fn displacement_m(at: impl Fn(u32) -> DVec3, landmark: u32, unit_m: f64) -> DVec3 {
    let Some([upper, lower]) = EDGES.into_iter().find(|pair| pair.contains(&landmark)) else { return DVec3::ZERO };
    let meeting = at(lower).lerp(at(upper), MEET_AT);
    let [outer, inner] = CORNERS.map(&at);
    let across = inner - outer;
    let along = ((meeting - outer).dot(across) / across.length_squared()).clamp(0.0, 1.0);
    let forward = DVec3::Z * (4.0 * along * (1.0 - along) * FORWARD_MM * unit_m);
    meeting + forward - at(landmark)
}
