// SPDX-License-Identifier: GPL-3.0-or-later
// What there is to say about the words that are no items with fields of their own: directives,
// transformations, blocks that hold other blocks, constants. Read by --help and by editors.
#pragma once

#include <span>
#include <string_view>

namespace candelabra {

struct GlossaryEntry {
    std::string_view words;  ///< all that it explains, one blank between them
    std::string_view form;   ///< how they are written
    std::string_view help;
};

std::span<const GlossaryEntry> glossary();

/// The entry for a word, with or without its #; null when there is none.
const GlossaryEntry* glossary_entry(std::string_view word);

}  // namespace candelabra
