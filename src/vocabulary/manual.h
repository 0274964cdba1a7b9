// SPDX-License-Identifier: GPL-3.0-or-later
// The vocabulary as something to read: plain text for --help, roff for the manual pages, JSON for
// editors. Everything comes from the same tables that the language is read with. Called by the
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

/// One line of a list: what is written, and what it means.
struct ManualEntry {
    std::string term;
    std::string help;
};

/// How the item is written: "sphere { centre, radius }", or in a block "camera { perspective ...
/// }".
std::string usage(const ItemInfo&, std::string_view block = {});

/// The field whose word the value stands behind: itself, unless it is a further value of a word.
std::size_t word_of(const ItemInfo&, std::size_t field);

/// "the third value", for a further value of a word; otherwise empty.
std::string_view further_value(const ItemInfo&, std::size_t field);

/// How a field and the further values of its word are written: "area_light v, v, n, n".
std::string term(const ItemInfo&, std::size_t field);

/// What the field takes: "number above 0".
std::string takes(const FieldInfo&);

/// What the field takes, and what it has when nothing is said: "number above 0, default 1".
std::string values(const ItemInfo&, std::size_t field);

/// Everything about one item, as plain text.
std::string manual(const ItemInfo&, std::string_view block = {});

/// Everything about some groups, in any form.
std::string manual(std::span<const ItemGroup>, ManualForm);

/// A list, in any form.
std::string manual(std::span<const ManualEntry>, ManualForm);

/// The text with whatever roff would take for a command made printable.
std::string roff(std::string_view text);

/// The same in lines, each ended, of which none is taken for a command either.
std::string roff_lines(std::string_view text);

/// The text broken between words into lines of at most `width` characters, all but the first
/// indented.
std::string wrapped(std::string_view text, std::size_t indent, std::size_t width = 80);

}  // namespace candelabra
