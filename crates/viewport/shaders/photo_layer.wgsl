// The picture taken of the mesh, warped, on its plane.
@group(1) @binding(0) var picture: texture_2d<f32>;
@group(1) @binding(1) var picture_sampler: sampler;

struct Corner {
    @builtin(position) clip: vec4f,
    @location(0) uv: vec2f,
}

// Target and source of a point, in px of the picture.
@vertex
fn vertex(@location(0) to_px: vec2f, @location(1) from_px: vec2f) -> Corner {
    let place_px = mix(to_px, from_px, frame.before);
    let place_m = frame.picture_origin_m + place_px.x * frame.picture_right_m + place_px.y * frame.picture_down_m;
    let uv = from_px / vec2f(frame.picture_width_px, frame.picture_height_px);
    return Corner(frame.clip_from_model * vec4f(place_m, 1.0), uv);
}

@fragment
fn fragment(corner: Corner) -> @location(0) vec4f {
    return premultiplied(srgb_from_linear(textureSample(picture, picture_sampler, corner.uv).rgb), frame.picture);
}
