// The shaded surface.
struct Corner {
    @builtin(position) clip: vec4f,
    @location(0) model_m: vec3f,
    @location(1) normal: vec3f,
    @location(2) uv: vec2f,
    @location(3) colour: vec3f,
    @location(4) scalar: f32,
    @location(5) response: f32,
    // Distance from the handles, as a multiple of the influence radius.
    @location(6) influence_distance: f32,
}

const CLAY = vec3f(0.445, 0.385, 0.330);
const INSIDE = vec3f(0.23, 0.205, 0.185);
const PICTURE = 0u;
const COLOURS = 1u;
const NORMALS = 3u;
const RESPONSE = 4u;
const DISTORTION = 5u;

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> Corner {
    let attributes = vertex_attributes(index);
    var corner: Corner;
    corner.model_m = position_m(index);
    corner.clip = frame.clip_from_model * vec4f(corner.model_m, 1.0);
    corner.normal = normal(index);
    corner.uv = attributes.uv;
    corner.colour = linear_from_srgb(attributes.colour);
    corner.scalar = attributes.scalar;
    corner.response = response(index);
    corner.influence_distance = follow(index).influence_distance;
    return corner;
}

// Blue, neutral, red for -1, 0, 1.
fn diverging(value: f32) -> vec3f {
    let neutral = vec3f(0.60, 0.57, 0.54);
    let far = select(vec3f(0.60, 0.035, 0.045), vec3f(0.035, 0.13, 0.55), value < 0.0);
    return mix(neutral, far, pow(clamp(abs(value), 0.0, 1.0), 0.7));
}

fn painted(corner: Corner, picture_colour: vec3f) -> vec3f {
    switch frame.shading {
        case PICTURE: { return picture_colour; }
        case COLOURS: { return corner.colour; }
        case RESPONSE: { return mix(CLAY, linear_from_srgb(frame.accent.rgb), smoothstep(0.0, 1.0, corner.response)); }
        case DISTORTION: { return diverging(corner.scalar); }
        default: { return CLAY; }
    }
}

fn shaded(albedo: vec3f, facing: vec3f, towards_eye: vec3f) -> vec3f {
    let direct = max(dot(facing, frame.light_direction), 0.0);
    let light = vec3f(frame.ambient) + frame.light_colour * frame.light_strength * direct;
    if frame.shading == PICTURE || frame.shading == COLOURS {
        return albedo * light;
    }
    let half_way = normalize(frame.light_direction + towards_eye);
    let gleam = 0.06 * pow(max(dot(facing, half_way), 0.0), 24.0) * frame.light_strength;
    return albedo * light + frame.light_colour * gleam;
}

// Coverage of a line along `value` = 0 with a width in CSS px; `per_px` is the derivative of `value`.
fn line_along(value: f32, per_px: f32, width_px: f32) -> f32 {
    let distance_px = abs(value) / max(per_px, 1e-9);
    return coverage(distance_px - 0.5 * width_px * frame.pixel_ratio);
}

// Lines on the surface: the influence radius and the plane of symmetry.
fn lines_on(corner: Corner, distance_per_px: f32, x_per_px: f32) -> vec4f {
    let away = corner.influence_distance - 1.0;
    let halo = 0.6 * frame.rim * line_along(away, distance_per_px, 4.0);
    let rim = frame.rim * line_along(away, distance_per_px, 2.0);
    let plane = 0.8 * frame.mirror_plane * line_along(corner.model_m.x, x_per_px, 1.0);
    let line = max(rim, plane);
    return vec4f(mix(vec3f(1.0), frame.accent.rgb, line), max(line, halo));
}

@fragment
fn fragment(corner: Corner, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    // Mirroring reverses the winding.
    let front = is_front != (frame.swapped > 0.5);
    let picture_colour = textureSample(picture, picture_sampler, corner.uv).rgb;
    let distance_per_px = length(vec2f(dpdx(corner.influence_distance), dpdy(corner.influence_distance)));
    let x_per_px = length(vec2f(dpdx(corner.model_m.x), dpdy(corner.model_m.x)));
    let facing = normalize(select(-corner.normal, corner.normal, front));
    let lines = lines_on(corner, distance_per_px, x_per_px);
    if frame.shading == NORMALS {
        return vec4f(mix(0.5 * facing + 0.5, lines.rgb, lines.a), 1.0);
    }
    var albedo = INSIDE;
    if front {
        albedo = painted(corner, picture_colour);
    }
    let glow = frame.glow * smoothstep(0.0, 1.0, corner.response);
    let glowing = mix(srgb_from_linear(shaded(albedo, facing, to_eye(corner.model_m))), frame.accent.rgb, 0.6 * glow);
    return vec4f(mix(glowing, lines.rgb, lines.a), 1.0);
}
