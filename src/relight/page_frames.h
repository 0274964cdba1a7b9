// SPDX-License-Identifier: GPL-3.0-or-later
// The frames of a show in few bytes, for pages that play it (src/preview/page/show.js has the
// decoder). A factor v on a lamp is a byte n with v = scale (n / 255)^2. A frame has a byte of each
// lamp by its place in the list, or three where some lamp has a colour; from the second frame on,
// bytes are differences from the frame before.
#pragma once

#include "relight/light_show.h"

#include <cstddef>
#include <optional>
#include <string>

namespace candelabra {

struct PageFrames {
    std::size_t count = 0;  ///< at least 1
    bool grey = true;       ///< one byte of each lamp
    double scale = 1;
    std::string bytes;
};

/// Returns nothing if the frames have more bytes than that.
std::optional<PageFrames> page_frames(const LightShow&, std::size_t most_bytes);

}  // namespace candelabra
