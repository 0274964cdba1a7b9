// SPDX-License-Identifier: GPL-3.0-or-later
// `candelabra share`: a page with a picture whose lamps can be mixed anew, of a scene or of an
// OpenEXR file with the light of its lamps.
#pragma once

#include "console/console.h"

#include <cstddef>
#include <span>
#include <string_view>

namespace candelabra {

/// The most bytes of a page with up to 1280x720 pixels. Larger pictures have more in proportion.
inline constexpr std::size_t most_page_bytes = 5'000'000;
/// The most lamps of a page.
inline constexpr std::size_t most_page_lamps = 32;

/// `arguments`: those after `share`. Returns the exit status.
int run_share(std::span<const std::string_view> arguments, const Console&);

}  // namespace candelabra
