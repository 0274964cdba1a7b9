// SPDX-License-Identifier: GPL-3.0-or-later
// The panel of the scene: its own widgets, sets of their values, and frames that are played.
// Frames one behind the other, each as soon as the whole picture of the last one can be seen.
const isFrame = knob => ["frame_number", "clock"].includes(knob.name);
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
           sceneName() + ".set.json");
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
