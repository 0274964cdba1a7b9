// SPDX-License-Identifier: GPL-3.0-or-later
// What the preview's film has gathered at a moment, taken apart so that it can be lit and developed
// anew without being rendered: the light of each statement by itself. Made between two stretches of
// rendering, used by a thread of its own.
#pragma once

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

/// A statement's lamps as the page has turned them: factors of their light.
struct Dimmer {
    double strength = 1;
    Vec3 colour = Vec3(1);

    Vec3 factor() const { return strength * colour; }
    friend bool operator==(const Dimmer&, const Dimmer&) = default;
};

/// How the page wants a plate to be developed.
struct Look {
    std::vector<FilmChange> film = {};  ///< of the scene's own film
    std::map<std::string, Dimmer> lamps = {};
    bool denoised = false;
    std::string view = "picture";  ///< or a layer

    /// Whether light is not as it was rendered.
    bool relights() const;
    friend bool operator==(const Look&, const Look&) = default;
};

/// Pictures of a part of all pixels: coarse ones have fewer rows and columns.
struct Plate {
    int width = 0, height = 0;       ///< of the whole picture
    Image light;                     ///< as the scene gives it
    Image smooth = {};               ///< see Negative
    std::vector<Image> lights = {};  ///< of each statement; empty: they were not asked for
    std::optional<Image> view = {};  ///< a layer, as a screen shows it
    std::string view_name = "picture";
};

/// What does not change while a picture becomes better.
struct PlateFrame {
    FilmSettings film;
    PictureFormat format;
    std::vector<std::string> names;  ///< of the statements that make lights
    int threads = 0;
    int generation = 0;  ///< number of the picture: more after each change
};

/// Of the pixels that have samples; others show the coarse plate, which has the same images, spread
/// over the whole picture. Null: they are black.
Plate plate_of(const Film&, const Aovs&, const FilmSettings&, bool with_lights,
               const Plate* coarse = nullptr);

/// The picture between the pixels of a smaller one, at the place of a pixel of the whole picture.
Vec3 spread_out(const Image& coarse, const Image& whole, int x, int y);

/// Means of squares of so many pixels.
Plate reduced(const Plate&, int step);

/// The light with the dimmers. Lamps without a dimmer are as they are, and so is what belongs to no
/// lamp.
Image relit(const Plate&, const std::vector<std::string>& names, const Look&);

/// A picture as a screen shows it, and how it is encoded.
struct Print {
    Image image;
    PictureFormat format;
};
Print print_of(const Plate&, const PlateFrame&, const Look&);

/// The film that the look makes of the scene's.
FilmSettings film_with(FilmSettings, const Look&);

/// Changes one setting. `exposure` is a number of stops, with or without `auto`, which is `on` or
/// `off`; the others are as in change(). An error as a sentence, empty when there is none.
std::string change_look(FilmSettings&, const FilmChange&);

/// Red, green, blue and 255 for each pixel.
std::string screen_bytes(const Print&, int threads);

/// An OpenEXR file of the light as the look has it, with the light of each statement if the plate
/// has it, and the film in a text. Nothing, with a diagnostic, when it cannot be made.
std::optional<std::string> exr_of(const Plate&, const PlateFrame&, const Look&, Diagnostics&);

}  // namespace candelabra
