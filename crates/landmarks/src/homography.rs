//! Projective maps between quadrilaterals, with the arithmetic of OpenCV's `getPerspectiveTransform`.

/// Rows of a 3 × 3 matrix.
pub(crate) type Matrix = [[f64; 3]; 3];

/// The map from `source` to `target`, corner by corner, with a last entry of 1.
///
/// Solves the 8 × 8 system of `X = (m00 x + m01 y + m02) / (m20 x + m21 y + 1)` and likewise for `Y`. Products of
/// coordinates are rounded to f32.
pub(crate) fn between(source: &[[f32; 2]; 4], target: &[[f32; 2]; 4]) -> Matrix {
    let mut rows = [[0.0; 9]; 8];
    for (i, (&[x, y], &[target_x, target_y])) in source.iter().zip(target).enumerate() {
        let [wide_x, wide_y] = [f64::from(x), f64::from(y)];
        let products = |t: f32| [f64::from(-x * t), f64::from(-y * t), f64::from(t)];
        let ([xx, yx, x_end], [xy, yy, y_end]) = (products(target_x), products(target_y));
        rows[i] = [wide_x, wide_y, 1.0, 0.0, 0.0, 0.0, xx, yx, x_end];
        rows[i + 4] = [0.0, 0.0, 0.0, wide_x, wide_y, 1.0, xy, yy, y_end];
    }
    let m = solve(rows);
    [[m[0], m[1], m[2]], [m[3], m[4], m[5]], [m[6], m[7], 1.0]]
}

/// Solves eight equations, with the right-hand side in the last column, by Gaussian elimination with partial pivoting.
fn solve(mut rows: [[f64; 9]; 8]) -> [f64; 8] {
    for i in 0..8 {
        let mut pivot = i;
        for j in i + 1..8 {
            if rows[j][i].abs() > rows[pivot][i].abs() {
                pivot = j;
            }
        }
        rows.swap(i, pivot);
        let minus_inverse = -1.0 / rows[i][i];
        let pivot_row = rows[i];
        for row in rows.iter_mut().skip(i + 1) {
            let factor = row[i] * minus_inverse;
            row.iter_mut().zip(pivot_row).skip(i + 1).for_each(|(value, above)| *value += factor * above);
        }
    }
    let mut solution = [0.0; 8];
    for i in (0..8).rev() {
        let known = (i + 1..8).fold(rows[i][8], |rest, k| rest - rows[i][k] * solution[k]);
        solution[i] = known / rows[i][i];
    }
    solution
}

/// The inverse, from the adjugate.
pub(crate) fn inverse(m: &Matrix) -> Matrix {
    let minor = |a: usize, b: usize, c: usize, d: usize| m[a][c] * m[b][d] - m[a][d] * m[b][c];
    let determinant = m[0][0] * minor(1, 2, 1, 2) - m[0][1] * minor(1, 2, 0, 2) + m[0][2] * minor(1, 2, 0, 1);
    let scale = 1.0 / determinant;
    let entry = |p: [usize; 4], q: [usize; 4]| (m[p[0]][p[1]] * m[p[2]][p[3]] - m[q[0]][q[1]] * m[q[2]][q[3]]) * scale;
    [
        [entry([1, 1, 2, 2], [1, 2, 2, 1]), entry([0, 2, 2, 1], [0, 1, 2, 2]), entry([0, 1, 1, 2], [0, 2, 1, 1])],
        [entry([1, 2, 2, 0], [1, 0, 2, 2]), entry([0, 0, 2, 2], [0, 2, 2, 0]), entry([0, 2, 1, 0], [0, 0, 1, 2])],
        [entry([1, 0, 2, 1], [1, 1, 2, 0]), entry([0, 1, 2, 0], [0, 0, 2, 1]), entry([0, 0, 1, 1], [0, 1, 1, 0])],
    ]
}
