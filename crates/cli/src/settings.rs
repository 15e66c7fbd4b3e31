use glam::DVec2;
use rosto_face::{DISTANCES_M, PhotoLens};
use rosto_studio::FALLOFF_BAND_SHARES;
use rosto_warp::Dab;

/// Parses a radius in the units of the edits.
pub fn radius(text: &str) -> Result<f64, String> {
    number(text, |radius| radius > 0.0 && radius.is_finite(), "expected a positive number")
}

/// Parses a camera distance in cm.
pub fn distance(text: &str) -> Result<PhotoLens, String> {
    const CM_PER_M: f64 = 100.0;
    let distance_m = text.parse::<f64>().ok().map(|distance_cm| distance_cm / CM_PER_M);
    let lens = distance_m.and_then(|distance_m| PhotoLens::Distance(distance_m).checked().ok());
    let [least, most] = [DISTANCES_M.start(), DISTANCES_M.end()].map(|metres| CM_PER_M * metres);
    lens.ok_or_else(|| format!("expected a distance from {least} to {most} cm"))
}

/// Parses a viewing distance in cm; returns metres.
pub fn seen_from(text: &str) -> Result<f64, String> {
    match distance(text)? {
        PhotoLens::Distance(distance_m) => Ok(distance_m),
        _ => Err("expected a number of cm".to_owned()),
    }
}

/// Parses the width of the falloff band, as a share of the face's longer side.
pub fn falloff_band(text: &str) -> Result<f64, String> {
    let [least, most] = [FALLOFF_BAND_SHARES.start(), FALLOFF_BAND_SHARES.end()];
    number(
        text,
        |falloff_band| FALLOFF_BAND_SHARES.contains(&falloff_band),
        &format!("expected a share from {least} to {most}"),
    )
}

/// Parses a circle in the photo's pixels.
pub fn dab(text: &str) -> Result<Dab, String> {
    let numbers: Option<Vec<f64>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
    match numbers.as_deref() {
        Some(&[x, y, radius_px]) if radius_px > 0.0 && [x, y, radius_px].iter().all(|number| number.is_finite()) => {
            Ok(Dab { centre_px: DVec2::new(x, y), radius_px })
        }
        _ => Err("expected X,Y,RADIUS in px with a positive radius".to_owned()),
    }
}

/// Parses a focal length in mm.
pub fn focal_length(text: &str) -> Result<PhotoLens, String> {
    let lens = text.parse().ok().and_then(|focal_length_mm| PhotoLens::Given(focal_length_mm).checked().ok());
    lens.ok_or_else(|| "expected a focal length from 5 to 2000 mm".to_owned())
}

/// Parses a share.
pub fn share(text: &str) -> Result<f64, String> {
    number(text, |share| (0.0..=1.0).contains(&share), "expected a share from 0 to 1")
}

fn number(text: &str, is_valid: impl Fn(f64) -> bool, error: &str) -> Result<f64, String> {
    text.parse().ok().filter(|number| is_valid(*number)).ok_or_else(|| error.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn radii_and_shares_outside_their_range_are_refused() {
        assert_eq!((radius("2.5"), share("0.25")), (Ok(2.5), Ok(0.25)));
        assert!(["0", "-5", "nan", "inf", "wide"].iter().all(|text| radius(text).is_err()));
        assert!(["-0.1", "1.1", "nan", "half"].iter().all(|text| share(text).is_err()));
    }

    #[test]
    fn circles_need_a_centre_and_a_positive_radius() {
        let dab_of = |x, y, radius_px| Ok(Dab { centre_px: DVec2::new(x, y), radius_px });
        assert_eq!((dab("10,20,5"), dab("-1.5, 2, 0.5")), (dab_of(10.0, 20.0, 5.0), dab_of(-1.5, 2.0, 0.5)));
        let refused = ["10,20", "10,20,0", "10,20,-5", "1,2,3,4", "nan,2,3", "1,2,inf", "here"];
        assert!(refused.iter().all(|text| dab(text).is_err()));
    }
}
