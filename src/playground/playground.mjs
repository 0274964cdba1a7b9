// SPDX-License-Identifier: GPL-3.0-or-later
// The page: the text of a scene, and its picture, which becomes finer. Nothing leaves the page. Sliders
// and the like are those of the preview (src/preview/page/widgets.js).
import { loadAssets } from "./assets.mjs";
import { Editor } from "./editor.mjs";
import { bandsOf, Engine, needsWhole } from "./engine.mjs";
import { colourer, Language } from "./language.mjs";

const canvas = element("picture"), context = canvas.getContext("2d");
const workers = Math.min(8, Math.max(1, (navigator.hardwareConcurrency ?? 2) - 1));
// `#scene=` in the address is a scene, `#example=` the name of one, `#size=320x240` the size of the
// picture, `#samples=4` those of the last pass.
const asked = () => new URLSearchParams(location.hash.slice(1));
const finest = Number(asked().get("samples")) || 256;
// The first pass is small; each later one has the whole size.
const passes = [{ shrink: 4, samples: 1 }, ...[1, 4, 16, 64, 256].filter(samples => samples <= finest)
  .map(samples => ({ shrink: 1, samples }))];

const assets = await loadAssets();
const engine = new Engine(assets), language = new Language(engine), files = {};
let generation = 0, soon = 0, wholePicture = null;
const editor = new Editor({ colour: colourer(assets.grammar), language, files: () => files,
                            changed: () => later(400) });

function tell(status, samples = "", time = "") {
  element("status").textContent = status;
  element("samples").textContent = samples;
  element("time").textContent = time;
}

// ---- messages

// Messages are lines of JSON; what the scene prints itself stands between them.
function messagesOf(text) {
  return text.split("\n").filter(line => line.trim() !== "").map(line => {
    try {
      return JSON.parse(line);
    } catch {
      return { severity: "note", message: line };
    }
  });
}

// Places in the scene count bytes of UTF-8; the editor counts units of UTF-16.
function unitsOf(bytes) {
  return new TextDecoder().decode(new TextEncoder().encode(editor.text).subarray(0, bytes)).length;
}

function showMessages(messages) {
  const list = element("messages"), marks = [];
  list.replaceChildren();
  for (const { severity, message, label, help, place } of messages) {
    const item = document.createElement("button"), rest = document.createElement("small");
    const here = place?.file?.endsWith("scene.pov");
    item.className = severity;
    item.append(here ? `line ${place.line}: ${message}` : message);
    rest.textContent = [label, help].filter(part => part).join("\n");
    if (rest.textContent) item.append(rest);
    if (here) {
      const first = unitsOf(place.first);
      marks.push({ first, last: unitsOf(place.last), severity });
      item.onclick = () => editor.go(first);
    }
    list.append(item);
  }
  editor.mark(marks);
}

// ---- the scene's own widgets

let shownKnobs = "[]", knobValues = {};

// The value of a knob for --preset, of what its widget sends.
function valueOf(knob, sent) {
  if (knob.kind === "colour") return { rgb: sent.split(",").map(Number) };
  if (knob.kind === "vector") return sent.split(",").map(Number);
  return knob.kind === "list" && typeof knob.value === "number" ? Number(sent) : sent;
}

async function showKnobs() {
  const knobs = await language.ask("candelabra/knobs", editor.text, files, 0, 0) ?? [];
  const form = JSON.stringify(knobs);
  if (form === shownKnobs) return;
  shownKnobs = form;
  knobValues = {};
  const rows = knobs.map(knob => knobRow(knob, sent => {
    knobValues[knob.name] = valueOf(knob, sent);
    later(150);
  }));
  rows.forEach((row, i) => row.set(knobs[i].value));
  element("knobs").replaceChildren(...withSections(knobs, rows));
}

// ---- pictures

function sizeOfPicture() { return element("size").value.split("x").map(Number); }

function settings() {
  const words = [], exposure = Number(element("exposure").value), clock = Number(element("clock").value);
  if (exposure !== 0) words.push("--exposure", String(exposure));
  if (clock !== 0) words.push("+K" + clock);
  if (element("response").value) words.push("--response", element("response").value);
  if (Object.keys(knobValues).length > 0) words.push("--preset", "set.json");
  return words;
}

async function draw(results, width, height, bands) {
  const pictures = await Promise.all(results.map(({ made }) => createImageBitmap(new Blob([made["out.png"]]),
                                                                             { colorSpaceConversion: "none" })));
  const [wide, high] = sizeOfPicture();
  if (canvas.width !== wide || canvas.height !== high) Object.assign(canvas, { width: wide, height: high });
  context.imageSmoothingEnabled = width !== wide;
  pictures.forEach((picture, i) => {
    const [first, last] = bands[i], rows = last - first + 1, scale = high / height;
    context.drawImage(picture, 0, first - 1, width, rows, 0, (first - 1) * scale, wide, rows * scale);
  });
  wholePicture = results.length === 1 && width === wide ? results[0].made["out.png"] : null;
}

// One pass; returns whether the next one may follow.
async function renderPass({ shrink, samples }, mine, whole) {
  const [width, height] = sizeOfPicture().map(each => Math.ceil(each / shrink));
  const bands = whole ? [[1, height]] : bandsOf(height, workers);
  const common = ["scene.pov", `+W${width}`, `+H${height}`, "--samples", String(samples), "--progress", "none",
                  "--diagnostics=json", "-o", "out.png", ...settings()];
  let done = 0;
  const results = await Promise.all(bands.map(async ([first, last]) => {
    const rows = bands.length > 1 ? [`+SR${first}`, `+ER${last}`] : [];
    const result = await engine.run({ words: [...common, ...rows], files: { ...files, "scene.pov": editor.text, "set.json": JSON.stringify(knobValues) },
                                      wants: ["out.png"] }, "picture");
    element("bar").style.width = 100 * ++done / bands.length + "%";
    return result;
  }));
  if (mine !== generation) return null;
  element("bar").style.width = "0";
  const bad = results.find(({ status, made }) => status !== 0 || !made["out.png"]), good = !bad;
  if (shrink > 1 || bad) showMessages(messagesOf((bad ?? results[0]).err));
  if (good) await draw(results, width, height, bands);
  return good && mine === generation ? results[0].made["out.png"] : null;
}

async function render() {
  stop();
  const mine = ++generation, begun = performance.now();
  let count = 0;
  document.body.dataset.passes = "0";
  element("stop").disabled = false;
  let whole = true;
  const inWords = count => count === 1 ? "1 sample" : `${count} samples`;
  for (const pass of passes) {
    tell("rendering", pass.shrink > 1 ? "draft" : inWords(pass.samples));
    const picture = await renderPass(pass, mine, whole);
    if (mine !== generation) return;
    if (pass.shrink > 1) showKnobs();
    if (!picture) {
      tell("mistake in the scene");
      element("stop").disabled = true;
      return;
    }
    whole = needsWhole(picture);
    document.body.dataset.passes = String(++count);
    element("time").textContent = ((performance.now() - begun) / 1000).toFixed(1) + " s";
  }
  document.body.dataset.passes = "all";
  tell("finished", inWords(passes.at(-1).samples), ((performance.now() - begun) / 1000).toFixed(1) + " s");
  element("stop").disabled = true;
}

function stop() {
  ++generation;
  clearTimeout(soon);
  engine.stop("picture");
  element("bar").style.width = "0";
  element("stop").disabled = true;
  tell("stopped");
}

function later(milliseconds) {
  clearTimeout(soon);
  soon = setTimeout(render, milliseconds);
}

// ---- scenes in and out

async function through(bytes, stream) {
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
}
async function packed(text) {
  const bytes = await through(new TextEncoder().encode(text), new CompressionStream("deflate-raw"));
  return btoa(Array.from(bytes, byte => String.fromCharCode(byte)).join(""))
    .replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}
async function unpacked(code) {
  const bytes = Uint8Array.from(atob(code.replaceAll("-", "+").replaceAll("_", "/")), c => c.charCodeAt(0));
  return new TextDecoder().decode(await through(bytes, new DecompressionStream("deflate-raw")));
}

function addFile(name, content) {
  files[name] = content;
  element("file-list").textContent = "Files beside the scene: " + Object.keys(files).join(", ");
}

async function open(list) {
  for (const file of list) {
    if (/\.pov$/i.test(file.name)) editor.text = await file.text();
    else addFile(file.name, new Uint8Array(await file.arrayBuffer()));
  }
  later(0);
}

function begin(name) {
  const example = assets.examples[name];
  for (const [path, content] of Object.entries(example.files)) addFile(path, content);
  if (!asked().has("size")) element("size").value = example.size;
  editor.text = example.text;
  later(0);
}

element("examples").append(...Object.keys(assets.examples).map(name => new Option(name, name)));
element("examples").onchange = event => { history.replaceState(null, "", location.pathname); begin(event.target.value); };
element("open").onclick = () => element("files").click();
element("files").onchange = event => open(event.target.files);
element("run").onclick = render;
element("stop").onclick = stop;
element("size").onchange = render;
for (const id of ["exposure", "clock"])
  element(id).oninput = event => { element(id + "-value").textContent = event.target.value; later(150); };
element("response").onchange = render;
element("save-scene").onclick = () => saveFile(editor.text, "scene.pov");
element("save-picture").onclick = () => {
  if (wholePicture) saveFile(wholePicture, "scene.png");
  else canvas.toBlob(blob => saveFile(blob, "scene.png"));
};
element("share").onclick = async () => {
  history.replaceState(null, "", "#scene=" + await packed(editor.text));
  try {
    await navigator.clipboard.writeText(location.href);
    toast(Object.keys(files).length > 0 ? "Copied; the files beside the scene are not in the address" : "Copied");
  } catch {
    toast("The address of this page holds the scene");
  }
};
document.addEventListener("keydown", event => {
  if (event.key === "Enter" && event.ctrlKey) render();
  else if (event.key === "Escape") stop();
});
for (const kind of ["dragenter", "dragover", "dragleave", "drop"])
  document.addEventListener(kind, event => {
    if (!event.dataTransfer?.types.includes("Files")) return;
    event.preventDefault();
    document.body.classList.toggle("dropping", kind === "dragenter" || kind === "dragover");
    if (kind === "drop") open(event.dataTransfer.files);
  });

async function beginWithAddress() {
  const words = asked(), code = words.get("scene"), size = words.get("size"), name = words.get("example");
  if (/^\d{1,4}x\d{1,4}$/.test(size ?? "")) {
    if (![...element("size").options].some(each => each.value === size)) element("size").add(new Option(size, size));
    element("size").value = size;
  }
  if (!code) {
    const chosen = name in assets.examples ? name : Object.keys(assets.examples)[0];
    element("examples").value = chosen;
    return begin(chosen);
  }
  try {
    editor.text = await unpacked(code);
    later(0);
  } catch {
    toast("The scene in this address is damaged");
    begin(Object.keys(assets.examples)[0]);
  }
}
window.addEventListener("hashchange", beginWithAddress);
await beginWithAddress();
document.body.dataset.ready = "yes";
