// SPDX-License-Identifier: GPL-3.0-or-later
// Explanations of the words that are not items with fields: directives, transformations, blocks
// that contain other blocks, constants. Read by --help and by editors.
#pragma once

#include <array>
#include <span>
#include <string_view>

namespace candelabra {

struct GlossaryEntry {
    std::string_view words;  ///< words that it explains, separated by spaces
    std::string_view form;   ///< how they are written
    std::string_view help;
    /// Texts that show them (vocabulary/examples.h); the rest is empty.
    std::array<std::string_view, 4> examples = {};
};

std::span<const GlossaryEntry> glossary();

/// Whether this version has the things that an explanation is about.
bool says_available(std::string_view help);

/// The entry for a word, with or without its #; null when there is none.
const GlossaryEntry* glossary_entry(std::string_view word);

}  // namespace candelabra
