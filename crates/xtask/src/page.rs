//! Builds `dist/`, the npm package, the documentation site and its pictures.

use crate::need;
use crate::places::{cache, remove_folder, root, target};
use crate::run::{Run, announced, is_program};
use crate::rust;
use crate::setup::{self, Kit};
use anyhow::{Context, Result, ensure};
use std::net::{Ipv4Addr, TcpListener};

/// `cargo xtask dist`.
pub fn dist(_: &[&str]) -> Result<()> {
    let kit = setup::obtain(&need::PAGE)?;
    build(&kit)?;
    print!("{}", kit.npm("size").checked()?);
    println!("dist/ is ready; serve it from any static host.");
    Ok(())
}

/// Builds `dist/`.
pub fn build(kit: &Kit) -> Result<()> {
    announced("page", "the first build takes several minutes", || trunk(kit).arg("build").checked().map(|_| ()))
}

/// Trunk; Trunk.toml selects the profile that the tests use, too.
pub fn trunk(kit: &Kit) -> Run {
    kit.run("trunk").arg("--skip-version-check")
}

/// `cargo xtask serve`: serves the page until interrupted, and rebuilds it when a file changes.
pub fn serve(_: &[&str]) -> Result<()> {
    let kit = setup::obtain(&need::PAGE)?;
    let is_free = |port: &u16| TcpListener::bind((Ipv4Addr::LOCALHOST, *port)).is_ok();
    let port = (8080..8180).find(is_free).context("no free port from 8080 to 8179")?;
    println!("Building the page (the first build takes several minutes). Address: http://127.0.0.1:{port}/");
    println!("Press Ctrl-C to stop.");
    let has_screen = cfg!(target_os = "macos") || std::env::var_os("DISPLAY").is_some() && is_program("xdg-open");
    let serve = trunk(&kit).args(["serve", "--port", &port.to_string(), &format!("--open={has_screen}")]);
    // A separate folder, so that dist/ stays unchanged.
    let status = serve.arg("--dist").arg(target().join("xtask/serve")).command.status()?;
    ensure!(status.success(), "Trunk failed with {status}; see above");
    Ok(())
}

/// `cargo xtask npm`: builds the npm package from the page, and packs it for publishing.
pub fn npm(_: &[&str]) -> Result<()> {
    let kit = setup::obtain(&need::PAGE)?;
    build(&kit)?;
    let folder = target().join("npm");
    remove_folder(&folder)?;
    print!("{}", kit.run("node").arg("web/build/package.mjs").checked()?);
    let pack = kit.run("npm").words("pack --silent --pack-destination").arg(&folder).arg(folder.join("rosto"));
    println!("{} is ready.", folder.join(pack.checked()?.trim()).display());
    Ok(())
}

/// `cargo xtask site`: builds the documentation as a static site into `target/site`.
pub fn site(_: &[&str]) -> Result<()> {
    let built = announced("site", "builds the command line first, for its reference", || {
        build_site(&setup::obtain(&need::PAGE)?)?.checked()
    })?;
    print!("{built}");
    Ok(())
}

/// Program that builds the site.
pub fn build_site(kit: &Kit) -> Result<Run> {
    let node = kit.run("node").arg("docs/site/build.mjs").arg(target().join("site")).log("site");
    Ok(node.env("ROSTO_CLI", rust::command_line()?))
}

/// `cargo xtask screenshots`: renders the documentation's pictures of the page and of models.
pub fn screenshots(_: &[&str]) -> Result<()> {
    let kit = setup::obtain(&need::GATE)?;
    build(&kit)?;
    let draw = kit.npm("pictures").env("ROSTO_CLI", rust::command_line()?);
    print!("{}", announced("pictures", "for the documentation", || draw.checked())?);
    Ok(())
}

/// `cargo xtask reproduce`: builds the page from scratch in another checkout, and compares the results.
pub fn reproduce(_: &[&str]) -> Result<()> {
    let git = |words: &str| Run::new("git").words(words);
    let changes = git("status --porcelain").checked()?;
    ensure!(changes.is_empty(), "commit these changes first; the second build uses the committed files:\n{changes}");
    build(&setup::obtain(&need::PAGE)?)?;
    let other = cache()?.join(format!("another-checkout-{}", std::process::id()));
    git("worktree add --detach").arg(&other).checked()?;
    // Uses the checkout's own target folder.
    let mut again = Run::new("cargo").words("xtask dist").current_dir(&other).log("reproduce");
    again.command.env_remove("CARGO_TARGET_DIR");
    let compared = announced("second build", "from scratch, in another folder", || {
        again.checked()?;
        // Trunk's lock is empty and not published.
        Run::new("diff").words("-r --exclude=.trunk-lock").arg(root().join("dist")).arg(other.join("dist")).checked()
    });
    git("worktree remove --force").arg(&other).checked()?;
    compared.context("two builds of the same sources differ")?;
    println!("Both builds are identical. The name of the folder in dist/ is a hash of its files.");
    Ok(())
}
