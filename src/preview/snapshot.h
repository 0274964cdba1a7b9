// SPDX-License-Identifier: GPL-3.0-or-later
// A snapshot of the preview's film, with the light of each statement in its own image, so that it
// can be relit and developed without being rendered again. Made between two stretches of rendering;
// used by the developer's thread.
#pragma once

#include "base/rgb.h"
#include "film/develop.h"
#include "picture/write.h"
#include "transport/aovs.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace candelabra {

class Film;

/// Factors on the light of a statement's lamps, set by the page.
struct Dimmer {
    double strength = 1;
    Rgb colour = Rgb(1);

    Rgb factor() const { return strength * colour; }
    friend bool operator==(const Dimmer&, const Dimmer&) = default;
};

/// Settings of the page for developing a snapshot.
struct Look {
    std::vector<FilmChange> film = {};  ///< changes of the scene's own film
    std::map<std::string, Dimmer> lamps = {};
    bool denoised = false;
    std::string view = "picture";  ///< or a layer

    /// Whether the light of any lamp is changed.
    bool relights() const;
    friend bool operator==(const Look&, const Look&) = default;
};

/// Images of some or all pixels of a picture. Coarse ones have fewer rows and columns.
struct LightSnapshot {
    int width = 0, height = 0;       ///< of the whole picture
    Image light;                     ///< before any dimming
    Image smooth = {};               ///< see Negative
    std::vector<Image> lights = {};  ///< of each statement; empty: not requested
    std::optional<Image> view = {};  ///< a layer in display colours
    std::string view_name = "picture";
};

/// Data that stay constant while a picture converges.
struct SnapshotContext {
    FilmSettings film;
    PictureFormat format;
    std::vector<std::string> names;  ///< of the statements that make lights
    int threads = 0;
    int generation = 0;  ///< incremented with each change of the picture
};

/// Returns a snapshot of the pixels that have samples. The others show the coarse snapshot, which
/// has the same images, interpolated over the whole picture. If it is null, they are black.
LightSnapshot snapshot_of(const Film&, const Aovs&, const FilmSettings&, bool with_lights,
                          const LightSnapshot* coarse = nullptr);

/// Interpolates a smaller picture bilinearly at a pixel of the whole picture.
Rgb spread_out(const Image& coarse, const Image& whole, int x, int y);

/// Returns the means of squares of step x step pixels.
LightSnapshot reduced(const LightSnapshot&, int step);

/// Returns the light with the dimmers applied. Lamps without a dimmer, and light that belongs to no
/// lamp, are unchanged.
Image relit(const LightSnapshot&, const std::vector<std::string>& names, const Look&);

/// A picture in display values, and its encoding.
struct DisplayImage {
    Image image;
    PictureFormat format;
};
DisplayImage display_image(const LightSnapshot&, const SnapshotContext&, const Look&);

/// Applies the film changes of the look to the scene's film.
FilmSettings film_with(FilmSettings, const Look&);

/// Changes one setting. `exposure` is a number of stops, with or without `auto`, which is `on` or
/// `off`; the others are as in change(). Returns an error as a sentence, or empty.
std::string change_look(FilmSettings&, const FilmChange&);

/// Returns the bytes red, green, blue and 255 for each pixel.
std::string screen_bytes(const DisplayImage&, int threads);

/// Returns an OpenEXR file of the light with the look applied, the light of each statement if the
/// snapshot has it, and the film in a text attribute. Returns nothing, with a diagnostic, on
/// failure.
std::optional<std::string> exr_of(const LightSnapshot&, const SnapshotContext&, const Look&,
                                  Diagnostics&);

}  // namespace candelabra
