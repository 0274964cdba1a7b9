// SPDX-License-Identifier: GPL-3.0-or-later
// One typed parameter of an item: its name, its member, its place in the text and its range. Items
// state their fields once, in their .cpp files; language, manual and tests read them from ItemInfo.
#pragma once

#include "vocabulary/item_info.h"

namespace candelabra {

/// For fields that are not stored in one member.
struct NoMember {};

/// The members that a field can refer to. A Vec3 may hold a colour; see Field::colour.
template <class T>
using Member =
    std::variant<double T::*, int T::*, bool T::*, Vec2 T::*, Vec3 T::*, Vec4 T::*, Colour T::*,
                 std::string T::*, std::optional<int> T::*, std::optional<double> T::*,
                 std::optional<Vec2> T::*, std::optional<Vec3> T::*, std::vector<double> T::*,
                 std::vector<Vec2> T::*, std::vector<Vec3> T::*, std::vector<Ball> T::*,
                 std::vector<Face> T::*, Handle<Formula> T::*, NoMember>;

/// One parameter of the item T.
template <class T>
struct Field {
    std::string_view name;
    Member<T> member;
    Placement place;
    std::string_view help;
    Range range = {};
    /// Whether a Vec3 holds red, green and blue: it takes any colour, without filter and transmit.
    bool colour = false;
    /// Whether the text may omit the value, such as the hole of a disc.
    bool may_be_left_out = false;
    double chosen = 0;  ///< value that the word of a choice stands for
    int entries = 0;    ///< fixed number of entries of a counted field; 0: given in the text
    const PartsInfo* parts = nullptr;  ///< see parts.h
};

/// The same field, as a colour.
template <class T>
constexpr Field<T> as_colour(Field<T> field) {
    field.colour = true;
    return field;
}

/// The same counted field with a fixed number of entries, which the text does not give.
template <class T>
constexpr Field<T> always(int entries, Field<T> field) {
    field.entries = entries;
    return field;
}

/// A word that sets a member, shared with other words, to a number (an enumerator).
template <class T>
constexpr Field<T> chooses(std::string_view name, int T::*member, int chosen,
                           std::string_view help) {
    Field<T> field{name, member, choice, help};
    field.chosen = chosen;
    return field;
}

/// The same field, which the text may omit.
template <class T>
constexpr Field<T> maybe(Field<T> field) {
    field.may_be_left_out = true;
    return field;
}

}  // namespace candelabra
