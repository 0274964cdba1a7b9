// SPDX-License-Identifier: GPL-3.0-or-later
// Examples of words, which help, editors, the manual and the book show, and which
// tests/examples/words_test.cpp renders. They stand in the vocabularies of items (schema.h), in the
// glossary, and in the heads of the library's files (editor/library_guide.h). An example is one or
// more statements of a scene, or a part of an object or of a camera, such as `finish { phong 1 }`.
#pragma once

#include "vocabulary/item_info.h"

#include <span>
#include <string_view>

namespace candelabra {

/// The first example that contains the word as a whole, or else the first one; empty if there is
/// none.
std::string_view example_of(std::string_view word, std::span<const std::string_view> examples);

/// Whether the word stands in the text by itself, and not as a part of another one.
bool contains_word(std::string_view text, std::string_view word);

}  // namespace candelabra
