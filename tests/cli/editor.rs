//! `hysteron lsp` beside `hysteron check`: an editor is told the same.

use serde_json::{Value as Json, json};
use std::collections::BTreeMap;
use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

/// A server as a process of its own.
struct Server {
    child: Child,
    input: ChildStdin,
    output: BufReader<ChildStdout>,
}

impl Server {
    fn start() -> Self {
        let mut command = Command::new(env!("CARGO_BIN_EXE_hysteron"));
        let mut child = command
            .args(["lsp", "--stdio", "--time-limit", "10min"])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let (input, output) = (child.stdin.take().unwrap(), BufReader::new(child.stdout.take().unwrap()));
        let mut server = Self { child, input, output };
        server.send(json!({ "id": 1, "method": "initialize", "params": { "capabilities": {} } }));
        assert_eq!(server.receive()["result"]["serverInfo"]["name"], "hysteron");
        server.send(json!({ "method": "initialized", "params": {} }));
        server
    }

    fn send(&mut self, mut message: Json) {
        message["jsonrpc"] = json!("2.0");
        let text = message.to_string();
        write!(self.input, "Content-Length: {}\r\n\r\n{text}", text.len()).unwrap();
        self.input.flush().unwrap();
    }

    fn receive(&mut self) -> Json {
        let mut length = 0;
        loop {
            let mut line = String::new();
            assert_ne!(self.output.read_line(&mut line).unwrap(), 0, "the server has ended");
            match line.trim() {
                "" => break,
                head => length = head.strip_prefix("Content-Length: ").map_or(length, |n| n.parse().unwrap()),
            }
        }
        let mut text = vec![0; length];
        self.output.read_exact(&mut text).unwrap();
        serde_json::from_slice(&text).unwrap()
    }

    /// Open a file; its diagnostics.
    fn open(&mut self, path: &Path) -> Vec<Json> {
        let (uri, text) = (format!("file://{}", path.display()), std::fs::read_to_string(path).unwrap());
        let item = json!({ "uri": uri, "languageId": "tcl", "version": 1, "text": text });
        self.send(json!({ "method": "textDocument/didOpen", "params": { "textDocument": item } }));
        let told = loop {
            let message = self.receive();
            if message["params"]["uri"] == uri.as_str() {
                break message["params"]["diagnostics"].as_array().unwrap().clone();
            }
        };
        self.send(json!({ "method": "textDocument/didClose", "params": { "textDocument": { "uri": uri } } }));
        told
    }

    fn end(mut self) {
        self.send(json!({ "id": 2, "method": "shutdown" }));
        while self.receive()["id"] != 2 {}
        self.send(json!({ "method": "exit" }));
        assert_eq!(self.child.wait().unwrap().code(), Some(0));
    }
}

fn scripts(folder: &Path, out: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            scripts(&path, out);
        } else if path.extension().is_some_and(|e| e == "tcl") {
            out.push(path);
        }
    }
    out.sort();
}

/// Errors and warnings as `line column severity code message`.
type Messages = Vec<String>;

/// What `hysteron check` says, by the name of the file.
fn checked(path: &Path) -> BTreeMap<String, Messages> {
    let mut command = Command::new(env!("CARGO_BIN_EXE_hysteron"));
    let name = path.file_name().unwrap();
    let output = command.args(["check", "--json"]).arg(name).current_dir(path.parent().unwrap()).output().unwrap();
    let table: Json = serde_json::from_slice(&output.stdout).unwrap();
    let mut all: BTreeMap<String, Messages> = BTreeMap::new();
    for m in table["messages"].as_array().unwrap().iter().filter(|m| m["severity"] != "note") {
        let file = m["file"].as_str().map_or(name.to_str().unwrap(), |f| f.rsplit('/').next().unwrap());
        let code = m["code"].as_str().unwrap_or("-");
        let place = |key: &str| m[key].as_u64().unwrap_or(1);
        let message = m["message"].as_str().unwrap();
        let times = m["count"].as_u64().filter(|n| *n > 1).map(|n| format!(" ({n} times)")).unwrap_or_default();
        let text = format!(
            "{} {} {} {code} {message}{times}",
            place("line"),
            place("column"),
            m["severity"].as_str().unwrap()
        );
        all.entry(file.to_owned()).or_default().push(text);
    }
    all.values_mut().for_each(|m| m.sort());
    all
}

fn told(diagnostics: &[Json]) -> Messages {
    let text = |d: &Json| {
        let severity = match d["severity"].as_u64() {
            Some(1) => "error",
            Some(2) => "warning",
            _ => return None,
        };
        let place = |key: &str| d["range"]["start"][key].as_u64().unwrap() + 1;
        let message = d["message"].as_str().unwrap().lines().next().unwrap();
        let code = d["code"].as_str().unwrap_or("-");
        Some(format!("{} {} {severity} {code} {message}", place("line"), place("character")))
    };
    let mut all: Messages = diagnostics.iter().filter_map(text).collect();
    all.sort();
    all
}

/// A file that a script sources is checked as a part of it, or for itself where no script comes to it.
#[test]
fn an_editor_is_told_what_check_says_of_the_shipped_inputs() {
    let mut paths = vec![];
    for folder in ["tcl-like-inputs", "models"] {
        scripts(&Path::new(env!("CARGO_MANIFEST_DIR")).join(folder), &mut paths);
    }
    assert!(paths.len() > 20);
    let checks: Vec<BTreeMap<String, Messages>> = paths.iter().map(|p| checked(p)).collect();
    let mut server = Server::start();
    let mut wrong = vec![];
    for path in &paths {
        let told = told(&server.open(path));
        let name = path.file_name().unwrap().to_str().unwrap();
        let possible: Vec<&Messages> = checks.iter().filter_map(|c| c.get(name)).collect();
        let is_sound = !checks[paths.iter().position(|p| p == path).unwrap()].contains_key(name);
        if !(possible.contains(&&told) || told.is_empty() && (is_sound || possible.is_empty())) {
            wrong.push(format!("{}: {told:#?}\ncheck: {possible:#?}", path.display()));
        }
    }
    server.end();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
