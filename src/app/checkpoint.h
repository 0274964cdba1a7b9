// SPDX-License-Identifier: GPL-3.0-or-later
// A picture on its way as a file: an OpenEXR picture that any viewer shows, whose further planes
// hold the exact sums of each pixel, and whose head says what the picture is of. Written at
// intervals, read to go on, merged from many machines.
#pragma once

#include "app/identity.h"
#include "film/schedule.h"

#include <optional>
#include <string>
#include <string_view>

namespace candelabra {

/// What names of states end in.
inline constexpr std::string_view state_ending = ".state.exr";

struct Checkpoint {
    Identity identity;
    RenderState state;
    std::uint32_t samples = 0;      ///< of each pixel of this share, when that number is even
    std::uint32_t all_samples = 0;  ///< the same for the whole picture
    bool finished = false;

    friend bool operator==(const Checkpoint&, const Checkpoint&) = default;
};

/// The bytes of the file; nothing, with a diagnostic, when there is no memory or no library.
std::optional<std::string> encode(const Checkpoint&, Diagnostics&);

/// The state in a file; nothing, with a diagnostic, when it is damaged or something else.
std::optional<Checkpoint> read_checkpoint(const std::string& path, Diagnostics&);

}  // namespace candelabra
