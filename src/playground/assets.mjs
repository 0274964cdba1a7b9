// SPDX-License-Identifier: GPL-3.0-or-later
// What the page is made of besides its text: the program, its library, examples and the grammar. They
// are files beside the page, or parts of it in the form that is one file.

// What a part of the page has packed, as an answer of this kind.
async function inflated(text, kind) {
  const { body } = await fetch("data:application/gzip;base64," + text);
  return new Response(body.pipeThrough(new DecompressionStream("gzip")), { headers: { "content-type": kind } });
}

// Compiles while the bytes come, which a server has to call by their kind.
async function compiledOf(answer) {
  const known = answer.headers.get("content-type")?.startsWith("application/wasm");
  return known ? WebAssembly.compileStreaming(answer) : WebAssembly.compile(await answer.arrayBuffer());
}

// The content of files, each a text or {base64}.
export function contents(files) {
  const bytes = code => Uint8Array.from(atob(code), c => c.charCodeAt(0));
  return Object.fromEntries(Object.entries(files).map(([name, each]) =>
    [name, typeof each === "string" ? each : bytes(each.base64)]));
}

export async function loadAssets() {
  const inside = id => document.getElementById("part:" + id)?.textContent;
  const part = async (id, kind) => inside(id) ? inflated(inside(id), kind) : fetch(id);
  const [compiled, parts, code] = await Promise.all([
    part("candelabra.wasm", "application/wasm").then(compiledOf),
    part("parts.json", "application/json").then(found => found.json()),
    part("worker.js", "text/javascript").then(found => found.text()),
  ]);
  const address = URL.createObjectURL(new Blob([code], { type: "text/javascript" }));
  for (const example of Object.values(parts.examples)) example.files = contents(example.files);
  return { compiled, grammar: parts.grammar, examples: parts.examples, library: contents(parts.library), makeWorker: () => new Worker(address) };
}
