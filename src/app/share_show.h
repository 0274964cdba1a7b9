// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of a page that plays a show of many lamps, made of the light that --keep-lights has
// kept.
#pragma once

#include "app/show_files.h"
#include "base/image.h"
#include "preview/share_page.h"

#include <cstddef>
#include <optional>
#include <string>

namespace candelabra {

/// The most bytes of a page with up to 1280x720 pixels. Larger pictures have more in proportion.
inline constexpr std::size_t most_page_bytes = 5'000'000;
/// The most lamps of a page.
inline constexpr std::size_t most_page_lamps = 32;

/// The most bytes of a page with this picture.
std::size_t most_bytes_of_page(const Image&);

/// `lights`: path of the file; `name`: of the page. Returns nothing after an error has been
/// reported.
std::optional<SharedPicture> shared_show(const std::string& lights, const ShowFiles&,
                                         const std::string& name, const Options&, Diagnostics&);

}  // namespace candelabra
