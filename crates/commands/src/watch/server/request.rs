//! HTTP requests, read with bounds on their size and duration.

use super::response::Response;
use std::io::{self, Read};
use std::net::TcpStream;
use std::time::{Duration, Instant};

/// The largest accepted size of a head in bytes; browsers send some hundreds.
const MOST_HEAD: usize = 16 * 1024;
/// The largest accepted number of headers.
const MOST_HEADERS: usize = 64;
/// The largest accepted size of a body in bytes; a body is an object of numbers.
const MOST_BODY: usize = 64 * 1024;
/// The time within which a request must be complete.
const PATIENCE: Duration = Duration::from_secs(5);

/// The method of a request, as far as the server distinguishes methods.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    Get,
    Post,
    Other,
}

/// A request.
#[derive(Debug)]
pub struct Request {
    pub method: Method,
    /// The path with the query.
    pub target: String,
    pub host: String,
    pub body: Vec<u8>,
}

/// The reason for which there is no request.
#[derive(Debug)]
pub enum Refusal {
    Answered(Response),
    /// The connection is closed, so that no answer is possible.
    Gone,
}

impl From<io::Error> for Refusal {
    fn from(error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut => Refusal::Answered(Response::SLOW),
            _ => Refusal::Gone,
        }
    }
}

impl Request {
    /// Reads a request of bounded size within a bounded time.
    ///
    /// # Errors
    /// The answer that refuses the request, or the end of the connection.
    pub fn read(stream: &TcpStream) -> Result<Self, Refusal> {
        let end = Instant::now() + PATIENCE;
        let mut bytes = Vec::new();
        loop {
            if let Some((mut request, head, length)) = parsed(&bytes)? {
                while bytes.len() < head + length {
                    more(stream, &mut bytes, end)?;
                }
                request.body = bytes[head..head + length].to_vec();
                return Ok(request);
            }
            if bytes.len() > MOST_HEAD {
                return Err(Refusal::Answered(Response::LONG_HEAD));
            }
            more(stream, &mut bytes, end)?;
        }
    }
}

/// Reads the available bytes, at least one.
fn more(mut stream: &TcpStream, bytes: &mut Vec<u8>, end: Instant) -> Result<(), Refusal> {
    let left = end.saturating_duration_since(Instant::now());
    if left.is_zero() {
        return Err(Refusal::Answered(Response::SLOW));
    }
    stream.set_read_timeout(Some(left))?;
    let mut part = [0; 4096];
    match stream.read(&mut part)? {
        0 => Err(Refusal::Gone),
        count => {
            bytes.extend_from_slice(&part[..count]);
            Ok(())
        }
    }
}

/// The request if its head is complete, with the lengths of head and body in bytes.
fn parsed(bytes: &[u8]) -> Result<Option<(Request, usize, usize)>, Refusal> {
    let refused = |response| Err(Refusal::Answered(response));
    let mut headers = [httparse::EMPTY_HEADER; MOST_HEADERS];
    let mut read = httparse::Request::new(&mut headers);
    let head = match read.parse(bytes) {
        Ok(httparse::Status::Complete(head)) => head,
        Ok(httparse::Status::Partial) => return Ok(None),
        Err(httparse::Error::TooManyHeaders) => return refused(Response::LONG_HEAD),
        Err(_) => return refused(Response::bad("this is no request of HTTP/1.1")),
    };
    if head > MOST_HEAD {
        return refused(Response::LONG_HEAD);
    }
    let all = |name: &str| -> Vec<&[u8]> {
        read.headers.iter().filter(|header| header.name.eq_ignore_ascii_case(name)).map(|header| header.value).collect()
    };
    // a body of unstated length (transfer encodings) is not supported
    if !all("transfer-encoding").is_empty() {
        return refused(Response::bad("a body is accepted with its Content-Length"));
    }
    let length = match all("content-length")[..] {
        [] => 0,
        [one] => match std::str::from_utf8(one).ok().and_then(|text| text.trim().parse::<usize>().ok()) {
            Some(length) if length <= MOST_BODY => length,
            Some(_) => return refused(Response::LONG_BODY),
            None => return refused(Response::bad("the Content-Length is no number")),
        },
        _ => return refused(Response::bad("there are several lengths")),
    };
    let host = match all("host")[..] {
        [one] => String::from_utf8_lossy(one).into_owned(),
        // no host, or several contradictory ones
        _ => String::new(),
    };
    let method = match read.method {
        Some("GET") => Method::Get,
        Some("POST") => Method::Post,
        _ => Method::Other,
    };
    let target = read.path.unwrap_or_default().to_owned();
    Ok(Some((Request { method, target, host, body: Vec::new() }, head, length)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn status(head: &str) -> u16 {
        match parsed(head.as_bytes()) {
            Ok(Some(_)) => 200,
            Ok(None) => 100,
            Err(Refusal::Answered(response)) => response.status(),
            Err(Refusal::Gone) => 0,
        }
    }

    #[test]
    fn a_request_is_whole_or_refused() {
        assert_eq!(status("GET / HTTP/1.1\r\nHost: a\r\n\r\n"), 200);
        assert_eq!(status("GET / HTTP/1.1\r\nHost: a\r\n"), 100);
        assert_eq!(status("GET /\0 HTTP/1.1\r\n\r\n"), 400);
        assert_eq!(status("\u{16}\u{3}\u{1}"), 400);
        for length in ["-1", "x", "18446744073709551616", "1\r\nContent-Length: 2"] {
            assert_eq!(status(&format!("POST / HTTP/1.1\r\nContent-Length: {length}\r\n\r\n")), 400, "{length}");
        }
        assert_eq!(status("POST / HTTP/1.1\r\nContent-Length: 99999999\r\n\r\n"), 413);
        assert_eq!(status("POST / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\n"), 400);
        assert_eq!(status(&format!("GET / HTTP/1.1\r\n{}\r\n", "a: b\r\n".repeat(MOST_HEADERS + 1))), 431);
    }

    #[test]
    fn two_hosts_are_none() {
        let head = "GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nHost: a\r\n\r\n";
        let Ok(Some((request, ..))) = parsed(head.as_bytes()) else { panic!("it is whole") };
        assert_eq!(request.host, "");
    }
}
