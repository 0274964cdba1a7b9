// SPDX-License-Identifier: GPL-3.0-or-later
// Shows as bytes of channels, and the patch that says which lamps hang on which channels.
#pragma once

#include "relight/fseq.h"
#include "relight/light_show.h"
#include "text/diagnostic.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// The light of a lamp by the value of its channel.
struct ChannelCurve {
    double exponent = 1;

    /// Takes `linear`, `square` or an exponent from 0.1 to 10. Nothing for other texts.
    static std::optional<ChannelCurve> of(std::string_view text);
};

/// Channels and the lamps on them.
struct PatchedLamp {
    std::uint32_t lamp;                 ///< its place in the list
    std::uint32_t channel;              ///< its first, counted from 0
    std::array<std::uint8_t, 4> place;  ///< of red, green, blue and white among them
};

/// All lamps in the order of their names and numbers, from the first channel on, with one channel
/// or three. Nothing if no such number of channels fits.
std::optional<std::vector<PatchedLamp>> usual_patch(const LampList&, std::uint32_t channels);

/// Reads a patch: a table with the columns `lamp`, `channel` (of the first lamp, counted from 1)
/// and `order`, such as RGB, GRB, RGBW or W. Lamps of a range follow each other. Returns nothing
/// after an error has been reported.
std::optional<std::vector<PatchedLamp>> patch_of_table(std::string_view text,
                                                       const std::string& path, const LampNames&,
                                                       Diagnostics&);

/// The frames of the data. A lamp whose channels the data do not have is as it was rendered.
std::unique_ptr<ShowFrames> channel_frames(ChannelData, const std::vector<PatchedLamp>&,
                                           const ChannelCurve&);

}  // namespace candelabra
