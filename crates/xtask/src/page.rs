//! What is built of the page: `dist/`, the npm package, the site beside it, and the documentation's pictures.

use crate::places::{cache, remove_folder, root, target};
use crate::run::{Run, announced, is_program};
use crate::rust;
use crate::setup::{self, Kit};
use anyhow::{Context, Result, ensure};
use std::net::{Ipv4Addr, TcpListener};

/// `cargo xtask dist`.
pub fn dist(_: &[&str]) -> Result<()> {
    let kit = setup::for_page()?;
    build(&kit)?;
    print!("{}", kit.npm("size").checked()?);
    println!("dist/ is ready; serve it from any static host.");
    Ok(())
}

/// Builds `dist/`.
pub fn build(kit: &Kit) -> Result<()> {
    announced("page", "the first time takes some minutes", || trunk(kit).arg("build").checked().map(|_| ()))
}

/// Trunk, in the profile in which the tests are built, too.
pub fn trunk(kit: &Kit) -> Run {
    kit.run("trunk").arg("--skip-version-check")
}

/// `cargo xtask serve`: serves the page until it is interrupted, and builds it again when a file changes.
pub fn serve(_: &[&str]) -> Result<()> {
    let kit = setup::for_page()?;
    let is_free = |port: &u16| TcpListener::bind((Ipv4Addr::LOCALHOST, *port)).is_ok();
    let port = (8080..8180).find(is_free).context("no port from 8080 to 8179 is free: end what listens there")?;
    println!("Building the page, which takes some minutes the first time; then it is at http://127.0.0.1:{port}/");
    println!("Ctrl-C ends it.");
    let has_screen = cfg!(target_os = "macos") || std::env::var_os("DISPLAY").is_some() && is_program("xdg-open");
    let serve = trunk(&kit).args(["serve", "--port", &port.to_string(), &format!("--open={has_screen}")]);
    // A folder of its own: the page built for the web stays as it is.
    let status = serve.arg("--dist").arg(target().join("xtask/serve")).command.status()?;
    ensure!(status.success(), "Trunk ended with {status}: see what it says above");
    Ok(())
}

/// `cargo xtask npm`: builds the npm package out of the page and packs it as it would be published.
pub fn npm(_: &[&str]) -> Result<()> {
    let kit = setup::for_page()?;
    build(&kit)?;
    let folder = target().join("npm");
    remove_folder(&folder)?;
    print!("{}", kit.run("node").arg("web/package/build.mjs").checked()?);
    let pack = kit.run("npm").words("pack --silent --pack-destination").arg(&folder).arg(folder.join("rosto"));
    println!("{} is ready.", folder.join(pack.checked()?.trim()).display());
    Ok(())
}

/// `cargo xtask site`: builds the documentation as a static site into `target/site`.
pub fn site(_: &[&str]) -> Result<()> {
    let built = announced("site", "the command line is built first: it describes itself", || {
        build_site(&setup::for_page()?)?.checked()
    })?;
    print!("{built}");
    Ok(())
}

/// The program that builds the site.
pub fn build_site(kit: &Kit) -> Result<Run> {
    let node = kit.run("node").arg("docs/site/build.mjs").arg(target().join("site")).log("site");
    Ok(node.env("ROSTO_CLI", rust::command_line()?))
}

/// `cargo xtask screenshots`: draws the documentation's pictures of the page and of models.
pub fn screenshots(_: &[&str]) -> Result<()> {
    let kit = setup::for_tests()?;
    build(&kit)?;
    let draw = kit.npm("pictures").env("ROSTO_CLI", rust::command_line()?);
    print!("{}", announced("pictures", "of the page and of models", || draw.checked())?);
    Ok(())
}

/// `cargo xtask reproduce`: builds the page once more, in a checkout of its own and from nothing, and compares the two.
pub fn reproduce(_: &[&str]) -> Result<()> {
    let git = |words: &str| Run::new("git").words(words);
    let changes = git("status --porcelain").checked()?;
    ensure!(changes.is_empty(), "commit these first, since the other checkout has what git has:\n{changes}");
    build(&setup::for_page()?)?;
    let other = cache()?.join(format!("another-checkout-{}", std::process::id()));
    git("worktree add --detach").arg(&other).checked()?;
    // A build folder of its own, and cargo's toolchain found anew.
    let mut again = Run::new("cargo").words("xtask dist").current_dir(&other).log("reproduce");
    again.command.env_remove("CARGO_TARGET_DIR");
    let compared = announced("page again", "from nothing, in another folder", || {
        again.checked()?;
        // Trunk's lock is empty and never published.
        Run::new("diff").words("-r --exclude=.trunk-lock").arg(root().join("dist")).arg(other.join("dist")).checked()
    });
    git("worktree remove --force").arg(&other).checked()?;
    compared.context("two builds of the same sources differ")?;
    println!("Both are the same, byte for byte; dist/integrity.json has the SHA-256 of every file.");
    Ok(())
}
