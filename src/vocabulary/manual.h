// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the vocabulary as documentation: plain text for --help, roff for the manual pages, JSON
// for editors. It comes from the same tables that the language is read with. Called by the
// application only.
#pragma once

#include "vocabulary/schema.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace candelabra {

enum class ManualForm { text, roff, json };

/// Items that belong together: all shapes, all patterns ...
struct ItemGroup {
    std::string_view name;
    std::string_view help;
    std::span<const ItemInfo* const> items;
    /// The block whose first word is the item's name; empty: the item is a block itself.
    std::string_view block = {};
};

/// One entry of a list: a term and its explanation.
struct ManualEntry {
    std::string term;
    std::string help;
    std::string example = {};  ///< may be empty
};

/// Usage of the item: "sphere { centre, radius }", or in a block "camera { perspective ... }".
std::string usage(const ItemInfo&, std::string_view block = {});

/// The field whose word precedes the value: the field itself, unless it is a further value.
std::size_t word_of(const ItemInfo&, std::size_t field);

/// "the third value", for a further value of a word; otherwise empty.
std::string_view further_value(const ItemInfo&, std::size_t field);

/// Usage of a field with the further values of its word: "area_light v, v, n, n".
std::string term(const ItemInfo&, std::size_t field);

/// Type and range of the field: "number above 0".
std::string takes(const FieldInfo&);

/// Type, range and default of the field: "number above 0, default 1".
std::string values(const ItemInfo&, std::size_t field);

/// The documentation of one item, as plain text.
std::string manual(const ItemInfo&, std::string_view block = {});

/// The documentation of some groups, in any form.
std::string manual(std::span<const ItemGroup>, ManualForm);

/// A list, in any form.
std::string manual(std::span<const ManualEntry>, ManualForm);

/// Escapes the text for roff, so that no part of it is a command.
std::string roff(std::string_view text);

/// Escapes the text and breaks it into terminated lines, none of which is a command.
std::string roff_lines(std::string_view text);

/// Breaks the text between words into lines of at most `width` characters; all but the first are
/// indented.
std::string wrapped(std::string_view text, std::size_t indent, std::size_t width = 80);

}  // namespace candelabra
