// SPDX-License-Identifier: GPL-3.0-or-later
// The extents of whole declarations: for outlines, and for the scope of parameters.
#pragma once

#include "editor/edited_file.h"

#include <vector>

namespace candelabra {

/// Returns the extents of the file's declarations, in their order: from the # of the directive to
/// its end, which for values is the semicolon after them. A parameter has the extent of its macro.
/// The extent of an unparsable directive ends after the name.
std::vector<Part> extents(const EditedFile&);

}  // namespace candelabra
