// SPDX-License-Identifier: GPL-3.0-or-later
// A picture whose lamps are mixed anew: unfolds the light of each lamp (src/picture/light_code.h),
// adds it up, and develops the sum as the film does (src/film/develop.h).
const facts = JSON.parse(element("data").textContent);
const { width, height, levels, film } = facts;
// With a show there is the light of crowds of lamps, that of none, and that of some lamps.
const count = width * height;
const layers = facts.show ? 2 + facts.show.strong.length : facts.lamps.length;

// Unfolding.
const lifting = [-1.586134342059924, -0.052980118572961, 0.882911075530934, 0.443506852043971];
const evenScale = 1.149604398860241;

function lift(line, first, length, stride, lanes, from, weight) {
  for (let i = from; i < length; i += 2) {
    const before = first + (i === 0 ? i + 1 : i - 1) * stride;
    const after = first + (i + 1 < length ? i + 1 : i - 1) * stride, here = first + i * stride;
    for (let lane = 0; lane < lanes; ++lane)
      line[here + lane] += weight * (line[before + lane] + line[after + lane]);
  }
}

// The inverse of a transform: the low half of the line is in front.
function synthesise(plane, first, length, stride, lanes, room) {
  if (length < 2) return;
  const low = (length + 1) >> 1;
  for (let i = 0; i < length; ++i)
    room.set(plane.subarray(first + i * stride, first + i * stride + lanes), i * lanes);
  for (let i = 0; i < length; ++i) {
    const from = (i % 2 === 0 ? i >> 1 : low + (i >> 1)) * lanes, to = first + i * stride;
    const scale = i % 2 === 0 ? 1 / evenScale : evenScale;
    for (let lane = 0; lane < lanes; ++lane) plane[to + lane] = scale * room[from + lane];
  }
  for (let i = 3; i >= 0; --i) lift(plane, first, length, stride, lanes, 1 - i % 2, -lifting[i]);
}

function sizesOf() {
  const sizes = [{ width, height }];
  for (let level = 0; level < levels; ++level) {
    const last = sizes[level];
    sizes.push({ width: (last.width + 1) >> 1, height: (last.height + 1) >> 1 });
  }
  return sizes;
}

// Reads planes one behind the other.
class Reader {
  constructor(bytes) {
    Object.assign(this, { bytes, at: 0, room: new Float32Array(count), sizes: sizesOf() });
  }
  number() {
    const { bytes } = this;
    let number = bytes[this.at++];
    if (number === 255) {
      number = (bytes[this.at] | bytes[this.at + 1] << 8 | bytes[this.at + 2] << 16 |
                bytes[this.at + 3] << 24) >>> 0;
      this.at += 4;
    }
    return number % 2 === 0 ? number / 2 : -(number + 1) / 2;
  }
  part(plane, left, top, right, bottom, step) {
    for (let y = top; y < bottom; ++y)
      for (let i = y * width + left, end = y * width + right; i < end; ++i)
        plane[i] = this.bytes[this.at] === 0 ? (++this.at, 0) : step * this.number();
  }
  plane(step) {
    const plane = new Float32Array(count), { sizes, room } = this, least = sizes[levels];
    this.part(plane, 0, 0, least.width, least.height, step);
    for (let level = levels; level > 0; --level) {
      const low = sizes[level], all = sizes[level - 1];
      this.part(plane, low.width, 0, all.width, low.height, step);
      this.part(plane, 0, low.height, low.width, all.height, step);
      this.part(plane, low.width, low.height, all.width, all.height, step);
    }
    for (let level = levels - 1; level >= 0; --level) {
      const size = sizes[level];
      synthesise(plane, 0, size.height, width, size.width, room);
      for (let y = 0; y < size.height; ++y) synthesise(plane, y * width, size.width, 1, 1, room);
    }
    return plane;
  }
}

// Light is kept in 16 bits a channel, 2048 to a doubling.
const perStop = 2048;
const lightOfCode = Float32Array.from({ length: 65536 }, (_, code) =>
  (2 ** (code / perStop) - 1) / facts.gain);

function layerOf(reader) {
  const brightness = reader.plane(facts.step), redness = reader.plane(2 * facts.step);
  const greenness = reader.plane(2 * facts.step), codes = new Uint16Array(3 * count);
  const code = value => Math.max(0, Math.min(65535, Math.round(perStop * value)));
  for (let i = 0; i < count; ++i) {
    const mean = brightness[i] - greenness[i] / 2, half = redness[i] / 2;
    codes[3 * i] = code(mean + half);
    codes[3 * i + 1] = code(mean + greenness[i]);
    codes[3 * i + 2] = code(mean - half);
  }
  return codes;
}

async function bytesOf(id) {
  const text = atob(element(id).textContent.trim());
  element(id).remove();
  const packed = Uint8Array.from(text, c => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Developing. What a function makes of the upper 20 bits of a float is kept in a table.
const tableOf = made => {
  const bits = new Uint32Array(1), value = new Float32Array(bits.buffer);
  return Float32Array.from({ length: 1 << 19 }, (_, i) => {
    bits[0] = i << 12 | 1 << 11;
    return made(Number.isFinite(value[0]) ? value[0] : 1e30);
  });
};
function curveAt(exposure) {
  const { first, step, values } = film.curve;
  const place = (Math.log2(exposure) - first) / step;
  if (!(place > 0)) return values[0] * exposure / 2 ** first;
  const i = Math.min(values.length - 2, Math.floor(place)), part = Math.min(1, place - i);
  return values[i] + part * (values[i + 1] - values[i]);
}
const curveTable = film.curve ? tableOf(curveAt) : null;
const screenSteps = 16384;
const screenTable = Uint8ClampedArray.from({ length: screenSteps + 1 }, (_, i) =>
  encoded(i / screenSteps));

const one = new Float32Array(1), oneBits = new Uint32Array(one.buffer);
function curve(exposure) {
  one[0] = exposure;
  return exposure > 0 ? curveTable[oneBits[0] >>> 12] : 0;
}
const contrasted = value => value > 0 ? 0.18 * (value / 0.18) ** film.contrast : 0;

// The response of the film to three exposures, in place.
const responses = {
  linear() {},
  filmic(c) {
    for (let i = 0; i < 3; ++i) c[i] = curve(c[i]);
  },
  agx(c) {
    const { mixed_in, taken_back, kept_in_proportion, half_kept_exposure } = film.agx;
    const r = Math.max(0, c[0]), g = Math.max(0, c[1]), b = Math.max(0, c[2]);
    const brightest = Math.max(r, g, b), common = mixed_in * (r + g + b) / 3, own = 1 - mixed_in;
    if (brightest === 0) return;
    const red = curve(own * r + common), green = curve(own * g + common), blue = curve(own * b + common);
    const back = taken_back * (red + green + blue) / 3, all = 1 / (1 - taken_back);
    const kept = kept_in_proportion / (1 + brightest / half_kept_exposure);
    const proportion = kept * curve(brightest) / brightest, other = (1 - kept) * all;
    c[0] = other * (red - back) + proportion * r;
    c[1] = other * (green - back) + proportion * g;
    c[2] = other * (blue - back) + proportion * b;
  },
};

// A light: factors of the lamps, and stops beside those of the film.
const asRendered = () =>
  ({ exposure: 0, lamps: facts.lamps.map(() => ({ strength: 1, colour: [1, 1, 1] })) });
const lights = { a: asRendered(), b: asRendered() };
let active = "a", codesOfLayers = [];
let show = null, frame = 0;  // of the show

// The picture of a light, of each `stride`-th pixel.
function imageOf(light, stride) {
  const columns = Math.ceil(width / stride), rows = Math.ceil(height / stride);
  const image = new ImageData(columns, rows), shown = image.data, c = new Float64Array(3);
  const gain = 2 ** (film.exposure + light.exposure), respond = responses[film.response];
  const mixed = show?.mixed(frame, light.lamps.slice(0, -1));
  const own = lamp => lamp.colour.map(v => v * lamp.strength * gain);
  const factors = show ? [null, own(light.lamps.at(-1)), ...show.strong.map(lamp =>
    [0, 1, 2].map(c => gain * mixed.factors[3 * lamp + c]))] : light.lamps.map(own);
  const row = new Float32Array(3 * columns), balance = film.balance;
  for (let y = 0, at = 0; y < rows; ++y) {
    row.fill(0);
    for (let k = 0; k < layers; ++k) {
      if (show && k === 0) {
        show.addRow(row, y * stride, stride, mixed, codesOfLayers[0], lightOfCode, gain);
        continue;
      }
      const [red, green, blue] = factors[k], codes = codesOfLayers[k];
      if (red + green + blue === 0) continue;
      for (let x = 0, i = 3 * y * stride * width; x < 3 * columns; x += 3, i += 3 * stride) {
        row[x] += red * lightOfCode[codes[i]];
        row[x + 1] += green * lightOfCode[codes[i + 1]];
        row[x + 2] += blue * lightOfCode[codes[i + 2]];
      }
    }
    for (let x = 0; x < 3 * columns; x += 3, at += 4) {
      const r = row[x], g = row[x + 1], b = row[x + 2];
      for (let i = 0; i < 3; ++i)
        c[i] = balance ? balance[3 * i] * r + balance[3 * i + 1] * g + balance[3 * i + 2] * b : row[x + i];
      if (film.contrast !== 1)
        for (let i = 0; i < 3; ++i) c[i] = contrasted(c[i]);
      respond(c);
      if (film.saturation !== 1) {
        for (let i = 0; i < 3; ++i) c[i] = Math.min(1, Math.max(0, c[i]));
        const grey = film.luminance[0] * c[0] + film.luminance[1] * c[1] + film.luminance[2] * c[2];
        for (let i = 0; i < 3; ++i) c[i] = grey + film.saturation * (c[i] - grey);
      }
      for (let i = 0; i < 3; ++i)
        shown[at + i] = screenTable[Math.min(screenSteps, Math.max(0, Math.round(screenSteps * c[i])))];
      shown[at + 3] = 255;
    }
  }
  return image;
}

// Showing.
const stage = element("stage"), canvas = element("picture"), divider = element("divider");
const pictures = { a: null, b: null };
const wanted = { a: true, b: true };
let split = null, coarse = 1, pending = 0, finer = 0;

function paint(name, stride) {
  const image = imageOf(lights[name], stride);
  const made = document.createElement("canvas");
  Object.assign(made, { width: image.width, height: image.height });
  made.getContext("2d").putImageData(image, 0, 0);
  pictures[name] = made;
}
function draw() {
  const context = canvas.getContext("2d");
  context.imageSmoothingQuality = "high";
  const part = (name, left, right) => {
    context.save();
    context.beginPath();
    context.rect(left, 0, right - left, height);
    context.clip();
    context.drawImage(pictures[name], 0, 0, width, height);
    context.restore();
  };
  const border = split === null ? 0 : Math.round(split * width);
  if (split === null) return part(active, 0, width);
  part("a", 0, border);
  part("b", border, width);
}
function refresh(stride) {
  for (const name of split === null ? [active] : ["a", "b"])
    if (wanted[name] || !pictures[name] || (stride === 1 && pictures[name].width < width)) {
      paint(name, stride);
      wanted[name] = false;
    }
  draw();
}
// Shows a coarse picture at once where the whole one takes long, and the whole one a moment later.
function changed() {
  wanted[active] = true;
  clearTimeout(finer);
  if (!pending)
    pending = requestAnimationFrame(() => {
      pending = 0;
      const start = performance.now();
      refresh(coarse);
      const took = performance.now() - start;
      if (took > 80 && coarse < 8) coarse *= 2;
      if (took < 15 && coarse > 1) coarse /= 2;
      if (coarse > 1) finer = setTimeout(() => refresh(1), 200);
    });
}

function place() {
  const margin = innerWidth > 900 ? 16 : 0;
  const room = { x: stage.clientWidth - 2 * margin, y: stage.clientHeight - 2 * margin };
  const zoom = Math.max(0.01, Math.min(room.x / width, room.y / height));
  const left = (stage.clientWidth - width * zoom) / 2, top = (stage.clientHeight - height * zoom) / 2;
  Object.assign(canvas.style, { left: left + "px", top: top + "px", width: width * zoom + "px",
                                height: height * zoom + "px" });
  divider.hidden = split === null;
  divider.style.left = left + (split ?? 0) * width * zoom + "px";
}

// Controls.
const exposure = slider("Exposure", "In stops: doublings of the light", { min: -6, max: 6, step: 0.05 },
                        value => { lights[active].exposure = value; changed(); }, stops);
element("exposure").append(exposure);
const cards = facts.lamps.map((name, k) => lampCard(name, (strength, colour) => {
  lights[active].lamps[k] = { strength, colour };
  changed();
}, () => cards));
element("lamps").append(...cards);
let shares = [];
function showLight() {
  document.activeElement?.blur();
  exposure.set(lights[active].exposure);
  cards.forEach((card, k) => {
    const { strength, colour } = lights[active].lamps[k];
    card.set(strength, colour, shares[k] ?? 0);
  });
  for (const name of ["a", "b"])
    element("light-" + name).setAttribute("aria-pressed", name === active);
  element("split").setAttribute("aria-pressed", split !== null);
  place();
}
function choose(name) {
  active = name;
  showLight();
  if (codesOfLayers.length) refresh(1);
}
element("light-a").addEventListener("click", () => choose("a"));
element("light-b").addEventListener("click", () => choose("b"));
element("split").addEventListener("click", () => {
  split = split === null ? 0.5 : null;
  choose(active);
});
element("reset").addEventListener("click", () => {
  lights[active] = asRendered();
  showLight();
  changed();
});
divider.addEventListener("pointerdown", event => divider.setPointerCapture(event.pointerId));
divider.addEventListener("pointermove", event => {
  if (!divider.hasPointerCapture(event.pointerId)) return;
  const box = canvas.getBoundingClientRect();
  split = Math.min(1, Math.max(0, (event.clientX - box.left) / box.width));
  place();
  draw();
});
// Playing.
let playing = 0;
function goTo(number, stride) {
  frame = number;
  element("frame").value = frame;
  element("moment").value = (frame / show.rate).toFixed(1) + " s";
  wanted.a = wanted.b = true;
  refresh(stride);
}
function play(on) {
  cancelAnimationFrame(playing);
  playing = 0;
  element("play-shape").setAttribute("d", on ? "M5 3h3.5v14H5Zm6.5 0H15v14h-3.5Z" : "M6 3v14l11-7Z");
  if (!on) return goTo(frame, 1);
  const begun = performance.now() - 1000 * frame / show.rate;
  const step = now => {
    const next = Math.floor(Math.max(0, now - begun) / 1000 * show.rate) % show.frames;
    if (next !== frame) {
      goTo(next, coarse);
      const took = performance.now() - now;
      if (took > 60 && coarse < 4) coarse *= 2;
      if (took < 12 && coarse > 1) coarse /= 2;
    }
    playing = requestAnimationFrame(step);
  };
  playing = requestAnimationFrame(step);
}
element("play").addEventListener("click", () => play(!playing));
element("frame").addEventListener("input", event => {
  if (playing) play(false);
  goTo(Number(event.target.value), coarse);
  clearTimeout(finer);
  finer = setTimeout(() => refresh(1), 200);
});

addEventListener("keydown", event => {
  if (event.ctrlKey || event.metaKey || event.altKey || event.target.closest("input")) return;
  if (event.key === " " && show?.frames > 1 && !event.target.closest("button")) {
    event.preventDefault();
    return play(!playing);
  }
  const key = event.key.toLowerCase();
  if (key === "a" || key === "b") choose(key);
  if (key === "s") element("split").click();
});

element("save").addEventListener("click", () => {
  refresh(1);
  canvas.toBlob(blob => saveFile(blob, facts.name + ".png"));
});
const lampsOf = light => facts.names.map((name, k) => ({ name, ...light.lamps[k] }));
element("save-lamps").addEventListener("click", () =>
  saveFile(lampsAsJson(lampsOf(lights[active])), facts.name + ".json"));

const breath = () => new Promise(resolve => setTimeout(resolve, 0));
async function unfold() {
  const reader = new Reader(await bytesOf("light"));
  if (facts.show) {
    show = new Show(facts.show, await bytesOf("show-data"), width, height);
    element("frame").max = show.frames - 1;
    element("transport").hidden = show.frames < 2;
    element("save-lamps").hidden = true;
  }
  for (let k = 0; k < layers; ++k) {
    element("wait").textContent = `Unfolding the light … ${k + 1} of ${layers}`;
    await breath();
    codesOfLayers.push(layerOf(reader));
  }
  const sums = codesOfLayers.map(codes => {
    let sum = 0;
    for (let i = 0; i < codes.length; i += 7) sum += lightOfCode[codes[i]];
    return sum;
  });
  const most = show ? 0 : Math.max(...sums);
  shares = sums.map(sum => most > 0 ? sum / most : 0);
  element("wait").hidden = true;
  showLight();
  if (show) goTo(Math.min(facts.watched ? Number(sessionStorage.frame ?? 0) : 0, show.frames - 1), 1);
  refresh(1);
  document.body.dataset.ready = "yes";
}

Object.assign(canvas, { width, height });
document.body.style.setProperty("--shape", height / width);
showLight();
new ResizeObserver(place).observe(stage);
if (typeof DecompressionStream === "undefined")
  element("wait").textContent = "This browser is too old for this page: it cannot unpack the light.";
else
  unfold().catch(problem => { element("wait").textContent = "The page is damaged: " + problem; });
