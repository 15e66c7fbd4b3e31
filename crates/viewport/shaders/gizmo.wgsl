// Gizmo: three arms along the model's axes from the selected vertex. Follows `marks.wgsl`, which defines the axes.
struct Arm {
    @builtin(position) clip: vec4f,
    @location(0) across_px: f32,
    @location(1) @interpolate(flat) axis: u32,
    @location(2) strength: f32,
}

const START_PX = 11.0;

fn arm_half_width_px(axis: u32) -> f32 {
    return select(1.0, 1.75, axis == frame.gizmo_axis) * frame.pixel_ratio;
}

@vertex
fn arm_vertex(@builtin(vertex_index) index: u32, @builtin(instance_index) axis: u32) -> Arm {
    let corner = square_corner(index);
    let vertex_m = position_m(frame.gizmo_vertex);
    let from_clip = lifted(along_axis_m(vertex_m, axis, START_PX), 0.03);
    let to_clip = lifted(along_axis_m(vertex_m, axis, GIZMO_PX), 0.03);
    let line_px = place_px(to_clip) - place_px(from_clip);
    let along = line_px / max(length(line_px), 1e-6);
    let half_px = arm_half_width_px(axis) + 1.0;
    let sideways_px = vec2f(-along.y, along.x) * corner.y * half_px;
    var arm: Arm;
    arm.clip = moved_by_px(select(from_clip, to_clip, corner.x > 0.0), sideways_px);
    arm.across_px = corner.y * half_px;
    arm.axis = axis;
    arm.strength = frame.tools * arm_strength(vertex_m, axis);
    return arm;
}

@fragment
fn arm_fragment(arm: Arm) -> @location(0) vec4f {
    let inside = coverage(abs(arm.across_px) - arm_half_width_px(arm.axis));
    return premultiplied(axis_colour(arm.axis), inside * 0.95) * alpha * arm.strength;
}
