// SPDX-License-Identifier: GPL-3.0-or-later
// An OpenEXR file as the light of a picture: the picture, its layers, the light of single lamps and
// the film that the file records. Read by develop and share. Files of other programs may have any
// of these.
#pragma once

#include "base/image.h"
#include "camera/film_settings.h"
#include "options/options.h"
#include "picture/layers.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace candelabra {

class LightFile {
public:
    /// Returns nothing after an error has been reported.
    static std::optional<LightFile> read(const std::string& path, Diagnostics&);

    const std::string& path() const { return path_; }
    const std::string& film_text() const { return picture_.texts[0].second; }
    const std::string& description() const { return picture_.texts[1].second; }

    /// Returns the planes "R", "G" and "B" of a layer as a picture, or its grey plane "Y". The
    /// layer "" is the picture itself.
    std::optional<Image> image(const std::string& layer) const;
    /// The alpha of each pixel, from 0 to 1; empty: none.
    std::vector<double> alpha(const std::string& layer) const;
    /// The names of the layers that image() accepts, each once, in file order.
    std::vector<std::string> layers() const;

private:
    LightFile(std::string path, LayeredPicture picture)
        : path_(std::move(path)), picture_(std::move(picture)) {}

    const ChannelPlane* find(std::string_view name) const;

    std::string path_;
    LayeredPicture picture_;
};

/// Returns the film that the file records, with the changes of the options; it is on. Reports a
/// film that is not understood; returns nothing after an error.
std::optional<FilmSettings> film_of(const LightFile&, const Options&, Diagnostics&);

/// The same for the text of a film that another file records.
std::optional<FilmSettings> film_of(const std::string& text, const std::string& path,
                                    const Options&, Diagnostics&);

/// Returns the names of the lamps, and `rest`, whose layers begin with `before`. Together they are
/// the picture. Returns nothing after an error has been reported: there are none, or they do not
/// add up to the picture.
std::optional<std::vector<std::string>> lamps_of(const LightFile&, const std::string& before,
                                                 const Image& picture, Diagnostics&);

}  // namespace candelabra
