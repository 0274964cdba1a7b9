// SPDX-License-Identifier: GPL-3.0-or-later
// One parameter of one item, typed: its name, where it is stored, where it stands in the text,
// which values it takes. Items state their fields once, in their .cpp files; language, manual and
// tests read them from ItemInfo.
#pragma once

#include "vocabulary/item_info.h"

namespace candelabra {

/// For fields that are kept elsewhere than in one member.
struct NoMember {};

/// What a field can hold. Vec3 members named as colours take colours; see Field::rgb.
template <class T>
using Member =
    std::variant<double T::*, int T::*, bool T::*, Vec2 T::*, Vec3 T::*, Vec4 T::*, Colour T::*,
                 std::string T::*, std::optional<double> T::*, std::optional<Vec2> T::*,
                 std::optional<Vec3> T::*, std::vector<double> T::*, std::vector<Vec2> T::*,
                 std::vector<Vec3> T::*, std::vector<Ball> T::*, std::vector<Face> T::*,
                 Handle<Formula> T::*, NoMember>;

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
    /// A value without a word that the text may omit (the hole of a disc).
    bool may_be_left_out = false;
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

}  // namespace candelabra
