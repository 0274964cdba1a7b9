// SPDX-License-Identifier: GPL-3.0-or-later
// The computed indices after the name of an array, `[i][j]`. One may be a string: the name of a
// column or of a member, or a path of several names with points between them.
#pragma once

#include "syntax/tree.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

struct Indices {
    struct Text {
        std::size_t index;
        std::string text;
    };

    std::array<double, 16> values;
    std::size_t count = 0;
    const Tree* tree = nullptr;
    NodeId first = no_node;
    std::vector<Text> texts;  ///< the indices that are strings
    Span path;                ///< known: of a path, which has been taken apart
    bool asking = false;      ///< tests for the element: a name may be missing

    /// The place of an index.
    Span span(std::size_t i) const;
    /// False if there are too many.
    bool add(double value) {
        if (count == values.size()) return false;
        values[count++] = value;
        return true;
    }
    bool add(std::string text);
    /// Adds a part of a path. A whole number becomes a number.
    bool add_part(std::string_view part);
    /// The string at index i; null if it is a number.
    const std::string* text(std::size_t i) const {
        for (const Text& each : texts)
            if (each.index == i) return &each.text;
        return nullptr;
    }
    /// Replaces a path by its parts, whole numbers by numbers. Returns false, with no effect, if it
    /// is not a path or has too many parts.
    bool expand(std::size_t i);
};

}  // namespace candelabra
