// SPDX-License-Identifier: GPL-3.0-or-later
// The panel of lamps.
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
  saveFile(lampsAsJson(lampsNow), sceneName() + ".json"));
