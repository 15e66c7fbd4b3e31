// The picture taken of the mesh, warped, on its plane.
@group(1) @binding(0) var picture: texture_2d<f32>;
@group(1) @binding(1) var picture_sampler: sampler;

struct Corner {
    @builtin(position) clip: vec4f,
    @location(0) uv: vec2f,
}

// The first points are the corners of the whole picture.
const CORNERS = 4u;

// Target and source of a point, in px of the picture. The picture is behind everything else. Its moving part is in front
// of the whole one, so that a transparent picture shows one of them.
@vertex
fn vertex(@builtin(vertex_index) index: u32, @location(0) to_px: vec2f, @location(1) from_px: vec2f) -> Corner {
    let place_px = mix(to_px, from_px, frame.before);
    let place_m = frame.picture_origin_m + place_px.x * frame.picture_right_m + place_px.y * frame.picture_down_m;
    let uv = from_px / vec2f(frame.picture_width_px, frame.picture_height_px);
    let clip = frame.clip_from_model * vec4f(place_m, 1.0);
    let depth = select(0.9999, 0.99995, index < CORNERS);
    return Corner(vec4f(clip.xy, depth * clip.w, clip.w), uv);
}

@fragment
fn fragment(corner: Corner) -> @location(0) vec4f {
    // A picture from a saved file is transparent where the file does not store it.
    let texel = textureSample(picture, picture_sampler, corner.uv);
    return premultiplied(srgb_from_linear(texel.rgb), frame.picture * texel.a);
}
