//! `cargo xtask npm`: the npm package, made of the built page.

use crate::failure::Result;
use crate::{cache, dist, setup, workspace};
use std::process::ExitCode;
use std::time::Duration;

const LIMIT: Duration = Duration::from_secs(300);

/// Builds the page, puts the package together, and packs it as it would be published.
pub fn run() -> Result<ExitCode> {
    let kit = setup::for_page()?;
    println!("Building the page for the web; the first time takes some minutes.");
    dist::build(&kit)?;
    let folder = workspace::target().join("npm");
    cache::remove_folder(&folder)?;
    println!("{}", kit.run("node")?.arg("web/package/build.mjs").within(LIMIT).run()?.checked()?.trim());
    let pack = kit.run("npm")?.args(["pack", "--silent", "--pack-destination"]).arg(&folder).arg(folder.join("rosto"));
    println!("{} is ready.", folder.join(pack.within(LIMIT).run()?.checked()?.trim()).display());
    Ok(ExitCode::SUCCESS)
}
