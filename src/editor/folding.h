// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of a scene that an editor can fold away.
#pragma once

#include "editor/edited_file.h"

#include <cstddef>
#include <vector>

namespace candelabra {

struct Fold {
    enum Kind { code, comment, imports };

    std::size_t first_line = 0;  ///< stays to be seen
    std::size_t last_line = 0;   ///< the last that is hidden
    Kind kind = code;

    friend bool operator==(const Fold&, const Fold&) = default;
};

/// Of everything that takes several lines: blocks, lists in brackets, parts of directives,
/// comments, #include lines that follow each other. The line that closes a part stays to be seen.
/// Brackets without a counterpart are passed over. At most one fold begins in a line.
std::vector<Fold> folds(const EditedFile&);

}  // namespace candelabra
