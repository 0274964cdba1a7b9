// SPDX-License-Identifier: GPL-3.0-or-later
// The page of the preview: plain HTML, CSS and JavaScript in one text. It asks /status twice a
// second and takes a new /picture.png, or a layer as /view.png, when there is one; where one looks
// (pan, zoom) is the page's own business, and so outlives every change of the scene. What it
// changes, it sends to /turn. `#lights` in its address opens the report of light, `#view=normal` a
// layer, `#pick=10,20` a pixel.
#pragma once

#include <string_view>

namespace candelabra {

/// Is replaced by the token that the page needs to turn knobs (web/request.h).
inline constexpr std::string_view token_place = "TOKEN-OF-THIS-RUN";

inline constexpr char preview_page[] = R"page(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="token" content="TOKEN-OF-THIS-RUN">
<title>Candelabra</title>
<style>
body { margin: 0; background: #222; color: #ddd; font: 14px sans-serif; overflow: hidden; }
#stage { position: absolute; inset: 0 0 2em 0; overflow: hidden; cursor: grab; }
#picture { position: absolute; transform-origin: 0 0; image-rendering: pixelated; }
#errors { position: absolute; left: 2em; right: 2em; top: 2em; max-height: 80%; overflow: auto;
  margin: 0; padding: 1em; background: #300e; border-left: 4px solid #f44; white-space: pre-wrap;
  font-family: monospace; }
#errors:empty { display: none; }
#line { position: absolute; left: 0; right: 0; bottom: 0; height: 2em; line-height: 2em;
  padding: 0 1em; background: #111; white-space: nowrap; display: flex; gap: 1em; }
#status { flex: 1; overflow: hidden; text-overflow: ellipsis; }
#bar { position: absolute; left: 0; bottom: 2em; height: 3px; background: #fb4; width: 0; }
#tools button, #tools select { background: #333; color: #ddd; border: 1px solid #555; }
pre.panel { position: absolute; left: 1em; bottom: 1em; max-width: 90%; max-height: 70%;
  overflow: auto; margin: 0; padding: 0.7em 1em; background: #111d; white-space: pre;
  font: 12px monospace; cursor: text; user-select: text; }
#lights { left: auto !important; right: 1em; }
pre.panel:empty, pre.panel.closed { display: none; }
#knobs { position: absolute; right: 1em; top: 1em; padding: 0.5em 1em; background: #111c; }
#knobs:empty { display: none; }
#knobs label { display: block; margin: 0.4em 0; }
#knobs input { width: 14em; vertical-align: middle; }
#knobs output { display: inline-block; width: 4em; text-align: right; }
</style>
</head>
<body>
<div id="stage"><img id="picture" alt=""><pre id="errors"></pre></div>
<div><pre id="picked" class="panel" style="bottom: 3em"></pre>
<pre id="lights" class="panel closed" style="bottom: 3em"></pre></div>
<form id="knobs"></form>
<div id="bar"></div>
<div id="line"><span id="status">waiting</span>
<span id="tools"><select id="view" title="what is shown"></select>
<button id="report" title="what each light gives and costs">lights</button></span></div>
<script src="/page.js"></script>
</body>
</html>
)page";

/// The page's program, which lies at /page.js: scripts within the page are not run.
inline constexpr char preview_script[] = R"page("use strict";
const element = name => document.getElementById(name);
const stage = element("stage"), picture = element("picture");
const view = { x: 20, y: 20, zoom: 1 };
let shown = -1, drag = null, wanted = null;
const asked = new URLSearchParams(location.hash.slice(1));
function place() {
  picture.style.transform = `translate(${view.x}px,${view.y}px) scale(${view.zoom})`;
}
stage.addEventListener("wheel", event => {
  event.preventDefault();
  const factor = Math.exp(-event.deltaY / 500);
  view.x = event.clientX - (event.clientX - view.x) * factor;
  view.y = event.clientY - (event.clientY - view.y) * factor;
  view.zoom *= factor;
  place();
}, { passive: false });
stage.addEventListener("pointerdown", event => {
  event.preventDefault();
  drag = { x: event.clientX - view.x, y: event.clientY - view.y, moved: false };
});
addEventListener("pointermove", event => {
  if (!drag) return;
  const x = event.clientX - drag.x, y = event.clientY - drag.y;
  drag.moved = drag.moved || Math.abs(x - view.x) + Math.abs(y - view.y) > 3;
  view.x = x;
  view.y = y;
  place();
});
addEventListener("pointerup", async event => {
  const click = drag && !drag.moved;
  drag = null;
  if (!click) return;
  pick(Math.floor((event.clientX - view.x) / view.zoom),
       Math.floor((event.clientY - view.y) / view.zoom));
});
async function pick(x, y) {
  element("picked").textContent = await (await fetch(`/pick?x=${x}&y=${y}`)).text();
}
element("report").addEventListener("click", () => element("lights").classList.toggle("closed"));
element("view").addEventListener("change", showPicture);
function showPicture() {
  const name = element("view").value;
  picture.src = name === "picture" ? "/picture.png?" + shown : `/view.png?name=${name}&n=${shown}`;
}
function showViews(views) {
  if (element("view").options.length) return;
  element("view").append(...views.map(name => new Option(name)));
  if (asked.has("view")) element("view").value = asked.get("view");
  if (asked.has("lights")) element("lights").classList.remove("closed");
  if (asked.has("pick")) wanted = asked.get("pick").split(",");
}
let known = "";
const token = document.querySelector("meta[name=token]").content;
async function turn(knob, input, output) {
  output.value = input.value;
  const body = new URLSearchParams({ name: knob.name, value: input.value });
  const answer = await fetch("/turn", { method: "POST", headers: { "X-Token": token }, body });
  if (answer.status === 403) location.reload();  // the program has been started again
}
function showKnobs(knobs) {
  const form = JSON.stringify(knobs.map(({ value, ...form }) => form));
  if (form === known) return;
  known = form;
  element("knobs").replaceChildren(...knobs.map(knob => {
    const label = document.createElement("label"), input = document.createElement("input");
    const output = document.createElement("output");
    Object.assign(input, { type: "range", min: knob.low, max: knob.high, step: knob.step });
    input.value = output.value = knob.value;
    input.addEventListener("input", () => turn(knob, input, output));
    label.title = knob.help;
    label.append(knob.name + " ", input, output);
    return label;
  }));
}
async function ask() {
  try {
    const status = await (await fetch("/status")).json();
    element("errors").textContent = status.errors;
    element("status").textContent = status.line;
    element("lights").textContent = status.lights;
    showViews(status.views);
    showKnobs(status.knobs);
    element("bar").style.width = 100 * status.progress + "%";
    if (status.picture !== shown) {
      shown = status.picture;
      showPicture();
    }
    if (wanted && status.progress === 1) {
      pick(...wanted);
      wanted = null;
    }
  } catch {
    element("status").textContent = "the program has ended";
  }
  setTimeout(ask, 500);
}
place();
ask();
)page";

}  // namespace candelabra
