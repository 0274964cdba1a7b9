// SPDX-License-Identifier: GPL-3.0-or-later
// A file as an editor sees it: tokens, comments and the names that it makes, also when it is full
// of errors because somebody is typing. Offsets are bytes of the text.
#pragma once

#include "syntax/token_stream.h"
#include "syntax/tree.h"

#include <cstdint>
#include <string>
#include <vector>

namespace candelabra {

/// A half-open range of bytes.
struct Part {
    std::uint32_t first = 0;
    std::uint32_t last = 0;

    bool holds(std::uint32_t offset) const { return first <= offset && offset <= last; }
};

/// Where a name gets a meaning.
struct DeclaredName {
    enum Kind { variable, macro, parameter, file };

    NameId name = no_name;
    Kind kind = variable;
    bool local = false;
    Part place;
};

struct EditedFile {
    std::string path;
    std::string text;
    Tree values;  ///< what tokens of numbers and strings refer to
    std::vector<Token> tokens;
    std::vector<Part> comments;
    std::vector<DeclaredName> declarations;
    std::vector<std::string> includes;  ///< as they are written, of those with a plain name

    std::string_view part(Part place) const {
        return std::string_view(text).substr(place.first, place.last - place.first);
    }
    /// The token at or just before the offset, or null between tokens.
    const Token* token_at(std::uint32_t offset) const;
};

/// Cannot fail: what is no token is left out.
EditedFile read_tokens(std::string text, Names&);

}  // namespace candelabra
