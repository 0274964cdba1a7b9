// SPDX-License-Identifier: GPL-3.0-or-later
// Shows as lighting programs save them: a byte for each channel in each frame. FSEQ files of
// version 2, of xLights and the Falcon Player, are read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace candelabra {

/// The values of all channels in all frames.
struct ChannelData {
    std::uint32_t channels = 0;  ///< in a frame of `bytes`
    std::uint32_t step = 0;      ///< milliseconds between frames; 0: unknown
    /// First channel, counted from 0, and number of the channels that a frame has, in their order;
    /// empty: all from 0 on.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ranges;
    std::string bytes;  ///< frame by frame

    std::size_t frames() const { return channels > 0 ? bytes.size() / channels : 0; }
};

/// Reads the bytes of an FSEQ file. Returns nothing, and sets `problem`, which continues the name
/// of the file, and a way out.
std::optional<ChannelData> read_fseq(std::string_view bytes, std::string& problem,
                                     std::string& way_out);

}  // namespace candelabra
