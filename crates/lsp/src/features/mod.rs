//! Answers to what an editor asks.

mod actions;
pub(crate) mod completion;
mod format;
mod hover;
mod lens;
mod navigation;
mod outline;
mod signature;
mod snippet;
mod table;
mod thing;
mod tokens;
mod words;

use crate::buffer::View;
use crate::settings::Settings;
use lsp_types::request::{
    CodeActionRequest, CodeLensRequest, Completion, DocumentHighlightRequest, DocumentSymbolRequest,
    FoldingRangeRequest, Formatting, GotoDefinition, HoverRequest, PrepareRenameRequest, References, Rename, Request,
    SemanticTokensFullRequest, SignatureHelpRequest,
};
use lsp_types::{
    CodeActionKind, CodeActionOptions, CodeActionProviderCapability, CodeLensOptions, CompletionOptions,
    CompletionResponse, DocumentHighlight, DocumentSymbolResponse, FoldingRangeProviderCapability,
    GotoDefinitionResponse, HoverProviderCapability, OneOf, PrepareRenameResponse, RenameOptions,
    SemanticTokensFullOptions, SemanticTokensOptions, SemanticTokensResult, SemanticTokensServerCapabilities,
    ServerCapabilities, SignatureHelpOptions, TextDocumentPositionParams, TextDocumentSyncCapability,
    TextDocumentSyncKind, TextDocumentSyncOptions, TextDocumentSyncSaveOptions, WorkDoneProgressOptions,
};
use serde_json::Value as Json;

/// What the server can do.
pub(crate) fn capabilities(lenses: bool) -> ServerCapabilities {
    let characters = |all: &[&str]| Some(all.iter().map(|c| (*c).to_owned()).collect());
    let work_done_progress_options = WorkDoneProgressOptions::default();
    ServerCapabilities {
        text_document_sync: Some(TextDocumentSyncCapability::Options(TextDocumentSyncOptions {
            open_close: Some(true),
            change: Some(TextDocumentSyncKind::INCREMENTAL),
            save: Some(TextDocumentSyncSaveOptions::Supported(true)),
            ..TextDocumentSyncOptions::default()
        })),
        hover_provider: Some(HoverProviderCapability::Simple(true)),
        completion_provider: Some(CompletionOptions {
            trigger_characters: characters(&[" ", "$", "-", ".", "'"]),
            ..CompletionOptions::default()
        }),
        signature_help_provider: Some(SignatureHelpOptions {
            trigger_characters: characters(&[" ", "(", ","]),
            ..SignatureHelpOptions::default()
        }),
        definition_provider: Some(OneOf::Left(true)),
        references_provider: Some(OneOf::Left(true)),
        document_highlight_provider: Some(OneOf::Left(true)),
        document_symbol_provider: Some(OneOf::Left(true)),
        folding_range_provider: Some(FoldingRangeProviderCapability::Simple(true)),
        document_formatting_provider: Some(OneOf::Left(true)),
        rename_provider: Some(OneOf::Right(RenameOptions { prepare_provider: Some(true), work_done_progress_options })),
        code_action_provider: Some(CodeActionProviderCapability::Options(CodeActionOptions {
            code_action_kinds: Some(vec![CodeActionKind::QUICKFIX]),
            ..CodeActionOptions::default()
        })),
        code_lens_provider: lenses.then_some(CodeLensOptions { resolve_provider: Some(false) }),
        semantic_tokens_provider: Some(SemanticTokensServerCapabilities::SemanticTokensOptions(
            SemanticTokensOptions {
                legend: tokens::legend(),
                full: Some(SemanticTokensFullOptions::Bool(true)),
                ..SemanticTokensOptions::default()
            },
        )),
        ..ServerCapabilities::default()
    }
}

/// Answer a request of its type.
fn typed<R: Request>(params: Json, answer: impl FnOnce(R::Params) -> R::Result) -> Result<Json, String> {
    tried::<R>(params, |p| Ok(answer(p)))
}

/// Answer a request of its type that may be refused.
fn tried<R: Request>(
    params: Json,
    answer: impl FnOnce(R::Params) -> Result<R::Result, String>,
) -> Result<Json, String> {
    let params = serde_json::from_value(params).map_err(|e| e.to_string())?;
    serde_json::to_value(answer(params)?).map_err(|e| e.to_string())
}

/// Answer a request about a file; `None` for a method that is not known.
pub(crate) fn answer(view: &View<'_>, method: &str, params: Json, settings: &Settings) -> Option<Result<Json, String>> {
    let at = |p: &TextDocumentPositionParams| view.buffer.text.offset(p.position);
    Some(match method {
        HoverRequest::METHOD => typed::<HoverRequest>(params, |p| {
            let at = at(&p.text_document_position_params);
            hover::hover(view, at).or_else(|| table::hover(view, at))
        }),
        Completion::METHOD => typed::<Completion>(params, |p| {
            let at = at(&p.text_document_position);
            let mut items = completion::items(view, at);
            items.extend(table::completion(view, at));
            Some(CompletionResponse::Array(items))
        }),
        SignatureHelpRequest::METHOD => {
            typed::<SignatureHelpRequest>(params, |p| signature::help(view, at(&p.text_document_position_params)))
        }
        GotoDefinition::METHOD => typed::<GotoDefinition>(params, |p| {
            let found = navigation::definitions(view, at(&p.text_document_position_params));
            Some(GotoDefinitionResponse::Array(found))
        }),
        References::METHOD => typed::<References>(params, |p| {
            Some(navigation::references(view, at(&p.text_document_position), p.context.include_declaration))
        }),
        DocumentHighlightRequest::METHOD => typed::<DocumentHighlightRequest>(params, |p| {
            let ranges = navigation::highlights(view, at(&p.text_document_position_params));
            Some(ranges.into_iter().map(|range| DocumentHighlight { range, kind: None }).collect())
        }),
        PrepareRenameRequest::METHOD => typed::<PrepareRenameRequest>(params, |p| {
            navigation::renamable(view, at(&p)).map(PrepareRenameResponse::Range)
        }),
        Rename::METHOD => {
            tried::<Rename>(params, |p| navigation::rename(view, at(&p.text_document_position), &p.new_name).map(Some))
        }
        DocumentSymbolRequest::METHOD => {
            typed::<DocumentSymbolRequest>(params, |_| Some(DocumentSymbolResponse::Nested(outline::symbols(view))))
        }
        FoldingRangeRequest::METHOD => typed::<FoldingRangeRequest>(params, |_| Some(outline::foldings(view))),
        CodeActionRequest::METHOD => typed::<CodeActionRequest>(params, |p| Some(actions::actions(view, p.range))),
        SemanticTokensFullRequest::METHOD => typed::<SemanticTokensFullRequest>(params, |_| {
            view.is_script().then(|| SemanticTokensResult::Tokens(tokens::tokens(view)))
        }),
        Formatting::METHOD => {
            typed::<Formatting>(params, |p| view.is_script().then(|| format::edits(view, &p.options)))
        }
        CodeLensRequest::METHOD => typed::<CodeLensRequest>(params, |_| settings.lenses.then(|| lens::lenses(view))),
        _ => return None,
    })
}
