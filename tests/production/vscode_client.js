// SPDX-License-Identifier: GPL-3.0-or-later
// The extension of VS Code, driven with an editor that is made up here: mistakes while typing,
// hover, completion, signatures, definition, renaming, colours, layout, meanings of words, folding,
// links and symbols come through it; Render and Preview beside work; snippets are scenes, and the
// problem matcher finds what the program says.
//   node vscode_client.js PROGRAM
"use strict";
const assert = require("assert");
const fs = require("fs");
const Module = require("module");
const os = require("os");
const path = require("path");

process.argv[2] = path.resolve(process.argv[2]);
const folder = fs.mkdtempSync(path.join(os.tmpdir(), "candelabra-"));
process.on("exit", () => fs.rmSync(folder, { recursive: true }));

// What the extension uses of the editor.
class Position { constructor(line, character) { Object.assign(this, { line, character }); } }
class Range { constructor(start, end) { Object.assign(this, { start, end }); } }
const record = (...names) => class { constructor(...values) { names.forEach((n, i) => { this[n] = values[i]; }); } };
const { spawnSync } = require("child_process");
const providers = {}, events = {}, mistakes = new Map(), commands = {}, opened = [], panels = [];
const collect = name => (...given) => { providers[name] = given.find(g => typeof g === "object" && !g.language); return {}; };
const registered = name => provider => { providers[name] = provider; return {}; };
const event = name => listener => { events[name] = listener; return {}; };
const scene = path.join(folder, "a.pov");
let text = "", version = 0;
const open = { uri: { scheme: "file", fsPath: scene, toString: () => "file://" + scene }, languageId: "pov",
               save: async () => fs.writeFileSync(scene, text),
               get version() { return version; }, getText: () => text };
const vscode = {
  Position, Range,
  Uri: { parse: uri => uri, file: name => "file://" + name },
  Hover: record("contents", "range"), MarkdownString: record("value"), Location: record("uri", "range"),
  Diagnostic: record("range", "message", "severity"), DiagnosticRelatedInformation: record("location", "message"),
  CompletionItem: record("label", "kind"), TextEdit: record("range", "newText"), Color: record("red", "green", "blue", "alpha"),
  ColorInformation: record("range", "color"), ColorPresentation: record("label"),
  DocumentSymbol: record("name", "detail", "kind", "range", "selectionRange"),
  CodeAction: record("title", "kind"), CodeActionKind: { QuickFix: "quickfix" },
  SignatureHelp: class {}, SignatureInformation: record("label", "documentation"), ParameterInformation: record("label"),
  WorkspaceEdit: class { constructor() { this.all = new Map(); } set(uri, edits) { this.all.set(uri, edits); } },
  SemanticTokens: record("data"), SemanticTokensLegend: record("tokenTypes", "tokenModifiers"),
  FoldingRange: record("start", "end", "kind"), FoldingRangeKind: { Comment: 1, Imports: 2 },
  DocumentLink: record("range", "target"), DocumentHighlight: record("range", "kind"),
  SymbolInformation: record("name", "kind", "containerName", "location"),
  Task: record("definition", "scope", "name", "source", "execution", "problemMatchers"),
  ProcessExecution: record("process", "args", "options"), TaskScope: { Workspace: 2 }, ViewColumn: { Beside: -2 },
  window: {
    showWarningMessage: message => { throw new Error(message); },
    showErrorMessage: message => { throw new Error(message); },
    get activeTextEditor() { return { document: open }; },
    createWebviewPanel: () => {
      const panel = { sent: [], webview: { html: "", postMessage: state => panel.sent.push(state) },
                      onDidDispose: listener => { panel.dispose = listener; } };
      panels.push(panel);
      return panel;
    },
  },
  commands: {
    registerCommand: (name, command) => { commands[name] = command; return {}; },
    executeCommand: (name, uri) => opened.push([name, uri]),
  },
  // A task is carried out before it is said to have begun; its end is told a moment later.
  tasks: {
    executeTask: async task => {
      const { process: program, args, options } = task.execution;
      const { status } = spawnSync(program, args, options);
      const execution = { task };
      setTimeout(() => events.taskEnd({ execution, exitCode: status }), 10);
      return execution;
    },
    onDidEndTaskProcess: listener => { events.taskEnd = listener; return { dispose: () => {} }; },
  },
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
    registerDocumentSemanticTokensProvider: collect("meanings"),
    registerDocumentRangeSemanticTokensProvider: collect("meaningsOfRange"),
    registerFoldingRangeProvider: collect("folds"), registerDocumentLinkProvider: collect("links"),
    registerDocumentHighlightProvider: collect("highlights"), registerWorkspaceSymbolProvider: registered("names"),
    registerDocumentRangeFormattingEditProvider: collect("formatRange"),
  },
};
const load = Module._load;
Module._load = (name, ...rest) => (name === "vscode" ? vscode : load(name, ...rest));
const extension = require(path.join(__dirname, "../../src/packaging/vscode/extension.js"));

async function until(what, test) {
  for (let i = 0; i < 300; ++i) {
    if (test()) return;
    await new Promise(resolve => setTimeout(resolve, 100));
  }
  throw new Error("never: " + what);
}
/// As an editor tells of it: what is the same at both ends is not sent again.
function type(now) {
  const before = text;
  let same = 0, tail = 0;
  while (same < before.length && same < now.length && before[same] === now[same]) ++same;
  while (tail < before.length - same && tail < now.length - same &&
         before[before.length - 1 - tail] === now[now.length - 1 - tail]) ++tail;
  const position = offset => {
    const lines = before.slice(0, offset).split("\n");
    return new Position(lines.length - 1, lines[lines.length - 1].length);
  };
  text = now;
  ++version;
  if (version === 1) events.open(open);
  else events.change({ document: open, contentChanges: [
    { range: new Range(position(same), position(before.length - tail)), text: now.slice(same, now.length - tail) }] });
}

/// A snippet as it is when nobody changes what it proposes.
function expanded(body) {
  let snippet = Array.isArray(body) ? body.join("\n") : body;
  const values = {};
  for (let before = ""; before !== snippet;) {
    before = snippet;
    snippet = snippet.replace(/\$\{(\d+):((?:[^${}\\]|\\.|\{[^{}]*\}|\$(?!\{))*)\}/, (_, n, value) => {
      values[n] = values[n] || value.replace(/\\(.)/g, "$1");
      return values[n];
    });
  }
  return snippet.replace(/\$(\d+)/g, (_, n) => values[n] || "");
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
  const [part] = await providers.formatRange.provideDocumentRangeFormattingEdits(
    open, new Range(new Position(1, 0), new Position(1, 3)));
  assert.strictEqual(part.newText, "    sphere { 0, 1 }\n");

  fs.writeFileSync(path.join(folder, "b.inc"), "#declare Shared = 1;\n");
  type("#include \"b.inc\"\n// \u{1F4A1}\n// two\n#macro M(A)\nunion {\n  sphere { 0, A }\n}\n#end\nM(Shared)\n");
  const meanings = await providers.meanings.provideDocumentSemanticTokens(open);
  assert(meanings.data instanceof Uint32Array && meanings.data.length % 5 === 0 && meanings.data.length > 50);
  const some = await providers.meaningsOfRange.provideDocumentRangeSemanticTokens(
    open, new Range(new Position(8, 0), new Position(8, 9)));
  assert.deepStrictEqual([...some.data].map((n, i) => (i % 5 === 3 ? -1 : n)), [8, 0, 1, -1, 0, 0, 2, 6, -1, 0]);
  const folds = await providers.folds.provideFoldingRanges(open);
  assert.deepStrictEqual(folds.map(f => [f.start, f.end, f.kind]), [[1, 2, 1], [3, 6, undefined], [4, 5, undefined]]);
  const links = await providers.links.provideDocumentLinks(open);
  assert.deepStrictEqual(links.map(l => l.target), ["file://" + path.join(folder, "b.inc")]);
  const lit = await providers.highlights.provideDocumentHighlights(open, new Position(5, 14));
  assert.deepStrictEqual(lit.map(h => h.kind), [2, 1]);
  assert.deepStrictEqual((await providers.names.provideWorkspaceSymbols("sh")).map(n => n.name), ["Shared"]);
  const [symbol] = await providers.symbols.provideDocumentSymbols(open);
  assert.deepStrictEqual([symbol.range.start.line, symbol.range.end.line], [3, 7]);

  type("camera { location -5*z look_at 0 }\nsphere { 0, 1 pigment { rgb 1 } finish { emission 1 } }\n");
  await commands["candelabra.render"]();
  const picture = path.join(folder, "a.png");
  await until("a picture", () => opened.length > 0);
  assert.deepStrictEqual(opened, [["vscode.open", "file://" + picture]]);
  assert(fs.statSync(picture).size > 100);
  await commands["candelabra.preview"]();
  const [panel] = panels;
  assert.match(panel.webview.html, /default-src 'none'/);
  await until("a preview", () => panel.sent.some(state => state.png));
  assert.strictEqual(Buffer.from(panel.sent.find(state => state.png).png, "base64").toString("latin1", 1, 4), "PNG");
  fs.writeFileSync(scene, "shpere { 0, 1 }\n");
  await until("a mistake in the preview", () => panel.sent.some(state => state.errors.includes("shpere")));
  panel.dispose();

  const own = path.join(__dirname, "../../src/packaging/vscode");
  const facts = JSON.parse(fs.readFileSync(path.join(own, "package.json")));
  for (const { command } of facts.contributes.commands) assert(commands[command], command);
  const [matcher] = facts.contributes.problemMatchers;
  const [first, second] = matcher.pattern.map(p => new RegExp(p.regexp));
  const said = spawnSync(process.argv[2], ["a.pov"], { cwd: folder }).stderr.toString().split("\n");
  const at = said.findIndex((line, i) => first.test(line) && second.test(said[i + 1] || ""));
  assert.match(first.exec(said[at])[2], /shpere/);
  assert.deepStrictEqual(second.exec(said[at + 1]).slice(1), ["a.pov", "1", "1"]);
  const snippets = JSON.parse(fs.readFileSync(path.join(own, "snippets.json")));
  for (const [name, { body }] of Object.entries(snippets)) {
    const inner = name === "Microfacet finish" ? `sphere { 0, 1 ${expanded(body)} }` : expanded(body);
    fs.writeFileSync(scene, inner);
    const check = spawnSync(process.argv[2], ["--check", "a.pov"], { cwd: folder });
    assert.strictEqual(check.status, 0, name + "\n" + inner + "\n" + check.stderr);
  }
  await extension.deactivate();
  console.log("the extension works");
})().catch(error => {
  console.error(error);
  process.exit(1);
});
