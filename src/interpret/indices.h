// SPDX-License-Identifier: GPL-3.0-or-later
// The indices behind the name of an array, `[i][j]`, when they have been computed. One may be a
// string: the name of a column or of a member, or a path of several with points between them.
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
    std::vector<Text> texts;  ///< those that are strings
    Span path;                ///< known: here was a path, which has been taken apart
    bool asking = false;      ///< whether there is such an element: a name may be missing

    /// The place of one of them.
    Span span(std::size_t i) const;
    /// False: there are too many.
    bool add(double value) {
        if (count == values.size()) return false;
        values[count++] = value;
        return true;
    }
    bool add(std::string text);
    /// A part of a path: a whole number is one.
    bool add_part(std::string_view part);
    /// Null: it is a number.
    const std::string* text(std::size_t i) const {
        for (const Text& each : texts)
            if (each.index == i) return &each.text;
        return nullptr;
    }
    /// Puts the parts of a path into its place, whole numbers as numbers. False, and nothing has
    /// happened: it is no path, or there are too many parts.
    bool expand(std::size_t i);
};

}  // namespace candelabra
