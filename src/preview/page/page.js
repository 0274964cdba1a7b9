// SPDX-License-Identifier: GPL-3.0-or-later
// What the program says: the status is asked for, and answered when it changes. `#lights` in the
// address opens the report of light, `#view=normal` a layer, `#pick=10,20` a pixel.
const asked = new URLSearchParams(location.hash.slice(1));
let wanted = asked.has("pick") ? asked.get("pick").split(",").map(Number) : null;
let version = -1, shown = 0, first = true, paused = false;

function inWords(seconds) {
  if (seconds < 0) return "";
  if (seconds < 60) return Math.ceil(seconds) + " s left";
  if (seconds < 3600) return `${Math.floor(seconds / 60)} min ${Math.round(seconds % 60)} s left`;
  return `${Math.floor(seconds / 3600)} h ${Math.round(seconds % 3600 / 60)} min left`;
}

// A text with links to the scene, if it is another one.
function showText(target, text) {
  if (target.textContent !== text) linkify(target, text);
}
function showMessages(status) {
  showText(element("errors"), status.errors);
  const count = status.warnings.length + status.more_warnings, bar = element("warnings");
  bar.hidden = count === 0;
  bar.querySelector("summary").textContent = count === 1 ? "1 warning" : `${count} warnings`;
  const more = status.more_warnings > 0 ? `\n… and ${status.more_warnings} more\n` : "";
  showText(bar.querySelector("pre"), status.warnings.join("\n") + more);
  element("panel-console").hidden = status.said === "";
  showText(element("said"), status.said);
}

function showStanding(status) {
  showMessages(status);
  const state = status.errors ? "mistake in the scene" : status.paused ? "paused"
    : status.progress === 1 ? "finished" : status.busy ? "rendering" : "";
  element("status").textContent = [status.line, state].filter(part => part).join(" · ");
  element("samples").textContent =
    status.samples > 0 ? `${+status.samples.toPrecision(3)} samples` : "";
  element("noise").textContent =
    status.samples > 1 ? `noise ${(100 * status.noise).toPrecision(2)} %` : "";
  element("left").textContent = status.busy && status.progress < 1 ? inWords(status.left) : "";
  element("bar").style.width = status.progress < 1 ? 100 * status.progress + "%" : "0";
  paused = status.paused;
  element("pause").title = paused ? "Go on (space)" : "Pause the rendering (space)";
  element("pause").querySelector("path").setAttribute(
    "d", paused ? "M6 4l10 6-10 6Z" : "M7 4v12M13 4v12");
}

function showViews(status) {
  const select = element("view");
  if (!select.options.length) select.append(...status.views.map(
    name => new Option(name.replace("_", " "), name)));
  if (document.activeElement !== select) select.value = status.view;
  element("badge").hidden = status.shown_view === "picture";
  element("badge").textContent = status.shown_view.replace("_", " ");
}

function apply(status) {
  folder = status.folder;
  version = status.version;
  showStanding(status);
  showViews(status);
  showLamps(status.lamps, status.lit_apart);
  showFilm(status.film);
  showKnobs(status.knobs);
  playOn(status);
  element("denoise").checked = status.denoise;
  element("camera-reset").disabled = !status.moved;
  element("film-reset").disabled = !status.film_changed;
  element("lamps-reset").disabled = !status.relit;
  cameraMoves = status.can_move;
  element("tool-camera").disabled = !cameraMoves;
  if (first && asked.has("view")) post("/look", { view: asked.get("view") });
  if (first && asked.has("lights")) element("panel-report").open = true;
  first = false;
}

async function follow() {
  try {
    const status = await (await fetch("/status?since=" + version)).json();
    apply(status);
    if (status.picture !== shown) {
      const answer = await fetch("/picture");
      if (answer.ok) {
        take(await answer.arrayBuffer());
        shown = status.picture;
        document.body.dataset.picture = shown;
      }
    }
    if (wanted && status.progress === 1) {
      pickPixel(...wanted);
      wanted = null;
    }
    if (status.progress === 1) report();
    setTimeout(follow, 0);
  } catch {
    version = -1;
    element("status").textContent = "the program has ended";
    setTimeout(follow, 1000);
  }
}
element("pause").addEventListener("click", () => post("/pause", { on: paused ? "no" : "yes" }));
place();
follow();
