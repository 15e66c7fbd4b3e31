// Screen-sized marks: ring, square, pin, dot, speck and the axes' letters.
override alpha: f32 = 1.0;

struct Corner {
    @builtin(position) clip: vec4f,
    @location(0) place_px: vec2f,
    @location(1) @interpolate(flat) kind: u32,
    @location(2) strength: f32,
}

const RING = 0u;
const SQUARE = 1u;
const PIN = 2u;
const DOT = 3u;
const LETTER_X = 4u;
const LETTER_Z = 6u;
const SPECK = 7u;
const HALF_SIDE_PX = 14.0;
const GIZMO_PX = 68.0;
const LETTER_GAP_PX = 13.0;

fn axis_direction(axis: u32) -> vec3f {
    return vec3f(f32(axis == 0u), f32(axis == 1u), f32(axis == 2u));
}

fn axis_colour(axis: u32) -> vec3f {
    switch axis {
        case 0u: { return vec3f(0.80, 0.22, 0.22); }
        case 1u: { return vec3f(0.27, 0.58, 0.20); }
        default: { return vec3f(0.24, 0.42, 0.86); }
    }
}

// A point at a distance in CSS px from a vertex along an axis, measured perpendicular to the line of sight.
fn along_axis_m(vertex_m: vec3f, axis: u32, css_px: f32) -> vec3f {
    let clip = frame.clip_from_model * vec4f(vertex_m, 1.0);
    return vertex_m + axis_direction(axis) * css_px * frame.pixel_ratio * frame.m_per_px * clip.w;
}

// Arms towards the viewer fade: they would cover the vertex, and could not be dragged.
fn arm_strength(vertex_m: vec3f, axis: u32) -> f32 {
    return smoothstep(0.10, 0.35, length(cross(to_eye(vertex_m), axis_direction(axis))));
}

@vertex
fn vertex(@builtin(vertex_index) index: u32, @location(0) mark: vec2u) -> Corner {
    var point_m = position_m(mark.x);
    var strength = select(frame.tools, 1.0, mark.y == SQUARE || mark.y == PIN);
    if mark.y >= LETTER_X && mark.y <= LETTER_Z {
        strength *= arm_strength(point_m, mark.y - LETTER_X);
        point_m = along_axis_m(point_m, mark.y - LETTER_X, GIZMO_PX + LETTER_GAP_PX);
    }
    let corner = square_corner(index) * HALF_SIDE_PX;
    let clip = moved_by_px(lifted(point_m, 0.03), corner * vec2f(1.0, -1.0) * frame.pixel_ratio);
    return Corner(clip, corner, mark.y, strength);
}

fn segment(place: vec2f, a: vec2f, b: vec2f) -> f32 {
    let along = clamp(dot(place - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
    return length(place - a - along * (b - a));
}

fn letter(place: vec2f, kind: u32) -> f32 {
    let w = 3.4;
    let h = 4.6;
    switch kind - LETTER_X {
        case 0u: { return min(segment(place, vec2f(-w, -h), vec2f(w, h)), segment(place, vec2f(-w, h), vec2f(w, -h))); }
        case 1u: {
            let arms = min(segment(place, vec2f(-w, h), vec2f(0.0)), segment(place, vec2f(w, h), vec2f(0.0)));
            return min(arms, segment(place, vec2f(0.0), vec2f(0.0, -h)));
        }
        default: {
            let bars = min(segment(place, vec2f(-w, h), vec2f(w, h)), segment(place, vec2f(-w, -h), vec2f(w, -h)));
            return min(bars, segment(place, vec2f(w, h), vec2f(-w, -h)));
        }
    }
}

fn pin(place: vec2f) -> f32 {
    let head = length(place - vec2f(0.0, 8.5)) - 4.2;
    return min(head, segment(place, vec2f(0.0, 0.0), vec2f(0.0, 5.0)) - 0.9);
}

// Signed distance in CSS px to the outline of a mark; negative inside.
fn outline(place: vec2f, kind: u32) -> f32 {
    switch kind {
        case RING: { return abs(length(place) - 7.0) - 1.25; }
        case SQUARE: { return max(abs(place.x), abs(place.y)) - 3.0; }
        case PIN: { return pin(place); }
        case DOT: { return length(place) - 3.5; }
        case SPECK: { return length(place) - 1.5; }
        default: { return letter(place, kind) - 0.95; }
    }
}

fn mark_colour(kind: u32) -> vec3f {
    switch kind {
        case RING, DOT, SPECK: { return frame.accent.rgb; }
        case SQUARE, PIN: { return frame.ink.rgb; }
        default: { return axis_colour(kind - LETTER_X); }
    }
}

// Marks with their own colours lie on skin, so their outline does not depend on the theme.
fn halo_colour(kind: u32) -> vec3f {
    return select(vec3f(1.0), frame.halo.rgb, kind == SQUARE || kind == PIN);
}

@fragment
fn fragment(corner: Corner) -> @location(0) vec4f {
    let distance_px = outline(corner.place_px, corner.kind) * frame.pixel_ratio;
    let body = coverage(distance_px);
    let halo = coverage(distance_px - 1.25 * frame.pixel_ratio) * 0.85;
    let colour = premultiplied(mark_colour(corner.kind), body);
    return (colour + premultiplied(halo_colour(corner.kind), halo) * (1.0 - body)) * alpha * corner.strength;
}
