// SPDX-License-Identifier: GPL-3.0-or-later
// A file as an editor sees it: its tokens, comments and declared names, available even while the
// file is full of errors during typing. Offsets are in bytes.
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

/// A declaration of a name.
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
    Tree values;  ///< the values of number and string tokens
    std::vector<Token> tokens;
    std::vector<Part> comments;
    std::vector<DeclaredName> declarations;
    std::vector<std::string> includes;  ///< as written; only those that are plain strings

    std::string_view part(Part place) const {
        return std::string_view(text).substr(place.first, place.last - place.first);
    }
    /// Returns the token that contains the offset or ends there; null if there is none.
    const Token* token_at(std::uint32_t offset) const;
};

/// Never fails: characters that form no token are skipped.
EditedFile read_tokens(std::string text, Names&);

}  // namespace candelabra
