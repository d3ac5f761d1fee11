//! HTTP responses, with headers that keep other sites from reading the page.

use std::borrow::Cow;
use std::io::{self, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::time::Duration;

/// A response, after which the connection is closed.
#[derive(Clone, Debug)]
pub struct Response {
    status: &'static str,
    kind: &'static str,
    /// Further headers, each with its line end.
    extra: &'static str,
    /// The body; `None` for an event stream that lasts as long as the connection.
    body: Option<Cow<'static, str>>,
}

const TEXT: &str = "text/plain; charset=utf-8";
const HTML: &str = "text/html; charset=utf-8";

/// Headers of every response: no caching, no guessing of types, no framing, no access from other sites.
const HEADERS: &str = "Cache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\nReferrer-Policy: no-referrer\r\n\
    Cross-Origin-Resource-Policy: same-origin\r\nCross-Origin-Opener-Policy: same-origin\r\nX-Frame-Options: DENY\r\nConnection: close\r\n";

impl Response {
    pub const MISSING: Response = Response::fixed("404 Not Found", "there is nothing here\n");
    pub const FOREIGN: Response = Response::fixed("421 Misdirected Request", "this address is not served\n");
    pub const SLOW: Response = Response::fixed("408 Request Timeout", "the request did not come\n");
    pub const BUSY: Response = Response::fixed("503 Service Unavailable", "too many connections\n");
    pub const LONG_HEAD: Response =
        Response::fixed("431 Request Header Fields Too Large", "a head of 16 KiB and 64 lines is accepted\n");
    pub const LONG_BODY: Response = Response::fixed("413 Content Too Large", "a body of 64 KiB is accepted\n");
    pub const TAKEN: Response = Response::fixed("200 OK", "taken\n");
    pub const EVENTS: Response = Response { status: "200 OK", kind: "text/event-stream", extra: "", body: None };

    const fn fixed(status: &'static str, body: &'static str) -> Self {
        Response { status, kind: TEXT, extra: "", body: Some(Cow::Borrowed(body)) }
    }

    /// A response to a faulty request, with the reason.
    pub fn bad(why: &str) -> Self {
        Response { body: Some(Cow::Owned(format!("{why}\n"))), ..Response::fixed("400 Bad Request", "") }
    }

    /// A response to a request with the wrong method for its address.
    pub fn not_allowed(accepted: &'static str) -> Self {
        let extra = if accepted == "GET" { "Allow: GET\r\n" } else { "Allow: POST\r\n" };
        Response { extra, ..Response::fixed("405 Method Not Allowed", "this is asked in another way\n") }
    }

    pub fn page(html: String) -> Self {
        Response { status: "200 OK", kind: HTML, extra: "", body: Some(Cow::Owned(html)) }
    }

    /// A page that the browser saves as a file.
    pub fn file(html: String) -> Self {
        Response { extra: "Content-Disposition: attachment; filename=\"page.html\"\r\n", ..Response::page(html) }
    }

    #[cfg(test)]
    pub fn status(&self) -> u16 {
        self.status.split(' ').next().and_then(|number| number.parse().ok()).unwrap_or(0)
    }

    /// Writes the response.
    ///
    /// # Errors
    /// The connection is closed.
    pub fn write(&self, mut stream: &TcpStream) -> io::Result<()> {
        let Response { status, kind, extra, body } = self;
        let length = body.as_ref().map_or_else(String::new, |body| format!("Content-Length: {}\r\n", body.len()));
        let head = format!("HTTP/1.1 {status}\r\nContent-Type: {kind}\r\n{length}{HEADERS}{extra}\r\n");
        stream.write_all(head.as_bytes())?;
        stream.write_all(body.as_deref().unwrap_or_default().as_bytes())?;
        stream.flush()
    }

    /// Writes the response to a client whose request may be incomplete. Further bytes are read and discarded for a short time, since closing a
    /// connection with unread bytes may discard the response.
    ///
    /// # Errors
    /// The connection is closed.
    pub fn close(&self, mut stream: &TcpStream) -> io::Result<()> {
        const MOMENT: Duration = Duration::from_millis(300);
        const MOST_DROPPED: usize = 64;
        self.write(stream)?;
        stream.shutdown(Shutdown::Write)?;
        stream.set_read_timeout(Some(MOMENT))?;
        let mut dropped = [0; 4096];
        for _ in 0..MOST_DROPPED {
            if stream.read(&mut dropped)? == 0 {
                break;
            }
        }
        Ok(())
    }
}
