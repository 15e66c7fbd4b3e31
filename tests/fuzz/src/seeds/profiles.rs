use moxcms::{ColorProfile, ToneReprCurve};

/// Display P3 with each kind of curve, and a grey profile.
pub fn all() -> Vec<Vec<u8>> {
    const NUMBERS: [f32; 7] = [2.4, 0.948, 0.052, 0.0774, 0.0405, 0.01, 0.0];
    let parametric = [1, 3, 4, 5, 7].map(|count| ToneReprCurve::Parametric(NUMBERS[..count].to_vec()));
    let sampled = [vec![], vec![0x01CD], (0..64).map(|step| step * 1040).collect()].map(ToneReprCurve::Lut);
    let rgb = parametric.into_iter().chain(sampled).map(|curve| {
        let mut profile = ColorProfile::new_display_p3();
        for channel in [&mut profile.red_trc, &mut profile.green_trc, &mut profile.blue_trc] {
            *channel = Some(curve.clone());
        }
        profile
    });
    let profiles = rgb.chain([ColorProfile::new_gray_with_gamma(2.2)]);
    profiles.map(|profile| profile.encode().expect("invariant: it can be written")).collect()
}
