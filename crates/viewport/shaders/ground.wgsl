// A soft shadow on an invisible floor below the mesh. The floor keeps a minimum tilt towards the viewer, so that the
// shadow stays visible with a distant eye.
struct Corner {
    @builtin(position) clip: vec4f,
    @location(0) place: vec2f,
}

const WIDTH = 0.95;
const DEPTH = 0.62;
const LEAST_SLANT = 0.22;

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> Corner {
    let place = square_corner(index);
    let flat_m = vec3f(place.x * WIDTH, 0.0, place.y * DEPTH) * frame.radius_m;
    let steeper = max(LEAST_SLANT - to_eye(frame.ground_m).y, 0.0);
    let point_m = frame.ground_m + flat_m - frame.up * dot(flat_m, cross(frame.right, frame.up)) * steeper;
    return Corner(frame.clip_from_model * vec4f(point_m, 1.0), place);
}

@fragment
fn fragment(corner: Corner) -> @location(0) vec4f {
    let away = dot(corner.place, corner.place);
    let rim = 1.0 - smoothstep(0.3, 1.0, away);
    let seen_from_above = smoothstep(-0.08, -0.02, to_eye(frame.ground_m).y);
    return vec4f(0.0, 0.0, 0.0, frame.halo.a * exp(-4.5 * away) * rim * seen_from_above);
}
