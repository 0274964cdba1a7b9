// SPDX-License-Identifier: GPL-3.0-or-later
// The whole declarations behind names: for outlines, and for the reach of parameters.
#pragma once

#include "editor/edited_file.h"

#include <vector>

namespace candelabra {

/// One for each of the file's declarations, in their order: from the # of the directive to its end,
/// which for values is the semicolon behind them. Parameters have their macro. Of a directive that
/// cannot be read there is what stands up to the name.
std::vector<Part> extents(const EditedFile&);

}  // namespace candelabra
