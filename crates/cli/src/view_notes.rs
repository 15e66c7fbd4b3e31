//! Messages about several photos of one face.

use std::path::PathBuf;

use rosto_face::{FaceModel, LeftOut, Turn, View};

use crate::error::CliError;
use crate::terminal;

/// Reports the lead photo, the head's angle in each photo, the prediction errors and missing angles. Does nothing
/// for a single photo.
pub fn report(face: &FaceModel, photos: &[PathBuf]) -> Result<(), CliError> {
    let views = face.views();
    if views.len() == 1 {
        return Ok(());
    }
    let left_out = face.left_out().map_err(|reason| CliError::NoModel { path: photos[0].clone(), reason })?;
    for (index, view) in views.iter().enumerate() {
        let named = photos[view.photo].display();
        let leads = if index == 0 { " and leads" } else { "" };
        let prediction = left_out.iter().find(|of| of.photo == view.photo).map_or(String::new(), prediction_note);
        terminal::note(&format!("{named}: {}{leads}{}{prediction}", turned(view), agrees(index, view)));
    }
    let missing = Turn::missing(views.iter().map(|view| view.camera.pose()));
    missing.into_iter().for_each(|turn| terminal::note(missing_angle(turn)));
    Ok(())
}

fn turned(view: &View) -> String {
    let yaw_deg = view.camera.pose().yaw_deg;
    match yaw_deg.abs() {
        ..0.5 => "looks at the camera".to_owned(),
        by_deg => format!("turned by {by_deg:.0}° to its {}", if yaw_deg > 0.0 { "left" } else { "right" }),
    }
}

/// The mesh matches the lead photo by construction.
fn agrees(index: usize, view: &View) -> String {
    if index == 0 { String::new() } else { format!(", agrees within {:.1} px", view.reprojection.rms_px) }
}

fn prediction_note(of: &LeftOut) -> String {
    let [one, others] = [of.by_one, of.by_others].map(|by| by.rms_px);
    format!("; prediction error {one:.1} px from one other photo, {others:.1} px from all others")
}

fn missing_angle(turn: Turn) -> &'static str {
    match turn {
        Turn::Front => "none of the photos shows the face looking at the camera",
        Turn::Left => "a photo of the face turned to its left by 20 to 60° would improve the depth",
        Turn::Right => "a photo of the face turned to its right by 20 to 60° would improve the depth",
    }
}
