// SPDX-License-Identifier: GPL-3.0-or-later
// The panels: lamps, film, camera, sliders of the scene, what is under a pixel, the report.
let held = null;  // what a hand is on keeps its value, whatever the program says
addEventListener("pointerdown", event => { held = event.target.closest("input") || null; }, true);
addEventListener("pointerup", () => { held = null; }, true);

function toast(text) {
  element("toast").textContent = text;
  element("toast").hidden = false;
  clearTimeout(toast.over);
  toast.over = setTimeout(() => { element("toast").hidden = true; }, 2500);
}

function make(tag, properties = {}, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

function setValue(input, value) {
  if (input !== held && document.activeElement !== input) input.value = value;
  else if (input !== held && input.type === "range") input.value = value;
}

// A slider with its name and value. `show`: the value in words.
function slider(name, help, range, send, show = value => value) {
  const input = make("input", { type: "range", ...range });
  const output = make("output");
  const row = make("label", { className: "slider", title: help || "" },
                   make("span", { textContent: name }), output, input);
  input.setAttribute("aria-label", name);
  input.addEventListener("input", () => {
    output.value = show(Number(input.value));
    send(Number(input.value));
  });
  row.set = value => {
    if (input === held) return;
    setValue(input, value);
    output.value = show(value);
  };
  return row;
}

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
const linear = byte => {
  const value = byte / 255;
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
};
const encoded = value =>
  Math.round(255 * (value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055));
const hex = colour =>
  "#" + colour.map(v => encoded(Math.min(1, v)).toString(16).padStart(2, "0")).join("");
const fromHex = text => [1, 3, 5].map(i => linear(parseInt(text.slice(i, i + 2), 16)));
const greatestStrength = 4;

function lampRow(lamp, index) {
  const on = make("input", { type: "checkbox", title: "On or off" });
  const colour = make("input", { type: "color", title: "Colour of its light" });
  const strength = make("input", { type: "range", min: 0, max: greatestStrength, step: 0.01 });
  const output = make("output"), share = make("i");
  const only = make("button", { textContent: "Only", title: "This lamp alone, or all again" });
  for (const [input, says] of [[on, "on"], [colour, "colour"], [strength, "strength"]])
    input.setAttribute("aria-label", `${lamp.name}: ${says}`);
  const send = sender("/dim");
  let usual = 1;  // the strength to which it is switched on
  const row = make("div", { className: "lamp" }, on,
                   make("span", { className: "name", textContent: lamp.name }), output, colour,
                   strength, make("div", { className: "share" }, share),
                   make("span", { className: "from" }));
  strength.style.gridColumn = "1 / 4";
  row.insertBefore(only, strength.nextSibling);
  only.style.cssText = "height: 1.4rem; padding: 0 .4rem; font-size: .75rem";
  linkify(row.lastChild, lamp.statement);
  const tell = () => {
    const [red, green, blue] = fromHex(colour.value);
    output.value = Number(strength.value).toFixed(2) + "×";
    row.classList.toggle("off", Number(strength.value) === 0);
    send({ lamp: index, strength: strength.value, red, green, blue });
  };
  const put = value => {
    if (Number(strength.value) > 0) usual = Number(strength.value);
    strength.value = value;
    on.checked = value > 0;
    tell();
  };
  on.addEventListener("change", () => put(on.checked ? usual : 0));
  strength.addEventListener("input", () => {
    on.checked = Number(strength.value) > 0;
    tell();
  });
  colour.addEventListener("input", tell);
  only.addEventListener("click", () => {
    const alone = lampRows.every(each => each === row || !each.lit());
    for (const each of lampRows) each.put(alone || each === row ? 1 : 0);
  });
  row.put = put;
  row.lit = () => Number(strength.value) > 0;
  row.set = (lamp, most) => {
    setValue(strength, lamp.strength);
    setValue(colour, hex(lamp.colour));
    output.value = Number(strength.value).toFixed(2) + "×";
    on.checked = Number(strength.value) > 0;
    row.classList.toggle("off", !on.checked);
    const grey = Math.max(...lamp.shown);
    share.style.width = (most > 0 ? 100 * grey / most : 0) + "%";
  };
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
  const most = Math.max(0, ...lamps.map(lamp => Math.max(...lamp.shown)));
  lamps.forEach((lamp, i) => lampRows[i].set(lamp, most));
  element("lamps-hint").hidden = apart;
  element("lamps-reset").parentElement.hidden = !apart;
  if (!apart && lamps.length > 0)
    element("lamps-hint").textContent =
      "There are too many lamps for a picture of this size: make it smaller, or group them.";
}
element("lamps-reset").addEventListener("click", () => post("/dim", { reset: "all" }));

// Film.
const film = {};
const develop = name => {
  const send = sender("/develop");
  return value => send({ name, value });
};
const stops = value => (value > 0 ? "+" : "") + value.toFixed(2) + " stops";
const share = value => (100 * value).toFixed(0) + " %";
function selectOf(name, options, send) {
  const select = make("select", {}, ...options.map(each => new Option(each)));
  select.setAttribute("aria-label", name);
  select.addEventListener("change", () => send(select.value));
  const row = make("label", { className: "field" }, make("span", { textContent: name }), select);
  row.set = value => setValue(select, value);
  return row;
}
function checkOf(name, send) {
  const input = make("input", { type: "checkbox" });
  input.addEventListener("change", () => send(input.checked ? "on" : "off"));
  const row = make("label", { className: "check" }, input, name);
  row.set = value => { input.checked = value; };
  return row;
}
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

// The scene's own sliders.
let knownKnobs = "", knobRows = [];
function showKnobs(knobs) {
  const form = JSON.stringify(knobs.map(({ value, ...form }) => form));
  if (form !== knownKnobs) {
    knownKnobs = form;
    knobRows = knobs.map(knob => {
      const send = sender("/turn");
      return slider(knob.name, knob.help, { min: knob.low, max: knob.high, step: knob.step },
                    value => send({ name: knob.name, value }), value => +value.toPrecision(6));
    });
    element("knobs").replaceChildren(...knobRows);
    element("panel-knobs").hidden = knobs.length === 0;
  }
  knobs.forEach((knob, i) => knobRows[i].set(knob.value));
}

// Places of the text, as links into an editor.
const editors = { "VS Code": "vscode://file", VSCodium: "vscodium://file", Cursor: "cursor://file",
                  Zed: "zed://file", "no editor": "" };
element("editor").append(...Object.keys(editors).map(name => new Option(name)));
element("editor").value = localStorage.getItem("editor") || "VS Code";
element("editor").addEventListener("change", () => {
  localStorage.setItem("editor", element("editor").value);
  linkify(element("picked"), element("picked").textContent);
});
let folder = "";
function linkify(target, text) {
  const start = editors[element("editor").value];
  target.replaceChildren();
  let last = 0;
  for (const match of text.matchAll(/([^\s:]+):(\d+)(?=: )/g)) {
    target.append(text.slice(last, match.index));
    last = match.index + match[0].length;
    const path = match[1].startsWith("/") ? match[1] : folder + "/" + match[1];
    target.append(start ? make("a", { href: `${start}${encodeURI(path)}:${match[2]}`,
                                      textContent: match[0] }) : match[0]);
  }
  target.append(text.slice(last));
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
function useTheme(name) {
  document.documentElement.dataset.theme = name;
}
const dark = matchMedia("(prefers-color-scheme: dark)");
useTheme(localStorage.getItem("theme") || (dark.matches ? "dark" : "light"));
element("theme").addEventListener("click", () => {
  const name = document.documentElement.dataset.theme === "dark" ? "light" : "dark";
  localStorage.setItem("theme", name);
  useTheme(name);
});
element("help").addEventListener("click", () => element("keys").showModal());
element("keys-close").addEventListener("click", () => element("keys").close());
if (innerWidth <= 760) document.body.classList.add("without-panels");
showPanelButton();
makeFilm();
