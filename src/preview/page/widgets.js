// SPDX-License-Identifier: GPL-3.0-or-later
// What the pages are made of: sliders, cards of lamps, colours, light and dark. For the preview's
// page and for pages to share.
"use strict";
const element = id => document.getElementById(id);
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

// Colours: of light from 0 on, and of screens as #rrggbb.
const linear = byte => {
  const value = byte / 255;
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
};
const encoded = value =>
  Math.round(255 * (value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055));
const hex = colour =>
  "#" + colour.map(v => encoded(Math.min(1, v)).toString(16).padStart(2, "0")).join("");
const fromHex = text => [1, 3, 5].map(i => linear(parseInt(text.slice(i, i + 2), 16)));
const stops = value => (value > 0 ? "+" : "") + value.toFixed(2) + " stops";

// A lamp with its strength and its colour, of which `send` is told. `all`: the cards beside it.
const greatestStrength = 4;
function lampCard(name, send, all) {
  const on = make("input", { type: "checkbox", title: "On or off" });
  const colour = make("input", { type: "color", title: "Colour of its light" });
  const strength = make("input", { type: "range", min: 0, max: greatestStrength, step: 0.01 });
  const output = make("output"), share = make("i"), from = make("span", { className: "from" });
  const only = make("button", { textContent: "Only", className: "only",
                                title: "This lamp alone, or all again" });
  for (const [input, says] of [[on, "on"], [colour, "colour"], [strength, "strength"]])
    input.setAttribute("aria-label", `${name}: ${says}`);
  let usual = 1;  // the strength to which it is switched on
  const row = make("div", { className: "lamp" }, on,
                   make("span", { className: "name", textContent: name, title: name }), output, colour,
                   strength, only, make("div", { className: "share" }, share), from);
  const show = () => {
    output.value = Number(strength.value).toFixed(2) + "×";
    row.classList.toggle("off", Number(strength.value) === 0);
  };
  const tell = () => {
    show();
    send(Number(strength.value), fromHex(colour.value));
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
    const alone = all().every(each => each === row || !each.lit());
    for (const each of all()) each.put(alone || each === row ? 1 : 0);
  });
  row.from = from;
  row.put = put;
  row.lit = () => Number(strength.value) > 0;
  row.set = (value, light, part) => {  // part: of the brightest lamp's light
    setValue(strength, value);
    setValue(colour, hex(light));
    on.checked = Number(strength.value) > 0;
    show();
    share.style.width = 100 * part + "%";
  };
  return row;
}

// Widgets of a scene's own, for what `knobs` says of it (src/editor/knobs.h). A value is sent as a
// text or a number.
const short = value => +value.toPrecision(6);
const knobKinds = {
  slider: (knob, send) =>
    slider(knob.name, knob.help, { min: knob.low, max: knob.high, step: knob.step }, send, short),
  toggle: (knob, send) => checkOf(knob.name, value => send(value === "on" ? 1 : 0)),
  list: (knob, send) => selectOf(knob.name, knob.choices.map(String), send),
  text: (knob, send) => fieldOf(knob.name, "text", "change", send),
  colour: (knob, send) => {
    const row = fieldOf(knob.name, "color", "input", value => send(fromHex(value).join(",")));
    const set = row.set;
    row.set = value => set(hex(value));
    return row;
  },
  vector: (knob, send) => {
    const values = [...knob.value];
    const rows = ["x", "y", "z"].map((axis, i) =>
      slider(`${knob.name}.${axis}`, knob.help, { min: knob.low, max: knob.high, step: knob.step },
             value => {
               values[i] = value;
               send(values.join(","));
             }, short));
    const row = make("div", {}, ...rows);
    row.set = value => value.forEach((each, i) => {
      values[i] = each;
      rows[i].set(each);
    });
    return row;
  },
};
function fieldOf(name, type, moment, send) {
  const input = make("input", { type });
  input.setAttribute("aria-label", name);
  input.addEventListener(moment, () => send(input.value));
  const row = make("label", { className: "field" }, make("span", { textContent: name }), input);
  row.set = value => setValue(input, value);
  return row;
}
function knobRow(knob, send) {
  const row = knobKinds[knob.kind](knob, send);
  row.title = knob.help;
  return row;
}
// The rows, each section below its name.
function withSections(knobs, rows) {
  return knobs.flatMap((knob, i) => {
    const begins = knob.section && (i === 0 || knobs[i - 1].section !== knob.section);
    return begins ? [make("h3", { textContent: knob.section }), rows[i]] : [rows[i]];
  });
}

// Saves bytes or a text as a file of this browser.
function saveFile(content, name) {
  const address = URL.createObjectURL(new Blob([content]));
  make("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 10000);
}
// Lamps of a name, a strength and a colour as `develop --lights` reads them.
function lampsAsJson(lamps) {
  return JSON.stringify(Object.fromEntries(lamps.map(({ name, strength, colour }) =>
    [name, { strength, colour: hex(colour) }])), null, 1) + "\n";
}

// Light or dark. Some browsers keep nothing for pages from a file.
function useTheme(name) {
  document.documentElement.dataset.theme = name;
}
function kept(name) {
  try { return localStorage.getItem(name); } catch { return null; }
}
useTheme(kept("theme") || (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light"));
element("theme").addEventListener("click", () => {
  const name = document.documentElement.dataset.theme === "dark" ? "light" : "dark";
  try { localStorage.setItem("theme", name); } catch { /* it lasts as long as the page */ }
  useTheme(name);
});
