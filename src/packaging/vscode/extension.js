// SPDX-License-Identifier: GPL-3.0-or-later
// Help with scenes in VS Code: what `candelabra lsp` says, in the editor's own types. Needs no
// package besides the editor; the program's place can be set as `candelabra.path`.
"use strict";
const vscode = require("vscode");
const { Client } = require("./client.js");
const commands = require("./commands.js");

let client = null;
const scenes = { language: "pov", scheme: "file" };

const place = p => ({ line: p.line, character: p.character });
const position = p => new vscode.Position(p.line, p.character);
const range = r => new vscode.Range(position(r.start), position(r.end));
const lines = r => ({ start: place(r.start), end: place(r.end) });
const document = d => ({ uri: d.uri.toString() });
const at = (d, p) => ({ textDocument: document(d), position: place(p) });
const location = l => new vscode.Location(vscode.Uri.parse(l.uri), range(l.range));
const edit = e => new vscode.TextEdit(range(e.range), e.newText);
const list = value => (Array.isArray(value) ? value : value ? [value] : []);

function diagnostic(d) {
  const made = new vscode.Diagnostic(range(d.range), d.message, (d.severity || 1) - 1);
  made.source = "candelabra";
  made.code = d.code;
  made.relatedInformation = list(d.relatedInformation).map(
    r => new vscode.DiagnosticRelatedInformation(location(r.location), r.message));
  return made;
}

function follow(context) {
  const isScene = d => d.languageId === scenes.language && d.uri.scheme === scenes.scheme;
  const opened = d => isScene(d) && client.notify("textDocument/didOpen",
    { textDocument: { ...document(d), languageId: "pov", version: d.version, text: d.getText() } });
  const on = (event, method, parameters) => context.subscriptions.push(
    event(e => isScene(e.document || e) && client.notify(method, parameters(e.document || e))));
  vscode.workspace.textDocuments.forEach(opened);
  context.subscriptions.push(vscode.workspace.onDidOpenTextDocument(opened));
  context.subscriptions.push(vscode.workspace.onDidChangeTextDocument(
    e => isScene(e.document) && e.contentChanges.length > 0 && client.notify("textDocument/didChange", {
      textDocument: { ...document(e.document), version: e.document.version },
      contentChanges: e.contentChanges.map(c => ({ range: lines(c.range), text: c.text })) })));
  on(vscode.workspace.onDidSaveTextDocument, "textDocument/didSave", d => ({ textDocument: document(d) }));
  on(vscode.workspace.onDidCloseTextDocument, "textDocument/didClose", d => ({ textDocument: document(d) }));
}

/// What belongs to words, and to whole documents.
function provideStructure(context, legend) {
  const ask = (method, parameters) => client.request("textDocument/" + method, parameters);
  const languages = vscode.languages;
  const kinds = { comment: vscode.FoldingRangeKind.Comment, imports: vscode.FoldingRangeKind.Imports,
                  region: undefined };
  const meanings = found => found && new vscode.SemanticTokens(new Uint32Array(found.data));
  const words = new vscode.SemanticTokensLegend(legend.tokenTypes, legend.tokenModifiers);
  context.subscriptions.push(
    languages.registerDocumentSemanticTokensProvider(scenes, { provideDocumentSemanticTokens: async d =>
      meanings(await ask("semanticTokens/full", { textDocument: document(d) })) }, words),
    languages.registerDocumentRangeSemanticTokensProvider(scenes, { provideDocumentRangeSemanticTokens:
      async (d, r) => meanings(await ask("semanticTokens/range", { textDocument: document(d), range: lines(r) })) },
      words),
    languages.registerFoldingRangeProvider(scenes, { provideFoldingRanges: async d =>
      list(await ask("foldingRange", { textDocument: document(d) })).map(
        f => new vscode.FoldingRange(f.startLine, f.endLine, kinds[f.kind])) }),
    languages.registerDocumentLinkProvider(scenes, { provideDocumentLinks: async d =>
      list(await ask("documentLink", { textDocument: document(d) })).map(
        l => new vscode.DocumentLink(range(l.range), vscode.Uri.parse(l.target))) }),
    languages.registerDocumentHighlightProvider(scenes, { provideDocumentHighlights: async (d, p) =>
      list(await ask("documentHighlight", at(d, p))).map(
        h => new vscode.DocumentHighlight(range(h.range), h.kind - 1)) }),
    languages.registerWorkspaceSymbolProvider({ provideWorkspaceSymbols: async query =>
      list(await client.request("workspace/symbol", { query })).map(
        s => new vscode.SymbolInformation(s.name, s.kind - 1, s.containerName, location(s.location))) }),
    languages.registerDocumentRangeFormattingEditProvider(scenes, { provideDocumentRangeFormattingEdits:
      async (d, r) => list(await ask("rangeFormatting", { textDocument: document(d), range: lines(r) })).map(edit) }));
}

function provide(context) {
  const ask = (method, parameters) => client.request("textDocument/" + method, parameters);
  const languages = vscode.languages;
  context.subscriptions.push(
    languages.registerHoverProvider(scenes, { provideHover: async (d, p) => {
      const found = await ask("hover", at(d, p));
      return found && new vscode.Hover(new vscode.MarkdownString(found.contents.value), range(found.range));
    } }),
    languages.registerCompletionItemProvider(scenes, { provideCompletionItems: async (d, p) =>
      list(await ask("completion", at(d, p))).map(each => Object.assign(
        new vscode.CompletionItem(each.label, each.kind - 1),
        { detail: each.detail, documentation: each.documentation, sortText: each.sortText }))
    }, "#", '"'),
    languages.registerSignatureHelpProvider(scenes, { provideSignatureHelp: async (d, p) => {
      const found = await ask("signatureHelp", at(d, p));
      return found && Object.assign(new vscode.SignatureHelp(), {
        signatures: found.signatures.map(each => Object.assign(
          new vscode.SignatureInformation(each.label, each.documentation),
          { parameters: each.parameters.map(one => new vscode.ParameterInformation(one.label)) })),
        activeSignature: found.activeSignature, activeParameter: found.activeParameter });
    } }, "(", ","),
    languages.registerCodeActionsProvider(scenes, { provideCodeActions: async (d, r, context) => {
      const diagnostics = context.diagnostics.map(each => ({ range: lines(each.range), message: each.message }));
      const found = list(await ask("codeAction", { textDocument: document(d), context: { diagnostics },
        range: lines(r) }));
      return found.map(each => {
        const made = new vscode.CodeAction(each.title, vscode.CodeActionKind.QuickFix);
        made.edit = new vscode.WorkspaceEdit();
        for (const uri of Object.keys(each.edit.changes))
          made.edit.set(vscode.Uri.parse(uri), each.edit.changes[uri].map(edit));
        made.isPreferred = each.isPreferred;
        return made;
      });
    } }),
    languages.registerDefinitionProvider(scenes, { provideDefinition: async (d, p) =>
      list(await ask("definition", at(d, p))).map(location) }),
    languages.registerReferenceProvider(scenes, { provideReferences: async (d, p) =>
      list(await ask("references", at(d, p))).map(location) }),
    languages.registerRenameProvider(scenes, { provideRenameEdits: async (d, p, newName) => {
      const all = new vscode.WorkspaceEdit();
      const { changes } = await ask("rename", { ...at(d, p), newName });
      for (const [uri, edits] of Object.entries(changes)) all.set(vscode.Uri.parse(uri), edits.map(edit));
      return all;
    } }),
    languages.registerDocumentSymbolProvider(scenes, { provideDocumentSymbols: async d =>
      list(await ask("documentSymbol", { textDocument: document(d) })).map(s => new vscode.DocumentSymbol(
        s.name, "", s.kind - 1, range(s.range), range(s.selectionRange))) }),
    languages.registerDocumentFormattingEditProvider(scenes, { provideDocumentFormattingEdits: async d =>
      list(await ask("formatting", { textDocument: document(d) })).map(edit) }),
    languages.registerColorProvider(scenes, {
      provideDocumentColors: async d =>
        list(await ask("documentColor", { textDocument: document(d) })).map(c => new vscode.ColorInformation(
          range(c.range), new vscode.Color(c.color.red, c.color.green, c.color.blue, c.color.alpha))),
      provideColorPresentations: async ({ red, green, blue, alpha }, { document: d, range: r }) =>
        list(await ask("colorPresentation", { textDocument: document(d), color: { red, green, blue, alpha },
          range: lines(r) })).map(c => new vscode.ColorPresentation(c.label)),
    }));
}

async function activate(context) {
  const mistakes = vscode.languages.createDiagnosticCollection("candelabra");
  context.subscriptions.push(mistakes);
  const program = vscode.workspace.getConfiguration("candelabra").get("path") || "candelabra";
  context.subscriptions.push(
    vscode.commands.registerCommand("candelabra.render", () => commands.render(program)),
    vscode.commands.registerCommand("candelabra.preview", () => commands.preview(program)));
  const heard = (method, parameters) => {
    if (method === "textDocument/publishDiagnostics")
      mistakes.set(vscode.Uri.parse(parameters.uri), parameters.diagnostics.map(diagnostic));
  };
  client = new Client(program, ["lsp"], heard);
  let greeting;
  try {
    greeting = await client.request("initialize", { processId: process.pid, rootUri: null, capabilities: {} });
  } catch {
    vscode.window.showWarningMessage(`${program} cannot be started: scenes have their colours, and no more help`);
    return;
  }
  client.notify("initialized", {});
  follow(context);
  provide(context);
  provideStructure(context, greeting.capabilities.semanticTokensProvider.legend);
}

function deactivate() {
  return client && client.stop().catch(() => {});
}

module.exports = { activate, deactivate };
