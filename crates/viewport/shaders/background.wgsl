// The theme's gradient from top to bottom.
struct Corner {
    @builtin(position) clip: vec4f,
}

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> Corner {
    let corner = vec2f(f32(index & 1u), f32(index >> 1u)) * 4.0 - 1.0;
    return Corner(vec4f(corner, 1.0, 1.0));
}

// Noise below one 8-bit step, to avoid banding.
fn dither(place_px: vec2f) -> f32 {
    return (fract(52.9829189 * fract(dot(place_px, vec2f(0.06711056, 0.00583715)))) - 0.5) / 255.0;
}

@fragment
fn fragment(corner: Corner) -> @location(0) vec4f {
    let down = corner.clip.y / frame.viewport_px.y;
    let colour = mix(frame.ground_top.rgb, frame.ground_bottom.rgb, smoothstep(0.0, 1.0, down));
    return vec4f(colour + dither(corner.clip.xy), 1.0);
}
