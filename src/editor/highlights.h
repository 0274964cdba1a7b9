// SPDX-License-Identifier: GPL-3.0-or-later
// Highlights for the word under the cursor within its file: the other occurrences of a name, or the
// other parts of a directive.
#pragma once

#include "editor/edited_file.h"

#include <vector>

namespace candelabra {

struct WordHighlight {
    enum Kind { text, read, write };

    Part place;
    Kind kind = text;

    friend bool operator==(const WordHighlight& a, const WordHighlight& b) {
        return a.place.first == b.place.first && a.place.last == b.place.last && a.kind == b.kind;
    }
};

/// Returns highlights in source order; declarations of a name are writes. Empty if the offset is
/// neither on a name nor on a directive with an #end.
std::vector<WordHighlight> highlights(const EditedFile&, std::uint32_t offset);

}  // namespace candelabra
