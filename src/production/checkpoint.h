// SPDX-License-Identifier: GPL-3.0-or-later
// The state of an unfinished picture in a file. The file is an OpenEXR picture that any viewer
// shows; further planes hold the exact sums of each pixel, and the header identifies the picture.
// The light of lamps follows behind the picture.
// States are written at intervals, read to continue, and merged from many machines.
#pragma once

#include "film/schedule.h"
#include "production/identity.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace candelabra {

/// Extension of the file names of states.
inline constexpr std::string_view state_ending = ".state.exr";

struct Checkpoint {
    Identity identity;
    RenderState state;
    std::uint32_t samples = 0;      ///< per pixel of this share, if uniform
    std::uint32_t all_samples = 0;  ///< per pixel of the whole picture, if uniform
    bool finished = false;
    std::string lamps = {};  ///< the light of lamps that has been kept, as bytes; empty: none

    friend bool operator==(const Checkpoint&, const Checkpoint&) = default;
};

/// Returns the bytes of the file. Returns nothing, with a diagnostic, if memory or the OpenEXR
/// library is missing.
std::optional<std::string> encode(const Checkpoint&, Diagnostics&);

/// Returns how many bytes of memory encode() takes for a picture of that size, at most. `aovs`:
/// number of its further sums.
std::uint64_t bytes_to_encode(int width, int height, std::size_t aovs);

/// Reads a state. Returns nothing, with a diagnostic, if the file is damaged or is no state.
std::optional<Checkpoint> read_checkpoint(const std::string& path, Diagnostics&);

}  // namespace candelabra
