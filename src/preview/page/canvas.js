// SPDX-License-Identifier: GPL-3.0-or-later
// The picture on its canvas: where it is, how large, and what it is compared with. Coarse pictures
// have fewer pixels and are drawn as large as the whole one.
const stage = element("stage"), canvas = element("picture"), divider = element("divider");
const view = { x: 0, y: 0, zoom: 1, fits: true };
const now = { width: 0, height: 0, columns: 0, generation: 0, image: null };
const compared = { image: null, split: null, holds: false };  // split: a share of the stage
const margin = 16, greatestZoom = 64;

function place() {
  if (view.fits && now.width) {
    const room = { x: stage.clientWidth - 2 * margin, y: stage.clientHeight - 2 * margin };
    view.zoom = Math.max(0.01, Math.min(room.x / now.width, room.y / now.height));
    view.x = (stage.clientWidth - now.width * view.zoom) / 2;
    view.y = (stage.clientHeight - now.height * view.zoom) / 2;
  }
  element("zoom").value = Math.round(100 * view.zoom) + " %";
  draw();
}

function drawImage(context, image, left, right) {
  const scale = devicePixelRatio;
  context.save();
  context.beginPath();
  context.rect(left * scale, 0, (right - left) * scale, canvas.height);
  context.clip();
  context.imageSmoothingEnabled = image.width < now.width || view.zoom * scale < 3;
  context.imageSmoothingQuality = "high";
  context.drawImage(image, view.x * scale, view.y * scale, now.width * view.zoom * scale,
                    now.height * view.zoom * scale);
  context.restore();
}

function draw() {
  const scale = devicePixelRatio;
  const width = Math.round(stage.clientWidth * scale), height = Math.round(stage.clientHeight * scale);
  if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
  const context = canvas.getContext("2d");
  context.clearRect(0, 0, width, height);
  if (!now.image) return;
  const whole = stage.clientWidth, before = compared.image;
  const border = before && compared.split !== null ? compared.split * whole : 0;
  drawImage(context, before && compared.holds ? before : now.image, border, whole);
  if (border > 0) drawImage(context, before, 0, border);
  divider.hidden = !(before && compared.split !== null);
  divider.style.left = border + "px";
}

function fit() {
  view.fits = true;
  place();
}

// About a point of the stage.
function zoomBy(factor, x = stage.clientWidth / 2, y = stage.clientHeight / 2) {
  const zoom = Math.min(greatestZoom, Math.max(0.02, view.zoom * factor));
  view.x = x - (x - view.x) * zoom / view.zoom;
  view.y = y - (y - view.y) * zoom / view.zoom;
  view.zoom = zoom;
  view.fits = false;
  place();
}

function oneToOne() {
  zoomBy(1 / view.zoom);
}

function moveBy(x, y) {
  view.x += x;
  view.y += y;
  view.fits = false;
  place();
}

// The place under a point of the stage, 0 to 1 in both directions.
function placeUnder(x, y) {
  return { x: (x - view.x) / (now.width * view.zoom), y: (y - view.y) / (now.height * view.zoom) };
}

function copyOf(image) {
  const copy = new OffscreenCanvas(image.width, image.height);
  copy.getContext("2d").drawImage(image, 0, 0);
  return copy;
}

// Compares from the left border to this share of the stage; null: not at all.
function splitAt(share) {
  compared.split = share;
  element("split").setAttribute("aria-pressed", share !== null);
  draw();
}

function keep() {
  if (now.image) compared.image = copyOf(now.image);
  draw();
}

// From the bytes of /picture. The last fine picture before a change stays to be compared with.
function take(bytes) {
  const [width, height, columns, rows, generation] = new Uint32Array(bytes, 0, 5);
  const pixels = new Uint8ClampedArray(bytes, 20);
  const image = new OffscreenCanvas(columns, rows);
  image.getContext("2d").putImageData(new ImageData(pixels, columns, rows), 0, 0);
  const other = width !== now.width || height !== now.height;
  if (now.image && generation !== now.generation && now.columns === now.width)
    compared.image = now.image;
  if (other) {
    compared.image = null;
    splitAt(null);
  }
  Object.assign(now, { width, height, columns, generation, image });
  place();
}

new ResizeObserver(place).observe(stage);
