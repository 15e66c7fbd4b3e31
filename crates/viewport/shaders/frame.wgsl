// Uniforms of a frame, with the same fields in the same order as the stage's `FrameUniforms`.
struct FrameUniforms {
    clip_from_model: mat4x4f,
    // The eye as a homogeneous point; w, in 1/m, is 0 for parallel projection.
    eye: vec4f,
    light_direction: vec3f,
    light_strength: f32,
    light_colour: vec3f,
    ambient: f32,
    offset_a_m: vec3f,
    before: f32,
    offset_b_m: vec3f,
    glow: f32,
    right: vec3f,
    // Metres per px at w = 1 in clip space.
    m_per_px: f32,
    up: vec3f,
    shading: u32,
    ground_m: vec3f,
    radius_m: f32,
    viewport_px: vec2f,
    pointer_px: vec2f,
    ink: vec4f,
    // The alpha is the shadow's opacity. Colours of the theme are sRGB.
    halo: vec4f,
    accent: vec4f,
    ground_top: vec4f,
    ground_bottom: vec4f,
    dots: u32,
    hovered: u32,
    gizmo_vertex: u32,
    gizmo_axis: u32,
    // Whether the influence radius and the plane of symmetry are drawn, 0 or 1.
    rim: f32,
    mirror_plane: f32,
    pixel_ratio: f32,
    // Opacity of the picture, 0..1; its top left corner; offsets of one px to the right and down.
    picture: f32,
    picture_origin_m: vec3f,
    picture_width_px: f32,
    picture_right_m: vec3f,
    picture_height_px: f32,
    picture_down_m: vec3f,
    swapped: f32,
    // Opacity of marks and gizmo, 0..1.
    tools: f32,
}

@group(0) @binding(0) var<uniform> frame: FrameUniforms;

const NO_VERTEX = 0xffffffffu;

fn linear_from_srgb(encoded: vec3f) -> vec3f {
    let dark = encoded / 12.92;
    let light = pow((encoded + 0.055) / 1.055, vec3f(2.4));
    return select(light, dark, encoded <= vec3f(0.04045));
}

// Targets store sRGB, encoded here rather than by the driver.
fn srgb_from_linear(linear: vec3f) -> vec3f {
    let amount = clamp(linear, vec3f(0.0), vec3f(1.0));
    let dark = amount * 12.92;
    let light = 1.055 * pow(amount, vec3f(1.0 / 2.4)) - 0.055;
    return select(light, dark, amount <= vec3f(0.0031308));
}

// Premultiplied alpha, as in the page's compositing.
fn premultiplied(colour: vec3f, alpha: f32) -> vec4f {
    return vec4f(colour * alpha, alpha);
}

// Corners of two triangles that fill the square from (-1, -1) to (1, 1), for vertices 0..6.
fn square_corner(index: u32) -> vec2f {
    let right = index == 1u || index == 2u || index == 4u;
    let top = index == 2u || index == 4u || index == 5u;
    return vec2f(select(-1.0, 1.0, right), select(-1.0, 1.0, top));
}

fn place_px(clip: vec4f) -> vec2f {
    return (vec2f(0.5, -0.5) * clip.xy / clip.w + vec2f(0.5)) * frame.viewport_px;
}

fn moved_by_px(clip: vec4f, motion_px: vec2f) -> vec4f {
    return vec4f(clip.xy + motion_px * vec2f(2.0, -2.0) / frame.viewport_px * clip.w, clip.zw);
}

fn to_eye(point_m: vec3f) -> vec3f {
    return normalize(frame.eye.xyz - frame.eye.w * point_m);
}

// Clip position of a point, with a depth slightly nearer to the eye, so that lines on the surface are not hidden by it.
fn lifted(point_m: vec3f, share_of_radius: f32) -> vec4f {
    let clip = frame.clip_from_model * vec4f(point_m, 1.0);
    let nearer_m = point_m + to_eye(point_m) * share_of_radius * frame.radius_m;
    let nearer = frame.clip_from_model * vec4f(nearer_m, 1.0);
    return vec4f(clip.xy, clamp(nearer.z / nearer.w, 0.0, 1.0) * clip.w, clip.w);
}

// Pixel coverage from the signed distance to an edge in px (negative inside).
fn coverage(distance_px: f32) -> f32 {
    return clamp(0.5 - distance_px, 0.0, 1.0);
}
