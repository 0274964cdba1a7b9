// SPDX-License-Identifier: GPL-3.0-or-later
// Facts about an unfinished picture: layers as pictures, and the object and the lights at a pixel.
// Called by the preview while no rendering is in progress.
#pragma once

#include "base/image.h"
#include "preview/rendered_picture.h"

#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// Returns the names of the layers that can be viewed besides the picture.
std::vector<std::string_view> views();

/// Whether a layer stays constant while the picture converges.
bool is_still(std::string_view name);

/// Returns a layer in display colours: directions map from [-1, 1] to [0, 1], near things are
/// bright, each object has its own colour, and numbers are relative to their maximum. Returns
/// nothing for an unknown name. `step`: one of this many rows and columns is sampled. `cancelled`:
/// called by several threads, may be empty; once it returns true, rows may be missing.
std::optional<Image> view(const RenderedPicture&, std::string_view name, int step = 1,
                          const std::function<bool()>& cancelled = {});

/// Describes a pixel line by line: its colour, position, object and texture, and the statements
/// that light it with their shares. Empty outside of the picture.
std::string what_is_under(const RenderedPicture&, int x, int y);

}  // namespace candelabra
