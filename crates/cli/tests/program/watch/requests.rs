//! Requests that the server answers or refuses, and the end of the server.

use super::{PENDULUM, Watched, answer, is_own_processor};
use crate::run;
use std::io::Write;

#[test]
fn nothing_is_found_without_the_key_and_nothing_but_the_page_with_it() {
    if !is_own_processor() {
        return;
    }
    let watched = Watched::of("swing.toml", PENDULUM);
    let (status, page) = watched.get("");
    assert!(status == 200 && page.contains("Content-Security-Policy") && page.contains("<script nonce="), "{page}");
    let host = format!("Host: 127.0.0.1:{}\r\n", watched.port);
    let root = &watched.root;
    let wrong = root.replace(['0', '1'], "f");
    for path in ["/", "/favicon.ico", "", "*", &wrong, &root[..root.len() - 1], "//", "http://127.0.0.1/"] {
        let (status, whole) = watched.ask(&format!("GET {path} HTTP/1.1\r\n{host}"), "");
        assert!(matches!(status, 400 | 404), "{path}: {status}");
        assert!(!whole.contains("pendulum"), "{path}: {whole}");
    }
    for path in ["swing.toml", "../swing.toml", "%2e%2e/", "events/", "page.htm"] {
        assert_eq!(watched.get(path).0, 404, "{path}");
    }
    for (method, path) in [("POST", ""), ("PUT", "values"), ("GET", "values"), ("POST", "events"), ("OPTIONS", "")] {
        assert_eq!(watched.ask(&watched.head(method, path), "").0, 405, "{method} {path}");
    }
    assert!(watched.get("page.html").1.contains("Content-Disposition: attachment"));
}

#[test]
fn a_page_of_another_host_is_refused() {
    if !is_own_processor() {
        return;
    }
    let watched = Watched::of("swing.toml", PENDULUM);
    let port = watched.port;
    let line = format!("GET {} HTTP/1.1\r\n", watched.root);
    for host in ["evil.example", "evil.example:80", "127.0.0.1", "127.0.0.1:1", "127.0.0.1.evil.example:80", ""] {
        let (status, whole) = watched.ask(&format!("{line}Host: {host}\r\n"), "");
        assert!(status == 421 && !whole.contains("pendulum"), "{host}: {whole}");
    }
    assert_eq!(watched.ask(&line, "").0, 421);
    assert_eq!(watched.ask(&format!("{line}Host: localhost:{port}\r\n"), "").0, 200);
}

#[test]
fn what_is_too_long_or_no_request_is_refused_and_the_page_goes_on() {
    if !is_own_processor() {
        return;
    }
    let watched = Watched::of("swing.toml", PENDULUM);
    let huge = format!("{}X: {}\r\n", watched.head("GET", ""), "x".repeat(100_000));
    assert_eq!(watched.ask(&huge, "").0, 431);
    let many = watched.head("GET", "") + &"a: b\r\n".repeat(100);
    assert_eq!(watched.ask(&many, "").0, 431);
    assert_eq!(watched.ask(&watched.head("POST", "values"), &"1".repeat(100_000)).0, 413);
    for body in ["", "[]", "{", "{\"parameters.m\": \"1\"}", "{\"parameters.m\": null}", "\u{0}"] {
        assert_eq!(watched.ask(&watched.head("POST", "values"), body).0, 400, "{body:?}");
    }
    let mut stream = watched.connected();
    stream.write_all(&[0x16, 3, 1, 2, 0, 1, 0, 1, 0xfc, 3, 3, 0xff]).expect("it is read");
    assert_eq!(answer(stream).0, 400);
    assert_eq!(watched.get("").0, 200);
}

#[test]
fn a_file_or_a_port_that_cannot_be_had_is_refused() {
    let missing = run(&["watch", "nowhere.toml"]);
    assert_eq!(missing.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&missing.stderr).contains("nowhere.toml: there is no such file"), "{missing:?}");
    #[cfg(unix)]
    assert_eq!(run(&["watch", "/dev/null"]).status.code(), Some(2));
    let taken = std::net::TcpListener::bind("127.0.0.1:0").expect("a port is free");
    let port = taken.local_addr().expect("it has an address").port().to_string();
    let refused = run(&["watch", "scenes/models/double_pendulum.toml", "--port", &port]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&refused.stderr).contains(&format!("--port {port}: ")), "{refused:?}");
    for wrong in ["0", "65536", "x"] {
        assert_eq!(run(&["watch", "a.toml", "--port", wrong]).status.code(), Some(2), "{wrong}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn ctrl_c_ends_the_program_and_its_pages_are_told() {
    if !is_own_processor() {
        return;
    }
    let mut watched = Watched::of("swing.toml", PENDULUM);
    let mut events = watched.events();
    events.until("the system is read", |page| page.is("heading", "current"));
    let sent = std::process::Command::new("kill").args(["-INT", &watched.child.id().to_string()]).status();
    assert!(sent.is_ok_and(|sent| sent.success()), "it was not running any more");
    while events.next().is_some() {}
    assert_eq!(watched.child.wait().expect("it ends").code(), Some(130));
}
