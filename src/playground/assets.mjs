// SPDX-License-Identifier: GPL-3.0-or-later
// What the page is made of besides its text: the program, its library, examples and the grammar. They
// are files beside the page, or parts of it in the form that is one file.

async function inflated(text) {
  const bytes = Uint8Array.from(atob(text), c => c.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip")));
}

// The content of files, each a text or {base64}.
function contents(files) {
  const bytes = code => Uint8Array.from(atob(code), c => c.charCodeAt(0));
  return Object.fromEntries(Object.entries(files).map(([name, each]) =>
    [name, typeof each === "string" ? each : bytes(each.base64)]));
}

export async function loadAssets() {
  const inside = id => document.getElementById("part:" + id)?.textContent;
  const part = async id => inside(id) ? inflated(inside(id)) : fetch(id);
  const [compiled, parts, code] = await Promise.all([
    part("candelabra.wasm").then(found => found.arrayBuffer()).then(bytes => WebAssembly.compile(bytes)),
    part("parts.json").then(found => found.json()),
    part("worker.js").then(found => found.text()),
  ]);
  const address = URL.createObjectURL(new Blob([code], { type: "text/javascript" }));
  for (const example of Object.values(parts.examples)) example.files = contents(example.files);
  return { compiled, grammar: parts.grammar, examples: parts.examples, library: contents(parts.library), makeWorker: () => new Worker(address) };
}
