// A soft shadow on an unseen floor under the face.
struct Corner {
    @builtin(position) clip: vec4f,
    @location(0) place: vec2f,
}

const WIDTH = 0.95;
const DEPTH = 0.62;

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> Corner {
    let place = square_corner(index);
    let point_m = frame.ground_m + vec3f(place.x * WIDTH, 0.0, place.y * DEPTH) * frame.radius_m;
    return Corner(frame.clip_from_model * vec4f(point_m, 1.0), place);
}

@fragment
fn fragment(corner: Corner) -> @location(0) vec4f {
    let away = dot(corner.place, corner.place);
    let rim = 1.0 - smoothstep(0.3, 1.0, away);
    let seen_from_above = smoothstep(-0.04, 0.04, to_eye(frame.ground_m).y);
    return vec4f(0.0, 0.0, 0.0, frame.halo.a * exp(-4.5 * away) * rim * seen_from_above);
}
