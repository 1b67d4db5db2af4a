//! A driver that plays an editor over a connection in memory.

use hysteron_lsp::{Settings, serve};
use lsp_server::{Connection, Message, Notification, Request, RequestId};
use serde_json::{Value as Json, json};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Time after which an answer is missed.
const PATIENCE: Duration = Duration::from_secs(60);

/// An editor with a server.
pub struct Editor {
    client: Connection,
    server: Option<JoinHandle<Result<(), String>>>,
    last: i32,
    /// Diagnostics that have come, by address, with the version of the text.
    told: Vec<(String, i64, Vec<Json>)>,
    /// Folder of its own, removed at the end.
    pub folder: PathBuf,
    pub capabilities: Json,
}

impl Editor {
    pub fn new() -> Self {
        Self::with(json!({}))
    }

    pub fn with(options: Json) -> Self {
        static COUNT: AtomicUsize = AtomicUsize::new(0);
        let n = COUNT.fetch_add(1, Ordering::Relaxed);
        let folder = std::env::temp_dir().join(format!("hysteron-lsp-{}-{n}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let folder = folder.canonicalize().unwrap();
        let (server, client) = Connection::memory();
        let server = std::thread::spawn(move || serve(server, Settings::default()));
        let mut editor = Self { client, server: Some(server), last: 0, told: vec![], folder, capabilities: Json::Null };
        let answer = editor.request("initialize", json!({ "capabilities": {}, "initializationOptions": options }));
        editor.capabilities = answer["capabilities"].clone();
        editor.notify("initialized", json!({}));
        editor
    }

    /// Put a file on the disk.
    pub fn write(&self, name: &str, text: &str) {
        std::fs::write(self.folder.join(name), text).unwrap();
    }

    pub fn uri(&self, name: &str) -> String {
        uri(&self.folder.join(name))
    }

    pub fn notify(&mut self, method: &str, params: Json) {
        self.client.sender.send(Notification::new(method.to_owned(), params).into()).unwrap();
    }

    pub fn send(&mut self, method: &str, params: Json) -> RequestId {
        self.last += 1;
        let id = RequestId::from(self.last);
        self.client.sender.send(Request::new(id.clone(), method.to_owned(), params).into()).unwrap();
        id
    }

    /// Ask, and wait for the answer; that of an error is `{"error": message}`.
    pub fn request(&mut self, method: &str, params: Json) -> Json {
        let id = self.send(method, params);
        let end = Instant::now() + PATIENCE;
        loop {
            match self.receive(end).unwrap_or_else(|| panic!("no answer to {method}")) {
                Message::Response(r) if r.id == id => {
                    return match r.response_result {
                        Err(e) => json!({ "error": e.message }),
                        Ok(result) => result,
                    };
                }
                other => self.keep(other),
            }
        }
    }

    fn receive(&self, end: Instant) -> Option<Message> {
        self.client.receiver.recv_timeout(end.saturating_duration_since(Instant::now())).ok()
    }

    fn keep(&mut self, message: Message) {
        let Message::Notification(n) = message else { return };
        if n.method == "textDocument/publishDiagnostics" {
            let uri = n.params["uri"].as_str().unwrap().to_owned();
            let version = n.params["version"].as_i64().unwrap_or(-1);
            let all = n.params["diagnostics"].as_array().unwrap().clone();
            self.told.push((uri, version, all));
        }
    }

    /// Wait for the diagnostics of a version of a file that satisfy a condition.
    pub fn diagnostics_that(&mut self, name: &str, version: i64, good: impl Fn(&[Json]) -> bool) -> Vec<Json> {
        let (uri, end) = (self.uri(name), Instant::now() + PATIENCE);
        loop {
            let found = self.told.iter().rev().find(|(u, v, all)| *u == uri && *v >= version && good(all));
            if let Some((_, _, all)) = found {
                return all.clone();
            }
            let Some(message) = self.receive(end) else { panic!("no diagnostics of {name}: {:?}", self.told.last()) };
            self.keep(message);
        }
    }

    /// Wait for the first diagnostics of a version of a file.
    pub fn diagnostics(&mut self, name: &str, version: i64) -> Vec<Json> {
        self.diagnostics_that(name, version, |_| true)
    }

    /// Open a file that need not be on the disk, and wait for its diagnostics.
    pub fn open(&mut self, name: &str, text: &str) -> Vec<Json> {
        let item = json!({ "uri": self.uri(name), "languageId": "tcl", "version": 1, "text": text });
        self.notify("textDocument/didOpen", json!({ "textDocument": item }));
        self.diagnostics(name, 1)
    }

    /// Replace the whole text.
    pub fn replace(&mut self, name: &str, version: i64, text: &str) {
        let document = json!({ "uri": self.uri(name), "version": version });
        let changes = json!([{ "text": text }]);
        self.notify("textDocument/didChange", json!({ "textDocument": document, "contentChanges": changes }));
    }

    /// Replace a range: lines and characters from 0.
    pub fn edit(&mut self, name: &str, version: i64, range: [u32; 4], text: &str) {
        let document = json!({ "uri": self.uri(name), "version": version });
        let [l, c, to_l, to_c] = range;
        let range = json!({ "start": { "line": l, "character": c }, "end": { "line": to_l, "character": to_c } });
        let changes = json!([{ "range": range, "text": text }]);
        self.notify("textDocument/didChange", json!({ "textDocument": document, "contentChanges": changes }));
    }

    /// Ask about a position, with further parameters.
    pub fn at(&mut self, method: &str, name: &str, line: u32, character: u32, more: Json) -> Json {
        let mut params = json!({
            "textDocument": { "uri": self.uri(name) },
            "position": { "line": line, "character": character },
        });
        if let (Some(params), Some(more)) = (params.as_object_mut(), more.as_object()) {
            params.extend(more.clone());
        }
        self.request(method, params)
    }

    /// The text of a hover; empty for none.
    pub fn hover(&mut self, name: &str, line: u32, character: u32) -> String {
        let answer = self.at("textDocument/hover", name, line, character, json!({}));
        answer["contents"]["value"].as_str().unwrap_or_default().to_owned()
    }

    /// Labels of the completion.
    pub fn complete(&mut self, name: &str, line: u32, character: u32) -> Vec<Json> {
        let answer = self.at("textDocument/completion", name, line, character, json!({}));
        answer.as_array().cloned().unwrap_or_default()
    }

    /// Shut the server down; its result.
    pub fn end(mut self) -> Result<(), String> {
        self.request("shutdown", Json::Null);
        self.notify("exit", Json::Null);
        self.server.take().unwrap().join().unwrap()
    }
}

impl Drop for Editor {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.folder);
    }
}

/// Address of a file.
pub fn uri(path: &Path) -> String {
    format!("file://{}", path.display())
}

/// `line:start-end code message` of diagnostics, lines and characters from 1.
pub fn short(diagnostics: &[Json]) -> Vec<String> {
    let line = |d: &Json| {
        let (start, end) = (&d["range"]["start"], &d["range"]["end"]);
        let n = |v: &Json| v.as_u64().unwrap() + 1;
        let message = d["message"].as_str().unwrap().lines().next().unwrap().to_owned();
        let code = d["code"].as_str().unwrap_or("-");
        format!("{}:{}-{} {code} {message}", n(&start["line"]), n(&start["character"]), n(&end["character"]))
    };
    let mut all: Vec<String> = diagnostics.iter().map(line).collect();
    all.sort();
    all
}

/// `line:start-end` of ranges or locations, lines and characters from 1.
pub fn places(answer: &Json) -> Vec<String> {
    let place = |l: &Json| {
        let range = if l["range"].is_object() { &l["range"] } else { l };
        let n = |a: &str, b: &str| range[a][b].as_u64().unwrap() + 1;
        format!("{}:{}-{}", n("start", "line"), n("start", "character"), n("end", "character"))
    };
    answer.as_array().unwrap().iter().map(place).collect()
}
