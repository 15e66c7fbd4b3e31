//! What is said of several photos of one face.

use std::path::PathBuf;

use rosto_face::{FaceModel, LeftOut, Turn, View};

use crate::error::CliError;
use crate::terminal;

/// Says which photo leads, how the face is turned in each, how well the others foresee it, and which turn none shows; nothing of
/// a single photo.
pub fn tell(face: &FaceModel, photos: &[PathBuf]) -> Result<(), CliError> {
    let views = face.views();
    if views.len() == 1 {
        return Ok(());
    }
    let left_out = face.left_out().map_err(|reason| CliError::NoModel { path: photos[0].clone(), reason })?;
    for (index, view) in views.iter().enumerate() {
        let named = photos[view.photo].display();
        let leads = if index == 0 { " and leads" } else { "" };
        let seen = left_out.iter().find(|of| of.photo == view.photo).map_or(String::new(), foreseen);
        terminal::note(&format!("{named}: {}{leads}{}{seen}", turned(view), agrees(index, view)));
    }
    let missing = Turn::missing(views.iter().map(|view| view.camera.pose()));
    missing.into_iter().for_each(|turn| terminal::note(missed(turn)));
    Ok(())
}

fn turned(view: &View) -> String {
    let yaw_deg = view.camera.pose().yaw_deg;
    match yaw_deg.abs() {
        ..0.5 => "looks at the camera".to_owned(),
        by_deg => format!("turned by {by_deg:.0}° to its {}", if yaw_deg > 0.0 { "left" } else { "right" }),
    }
}

/// The one that leads has the mesh on it.
fn agrees(index: usize, view: &View) -> String {
    if index == 0 { String::new() } else { format!(", agrees within {:.1} px", view.reprojection.rms_px) }
}

fn foreseen(of: &LeftOut) -> String {
    let [one, others] = [of.by_one, of.by_others].map(|by| by.rms_px);
    format!("; left out, it is foreseen within {one:.1} px by one other and {others:.1} px by all others")
}

fn missed(turn: Turn) -> &'static str {
    match turn {
        Turn::Front => "none of the photos shows the face looking at the camera",
        Turn::Left => "a photo of the face turned to its left by 20 to 60° would make the mesh truer",
        Turn::Right => "a photo of the face turned to its right by 20 to 60° would make the mesh truer",
    }
}
