// SPDX-License-Identifier: GPL-3.0-or-later
// One parameter of one item: its name, where it is stored, where it stands in the text, which
// values it takes. Items state their fields once, in vocabulary(); language, manual and tests read
// them from there.
#pragma once

#include "base/colour.h"
#include "base/vector.h"

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// Where a parameter stands in its block.
enum class Placement {
    positional,  ///< a value without a word, in the order of the fields
    item,        ///< the word, then the value
    flag,        ///< the word alone; a number behind it switches it off (0) or on
    list,        ///< the word, then { count, value, value, ... }
    counted,     ///< a count, then so many entries, without a word, after the positional fields
    choice,      ///< the word alone, one of several that set the same member to a number
    following,   ///< a value right after that of the field before it, an item
    parts,       ///< the word, then a block; any number of them
    loose_part,  ///< the word, then the values of a part without a block; any number of them
};
inline constexpr Placement positional = Placement::positional;
inline constexpr Placement item = Placement::item;
inline constexpr Placement flag = Placement::flag;
inline constexpr Placement list = Placement::list;
inline constexpr Placement counted = Placement::counted;
inline constexpr Placement choice = Placement::choice;
inline constexpr Placement following = Placement::following;

/// Values that a number may take (each component, for vectors).
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_excluded = false;

    bool contains(double x) const { return (low_excluded ? x > low : x >= low) && x <= high; }
};
constexpr Range at_least(double low) {
    return {low, std::numeric_limits<double>::infinity(), false};
}
constexpr Range above(double low) { return {low, std::numeric_limits<double>::infinity(), true}; }
constexpr Range between(double low, double high) { return {low, high, false}; }

using Face = std::array<int, 3>;

/// A centre and a radius, written one after the other.
struct Ball {
    Vec3 centre = Vec3(0);
    double radius = 0;
    friend bool operator==(const Ball&, const Ball&) = default;
};

/// For fields that are kept elsewhere than in one member.
struct NoMember {};

struct PartsInfo;

/// What a field can hold. Vec3 members named as colours take colours; see Field::rgb.
template <class T>
using Member =
    std::variant<double T::*, int T::*, bool T::*, Vec2 T::*, Vec3 T::*, Vec4 T::*, Colour T::*,
                 std::string T::*, std::optional<double> T::*, std::optional<Vec3> T::*,
                 std::vector<double> T::*, std::vector<Vec2> T::*, std::vector<Vec3> T::*,
                 std::vector<Ball> T::*, std::vector<Face> T::*, NoMember>;

/// One parameter of the item T.
template <class T>
struct Field {
    std::string_view name;
    Member<T> member;
    Placement place;
    std::string_view help;
    Range range = {};
    bool colour = false;  ///< a Vec3 that means red, green, blue: any colour is taken, filter and
                          ///< transmit are dropped
    bool may_be_left_out =
        false;          ///< a positional field that the text may omit (the hole of a disc)
    double chosen = 0;  ///< what the word of a choice stands for
    int entries = 0;    ///< of a counted field that has always so many; 0: the text says how many
    const PartsInfo* parts = nullptr;  ///< see parts.h
};

/// The same field, as a colour.
template <class T>
constexpr Field<T> as_colour(Field<T> field) {
    field.colour = true;
    return field;
}

/// The same counted field with a fixed number of entries, which the text does not say.
template <class T>
constexpr Field<T> always(int entries, Field<T> field) {
    field.entries = entries;
    return field;
}

/// A word that sets a member which it shares with others to a number (an enumerator).
template <class T>
constexpr Field<T> chooses(std::string_view name, int T::*member, int chosen,
                           std::string_view help) {
    Field<T> field{name, member, choice, help};
    field.chosen = chosen;
    return field;
}

/// The same field, which the text may leave out.
template <class T>
constexpr Field<T> maybe(Field<T> field) {
    field.may_be_left_out = true;
    return field;
}
