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
};
inline constexpr Placement positional = Placement::positional;
inline constexpr Placement item = Placement::item;
inline constexpr Placement flag = Placement::flag;
inline constexpr Placement list = Placement::list;

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

/// What a field can hold. Vec3 members named as colours take colours; see Field::rgb.
template <class T>
using Member = std::variant<double T::*, int T::*, bool T::*, Vec2 T::*, Vec3 T::*, Colour T::*,
                            std::string T::*, std::optional<double> T::*, std::optional<Vec3> T::*,
                            std::vector<Vec3> T::*, std::vector<Face> T::*>;

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
        false;  ///< a positional field that the text may omit (the hole of a disc)
};

/// The same field, as a colour.
template <class T>
constexpr Field<T> as_colour(Field<T> field) {
    field.colour = true;
    return field;
}

/// The same field, which the text may leave out.
template <class T>
constexpr Field<T> maybe(Field<T> field) {
    field.may_be_left_out = true;
    return field;
}
