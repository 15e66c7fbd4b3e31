// The face itself, shaded.
struct Corner {
    @builtin(position) clip: vec4f,
    @location(0) model_m: vec3f,
    @location(1) normal: vec3f,
    @location(2) uv: vec2f,
    @location(3) colour: vec3f,
    @location(4) scalar: f32,
    @location(5) response: f32,
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
    let skin = vertex_attributes(index);
    var corner: Corner;
    corner.model_m = position_m(index);
    corner.clip = frame.clip_from_model * vec4f(corner.model_m, 1.0);
    corner.normal = normal(index);
    corner.uv = skin.uv;
    corner.colour = linear_from_srgb(skin.colour);
    corner.scalar = skin.scalar;
    corner.response = response(index);
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

fn shaded(albedo: vec3f, facing: vec3f, to_eye: vec3f) -> vec3f {
    let direct = max(dot(facing, frame.light_direction), 0.0);
    let light = vec3f(frame.ambient) + frame.light_colour * frame.light_strength * direct;
    if frame.shading == PICTURE || frame.shading == COLOURS {
        return albedo * light;
    }
    let half_way = normalize(frame.light_direction + to_eye);
    let gleam = 0.06 * pow(max(dot(facing, half_way), 0.0), 24.0) * frame.light_strength;
    return albedo * light + frame.light_colour * gleam;
}

@fragment
fn fragment(corner: Corner, @builtin(front_facing) front: bool) -> @location(0) vec4f {
    let picture_colour = textureSample(picture, picture_sampler, corner.uv).rgb;
    let facing = normalize(select(-corner.normal, corner.normal, front));
    let to_eye = normalize(frame.eye_m - corner.model_m);
    if frame.shading == NORMALS {
        return vec4f(0.5 * facing + 0.5, 1.0);
    }
    var albedo = INSIDE;
    if front {
        albedo = painted(corner, picture_colour);
    }
    let glow = frame.glow * smoothstep(0.0, 1.0, corner.response);
    return vec4f(mix(srgb_from_linear(shaded(albedo, facing, to_eye)), frame.accent.rgb, 0.6 * glow), 1.0);
}
