// Edges as antialiased quads one CSS px wide.
struct Corner {
    @builtin(position) clip: vec4f,
    @location(0) across_px: f32,
    @location(1) strength: f32,
}

const HALF_WIDTH = 0.5;

@vertex
fn vertex(@builtin(vertex_index) index: u32, @location(0) ends: vec2u) -> Corner {
    let corner = square_corner(index);
    let from_clip = lifted(position_m(ends.x), 0.006);
    let to_clip = lifted(position_m(ends.y), 0.006);
    let line_px = place_px(to_clip) - place_px(from_clip);
    let along = line_px / max(length(line_px), 1e-6);
    let half_px = max(HALF_WIDTH * frame.pixel_ratio, 0.5) + 0.5;
    let sideways_px = vec2f(-along.y, along.x) * corner.y * half_px;
    let start = select(from_clip, to_clip, corner.x > 0.0);
    let end = select(ends.x, ends.y, corner.x > 0.0);
    let facing = dot(normal(end), to_eye(position_m(end)));
    var out: Corner;
    out.clip = moved_by_px(start, sideways_px);
    out.across_px = corner.y * half_px;
    out.strength = mix(0.35, 1.0, smoothstep(0.0, 0.5, abs(facing)));
    return out;
}

@fragment
fn fragment(corner: Corner) -> @location(0) vec4f {
    let half_px = max(HALF_WIDTH * frame.pixel_ratio, 0.5);
    let alpha = coverage(abs(corner.across_px) - half_px) * frame.ink.a * corner.strength;
    return premultiplied(frame.ink.rgb, alpha);
}
