// SPDX-License-Identifier: GPL-3.0-or-later
// The panel of a pixel, and places of the text as links. linkTo(path, line) has the properties of a link
// to such a place; null: there is none.
function linkify(target, text) {
  target.replaceChildren();
  let last = 0;
  for (const match of text.matchAll(/([^\s:]+):(\d+)(?=: |:\d)/g)) {
    target.append(text.slice(last, match.index));
    last = match.index + match[0].length;
    const link = linkTo(match[1], match[2]);
    target.append(link ? make("a", { ...link, textContent: match[0] }) : match[0]);
  }
  if (last < text.length) target.append(text.slice(last));
}
async function pick(x, y) {
  const text = await ask(`/pick?x=${x}&y=${y}`);
  element("pick-hint").hidden = text !== "";
  linkify(element("picked"), text);
  element("panel-pick").open = true;
  element("panel-pick").scrollIntoView({ block: "nearest" });
}
