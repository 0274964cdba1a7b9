// SPDX-License-Identifier: GPL-3.0-or-later
// The page: the text of a scene, and its picture, which becomes finer. Nothing leaves the page. The panels
// are those of the preview (src/preview/page/*_panel.js); a back end answers them.
import { contents, loadAssets } from "./assets.mjs";
import { BackEnd } from "./back_end.mjs";
import { Editor } from "./editor.mjs";
import { bandsOf, Engine, needsWhole, textsOf } from "./engine.mjs";
import { colourer, Language } from "./language.mjs";

const canvas = element("picture"), context = canvas.getContext("2d");
const workers = Math.min(8, Math.max(1, (navigator.hardwareConcurrency ?? 2) - 1));
// `#scene=` in the address is a scene, `#files=` what lies beside it, `#example=` the name of one, `#size=320x240`
// the size of the picture, `#samples=4` those of the last pass.
const asked = () => new URLSearchParams(location.hash.slice(1));
const finest = Number(asked().get("samples")) || 256;
// The first pass is small; each later one has the whole size.
const passes = [{ shrink: 4, samples: 1 }, ...[1, 4, 16, 64, 256].filter(samples => samples <= finest)
  .map(samples => ({ shrink: 1, samples }))];
// From here on the light of each lamp is kept, which the panels mix.
const leastOfLight = 16;

const assets = await loadAssets();
const engine = new Engine(assets), language = new Language(engine), files = {};
let generation = 0, soon = 0, drawn = 0, wholePicture = null;
const editor = new Editor({ colour: colourer(assets.grammar), language, files: () => files,
                            changed: () => later(400) });
const backEnd = new BackEnd({ engine, workers, size: sizeOfPicture, files: () => ({ ...files, "scene.pov": editor.text }),
                        relit: png => draw([png], ...sizeOfPicture()), changed: () => later(player.plays ? 0 : 150) });
Object.assign(globalThis, {
  ask: path => backEnd.ask(path),
  post: (path, form) => backEnd.post(path, form),
  sceneName: () => "scene",
  linkTo: (file, line) => file !== "scene.pov" ? null
    : { href: "#", onclick: event => { event.preventDefault(); editor.goToLine(Number(line)); } },
});

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

// ---- pictures

function sizeOfPicture() { return element("size").value.split("x").map(Number); }

async function draw(files, width, height, bands = [[1, height]]) {
  const pictures = await Promise.all(files.map(png => createImageBitmap(new Blob([png]), { colorSpaceConversion: "none" })));
  const [wide, high] = sizeOfPicture();
  if (canvas.width !== wide || canvas.height !== high) Object.assign(canvas, { width: wide, height: high });
  context.imageSmoothingEnabled = width !== wide;
  pictures.forEach((picture, i) => {
    const [first, last] = bands[i], rows = last - first + 1, scale = high / height;
    context.drawImage(picture, 0, first - 1, width, rows, 0, (first - 1) * scale, wide, rows * scale);
  });
  wholePicture = files.length === 1 && width === wide ? files[0] : null;
  document.body.dataset.drawn = String(++drawn);
}

// What a pass has made: the runs of the program, of which `bad` has failed, files of PNG for bands, and the
// light if it is kept.
async function pictureOf(width, height, samples, whole, told) {
  const bands = whole ? [[1, height]] : bandsOf(height, workers);
  const common = ["scene.pov", `+W${width}`, `+H${height}`, "--samples", String(samples), "--progress", "none",
                  "--diagnostics=json", "-o", "out.png", ...backEnd.sceneWords(), ...backEnd.filmWords()];
  const runs = await Promise.all(bands.map(async ([first, last]) => {
    const rows = bands.length > 1 ? [`+SR${first}`, `+ER${last}`] : [];
    const run = await engine.run({ words: [...common, ...rows], files: backEnd.sceneFiles(), wants: ["out.png"] }, "picture");
    told(bands.length);
    return run;
  }));
  return { bands, bad: runs.find(({ status, made }) => status !== 0 || !made["out.png"]), said: runs[0].err,
           pictures: runs.map(({ made }) => made["out.png"]) };
}
async function lightOf(width, height, samples, told) {
  const { bad, said, light, stats } = await backEnd.renderLight(width, height, samples, told);
  if (bad) return { bad };
  const run = await backEnd.developed(light);
  return { bad: run.made["out.png"] ? null : run, light, stats, said, pictures: [run.made["out.png"]] };
}

// One pass; returns a file of it if the next one may follow.
async function renderPass({ shrink, samples }, mine, whole) {
  const [width, height] = sizeOfPicture().map(each => Math.ceil(each / shrink));
  let done = 0;
  const told = count => { element("bar").style.width = 100 * ++done / count + "%"; };
  const apart = !backEnd.crowded && (backEnd.dims || (shrink === 1 && samples >= leastOfLight));
  let made = apart ? await lightOf(width, height, samples, told) : null;
  if (mine !== generation) return null;
  if (!made || made.bad) {
    done = 0;
    made = await pictureOf(width, height, samples, whole, told);
    if (mine !== generation) return null;
    if (apart && !made.bad) {  // the light of each lamp needs too much memory
      backEnd.crowded = true;
      backEnd.show();
    }
  }
  element("bar").style.width = "0";
  if (shrink > 1 || made.bad) showMessages(messagesOf(made.bad?.err ?? made.said));
  if (made.bad) return null;
  if (made.light && shrink === 1) backEnd.takeLight(made.light, made.stats);
  await draw(made.pictures, width, height, made.bands);
  return mine === generation ? made.pictures[0] : null;
}

// The film that a picture was developed by, as its head says it.
function filmIn(png) { return /developed=([^;]*)/.exec(Object.values(textsOf(png)).join(" "))?.[1]; }

async function render() {
  stop();
  backEnd.forget();
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
    if (pass.shrink > 1) askKnobs();
    if (!picture) {
      tell("mistake in the scene");
      element("stop").disabled = true;
      return;
    }
    whole = needsWhole(picture);
    if (backEnd.filmWords().length === 0) backEnd.takeFilm(filmIn(picture));
    document.body.dataset.passes = String(++count);
    element("time").textContent = ((performance.now() - begun) / 1000).toFixed(1) + " s";
    if (pass.shrink > 1) continue;
    playOn({ knobs: backEnd.shownKnobs(), generation: mine, columns: 1, width: 1 });
    if (player.plays) return;
  }
  document.body.dataset.passes = "all";
  tell("finished", inWords(passes.at(-1).samples), ((performance.now() - begun) / 1000).toFixed(1) + " s");
  element("stop").disabled = true;
}

// The scene's own widgets are those that its comments ask for.
async function askKnobs() {
  backEnd.takeKnobs(await language.ask("candelabra/knobs", editor.text, files, 0, 0) ?? []);
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

// The files beside the scene as JSON for contents(), packed; nothing if they are too large for an address.
const longestFiles = 100000;
async function packedFiles() {
  if (Object.values(files).reduce((sum, content) => sum + content.length, 0) > 10 * longestFiles) return "";
  const texts = Object.entries(files).map(([name, content]) => {
    if (typeof content === "string") return [name, content];
    try {
      return [name, new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(content)];
    } catch {
      return [name, { base64: btoa(Array.from(content, byte => String.fromCharCode(byte)).join("")) }];
    }
  });
  const code = await packed(JSON.stringify(Object.fromEntries(texts)));
  return code.length <= longestFiles ? code : "";
}

function addFile(name, content) {
  files[name] = content;
  element("file-list").textContent = "Files beside the scene: " + Object.keys(files).join(", ");
}

function showOwn(text) {
  element("examples").value = "";
  editor.text = text;
}

async function open(list) {
  for (const file of list) {
    if (/\.pov$/i.test(file.name)) showOwn(await file.text());
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
element("save-scene").onclick = () => saveFile(editor.text, "scene.pov");
element("save-picture").onclick = () => {
  if (wholePicture) saveFile(wholePicture, "scene.png");
  else canvas.toBlob(blob => saveFile(blob, "scene.png"));
};
element("save-light").onclick = () => saveFile(backEnd.light, "scene.exr");
canvas.addEventListener("click", event => {
  const box = canvas.getBoundingClientRect(), [width, height] = sizeOfPicture();
  const pixelAt = (place, begin, length, count) =>
    Math.min(Math.max(Math.floor((place + 0.5 - begin) / length * count), 0), count - 1);
  pick(pixelAt(event.clientX, box.left, box.width, width), pixelAt(event.clientY, box.top, box.height, height));
});
element("share").onclick = async () => {
  const any = Object.keys(files).length > 0, beside = any ? await packedFiles() : "";
  history.replaceState(null, "", "#scene=" + await packed(editor.text) + (beside && "&files=" + beside));
  try {
    await navigator.clipboard.writeText(location.href);
    toast(any && !beside ? "Copied; the files beside the scene are too large for the address" : "Copied");
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

// Files of an address lie beside its scene or in folders there: the library of the page is not theirs to replace.
function filesBeside(files) {
  for (const path of Object.keys(files))
    if (path.startsWith("/") || path.split("/").includes("..")) throw new RangeError(path + " is not beside the scene");
  return contents(files);
}

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
    const text = await unpacked(code);
    const beside = words.has("files") ? filesBeside(JSON.parse(await unpacked(words.get("files")))) : {};
    for (const [path, content] of Object.entries(beside)) addFile(path, content);
    showOwn(text);
    later(0);
  } catch {
    toast("The scene in this address is damaged");
    begin(Object.keys(assets.examples)[0]);
  }
}
window.addEventListener("hashchange", beginWithAddress);
backEnd.show();
playOn({ knobs: backEnd.shownKnobs(), generation: 0, columns: 0, width: 1 });
// One panel is open at a time.
for (const panel of document.querySelectorAll("#panels details")) Object.assign(panel, { name: "panels", open: panel.id === "panel-lamps" });
await beginWithAddress();
document.body.dataset.ready = "yes";
