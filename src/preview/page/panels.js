// SPDX-License-Identifier: GPL-3.0-or-later
// What the preview has besides the panels that it shares with the playground: links into editors, the
// camera, the report, layers.
element("camera-copy").addEventListener("click", () => copy("/camera", "Camera"));
element("camera-reset").addEventListener("click", resetCamera);

// Places of the text, as links into an editor.
const editors = { "VS Code": "vscode://file", VSCodium: "vscodium://file", Cursor: "cursor://file",
                  Zed: "zed://file", "no editor": "" };
element("editor").append(...Object.keys(editors).map(name => new Option(name)));
element("editors").hidden = false;
element("editor").value = localStorage.getItem("editor") || "VS Code";
element("editor").addEventListener("change", () => {
  localStorage.setItem("editor", element("editor").value);
  for (const name of ["picked", "errors", "said"])
    linkify(element(name), element(name).textContent);
});
let folder = "";
function linkTo(file, line) {
  const start = editors[element("editor").value];
  const path = file.startsWith("/") ? file : folder + "/" + file;
  return start ? { href: `${start}${encodeURI(path)}:${line}` } : null;
}
async function pickPixel(x, y) {
  if (x < 0 || y < 0 || x >= now.width || y >= now.height) return;
  document.body.classList.remove("without-panels");
  showPanelButton();
  await pick(x, y);
}
async function report() {
  if (!element("panel-report").open) return;
  linkify(element("lights"), await ask("/report"));
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
