use super::build::choice;
use super::widget::{ChoiceLook, Control, Widget};
use crate::{Choice, Intent, Session};

impl Session {
    /// A widget for a setting with named values. `id` is also the key of its label.
    pub(super) fn setting(&self, id: &'static str, setting: Choice, look: ChoiceLook) -> Widget {
        self.setting_for(id, setting, look, &[])
    }

    /// The same, with values that only experts see.
    pub(super) fn setting_for(
        &self,
        id: &'static str,
        setting: Choice,
        look: ChoiceLook,
        expert: &'static [&'static str],
    ) -> Widget {
        let (options, chosen) = (setting.values(), self.chosen(setting));
        choice(id, Control::Choice { name: setting.id(), options, expert, chosen, look }, move |id| {
            Intent::choosing(setting, &id)
        })
    }
}
