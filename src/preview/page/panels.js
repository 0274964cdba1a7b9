// SPDX-License-Identifier: GPL-3.0-or-later
// The panels: lamps, film, camera, sliders of the scene, what is under a pixel, the report.
async function copy(address, name) {
  const text = await (await fetch(address)).text();
  try {
    await navigator.clipboard.writeText(text);
    toast(name + " copied as script");
  } catch {
    element("picked").textContent = text;
    element("panel-pick").open = true;
    toast("The clipboard is closed: the text is in the panel Pixel");
  }
}

// Lamps.
function lampRow(lamp, index) {
  const send = sender("/dim");
  const row = lampCard(lamp.name, (strength, [red, green, blue]) =>
    send({ lamp: index, strength, red, green, blue }), () => lampRows);
  linkify(row.from, lamp.statement);
  return row;
}

let lampRows = [], knownLamps = "";
function showLamps(lamps, apart) {
  const names = JSON.stringify(lamps.map(lamp => [lamp.name, lamp.statement]));
  if (names !== knownLamps) {
    knownLamps = names;
    lampRows = lamps.map(lampRow);
    element("lamps").replaceChildren(...(apart ? lampRows : []));
  }
  lampsNow = lamps;
  const most = Math.max(0, ...lamps.map(lamp => Math.max(...lamp.shown)));
  lamps.forEach((lamp, i) => lampRows[i].set(
    lamp.strength, lamp.colour, most > 0 ? Math.max(...lamp.shown) / most : 0));
  element("lamps-hint").hidden = apart;
  element("lamps-reset").parentElement.hidden = !apart;
  if (!apart && lamps.length > 0)
    element("lamps-hint").textContent =
      "There are too many lamps for a picture of this size: make it smaller, or group them.";
}
element("lamps-reset").addEventListener("click", () => post("/dim", { reset: "all" }));
let lampsNow = [];
element("lamps-save").addEventListener("click", () =>
  saveFile(lampsAsJson(lampsNow), element("scene").textContent.replace(/\.\w+$/, "") + ".json"));

// Film.
const film = {};
const develop = name => {
  const send = sender("/develop");
  return value => send({ name, value });
};
const share = value => (100 * value).toFixed(0) + " %";
function makeFilm() {
  film.exposure = slider("Exposure", "In stops: doublings of the light",
                         { min: -8, max: 8, step: 0.05 }, develop("exposure"), stops);
  film.auto = checkOf("As the picture itself asks for", develop("auto"));
  film.key = slider("Key", "Luminance that the whole picture is given", { min: 0.02, max: 0.5, step: 0.01 },
                    develop("key"), value => value.toFixed(2));
  film.response = selectOf("Response", ["linear", "filmic", "agx"], develop("response"));
  film.contrast = slider("Contrast", "Exponent of the light around a middle grey",
                         { min: 0.5, max: 2, step: 0.05 }, develop("contrast"), value => value.toFixed(2));
  film.saturation = slider("Saturation", "Distance of colours from grey; 0: black and white",
                           { min: 0, max: 2, step: 0.05 }, develop("saturation"), value => value.toFixed(2));
  film.white_balance = slider("White", "Kelvins of a light that looks white",
                              { min: 1900, max: 12000, step: 100 },
                              develop("white_balance"), value => value <= 1900 ? "as it is" : value + " K");
  film.glare = checkOf("Glare", develop("glare"));
  const part = (name, help, max) =>
    slider(name, help, { min: 0, max, step: 0.005 }, develop("glare." + name.toLowerCase()), share);
  film.veil = part("Veil", "Light that is scattered around each lamp", 0.5);
  film.halo = part("Halo", "Light in the ring around each lamp", 0.1);
  film.star = part("Star", "Light in the rays of the aperture", 0.2);
  film.vignette = slider("Vignette", "Light that corners lose", { min: 0, max: 1, step: 0.01 },
                         develop("vignette"), share);
  element("film").replaceChildren(...Object.values(film));
}
function showFilm(settings) {
  for (const [name, row] of Object.entries(film)) row.set(settings[name]);
  for (const name of ["veil", "halo", "star"]) film[name].hidden = !settings.glare;
  film.key.hidden = !settings.auto;
  film.now = settings.exposure;
}
Object.defineProperty(film, "now", { value: 0, writable: true, enumerable: false });
function expose(more) {
  film.now = Math.min(8, Math.max(-8, film.now + more));
  develop("exposure")(film.now);
  toast(stops(film.now));
}
element("film-reset").addEventListener("click", () => post("/develop", { name: "reset" }));
element("film-copy").addEventListener("click", () => copy("/film", "Film"));
element("camera-copy").addEventListener("click", () => copy("/camera", "Camera"));
element("camera-reset").addEventListener("click", resetCamera);

// Frames one behind the other, each as soon as the whole picture of the last one can be seen.
const isFrame = knob => knob.name === "frame_number";
const player = { plays: false, after: -1, button: make("button", { textContent: "Play" }) };
player.button.addEventListener("click", () => {
  player.plays = !player.plays;
  player.after = -1;
  player.button.textContent = player.plays ? "Stop" : "Play";
  if (player.plays) playOn(player.last);
});
function playOn(status) {
  player.last = status;
  const frame = status.knobs.find(isFrame);
  const seen = status.generation > player.after && status.columns === status.width;
  if (!player.plays || !frame || !seen || status.errors) return;
  player.after = status.generation;
  const next = frame.value + frame.step;
  post("/turn", { name: frame.name, value: next > frame.high ? frame.low : next });
}

// The scene's own widgets.
let knownKnobs = "", knobRows = [], knobsNow = [];
function showKnobs(knobs) {
  const form = JSON.stringify(knobs.map(({ value, ...form }) => form));
  if (form !== knownKnobs) {
    knownKnobs = form;
    const send = sender("/turn");
    knobRows = knobs.map(knob => knobRow(knob, value => send({ name: knob.name, value })));
    element("knobs").replaceChildren(...withSections(knobs, knobRows));
    if (knobs.some(isFrame)) element("knobs").append(player.button);
    element("panel-knobs").hidden = knobs.length === 0;
    element("set-save").parentElement.hidden = knobs.every(isFrame);
  }
  knobsNow = knobs;
  knobs.forEach((knob, i) => knobRows[i].set(knob.value));
}

// Sets of values, as --preset reads them.
element("set-save").addEventListener("click", () => {
  const values = knobsNow.filter(knob => !isFrame(knob)).map(knob =>
    [knob.name, knob.kind === "colour" ? { rgb: knob.value } : knob.value]);
  saveFile(JSON.stringify(Object.fromEntries(values), null, 1) + "\n",
           element("scene").textContent.replace(/\.\w+$/, "") + ".set.json");
});
element("set-load").addEventListener("click", () => element("set-file").click());
element("set-file").addEventListener("change", async () => {
  const file = element("set-file").files[0];
  element("set-file").value = "";
  if (!file) return;
  try {
    const values = JSON.parse(await file.text());
    for (const knob of knobsNow) {
      const value = values[knob.name];
      if (value === undefined) continue;
      const text = typeof value === "boolean" ? Number(value) : value.rgb || value;
      post("/turn", { name: knob.name, value: String(text) });
    }
  } catch {
    toast("This file has no set of values");
  }
});

// Places of the text, as links into an editor.
const editors = { "VS Code": "vscode://file", VSCodium: "vscodium://file", Cursor: "cursor://file",
                  Zed: "zed://file", "no editor": "" };
element("editor").append(...Object.keys(editors).map(name => new Option(name)));
element("editor").value = localStorage.getItem("editor") || "VS Code";
element("editor").addEventListener("change", () => {
  localStorage.setItem("editor", element("editor").value);
  for (const name of ["picked", "errors", "said"])
    linkify(element(name), element(name).textContent);
});
let folder = "";
function linkify(target, text) {
  const start = editors[element("editor").value];
  target.replaceChildren();
  let last = 0;
  for (const match of text.matchAll(/([^\s:]+):(\d+)(?=: |:\d)/g)) {
    target.append(text.slice(last, match.index));
    last = match.index + match[0].length;
    const path = match[1].startsWith("/") ? match[1] : folder + "/" + match[1];
    target.append(start ? make("a", { href: `${start}${encodeURI(path)}:${match[2]}`,
                                      textContent: match[0] }) : match[0]);
  }
  if (last < text.length) target.append(text.slice(last));
}
async function pick(x, y) {
  if (x < 0 || y < 0 || x >= now.width || y >= now.height) return;
  const text = await (await fetch(`/pick?x=${x}&y=${y}`)).text();
  element("pick-hint").hidden = text !== "";
  linkify(element("picked"), text);
  element("panel-pick").open = true;
  document.body.classList.remove("without-panels");
  showPanelButton();
  element("panel-pick").scrollIntoView({ block: "nearest" });
}
async function report() {
  if (!element("panel-report").open) return;
  linkify(element("lights"), await (await fetch("/report")).text());
}
element("panel-report").addEventListener("toggle", report);

// Views.
function nextView(step = 1) {
  const select = element("view");
  select.selectedIndex = (select.selectedIndex + step) % select.options.length;
  post("/look", { view: select.value });
}
element("view").addEventListener("change", event => {
  post("/look", { view: event.target.value });
  event.target.blur();
});
element("denoise").addEventListener("change", event =>
  post("/look", { denoise: event.target.checked ? "on" : "off" }));

// The window.
function showPanelButton() {
  element("panel-button").setAttribute(
    "aria-pressed", !document.body.classList.contains("without-panels"));
}
element("panel-button").addEventListener("click", () => {
  document.body.classList.toggle("without-panels");
  showPanelButton();
});
element("help").addEventListener("click", () => element("keys").showModal());
element("keys-close").addEventListener("click", () => element("keys").close());
if (innerWidth <= 760) document.body.classList.add("without-panels");
showPanelButton();
makeFilm();
