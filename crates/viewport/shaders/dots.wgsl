// Dots on vertices: those near the pointer, or all.
struct Corner {
    @builtin(position) clip: vec4f,
    @location(0) place_px: vec2f,
    @location(1) strength: f32,
}

const REACH_PX = 70.0;
const RADIUS_PX = 2.0;

@vertex
fn vertex(@builtin(vertex_index) index: u32, @builtin(instance_index) dotted: u32) -> Corner {
    let clip = lifted(position_m(dotted), 0.012);
    let away_px = length(place_px(clip) - frame.pointer_px) / frame.pixel_ratio;
    let near = 1.0 - smoothstep(0.35 * REACH_PX, REACH_PX, away_px);
    let strength = max(near, f32(frame.dots) * 0.75);
    let corner = square_corner(index) * (RADIUS_PX + 2.0) * f32(strength > 0.0);
    return Corner(moved_by_px(clip, corner * frame.pixel_ratio), corner, strength);
}

@fragment
fn fragment(corner: Corner) -> @location(0) vec4f {
    let distance_px = (length(corner.place_px) - RADIUS_PX) * frame.pixel_ratio;
    let body = coverage(distance_px);
    let halo = 0.7 * coverage(distance_px - frame.pixel_ratio);
    let colour = premultiplied(frame.ink.rgb, body * 0.85);
    return (colour + premultiplied(frame.halo.rgb, halo) * (1.0 - body)) * corner.strength;
}
