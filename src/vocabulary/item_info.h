// SPDX-License-Identifier: GPL-3.0-or-later
// The vocabulary of one item for readers that do not know its type: the language, the manual and
// editors. Every item has one, `static const ItemInfo vocabulary`, which its .cpp file makes with
// described() (schema.h).
#pragma once

#include "base/colour.h"
#include "base/handle.h"
#include "base/vector.h"
#include "vocabulary/words.h"

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace candelabra {

class Formula;

/// Where a parameter stands in its block.
enum class Placement {
    positional,  ///< a value without a word, in the order of the fields
    item,        ///< the word, then the value
    flag,        ///< the word alone; a number behind it switches it off (0) or on
    list,        ///< the word, then { count, value, value, ... }
    counted,     ///< a count, then as many entries, without a word; after the positional fields
    choice,      ///< the word alone, one of several that set the same member to a number
    following,   ///< a value right after that of the preceding field; optional if the field says so
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

/// Values that a number, or each component of a vector, may have.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_excluded = false;
    bool any_sign = false;  ///< only the absolute value counts, as for radii in POV-Ray

    bool contains(double x) const { return (low_excluded ? x > low : x >= low) && x <= high; }
};
constexpr Range at_least(double low) {
    return {low, std::numeric_limits<double>::infinity(), false};
}
constexpr Range above(double low) { return {low, std::numeric_limits<double>::infinity(), true}; }
constexpr Range any_sign() { return {0, std::numeric_limits<double>::infinity(), false, true}; }
constexpr Range between(double low, double high) { return {low, high, false}; }

using Face = std::array<int, 3>;

/// A centre and a radius, written one after the other.
struct Ball {
    Vec3 centre = Vec3(0);
    double radius = 0;
    friend bool operator==(const Ball&, const Ball&) = default;
};

struct PartsInfo;

/// The value of a field. Integers and switches are passed as double.
using FieldValue = std::variant<std::monostate, double, Vec2, Vec3, Vec4, Colour, std::string,
                                std::vector<double>, std::vector<Vec2>, std::vector<Vec3>,
                                std::vector<Ball>, std::vector<Face>, Handle<Formula>>;

enum class FieldType {
    number,
    integer,
    boolean,
    vector2,
    vector3,
    vector4,
    rgb,
    colour,
    text,
    numbers,
    points,
    vectors,
    balls,
    faces,
    function,
    parts
};

/// One field, without the type of its item.
struct FieldInfo {
    std::string_view name;
    std::string_view help;
    Placement place;
    FieldType type;
    Range range;
    bool may_be_left_out;    ///< also true for std::optional members
    NameId word;             ///< no_name: the name is not reserved; only its spelling is known
    double chosen;           ///< value that the word of a choice stands for
    int entries;             ///< fixed number of entries of a counted field; otherwise 0
    const PartsInfo* parts;  ///< of a field that is placed as parts; otherwise null

    /// Whether the value comes without a word.
    constexpr bool unnamed() const {
        return place == Placement::positional || place == Placement::counted;
    }
    /// Whether the field's name is a word of the language.
    constexpr bool is_word() const { return !unnamed() && place != Placement::following; }
};

/// One item's vocabulary, without its type. All instances are constants.
struct ItemInfo {
    std::string_view name;
    std::string_view help;
    std::span<const FieldInfo> fields;
    /// The value must have the field's type.
    void (*set)(void* item, std::size_t field, const FieldValue& value);
    /// Returns monostate for an unset optional.
    FieldValue (*get)(const void* item, std::size_t field);
    FieldValue (*default_value)(std::size_t field);
    NameId word;     ///< of the name, if it is reserved
    int positional;  ///< number of fields without a word, which come first
    /// Texts that show it, the simplest first (vocabulary/examples.h).
    std::span<const std::string_view> examples = {};
};

}  // namespace candelabra
