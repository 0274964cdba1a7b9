// SPDX-License-Identifier: GPL-3.0-or-later
// What hands do: mouse, fingers and keys on the stage, for the picture or for the scene's camera.
const addMoves = (a, b) => ({ ...a, right: a.right + b.right, up: a.up + b.up });
const orbiting = {
  turn: sender("/orbit", addMoves),
  pan: sender("/orbit", addMoves),
  approach: sender("/orbit", (a, b) => ({ approach: a.approach * b.approach })),
};
const turnCamera = (right, up) => orbiting.turn({ by: "turn", right, up });
const panCamera = (right, up) => orbiting.pan({ by: "pan", right, up });
const approach = factor => orbiting.approach({ approach: factor });
const resetCamera = () => post("/orbit", { reset: "all" });
const pointAt = sender("/point");

let tool = "look", cameraMoves = true;
function choose(name) {
  tool = name === "camera" && cameraMoves ? "camera" : "look";
  for (const each of ["look", "camera"])
    element("tool-" + each).setAttribute("aria-pressed", each === tool);
  stage.classList.toggle("camera", tool === "camera");
}
element("tool-look").addEventListener("click", () => choose("look"));
element("tool-camera").addEventListener("click", () => choose("camera"));

const fingers = new Map();
let moved = false, pinch = null;
const degreesAcross = 200;
const at = event => {
  const box = stage.getBoundingClientRect();
  return { x: event.clientX - box.left, y: event.clientY - box.top };
};

stage.addEventListener("wheel", event => {
  event.preventDefault();
  const { x, y } = at(event);
  if ((tool === "camera") !== event.altKey && cameraMoves) approach(Math.exp(event.deltaY / 800));
  else zoomBy(Math.exp(-event.deltaY / 500), x, y);
}, { passive: false });

stage.addEventListener("pointerdown", event => {
  if (event.target === divider) return;
  stage.setPointerCapture(event.pointerId);
  fingers.set(event.pointerId, at(event));
  moved = moved && fingers.size > 1;
  pinch = null;
});
stage.addEventListener("contextmenu", event => tool === "camera" && event.preventDefault());

function drag(event, dx, dy) {
  const camera = (tool === "camera") !== event.altKey && cameraMoves;
  if (!camera) return moveBy(dx, dy);
  const across = event.shiftKey || event.buttons > 1;
  if (across) panCamera(-dx / (now.width * view.zoom), dy / (now.height * view.zoom));
  else turnCamera(-degreesAcross * dx / stage.clientWidth, degreesAcross * dy / stage.clientWidth);
}

// Two fingers zoom the picture, or go nearer.
function pinched() {
  const [a, b] = [...fingers.values()];
  const spread = Math.hypot(a.x - b.x, a.y - b.y);
  const middle = { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
  if (pinch && tool === "camera") {
    approach(pinch.spread / spread);
    panCamera(-(middle.x - pinch.middle.x) / (now.width * view.zoom),
              (middle.y - pinch.middle.y) / (now.height * view.zoom));
  } else if (pinch) {
    moveBy(middle.x - pinch.middle.x, middle.y - pinch.middle.y);
    zoomBy(spread / pinch.spread, middle.x, middle.y);
  }
  pinch = { spread, middle };
}

let pointed = 0;
stage.addEventListener("pointermove", event => {
  const here = at(event), last = fingers.get(event.pointerId);
  if (!last) return hover(here);
  if (!moved && Math.hypot(here.x - last.x, here.y - last.y) < 4) return;
  moved = true;
  stage.classList.add("dragging");
  fingers.set(event.pointerId, here);
  if (fingers.size === 2) pinched();
  else if (fingers.size === 1) drag(event, here.x - last.x, here.y - last.y);
});

// Where one points is rendered first.
function hover(here) {
  clearTimeout(pointed);
  const place = placeUnder(here.x, here.y);
  if (place.x < 0 || place.y < 0 || place.x > 1 || place.y > 1) return;
  pointed = setTimeout(() => pointAt(place), 120);
}

function lift(event) {
  const click = fingers.delete(event.pointerId) && !moved && fingers.size === 0;
  pinch = null;
  if (fingers.size > 0) return;
  moved = false;
  stage.classList.remove("dragging");
  if (!click || event.type === "pointercancel") return;
  const here = at(event), place = placeUnder(here.x, here.y);
  pickPixel(Math.floor(place.x * now.width), Math.floor(place.y * now.height));
}
stage.addEventListener("pointerup", lift);
stage.addEventListener("pointercancel", lift);

divider.addEventListener("pointerdown", event => divider.setPointerCapture(event.pointerId));
divider.addEventListener("pointermove", event => {
  if (!divider.hasPointerCapture(event.pointerId)) return;
  splitAt(Math.min(1, Math.max(0.001, at(event).x / stage.clientWidth)));
});

function toggleSplit() {
  if (compared.split !== null) return splitAt(null);
  if (!compared.image) return toast("There is no other picture yet: Keep this one");
  splitAt(0.5);
}
element("split").addEventListener("click", toggleSplit);
element("keep").addEventListener("click", () => {
  keep();
  toast("Kept: A/B compares with this picture");
});
element("fit").addEventListener("click", fit);
element("one").addEventListener("click", oneToOne);
function fullScreen() {
  if (document.fullscreenElement) document.exitFullscreen();
  else document.documentElement.requestFullscreen();
}
element("full").addEventListener("click", fullScreen);

function arrow(x, y) {
  const step = 40, degrees = 5;
  if (tool === "camera") turnCamera(x * degrees, y * degrees);
  else moveBy(-x * step, y * step);
}
const keys = {
  v: () => choose("look"), c: () => choose("camera"), f: fit, 1: oneToOne, 0: resetCamera,
  "+": () => zoomBy(1.25), "=": () => zoomBy(1.25), "-": () => zoomBy(0.8),
  ArrowLeft: () => arrow(-1, 0), ArrowRight: () => arrow(1, 0),
  ArrowUp: () => arrow(0, 1), ArrowDown: () => arrow(0, -1),
  "[": () => expose(-1 / 3), "]": () => expose(1 / 3), l: () => nextView(),
  s: toggleSplit, k: () => element("keep").click(), " ": () => element("pause").click(),
  p: () => element("panel-button").click(), t: () => element("theme").click(),
  Enter: fullScreen, "?": () => element("keys").showModal(),
};
addEventListener("keydown", event => {
  if (event.ctrlKey || event.metaKey || event.target.closest("input, select, dialog")) return;
  if (event.target.closest("button, a, summary") && (event.key === "Enter" || event.key === " ")) return;
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (key === "b" && !compared.holds) {
    compared.holds = true;
    draw();
  } else if (keys[key]) {
    event.preventDefault();
    keys[key]();
  }
});
addEventListener("keyup", event => {
  if (event.key.toLowerCase() !== "b") return;
  compared.holds = false;
  draw();
});
choose("look");
