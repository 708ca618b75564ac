//! Recordings and tables behind HTTP and the protocol of S3, on a server of this machine.
#![cfg(feature = "cloud")]

use std::io::{BufRead, BufReader, Write};
use std::net::{TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

const MODIFIED: &str = "Mon, 02 Nov 2026 08:00:00 GMT";

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// A folder behind HTTP: objects whole or in ranges, lists as WebDAV and as S3 give them. The
/// bucket of S3 is `bucket`.
struct Server {
    port: u16,
    /// Objects that were sent.
    sent: Arc<AtomicUsize>,
}

impl Server {
    fn start(folder: &Path) -> Self {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let (port, sent) = (listener.local_addr().unwrap().port(), Arc::new(AtomicUsize::new(0)));
        let (folder, counted) = (folder.to_path_buf(), Arc::clone(&sent));
        std::thread::spawn(move || {
            for stream in listener.incoming().flatten() {
                let (folder, counted) = (folder.clone(), Arc::clone(&counted));
                std::thread::spawn(move || answer(stream, &folder, &counted));
            }
        });
        Self { port, sent }
    }
}

/// One request of a connection, which ends with it.
fn answer(mut stream: TcpStream, folder: &Path, sent: &AtomicUsize) -> Option<()> {
    let mut lines = BufReader::new(stream.try_clone().ok()?).lines();
    let request = lines.next()?.ok()?;
    let headers: Vec<String> = lines.map_while(Result::ok).take_while(|line| !line.is_empty()).collect();
    let header = |name: &str| {
        let own = |line: &&String| line.to_ascii_lowercase().starts_with(&format!("{name}:"));
        headers.iter().find(own).and_then(|line| line.split_once(':')).map(|(_, value)| value.trim().to_string())
    };
    let mut words = request.split_whitespace();
    let (method, target) = (words.next()?, words.next()?);
    let (path, query) = target.split_once('?').unwrap_or((target, ""));
    let path = path.trim_start_matches('/').trim_start_matches("bucket").trim_start_matches('/');
    let mut head = |status: &str, length: usize, more: &str| {
        let text = format!(
            "HTTP/1.1 {status}\r\nContent-Length: {length}\r\nLast-Modified: {MODIFIED}\r\nETag: \"1\"\r\n{more}Connection: \
             close\r\n\r\n"
        );
        stream.write_all(text.as_bytes()).ok()
    };
    if method == "PROPFIND" || query.contains("list-type") {
        let prefix = query.split('&').find_map(|part| part.strip_prefix("prefix="));
        let prefix = prefix.map_or_else(|| path.to_string(), |prefix| prefix.replace("%2F", "/"));
        let list = list(folder, prefix.trim_end_matches('/'), method == "PROPFIND");
        head("200 OK", list.len(), "Content-Type: application/xml\r\n")?;
        return stream.write_all(list.as_bytes()).ok();
    }
    let Ok(bytes) = std::fs::read(folder.join(path)) else { return head("404 Not Found", 0, "") };
    let range = header("range").and_then(|range| {
        let (from, to) = range.strip_prefix("bytes=")?.split_once('-')?;
        match (from.parse::<usize>().ok(), to.parse::<usize>().ok()) {
            (None, Some(last)) => Some(bytes.len().saturating_sub(last)..bytes.len()),
            (Some(from), to) => Some(from..to.map_or(bytes.len(), |to| (to + 1).min(bytes.len()))),
            (None, None) => None,
        }
    });
    let (status, part, more) = match range {
        Some(range) => {
            let more = format!("Content-Range: bytes {}-{}/{}\r\n", range.start, range.end - 1, bytes.len());
            ("206 Partial Content", &bytes[range], more)
        }
        None => ("200 OK", &bytes[..], String::new()),
    };
    head(status, part.len(), &more)?;
    if method == "GET" {
        sent.fetch_add(1, Ordering::SeqCst);
        stream.write_all(part).ok()?;
    }
    Some(())
}

/// The files below a prefix.
fn list(folder: &Path, prefix: &str, webdav: bool) -> String {
    let below = folder.join(prefix);
    let files = std::fs::read_dir(below).into_iter().flatten().flatten().filter(|entry| entry.path().is_file());
    let mut all = String::new();
    for file in files {
        let (name, size) = (file.file_name().to_string_lossy().into_owned(), file.metadata().unwrap().len());
        all += &match webdav {
            true => format!(
                "<response><href>/{prefix}/{name}</href><propstat><status>HTTP/1.1 200 OK</status><prop><getlastmodified>{MODIFIED}\
                 </getlastmodified><getcontentlength>{size}</getcontentlength><resourcetype/></prop></propstat></response>"
            ),
            false => format!(
                "<Contents><Key>{prefix}/{name}</Key><Size>{size}</Size><LastModified>2026-11-02T08:00:00.000Z</LastModified>\
                 <ETag>\"1\"</ETag></Contents>"
            ),
        };
    }
    let name = if webdav { "multistatus" } else { "ListBucketResult" };
    format!("<?xml version=\"1.0\"?><{name}>{all}</{name}>")
}

/// The command with the credentials of a store that asks for none.
fn fleet(port: u16, words: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_denavit-fleet"));
    command.args(words).env("AWS_ENDPOINT", format!("http://127.0.0.1:{port}")).env("AWS_ALLOW_HTTP", "true");
    command.env("AWS_ACCESS_KEY_ID", "none").env("AWS_SECRET_ACCESS_KEY", "none").env("AWS_REGION", "here");
    let done = command.output().unwrap();
    println!("{words:?}\n{}{}", String::from_utf8_lossy(&done.stdout), String::from_utf8_lossy(&done.stderr));
    done
}

/// Recordings below `logs/` of a folder: two, and one that is cut.
fn logs() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("logs")).unwrap();
    for name in ["chirp_j2.csv.gz", "chirp_j6.csv.gz"] {
        std::fs::copy(root().join("data/kuka-iiwa14").join(name), folder.path().join("logs").join(name)).unwrap();
    }
    let whole = std::fs::read(folder.path().join("logs/chirp_j2.csv.gz")).unwrap();
    std::fs::write(folder.path().join("logs/cut.csv.gz"), &whole[..whole.len() / 2]).unwrap();
    folder
}

/// The factor of all, as the command prints it.
fn merged(port: u16, table: &str) -> String {
    let query = "SELECT encode(merge_factor(sha256, factor), 'hex') AS f, count(*) FROM factors";
    let done = fleet(port, &["sql", query, "--factors", table]);
    assert!(done.status.success());
    String::from_utf8(done.stdout).unwrap()
}

#[test]
fn stores_give_the_rows_of_a_folder() {
    let (folder, robot) = (logs(), root().join("robots/kuka-iiwa14.yaml").display().to_string());
    let server = Server::start(folder.path());
    let file = format!("file://{}/logs/", folder.path().display());
    let http = format!("http://127.0.0.1:{}/logs/", server.port);
    let tables: Vec<PathBuf> = ["file", "http", "s3"].iter().map(|name| folder.path().join(name)).collect();
    for (url, table) in [&file, &http, "s3://bucket/logs/"].into_iter().zip(&tables) {
        let table = table.display().to_string();
        let words = ["factor", url, "--robot", &robot, "--out", &table, "--threads", "2"];
        let done = fleet(server.port, &words);
        assert!(done.status.success());
        assert!(String::from_utf8_lossy(&done.stderr).contains("cut.csv.gz: no factor"), "the cut one is a row");
        // Again: nothing is missing, and nothing is fetched.
        let before = server.sent.load(Ordering::SeqCst);
        let again = fleet(server.port, &words);
        assert!(String::from_utf8_lossy(&again.stdout).starts_with("0 of 3 recordings"));
        assert_eq!(server.sent.load(Ordering::SeqCst), before);
    }
    let all: Vec<String> = tables.iter().map(|table| merged(server.port, &table.display().to_string())).collect();
    assert_eq!(all[0], all[1]);
    assert_eq!(all[0], all[2]);
    // The table itself can be in a store; so can a recording that is diagnosed.
    for table in [format!("http://127.0.0.1:{}/s3/", server.port), "s3://bucket/s3/".into()] {
        assert_eq!(merged(server.port, &table), all[0]);
    }
    let query = format!("SELECT diagnose('{http}cut.csv.gz', '{robot}') AS verdict");
    let done = fleet(server.port, &["sql", &query]);
    assert!(String::from_utf8_lossy(&done.stdout).contains("no diagnosis: "));
}

#[test]
fn a_store_that_is_not_there_is_said() {
    let robot = root().join("robots/kuka-iiwa14.yaml").display().to_string();
    let out = tempfile::tempdir().unwrap();
    let out = out.path().display().to_string();
    let done = fleet(9, &["factor", "gopher://old/logs/", "--robot", &robot, "--out", &out]);
    let said = String::from_utf8_lossy(&done.stderr).into_owned();
    assert!(said.contains("no store is known for gopher://; s3, http, https and file are"), "{said}");
    assert_eq!(done.status.code(), Some(2));
}
