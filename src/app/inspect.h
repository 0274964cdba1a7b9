// SPDX-License-Identifier: GPL-3.0-or-later
// What people want to know who look at a picture on its way: layers as pictures, and what is under
// a pixel and who lights it. Asked by the preview while nothing is being rendered.
#pragma once

#include "app/console.h"
#include "base/image.h"

#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// The layers that can be looked at beside the picture.
std::vector<std::string_view> views();

/// Whether a layer stays as it is while the picture becomes better.
bool is_still(std::string_view name);

/// One of these, in colours for a screen: directions from -1 to 1 as 0 to 1, near things bright,
/// each object in a colour of its own, and numbers as shares of their greatest. Nothing for
/// another name. `step`: of so many rows and columns one is taken. `cancelled`: asked by several
/// threads, may be empty; once it is true, rows may be missing.
std::optional<Image> view(const Exhibit&, std::string_view name, int step = 1,
                          const std::function<bool()>& cancelled = {});

/// Colour, place, object and texture under a pixel, and the statements that light it with their
/// shares, each on a line; empty outside of the picture.
std::string what_is_under(const Exhibit&, int x, int y);

}  // namespace candelabra
