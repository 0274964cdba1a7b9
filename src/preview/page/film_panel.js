// SPDX-License-Identifier: GPL-3.0-or-later
// The panel of the film.
const film = {};
const develop = name => {
  const send = sender("/develop");
  return value => send({ name, value });
};
const share = value => (100 * value).toFixed(0) + " %";
function makeFilm() {
  film.exposure = slider("Exposure", "In stops: doublings of the light",
                         { min: -8, max: 8, step: 0.05 }, develop("exposure"), stops);
  film.auto = checkOf("As the picture itself asks for", develop("auto"));
  film.key = slider("Key", "Luminance that the whole picture is given", { min: 0.02, max: 0.5, step: 0.01 },
                    develop("key"), value => value.toFixed(2));
  film.response = selectOf("Response", ["linear", "filmic", "agx"], develop("response"));
  film.contrast = slider("Contrast", "Exponent of the light around a middle grey",
                         { min: 0.5, max: 2, step: 0.05 }, develop("contrast"), value => value.toFixed(2));
  film.saturation = slider("Saturation", "Distance of colours from grey; 0: black and white",
                           { min: 0, max: 2, step: 0.05 }, develop("saturation"), value => value.toFixed(2));
  film.white_balance = slider("White", "Kelvins of a light that looks white",
                              { min: 1900, max: 12000, step: 100 },
                              develop("white_balance"), value => value <= 1900 ? "as it is" : value + " K");
  film.glare = checkOf("Glare", develop("glare"));
  const part = (name, help, max) =>
    slider(name, help, { min: 0, max, step: 0.005 }, develop("glare." + name.toLowerCase()), share);
  film.veil = part("Veil", "Light that is scattered around each lamp", 0.5);
  film.halo = part("Halo", "Light in the ring around each lamp", 0.1);
  film.star = part("Star", "Light in the rays of the aperture", 0.2);
  film.vignette = slider("Vignette", "Light that corners lose", { min: 0, max: 1, step: 0.01 },
                         develop("vignette"), share);
  element("film").replaceChildren(...Object.values(film));
}
function showFilm(settings) {
  for (const [name, row] of Object.entries(film)) row.set(settings[name]);
  for (const name of ["veil", "halo", "star"]) film[name].hidden = !settings.glare;
  film.key.hidden = !settings.auto;
  film.now = settings.exposure;
}
Object.defineProperty(film, "now", { value: 0, writable: true, enumerable: false });
function expose(more) {
  film.now = Math.min(8, Math.max(-8, film.now + more));
  develop("exposure")(film.now);
  toast(stops(film.now));
}
element("film-reset").addEventListener("click", () => post("/develop", { name: "reset" }));
element("film-copy").addEventListener("click", () => copy("/film", "Film"));
makeFilm();
