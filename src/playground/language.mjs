// SPDX-License-Identifier: GPL-3.0-or-later
// What the page knows of the language, all of it from the program: colours from its TextMate grammar,
// completion and help from its language server.

const classes = [[/^comment/, "comment"], [/^string/, "string"], [/^constant\.numeric/, "number"],
  [/^constant/, "constant"], [/^keyword\.control/, "directive"], [/^support\.function/, "function"],
  [/^support\.type|^storage/, "colour"], [/^keyword\.operator/, "operator"], [/^keyword/, "word"]];

function classOf(scope) { return classes.find(([pattern]) => pattern.test(scope))?.[1] ?? ""; }

// A function that cuts a text into [first, last, class].
export function colourer(grammar) {
  const parts = [["comment", String.raw`\/\*[\s\S]*?(?:\*\/|$)`], ["string", String.raw`"(?:\\[\s\S]|[^"\\])*"?`]];
  for (const { name, match, captures } of grammar.patterns) {
    if (match && name) parts.push([classOf(name), match.replace(/\$$/, "(?=\\n|$)")]);
    else if (match && captures) parts.push([classOf(captures[1].name), String.raw`#\s*macro`]);
  }
  const whole = new RegExp(parts.map(([, pattern], i) => `(?<p${i}>${pattern})`).join("|"), "g");
  return function* (text) {
    for (const found of text.matchAll(whole)) {
      const index = parts.findIndex((_, i) => found.groups["p" + i] !== undefined);
      yield [found.index, found.index + found[0].length, parts[index][0]];
    }
  };
}

const header = "Content-Length: ";

function framed(messages) {
  return messages.map(each => {
    const text = JSON.stringify({ jsonrpc: "2.0", ...each });
    return `${header}${new TextEncoder().encode(text).length}\r\n\r\n${text}`;
  }).join("");
}

function unframed(text) {
  const bytes = new TextEncoder().encode(text), decoder = new TextDecoder(), messages = [];
  for (let at = 0; at < bytes.length;) {
    const end = decoder.decode(bytes.subarray(at, at + 80)).indexOf("\r\n\r\n");
    const length = Number(decoder.decode(bytes.subarray(at + header.length, at + end)));
    if (end < 0 || !(length >= 0)) break;
    messages.push(JSON.parse(decoder.decode(bytes.subarray(at + end + 4, at + end + 4 + length))));
    at += end + 4 + length;
  }
  return messages;
}

// Asks the language server about a text: a whole session in one run of the program.
export class Language {
  constructor(engine) { this.engine = engine; }

  // The result of a request such as textDocument/hover at a line and a character, from 0.
  async ask(method, text, files, line, character) {
    this.engine.stop("language");
    const uri = "file:///scene/scene.pov", textDocument = { uri };
    const input = framed([
      { id: 1, method: "initialize", params: { processId: null, rootUri: null, capabilities: {} } },
      { method: "initialized", params: {} },
      { method: "textDocument/didOpen", params: { textDocument: { uri, languageId: "pov", version: 1, text } } },
      { id: 2, method, params: { textDocument, position: { line, character } } },
      { id: 3, method: "shutdown" }, { method: "exit" }]);
    const { out } = await this.engine.run({ words: ["lsp"], files: { ...files, "scene.pov": text }, input }, "language");
    return unframed(out).find(each => each.id === 2)?.result ?? null;
  }
}
