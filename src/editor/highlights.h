// SPDX-License-Identifier: GPL-3.0-or-later
// What belongs to the word under the cursor in the same file: the other places of a name, or the
// other parts of a directive.
#pragma once

#include "editor/edited_file.h"

#include <vector>

namespace candelabra {

struct Highlight {
    enum Kind { text, read, write };

    Part place;
    Kind kind = text;

    friend bool operator==(const Highlight& a, const Highlight& b) {
        return a.place.first == b.place.first && a.place.last == b.place.last && a.kind == b.kind;
    }
};

/// In the order of the text; a name's declarations are written. Empty where no name and no
/// directive with an #end is.
std::vector<Highlight> highlights(const EditedFile&, std::uint32_t offset);

}  // namespace candelabra
