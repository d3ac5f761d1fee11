//! The server of the page: HTTP on the loopback address, with a thread for each connection. It serves only the addresses of the page.
//!
//! * The first part of each address is a random key. Without the key nothing is found, so that pages of other programs cannot read this page.
//! * The header `Host` must name the loopback address, which prevents access by DNS rebinding.
//! * The sizes of heads and bodies, the times and the number of connections are bounded.

mod request;
mod response;

use super::board::{Board, News};
use super::page::{PageTitle, saved, served};
use super::session::Message;
use request::{Method, Refusal, Request};
use response::Response;
use serde_json::{Map, Value, json};
use std::io::{self, Write};
use std::net::{Ipv4Addr, SocketAddr, TcpListener, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::sync::mpsc::Sender;
use std::thread;
use std::time::Duration;

/// The largest number of simultaneous connections.
const MOST_CONNECTIONS: usize = 64;
/// The interval at which an idle event stream sends a comment, to detect a closed connection.
const PULSE: Duration = Duration::from_secs(10);
/// The time after which a client that reads nothing is disconnected.
const PATIENCE: Duration = Duration::from_secs(20);

/// A server that is bound to its port.
pub struct Server {
    listener: TcpListener,
    site: Site,
}

/// The data that all connections share.
#[derive(Clone)]
struct Site {
    key: Arc<str>,
    port: u16,
    board: Arc<Board>,
    title: PageTitle,
    values: Sender<Message>,
    open: Arc<AtomicUsize>,
}

impl Server {
    /// Binds to a port of the loopback address; port 0 selects a free port.
    ///
    /// # Errors
    /// The port is in use, or the system provides no random numbers for the key.
    pub fn listen(port: u16, board: Arc<Board>, title: PageTitle, values: Sender<Message>) -> io::Result<Self> {
        let listener = TcpListener::bind(SocketAddr::from((Ipv4Addr::LOCALHOST, port)))?;
        let port = listener.local_addr()?.port();
        let site = Site { key: random()?.into(), port, board, title, values, open: Arc::default() };
        Ok(Server { listener, site })
    }

    /// The address of the page.
    pub fn address(&self) -> String {
        format!("http://{}:{}/{}/", Ipv4Addr::LOCALHOST, self.site.port, self.site.key)
    }

    /// Serves the page in separate threads.
    ///
    /// # Errors
    /// No thread can be created.
    pub fn start(self) -> io::Result<()> {
        let Server { listener, site } = self;
        let accept = move || {
            for stream in listener.incoming() {
                // the connection broke before it was accepted
                let Ok(stream) = stream else { continue };
                let site = site.clone();
                let connection = Connection::of(Arc::clone(&site.open));
                let spawned = thread::Builder::new().spawn(move || {
                    // an error means that the reader has closed the connection
                    let _ = connection.map_or_else(|| Response::BUSY.write(&stream), |_open| site.answer(&stream));
                });
                // if no thread can be created, the connection is closed
                drop(spawned);
            }
        };
        thread::Builder::new().name("server".to_owned()).spawn(accept).map(drop)
    }
}

/// An open connection, counted until it is dropped.
struct Connection(Arc<AtomicUsize>);

impl Connection {
    /// Counts a new connection; `None` where the limit is reached.
    fn of(open: Arc<AtomicUsize>) -> Option<Self> {
        let before = open.fetch_add(1, Relaxed);
        let own = Connection(open);
        (before < MOST_CONNECTIONS).then_some(own)
    }
}

impl Drop for Connection {
    fn drop(&mut self) {
        self.0.fetch_sub(1, Relaxed);
    }
}

/// 128 random bits from the system, as hexadecimal digits.
fn random() -> io::Result<String> {
    let mut bytes = [0; 16];
    getrandom::fill(&mut bytes).map_err(|error| io::Error::other(format!("no random numbers: {error}")))?;
    Ok(bytes.iter().map(|byte| format!("{byte:02x}")).collect())
}

impl Site {
    fn answer(&self, stream: &TcpStream) -> io::Result<()> {
        stream.set_write_timeout(Some(PATIENCE))?;
        stream.set_nodelay(true)?;
        let request = match Request::read(stream) {
            Ok(request) => request,
            Err(Refusal::Answered(response)) => return response.close(stream),
            Err(Refusal::Gone) => return Ok(()),
        };
        if !self.is_host(&request.host) {
            return Response::FOREIGN.close(stream);
        }
        let (path, query) = request.target.split_once('?').unwrap_or((&request.target, ""));
        let Some(own) =
            path.strip_prefix('/').and_then(|path| path.split_once('/')).filter(|(key, _)| self.is_key(key))
        else {
            return Response::MISSING.close(stream);
        };
        match (own.1, request.method) {
            ("", Method::Get) => self.page(stream),
            ("page.html", Method::Get) => Response::file(saved(&self.board, &self.title)).write(stream),
            ("events", Method::Get) => self.events(stream, query),
            ("values", Method::Post) => self.take_values(&request).close(stream),
            ("" | "page.html" | "events", _) => Response::not_allowed("GET").close(stream),
            ("values", _) => Response::not_allowed("POST").close(stream),
            _ => Response::MISSING.close(stream),
        }
    }

    /// Whether a host is a name of the loopback address with the port of the server.
    fn is_host(&self, host: &str) -> bool {
        ["127.0.0.1", "localhost"].iter().any(|name| host.eq_ignore_ascii_case(&format!("{name}:{}", self.port)))
    }

    /// Whether a key is that of the page; the comparison takes constant time.
    fn is_key(&self, key: &str) -> bool {
        let letters = key.bytes().zip(self.key.bytes());
        key.len() == self.key.len() && letters.fold(0, |differ, (one, other)| differ | (one ^ other)) == 0
    }

    fn page(&self, stream: &TcpStream) -> io::Result<()> {
        let nonce = random()?;
        Response::page(served(&self.board, &self.title, &nonce)).write(stream)
    }

    /// Sends news to the page as server-sent events, until the page closes or the session ends.
    fn events(&self, mut stream: &TcpStream, query: &str) -> io::Result<()> {
        let since = query.strip_prefix("since=").and_then(|version| version.parse().ok());
        let mut version = since.unwrap_or(0);
        Response::EVENTS.write(stream)?;
        let values = self.board.values();
        if !values.is_empty() {
            write!(stream, "data: {}\n\n", json!({ "parts": [], "values": values }))?;
        }
        loop {
            match self.board.since(version, PULSE) {
                News::Version(now, news) => {
                    write!(stream, "data: {news}\n\n")?;
                    version = now;
                }
                News::None => stream.write_all(b": alive\n\n")?,
                News::End => return stream.write_all(b"event: end\ndata: \n\n"),
            }
        }
    }

    /// Accepts new values of sliders: an object with a number for each id of a slider.
    fn take_values(&self, request: &Request) -> Response {
        let wrong = || Response::bad("an object is accepted that gives ids of sliders their numbers");
        let Ok(values) = serde_json::from_slice::<Map<String, Value>>(&request.body) else { return wrong() };
        if !values.values().all(Value::is_number) {
            return wrong();
        }
        if let Some(why) = self.board.objection(&values) {
            return Response::bad(&why);
        }
        match self.values.send(Message::Values(values)) {
            Ok(()) => Response::TAKEN,
            Err(_) => Response::BUSY,
        }
    }
}
