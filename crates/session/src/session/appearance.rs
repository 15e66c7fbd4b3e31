use rosto_stage::{Glide, Light, NamedView, Scene, ShadingMode};

use super::{Result, Session};
use crate::error::{bounded_factor, within};
use crate::{Changed, Intent, Motion, SessionError, Turntable};

/// Appearance.
impl Session {
    /// Applies intents that change only the appearance.
    pub(super) fn see(&mut self, intent: Intent) -> Result {
        // Stretch is computed with each tick, and only while it is displayed.
        let begins = intent == Intent::Shading(ShadingMode::Distortion);
        let marks_change = matches!(intent, Intent::Before(_) | Intent::Wipe(_) | Intent::MarkAnchors(_));
        let is_photo = self.stage.scene() == Scene::Picture;
        let mut left = Changed::Nothing;
        match intent {
            Intent::Shading(paint) => self.stage.render_settings_mut().shading = paint,
            Intent::Lens(lens) => self.stage.camera_mut().set_lens(lens),
            Intent::Wireframe(wireframe) => self.view.wireframe = wireframe,
            Intent::Background(background) => {
                self.view.background = background;
                self.show_backdrop();
            }
            Intent::Turntable(turntable) => {
                self.view.turntable = turntable;
                if turntable == Turntable::Turns {
                    left = self.leave_photo();
                }
            }
            Intent::Motion(motion) => {
                self.view.motion = motion;
                let glide = if motion == Motion::Reduced { Glide::Off } else { Glide::Smooth };
                self.stage.camera_mut().set_glide(glide);
            }
            Intent::Dots(dots) => self.stage.render_settings_mut().dots = dots,
            Intent::Light(light) => self.stage.render_settings_mut().light = checked(light)?,
            Intent::Theme(theme) => self.stage.render_settings_mut().theme = theme,
            Intent::Before(share) => self.stage.render_settings_mut().before = within("the share", share, 0.0, 1.0)?,
            Intent::Wipe(share) => {
                let share = share.map(|share| within("the share", share, 0.0, 1.0)).transpose()?;
                self.stage.render_settings_mut().wipe = share;
            }
            Intent::PictureLight(light) => self.stage.render_settings_mut().picture_light = light,
            Intent::MarkAnchors(switch) => self.view.anchors = switch,
            Intent::Orbit(by_px) if by_px.is_finite() && !is_photo => self.stage.camera_mut().orbit(by_px.x, by_px.y),
            Intent::Orbit(by_px) | Intent::Pan(by_px) if by_px.is_finite() => {
                self.stage.camera_mut().pan(by_px.x, by_px.y);
            }
            Intent::ZoomAt(factor, at_px) if is_photo && at_px.is_finite() => {
                let factor = bounded_factor(factor)?;
                self.stage.camera_mut().zoom_at(factor, at_px);
            }
            Intent::Zoom(factor) | Intent::ZoomAt(factor, _) => {
                let factor = bounded_factor(factor)?;
                self.stage.camera_mut().zoom(factor);
            }
            Intent::Backdrop(backdrop) => {
                self.view.backdrop = backdrop;
                self.show_backdrop();
            }
            Intent::GoTo(view) => {
                if view != NamedView::Reset {
                    left = self.leave_photo();
                }
                self.stage.camera_mut().look(view);
            }
            Intent::Resize([width, height], pixel_ratio) => {
                let pixel_ratio = within("px for each CSS px", pixel_ratio, 1e-3, 1e3)?;
                self.stage.camera_mut().resize(width.max(1), height.max(1));
                self.stage.set_pixel_ratio(pixel_ratio);
            }
            Intent::ViewportInsets(insets_px) => self.stage.set_viewport_insets(insets_px),
            _ => {}
        }
        self.view.show_on(&mut self.stage, self.face.is_none());
        if marks_change {
            self.show_marks();
        }
        Ok(left.max(if begins { Changed::Tick } else { Changed::View }))
    }
}

pub(super) fn checked(light: Light) -> Result<Light, SessionError> {
    within("the light's azimuth in degrees", light.azimuth_deg, -360.0, 360.0)?;
    within("the light's elevation in degrees", light.elevation_deg, -90.0, 90.0)?;
    within("the light's strength", light.strength, 0.0, 10.0)?;
    within("the ambient light's strength", light.ambient, 0.0, 10.0)?;
    Ok(light)
}
