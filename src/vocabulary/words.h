// SPDX-License-Identifier: GPL-3.0-or-later
// The words of the language with their classes, and the names that scenes declare, each interned as
// a small number. The lexer looks up every word here; names are shared by all files of one
// evaluation. A word that only this language has (light_sampler, ...) is not reserved: it is an
// ordinary name until a block looks for it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// The class of a spelling in the grammar.
enum class WordClass : std::uint8_t {
    name,              ///< not reserved: names of a scene, and this language's own words
    word,              ///< names an item, a property or a switch
    unary_function,    ///< takes one argument, a full expression: sin(a < b)
    function,          ///< takes a list of arguments
    constant,          ///< a value: x, pi, true, clock
    colour,            ///< color, colour
    colour_prefix,     ///< rgb and its relatives
    channel,           ///< red, green, blue, filter, transmit, alpha
    layer,             ///< a word whose blocks may follow each other as one value: texture
    array,             ///< opens an array value
    function_literal,  ///< opens a function value
    directive,         ///< has a meaning only after #
};

struct Word {
    std::string_view spelling;
    WordClass word_class;
};

/// All reserved words of POV-Ray 3.7, including unimplemented ones, which are thus told apart from
/// misspelt words. Sorted within each class.
std::span<const Word> reserved_words();

/// Number of reserved words.
inline constexpr std::size_t reserved_word_count = 498;

/// Words of this language alone that make objects, such as `model`: they are names, which scenes
/// may declare, but have the same numbers in all tables.
std::span<const std::string_view> own_words();
inline constexpr std::size_t own_word_count = 1;

/// Whether the word, which is not reserved, has a value in the block that may begin with a sign:
/// `film { exposure -1 }`. Elsewhere it may be the name of a number, from which another is
/// subtracted.
bool takes_sign(std::string_view block, std::string_view word);

/// The number of a spelling in one Names table.
enum class NameId : std::uint32_t {};

inline constexpr NameId no_name{~std::uint32_t{0}};

class Names {
public:
    /// Holds the reserved words, in the order of reserved_words(), and then own_words().
    Names();

    /// The id of a spelling, which is added if necessary. Ids never change.
    NameId intern(std::string_view spelling);
    /// The id of a known spelling, or no_name.
    NameId find(std::string_view spelling) const;

    std::string_view spelling(NameId id) const {
        return entries_[static_cast<std::size_t>(id)].spelling;
    }
    WordClass word_class(NameId id) const;
    bool reserved(NameId id) const { return static_cast<std::size_t>(id) < reserved_word_count; }
    std::size_t size() const { return entries_.size(); }

private:
    struct Entry {
        std::string_view spelling;
        std::uint32_t hash;
    };

    std::size_t slot(std::string_view spelling, std::uint32_t hash) const;
    void grow();

    std::vector<Entry> entries_;
    /// Open addressing; a power of two, at most half full; 0: free, else id + 1.
    std::vector<std::uint32_t> slots_;
    std::deque<std::string> texts_;  ///< owns the spellings that are not reserved
};

}  // namespace candelabra
