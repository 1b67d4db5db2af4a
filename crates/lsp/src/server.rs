//! The loop of the server: it answers from what is known, and never waits for a check.

use crate::buffer::{Buffer, Known, View};
use crate::check::{Buffers, Checked};
use crate::features;
use crate::publish;
use crate::script::Script;
use crate::settings::Settings;
use crate::text::Text;
use crate::uri;
use crate::worker::{Limits, Worker};
use crossbeam_channel::{Receiver, select, unbounded};
use lsp_server::{Connection, ErrorCode, Message, Notification, Request, Response};
use lsp_types::notification::{
    DidChangeTextDocument, DidChangeWatchedFiles, DidCloseTextDocument, DidOpenTextDocument, DidSaveTextDocument, Exit,
    Notification as _, PublishDiagnostics,
};
use lsp_types::{
    DidChangeTextDocumentParams, DidChangeWatchedFilesParams, DidCloseTextDocumentParams, DidOpenTextDocumentParams,
    DidSaveTextDocumentParams, Uri,
};
use serde_json::Value as Json;
use std::collections::{BTreeMap, BTreeSet};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::time::Duration;

/// Time between two looks at the limits of a check.
const TICK: Duration = Duration::from_millis(100);
/// The same where nothing is checked.
const IDLE_TICK: Duration = Duration::from_secs(10);

/// Serve an editor over standard input and output.
///
/// # Errors
/// The connection breaks, or the editor does not keep to the protocol.
pub fn serve_stdio(settings: Settings) -> Result<(), String> {
    let (connection, threads) = Connection::stdio();
    let served = serve(connection, settings);
    served.and_then(|()| threads.join().map_err(|e| e.to_string()))
}

/// Serve an editor over a connection, until it says that it ends.
///
/// # Errors
/// The connection breaks, or the editor does not keep to the protocol.
pub fn serve(connection: Connection, settings: Settings) -> Result<(), String> {
    let (id, params) = connection.initialize_start().map_err(|e| e.to_string())?;
    let settings = settings.with(params.get("initializationOptions").unwrap_or(&Json::Null));
    let server_info = serde_json::json!({ "name": publish::SOURCE, "version": env!("CARGO_PKG_VERSION") });
    let capabilities = features::capabilities(settings.lenses);
    let answer = serde_json::json!({ "capabilities": capabilities, "serverInfo": server_info });
    connection.initialize_finish(id, answer).map_err(|e| e.to_string())?;
    let (sender, results) = unbounded();
    let limits = Limits { time: settings.time_limit, compat: settings.compat };
    let worker = Worker::new(limits, sender).map_err(|e| e.to_string())?;
    let (buffers, known, published) = Default::default();
    Server { connection, settings, worker, results, buffers, known, published }.run()
}

/// The server and what it knows.
struct Server {
    connection: Connection,
    settings: Settings,
    worker: Worker,
    results: Receiver<Checked>,
    /// Open files by their paths.
    buffers: BTreeMap<String, Buffer>,
    /// What is known of each root.
    known: BTreeMap<String, Known>,
    /// Files for which the editor has diagnostics.
    published: BTreeSet<String>,
}

/// Path of an address. What has no file yet is in the current folder.
fn path_of(uri: &Uri) -> String {
    uri::to_path(uri).unwrap_or_else(|| {
        let name: String = uri.as_str().chars().map(|c| if c.is_alphanumeric() { c } else { '-' }).collect();
        let folder = std::env::current_dir().map_or_else(|_| "/".to_owned(), hysteron_files::portable);
        format!("{}/{name}", folder.trim_end_matches('/'))
    })
}

impl Server {
    fn run(mut self) -> Result<(), String> {
        loop {
            let pause = if self.worker.is_idle() { IDLE_TICK } else { TICK };
            select! {
                recv(self.connection.receiver) -> message => {
                    let is_end = message.map_or(Ok(true), |message| self.message(message))?;
                    if is_end {
                        return Ok(());
                    }
                }
                recv(self.results) -> checked => if let Ok(checked) = checked {
                    self.take(checked);
                },
                default(pause) => {
                    let memory = memory_stats::memory_stats().map_or(0, |m| m.physical_mem);
                    self.worker.look(memory > self.settings.max_memory);
                }
            }
        }
    }

    /// Handle a message of the editor. Returns true at the end.
    fn message(&mut self, message: Message) -> Result<bool, String> {
        match message {
            Message::Request(request) => {
                if self.connection.handle_shutdown(&request).map_err(|e| e.to_string())? {
                    return Ok(true);
                }
                let response = self.answer(request);
                Ok(self.connection.sender.send(response.into()).is_err())
            }
            Message::Notification(n) if n.method == Exit::METHOD => Ok(true),
            Message::Notification(n) => {
                // What is not as the protocol has it is passed over.
                let _ = self.notified(n);
                Ok(false)
            }
            Message::Response(_) => Ok(false),
        }
    }

    fn answer(&self, request: Request) -> Response {
        let Request { id, method, params } = request;
        let uri = params.pointer("/textDocument/uri").and_then(Json::as_str).and_then(|u| u.parse().ok());
        let path = uri.as_ref().map(path_of);
        let open = path.as_ref().and_then(|path| Some((path, self.buffers.get(path)?)));
        let answered = catch_unwind(AssertUnwindSafe(|| match open {
            Some((path, buffer)) => {
                let view = View::new(path, buffer, &self.buffers, self.known_of(path));
                features::answer(&view, &method, params, &self.settings)
            }
            // The file has been closed.
            None => path.as_ref().map(|_| Ok(Json::Null)),
        }));
        match answered {
            Ok(Some(Ok(result))) => Response::new_ok(id, result),
            Ok(Some(Err(message))) => Response::new_err(id, ErrorCode::InvalidParams as i32, message),
            Ok(None) => Response::new_err(id, ErrorCode::MethodNotFound as i32, format!("{method} is not known")),
            Err(_) => Response::new_err(id, ErrorCode::InternalError as i32, format!("{method} failed")),
        }
    }

    /// What is known of a file: by its own check, or by that of a script that sources it.
    fn known_of(&self, path: &str) -> Option<&Known> {
        let has = |k: &&Known| k.script.as_ref().is_some_and(|s| s.text(path).is_some());
        self.known.values().find(has).or_else(|| self.known.get(path))
    }

    fn notified(&mut self, n: Notification) -> Result<(), serde_json::Error> {
        match n.method.as_str() {
            DidOpenTextDocument::METHOD => {
                let document = serde_json::from_value::<DidOpenTextDocumentParams>(n.params)?.text_document;
                let path = path_of(&document.uri);
                let buffer = Buffer::new(document.uri, document.version, Text::new(&document.text));
                self.buffers.insert(path.clone(), buffer);
                self.submit([path], true);
            }
            DidChangeTextDocument::METHOD => {
                let params = serde_json::from_value::<DidChangeTextDocumentParams>(n.params)?;
                let path = path_of(&params.text_document.uri);
                let Some(old) = self.buffers.remove(&path) else { return Ok(()) };
                let text = params.content_changes.iter().fold(old.text, |text, change| text.changed(change));
                self.buffers.insert(path.clone(), Buffer::new(old.uri, params.text_document.version, text));
                self.submit([path], false);
            }
            DidSaveTextDocument::METHOD => {
                let params = serde_json::from_value::<DidSaveTextDocumentParams>(n.params)?;
                self.submit([path_of(&params.text_document.uri)], true);
            }
            DidCloseTextDocument::METHOD => {
                let params = serde_json::from_value::<DidCloseTextDocumentParams>(n.params)?;
                self.close(&path_of(&params.text_document.uri));
            }
            DidChangeWatchedFiles::METHOD => {
                let params = serde_json::from_value::<DidChangeWatchedFilesParams>(n.params)?;
                let changed: Vec<String> = params.changes.iter().map(|c| path_of(&c.uri)).collect();
                self.submit(changed, true);
            }
            _ => {}
        }
        Ok(())
    }

    fn close(&mut self, path: &str) {
        self.buffers.remove(path);
        let open = |checked: &Checked| self.buffers.keys().any(|p| checked.texts.contains_key(p));
        let mut concerned = BTreeSet::from([path.to_owned()]);
        for known in self.known.values().filter(|k| !open(&k.checked)) {
            concerned.extend(known.checked.files());
        }
        self.known.retain(|_, k| open(&k.checked));
        self.submit([path.to_owned()], true);
        self.publish(concerned);
    }

    /// Give the texts to the thread that checks.
    fn submit(&self, changed: impl IntoIterator<Item = String>, is_renewed: bool) {
        let texts: Buffers = self.buffers.iter().map(|(p, b)| (p.clone(), b.text.shared())).collect();
        self.worker.submit(Arc::new(texts), changed, is_renewed);
    }

    /// Take the result of a check.
    fn take(&mut self, checked: Checked) {
        let mut concerned: BTreeSet<String> = checked.files().collect();
        if let Some(before) = self.known.get(&checked.root) {
            concerned.extend(before.checked.files());
        }
        if self.buffers.keys().any(|p| checked.texts.contains_key(p) || *p == checked.root) {
            let known = self.known.entry(checked.root.clone()).or_default();
            // What a half-typed text hides is still known from before.
            let is_poorer = |new: &Script| {
                let fewer = |old: &Arc<Script>| new.index.commands.len() < old.index.commands.len();
                (checked.is_cut || checked.is_stopped) && known.script.as_ref().is_some_and(fewer)
            };
            if let Some(script) = checked.script.clone().filter(|s| !is_poorer(s)) {
                known.script = Some(script);
            }
            known.checked = checked;
        } else {
            self.known.remove(&checked.root);
        }
        self.publish(concerned);
    }

    /// Tell the editor of files: those that are open, and others that have findings or had some.
    fn publish(&mut self, mut concerned: BTreeSet<String>) {
        let found: BTreeSet<&str> =
            self.known.values().flat_map(|k| k.checked.findings.iter().map(|f| f.place.path.as_str())).collect();
        concerned.retain(|p| self.buffers.contains_key(p) || self.published.contains(p) || found.contains(p.as_str()));
        for params in publish::diagnostics(self.known.values(), &self.buffers, &concerned) {
            let n = Notification::new(PublishDiagnostics::METHOD.to_owned(), params);
            let _ = self.connection.sender.send(n.into());
        }
        self.published = found.into_iter().map(str::to_owned).collect();
    }
}
