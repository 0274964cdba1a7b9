// SPDX-License-Identifier: GPL-3.0-or-later
// Classifies the words of a scene, for editors that colour them by meaning: names by their
// declarations, words of the language by their use.
#pragma once

#include "editor/workspace.h"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace candelabra {

struct SemanticToken {
    /// In the order of semantic_kinds().
    enum Kind {
        comment,
        keyword,
        string,
        number,
        type,
        property,
        function,
        constant,
        macro,
        parameter,
        variable
    };
    /// Bits, in the order of semantic_modifiers().
    enum Modifier : std::uint8_t { declaration = 1, of_library = 2 };

    Part place;  ///< within one line
    Kind kind = keyword;
    std::uint8_t modifiers = 0;

    friend bool operator==(const SemanticToken& a, const SemanticToken& b) {
        return a.place.first == b.place.first && a.place.last == b.place.last && a.kind == b.kind &&
               a.modifiers == b.modifiers;
    }
};

/// The protocol's names.
std::span<const std::string_view> semantic_kinds();
std::span<const std::string_view> semantic_modifiers();

/// Returns tokens in source order. Undeclared names and punctuation have none.
std::vector<SemanticToken> semantic_tokens(Workspace&, const std::string& path);

}  // namespace candelabra
