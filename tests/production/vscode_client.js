// SPDX-License-Identifier: GPL-3.0-or-later
// The extension of VS Code, driven with an editor that is made up here: mistakes while typing,
// hover, completion, signatures, definition, renaming, colours and layout come through it.
//   node vscode_client.js PROGRAM
"use strict";
const assert = require("assert");
const fs = require("fs");
const Module = require("module");
const os = require("os");
const path = require("path");

const folder = fs.mkdtempSync(path.join(os.tmpdir(), "candelabra-"));
process.on("exit", () => fs.rmSync(folder, { recursive: true }));

// What the extension uses of the editor.
class Position { constructor(line, character) { Object.assign(this, { line, character }); } }
class Range { constructor(start, end) { Object.assign(this, { start, end }); } }
const record = (...names) => class { constructor(...values) { names.forEach((n, i) => { this[n] = values[i]; }); } };
const providers = {}, events = {}, mistakes = new Map();
const collect = name => (...given) => { providers[name] = given.find(g => typeof g === "object" && !g.language); return {}; };
const event = name => listener => { events[name] = listener; return {}; };
const scene = path.join(folder, "a.pov");
let text = "", version = 0;
const open = { uri: { scheme: "file", toString: () => "file://" + scene }, languageId: "pov",
               get version() { return version; }, getText: () => text };
const vscode = {
  Position, Range,
  Uri: { parse: uri => uri },
  Hover: record("contents", "range"), MarkdownString: record("value"), Location: record("uri", "range"),
  Diagnostic: record("range", "message", "severity"), DiagnosticRelatedInformation: record("location", "message"),
  CompletionItem: record("label", "kind"), TextEdit: record("range", "newText"), Color: record("red", "green", "blue", "alpha"),
  ColorInformation: record("range", "color"), ColorPresentation: record("label"),
  DocumentSymbol: record("name", "detail", "kind", "range", "selectionRange"),
  CodeAction: record("title", "kind"), CodeActionKind: { QuickFix: "quickfix" },
  SignatureHelp: class {}, SignatureInformation: record("label", "documentation"), ParameterInformation: record("label"),
  WorkspaceEdit: class { constructor() { this.all = new Map(); } set(uri, edits) { this.all.set(uri, edits); } },
  window: { showWarningMessage: message => { throw new Error(message); } },
  workspace: {
    textDocuments: [], getConfiguration: () => ({ get: () => process.argv[2] }),
    onDidOpenTextDocument: event("open"), onDidChangeTextDocument: event("change"),
    onDidSaveTextDocument: event("save"), onDidCloseTextDocument: event("close"),
  },
  languages: {
    createDiagnosticCollection: () => ({ set: (uri, list) => mistakes.set(uri, list) }),
    registerHoverProvider: collect("hover"), registerCompletionItemProvider: collect("completion"),
    registerSignatureHelpProvider: collect("signature"), registerCodeActionsProvider: collect("actions"),
    registerDefinitionProvider: collect("definition"), registerReferenceProvider: collect("references"),
    registerRenameProvider: collect("rename"), registerDocumentSymbolProvider: collect("symbols"),
    registerDocumentFormattingEditProvider: collect("format"), registerColorProvider: collect("colour"),
  },
};
const load = Module._load;
Module._load = (name, ...rest) => (name === "vscode" ? vscode : load(name, ...rest));
const extension = require(path.join(__dirname, "../../src/app/packaging/vscode/extension.js"));

async function until(what, test) {
  for (let i = 0; i < 300; ++i) {
    if (test()) return;
    await new Promise(resolve => setTimeout(resolve, 100));
  }
  throw new Error("never: " + what);
}
function type(now) {
  text = now;
  ++version;
  if (version === 1) events.open(open);
  else events.change({ document: open });
}

(async () => {
  await extension.activate({ subscriptions: [] });
  const uri = "file://" + scene;
  type("#declare Size = 2;\nsphere { /* \u{1F4A1}ö */ 0, Sise pigment { rgb <1, 0.5, 0> } }\n");
  await until("a mistake", () => (mistakes.get(uri) || []).some(d => d.message.includes("Sise")));
  assert.strictEqual(mistakes.get(uri)[0].severity, 0);
  const { start } = mistakes.get(uri)[0].range;
  assert.deepStrictEqual([start.line, start.character], [1, 22]);
  const [action] = await providers.actions.provideCodeActions(open, mistakes.get(uri)[0].range,
                                                               { diagnostics: mistakes.get(uri) });
  assert.deepStrictEqual(action.edit.all.get(uri).map(e => e.newText), ["Size"]);
  type("#declare Size = 2;\nsphere { 0, Size pigment { rgb <1, 0.5, 0> } }\n");
  await until("no mistake", () => !mistakes.get(uri).some(d => d.severity === 0));
  const on = new Position(1, 13);
  assert.match((await providers.hover.provideHover(open, new Position(1, 2))).contents.value, /sphere/);
  const [declared] = await providers.definition.provideDefinition(open, on);
  assert.deepStrictEqual([declared.uri, declared.range.start.line], [uri, 0]);
  assert.strictEqual((await providers.references.provideReferences(open, on)).length, 2);
  assert((await providers.completion.provideCompletionItems(open, on)).some(c => c.label === "Size"));
  const renamed = await providers.rename.provideRenameEdits(open, on, "Radius");
  assert.deepStrictEqual(renamed.all.get(uri).map(e => e.newText), ["Radius", "Radius"]);
  await assert.rejects(providers.rename.provideRenameEdits(open, on, "sphere"));
  assert.strictEqual((await providers.symbols.provideDocumentSymbols(open))[0].name, "Size");
  const [colour] = await providers.colour.provideDocumentColors(open);
  assert(colour.color.red > colour.color.green && colour.color.green > colour.color.blue);
  const texts = await providers.colour.provideColorPresentations(new vscode.Color(0, 0, 1, 1), { document: open, range: colour.range });
  assert.match(texts[0].label, /rgb <0, 0, 1>/);
  type("#declare V = vrotate(x, y);\n");
  const help = await providers.signature.provideSignatureHelp(open, new Position(0, 24));
  assert.match(help.signatures[0].label, /^vrotate\(/);
  assert.strictEqual(help.activeParameter, 1);
  assert.strictEqual(help.signatures[0].parameters.length, 2);
  type("union {\nsphere { 0, 1 }\n}\n");
  const [laidOut] = await providers.format.provideDocumentFormattingEdits(open);
  assert(laidOut.newText.includes("    sphere"));
  await extension.deactivate();
  console.log("the extension works");
})().catch(error => {
  console.error(error);
  process.exit(1);
});
