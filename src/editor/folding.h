// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of a scene that an editor can fold.
#pragma once

#include "editor/edited_file.h"

#include <cstddef>
#include <vector>

namespace candelabra {

struct Fold {
    enum Kind { code, comment, imports };

    std::size_t first_line = 0;  ///< remains visible
    std::size_t last_line = 0;   ///< the last one that is hidden
    Kind kind = code;

    friend bool operator==(const Fold&, const Fold&) = default;
};

/// Returns folds for everything that spans several lines: blocks, lists in brackets, parts of
/// directives, comments, and consecutive #include lines. The line that closes a part remains
/// visible. Unbalanced brackets are ignored. At most one fold begins in a line.
std::vector<Fold> folds(const EditedFile&);

}  // namespace candelabra
