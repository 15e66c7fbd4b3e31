// The plane of symmetry x = 0: a faint sheet with a rim.
struct Corner {
    @builtin(position) clip: vec4f,
    @location(0) place: vec2f,
}

const HALF_SIDE = 1.12;

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> Corner {
    let place = square_corner(index);
    let middle_m = vec3f(0.0, frame.ground_m.y + 0.9 * frame.radius_m, frame.ground_m.z);
    let point_m = middle_m + vec3f(0.0, place.y, place.x) * HALF_SIDE * frame.radius_m;
    return Corner(frame.clip_from_model * vec4f(point_m, 1.0), place);
}

@fragment
fn fragment(corner: Corner) -> @location(0) vec4f {
    let inside = 1.0 - max(abs(corner.place.x), abs(corner.place.y));
    let rim = 1.0 - smoothstep(0.0, 1.5 * frame.pixel_ratio * fwidth(inside), inside);
    return premultiplied(frame.accent.rgb, mix(0.10, 0.55, rim));
}
