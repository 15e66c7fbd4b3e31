//! Serves the page from source, rebuilding when a file changes.

use crate::failure::{Failure, Result};
use crate::process::find_program;
use crate::{progress, setup, workspace};
use std::net::{Ipv4Addr, SocketAddrV4, TcpListener, TcpStream};
use std::process::ExitCode;
use std::time::Duration;

const FIRST_PORT: u16 = 8080;
const PORTS_TRIED: u16 = 100;
const POLL: Duration = Duration::from_millis(300);

/// Runs until it is interrupted.
pub fn run() -> Result<ExitCode> {
    let kit = setup::for_page()?;
    let port = free_port()?;
    if port != FIRST_PORT {
        progress::note(&format!("port {FIRST_PORT} is taken"));
    }
    // Its own folder, so that a page built for the web in dist/ stays as it is.
    let folder = workspace::target().join("xtask").join("serve");
    // Whatever would write scripts into the page is off: the page's own policy forbids them.
    // The profile that `dist` and the tests build with, too: whoever has run one of the three waits less for the others.
    let trunk = kit.run("trunk")?.args(["serve", "--release", "--no-autoreload=true", "--no-error-reporting=true"]);
    let trunk =
        trunk.args(["--disable-csp=true", "--disable-address-lookup=true", "--watch", "web", "--watch", "crates"]);
    let trunk = trunk.args(["--address", "127.0.0.1", "--port", &port.to_string(), "--dist"]);
    println!("Building the page; the first time takes some minutes.");
    let mut server = trunk.arg(&folder).env("TRUNK_SKIP_VERSION_CHECK", "true").spawn()?;
    let address = format!("http://127.0.0.1:{port}/");
    let ended = loop {
        if let Ok(Some(status)) = server.try_wait() {
            break status;
        }
        if answers(port) {
            println!("\nRosto is at {address} (Ctrl-C ends it)");
            open(&address);
            break server.wait().map_err(|error| Failure::new(format!("waiting for the server: {error}")))?;
        }
        std::thread::sleep(POLL);
    };
    if ended.success() {
        return Ok(ExitCode::SUCCESS);
    }
    Err(Failure::new(format!("the server ended with {ended}")).advice("see what Trunk says above"))
}

fn free_port() -> Result<u16> {
    let free = |port: &u16| TcpListener::bind(SocketAddrV4::new(Ipv4Addr::LOCALHOST, *port)).is_ok();
    let mut ports = FIRST_PORT..FIRST_PORT + PORTS_TRIED;
    ports.find(free).ok_or_else(|| {
        let last = FIRST_PORT + PORTS_TRIED - 1;
        Failure::new(format!("no port from {FIRST_PORT} to {last} is free on 127.0.0.1"))
    })
}

fn answers(port: u16) -> bool {
    TcpStream::connect_timeout(&SocketAddrV4::new(Ipv4Addr::LOCALHOST, port).into(), POLL).is_ok()
}

/// Opens a browser where there is a desktop to show it on; the address is printed either way.
fn open(address: &str) {
    let desktop = ["DISPLAY", "WAYLAND_DISPLAY"].iter().any(|name| std::env::var_os(name).is_some());
    let opener = match std::env::consts::OS {
        "macos" => "open",
        "linux" if desktop => "xdg-open",
        _ => return,
    };
    if find_program(opener).is_some() {
        // The page is served whether or not a browser shows up.
        let _ = crate::process::Run::new(opener).arg(address).within(Duration::from_secs(10)).quietly();
    }
}
