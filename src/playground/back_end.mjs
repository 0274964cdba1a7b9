// SPDX-License-Identifier: GPL-3.0-or-later
// What the panels ask and change (src/preview/page/*_panel.js), answered by runs of the program. The light of
// the last picture is kept, lamp by lamp, so that film and lamps need no new rendering.
import { joinBands, rowsOfBlock, textsOfExr } from "./exr.mjs";
import { bandsOf } from "./engine.mjs";

const filmDefaults = { exposure: 0, auto: false, key: 0.18, white_balance: 0, response: "linear", contrast: 1,
                       saturation: 1, vignette: 0, glare: false, veil: 0.15, halo: 0.01, star: 0.02 };
const glareParts = ["veil", "halo", "star"];
const clockKnob = { name: "clock", kind: "slider", help: "The clock of the scene", low: 0, high: 1, step: 0.02 };

// A film of its text in a picture: film=on exposure=1 auto_exposure=1 glare=on glare.veil=0.1
function filmOf(text) {
  const film = {};
  for (const [, name, value] of text.matchAll(/(\S+?)=(\S+)/g)) {
    const key = name.replace("glare.", "");
    if (name === "auto_exposure") film.auto = value === "1";
    else if (key in filmDefaults) film[key] = value === "on" ? true : value === "off" ? false
      : Number.isNaN(Number(value)) ? value : Number(value);
  }
  return film;
}

// The value of a knob for --preset, of what its widget sends.
function valueOf(knob, sent) {
  const text = String(sent);
  if (knob.kind === "colour") return { rgb: text.split(",").map(Number) };
  if (knob.kind === "vector") return text.split(",").map(Number);
  return typeof knob.value === "number" ? Number(text) : text;
}
const shownValue = value => value?.rgb ?? value;

export class BackEnd {
  // `files()`: those of the scene, with its text; `size()`: of the picture in pixels. `relit(png)` shows a picture
  // that has been developed anew; `changed()`: the picture has to be rendered anew.
  constructor({ engine, workers, files, size, relit, changed }) {
    Object.assign(this, { engine, workers, files, size, relit, changed, light: null, lamps: [], dimmers: {},
                          filmOfScene: {}, filmChanges: {}, knobs: [], values: {}, clock: 0, crowded: false });
  }

  get film() { return { ...filmDefaults, ...this.filmOfScene, ...this.filmChanges }; }
  get dims() { return Object.values(this.dimmers).some(({ strength, colour }) => strength !== 1 || colour.some(c => c !== 1)); }

  // Options for a picture of this film.
  filmWords() {
    const { film, filmChanges } = this, words = [];
    for (const name of Object.keys(filmChanges)) {
      if (name === "exposure" || name === "auto" || name === "glare" || glareParts.includes(name)) continue;
      words.push(`--${name.replace("_", "-")}=${filmChanges[name]}`);
    }
    if ("exposure" in filmChanges || "auto" in filmChanges) {
      const stops = film.exposure < 0 || !film.auto ? String(film.exposure) : "+" + film.exposure;
      words.push("--exposure=" + (film.auto ? "auto" + (film.exposure === 0 ? "" : stops) : stops));
    }
    const parts = glareParts.filter(name => name in filmChanges);
    if (film.glare && parts.length > 0) words.push("--glare=" + parts.map(name => `${name}=${film[name]}`).join());
    else if ("glare" in filmChanges) words.push("--glare=" + (film.glare ? "on" : "off"));
    return words;
  }
  sceneWords() {
    return [...(this.clock !== 0 ? ["+K" + this.clock] : []),
            ...(Object.keys(this.values).length > 0 ? ["--preset", "set.json"] : [])];
  }
  sceneFiles() { return { ...this.files(), "set.json": JSON.stringify(this.values) }; }

  // ---- what the program says of a scene

  takeFilm(text) {
    this.filmOfScene = filmOf(text ?? "");
    showFilm(this.film);
  }
  takeKnobs(knobs) {
    const names = new Set(knobs.map(({ name }) => name));
    for (const name of Object.keys(this.values)) if (!names.has(name)) delete this.values[name];
    this.knobs = knobs;
    this.show();
  }
  show() {
    showFilm(this.film);
    showLamps(this.lamps.map(({ name, statement, share }) => {
      const { strength, colour } = this.dimmers[name] ?? { strength: 1, colour: [1, 1, 1] };
      return { name, statement, strength, colour, shown: colour.map(c => c * strength * share) };
    }), !this.crowded);
    if (!this.crowded)
      element("lamps-hint").textContent = this.light ? "The scene has no lamps of its own."
        : "They come with the light of 16 samples.";
    element("lamps-hint").hidden = this.lamps.length > 0 && !this.crowded;
    showKnobs(this.shownKnobs());
    element("film-reset").disabled = Object.keys(this.filmChanges).length === 0;
    element("lamps-reset").disabled = !this.dims;
    element("save-light").disabled = !this.light;
  }
  shownKnobs() {
    return [...this.knobs.map(knob => ({ ...knob, value: shownValue(this.values[knob.name] ?? knob.value) })),
            { ...clockKnob, value: this.clock }];
  }
  // Another picture is to come: its light is not that of the last one.
  forget() {
    this.light = null;
    this.crowded = false;
  }

  // ---- light

  // Renders the light of each lamp in bands of rows, and joins them. Returns the file, or the run that failed.
  async renderLight(width, height, samples, told) {
    const bands = bandsOf(height, this.workers, rowsOfBlock);
    const words = ["scene.pov", `+W${width}`, `+H${height}`, "--samples", String(samples), "--layers", "lights",
                   "--progress", "none", "--diagnostics=json", "--stats", "stats.json", "-o", "light.exr", ...this.sceneWords()];
    const runs = await Promise.all(bands.map(async ([first, last]) => {
      const rows = bands.length > 1 ? [`+SR${first}`, `+ER${last}`] : [];
      const run = await this.engine.run({ words: [...words, ...rows], files: this.sceneFiles(),
                                          wants: ["light.exr", "stats.json"] }, "picture");
      told(bands.length);
      return run;
    }));
    const bad = runs.find(({ status, made }) => status !== 0 || !made["light.exr"]);
    if (bad) return { bad };
    return { said: runs[0].err, light: joinBands(runs.map(({ made }) => made["light.exr"]), bands),
             stats: runs.map(({ made }) => JSON.parse(new TextDecoder().decode(made["stats.json"]))) };
  }

  // Keeps a light for the panels. Shares of lamps are those of all bands.
  takeLight(light, stats) {
    this.light = light;
    this.crowded = false;
    const shares = stats.map(({ lights }) => lights);
    this.lamps = shares[0].map(({ name, statement }, i) =>
      ({ name, statement, share: shares.reduce((sum, rows) => sum + rows[i].light, 0) / shares.length }));
    this.filmOfScene = filmOf(textsOfExr(light).candelabraFilm ?? "");
    this.show();
  }

  // A PNG file of a light, by the film and the lamps as they are set.
  async developed(light) {
    const names = /; lights=([^;]*)/.exec(textsOfExr(light).ImageDescription)?.[1].split(",") ?? [];
    const dimmed = names.filter(name => this.dimmers[name]).map(name => ({ name, ...this.dimmers[name] }));
    const words = ["develop", "light.exr", "-o", "out.png", "--diagnostics=json", ...this.filmWords()];
    if (this.dims && dimmed.length > 0) words.push("--lights", "lamps.json");
    return this.engine.run({ words, files: { "light.exr": light, "lamps.json": lampsAsJson(dimmed) },
                             wants: ["out.png"] }, "develop");
  }

  async #again() {
    this.show();
    const { light } = this;
    if (!light) return this.changed();
    const { made } = await this.developed(light);
    if (made["out.png"] && light === this.light) await this.relit(made["out.png"]);
  }

  // ---- the panels' questions

  async ask(path) {
    const { pathname, searchParams } = new URL(path, "http://backEnd");
    if (pathname === "/film") return this.#filmText();
    const [width, height] = this.size(), place = `${searchParams.get("x")},${searchParams.get("y")}`;
    const { out, err } = await this.engine.run({ words: ["scene.pov", `+W${width}`, `+H${height}`, "--pick", place,
                                                         ...this.sceneWords()], files: this.sceneFiles() }, "pick");
    return out || err;
  }

  async post(path, form) {
    if (path === "/develop") {
      if (form.name === "reset") this.filmChanges = {};
      else this.filmChanges[form.name.replace("glare.", "")] = this.#filmValue(form);
      return this.#again();
    }
    if (path === "/dim") {
      if (form.reset) this.dimmers = {};
      else this.dimmers[this.lamps[form.lamp].name] = { strength: form.strength, colour: [form.red, form.green, form.blue] };
      return this.#again();
    }
    if (form.name === clockKnob.name) this.clock = Number(form.value);
    else this.values[form.name] = valueOf(this.knobs.find(({ name }) => name === form.name), form.value);
    this.show();
    this.changed();
  }

  #filmValue({ name, value }) {
    if (value === "on" || value === "off") return value === "on";
    return name === "white_balance" && value <= 1900 ? 0 : value;
  }
  #filmText() {
    const { film } = this, words = [];
    if (film.exposure !== 0) words.push(`exposure ${film.exposure}`);
    if (film.auto) words.push("auto_exposure");
    for (const name of ["key", "white_balance", "response", "contrast", "saturation", "vignette"])
      if (film[name] !== filmDefaults[name]) words.push(`${name} ${film[name]}`);
    if (film.glare) words.push(`glare { ${glareParts.map(name => `${name} ${film[name]}`).join(" ")} }`);
    return `film { ${words.join(" ")} }\n`;
  }
}
