// SPDX-License-Identifier: GPL-3.0-or-later
// Weights on the light of single lamps, by which develop lights pictures anew. They come from
// options `--light NAME=WEIGHT` and from a file, in which they may differ from frame to frame.
#pragma once

#include "base/image.h"
#include "text/diagnostic.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace candelabra {

/// Factors on the light of lamps by the names of their layers, without `light.`. Each name stands
/// once.
using LightFactors = std::vector<std::pair<std::string, Rgb>>;

/// The factor in a text: a number from 0 on, a colour such as #ff8800, or both with a comma or a
/// blank between. Nothing if it is wrong.
std::optional<Rgb> lamp_factor(std::string_view text);

class LightWeights {
public:
    /// Takes `NAME=WEIGHT`: 0 or above, a colour such as #ff8800, or both with a comma between.
    /// Returns false after an error has been reported.
    bool add(std::string_view text, Diagnostics&);

    /// Takes a file: JSON has an object with the weight of each lamp, or a list of such objects,
    /// one for each frame; any other file is a table whose header names lamps, with a row for each
    /// frame. Returns false after an error has been reported.
    bool read(const std::string& path, Diagnostics&);

    bool empty() const { return given_.empty() && frames_.empty(); }
    /// Number of frames that the file has; 0: all frames have the same weights.
    std::size_t frames() const { return by_frame_ ? frames_.size() : 0; }
    /// The factors of a frame. Those of add() replace those of the file.
    LightFactors of(std::size_t frame) const;

private:
    bool read_table(const std::string& path, std::string_view text, Diagnostics&);
    bool read_json(const std::string& path, const std::string& text, Diagnostics&);

    LightFactors given_;
    std::vector<LightFactors> frames_;
    bool by_frame_ = false;
};

/// The light of one lamp in a picture.
struct LampLight {
    Image light;
    Rgb factor = Rgb(1);
};

/// Replaces the light of the lamps in the picture by as much as their factors say. Factors of 1
/// change no bit. What is within the rounding of the layers, which are floats, is 0.
void relight(Image& picture, std::span<const LampLight> lamps);

}  // namespace candelabra
