// SPDX-License-Identifier: GPL-3.0-or-later
// One typed parameter of an item: its name, its member, its place in the text and its range. Items
// state their fields once, in their .cpp files; language, manual and tests read them from ItemInfo.
#pragma once

#include "base/rgb.h"
#include "vocabulary/item_info.h"

#include <tuple>
#include <type_traits>

namespace candelabra {

/// For fields that are not stored in one member.
struct NoMember {};

/// The types of members that a field can refer to. An Rgb takes any colour, without filter and
/// transmit.
using MemberTypes =
    std::tuple<double, int, bool, Vec2, Vec3, Vec4, Rgb, Colour, std::string, std::optional<int>,
               std::optional<double>, std::optional<Vec2>, std::optional<Vec3>, std::vector<double>,
               std::vector<Vec2>, std::vector<Vec3>, std::vector<Ball>, std::vector<Face>,
               Handle<Formula>, NoMember>;

template <class T, class V>
struct MemberSlot {
    V T::*pointer = nullptr;
};
template <class T>
struct MemberSlot<T, NoMember> {};

template <class T, class Types>
class MemberOf;
/// A pointer to a member of T that has one of the types. A std::variant of such pointers would
/// take half of the compile time of an item's file.
template <class T, class... V>
class MemberOf<T, std::tuple<V...>> : MemberSlot<T, V>... {
public:
    constexpr MemberOf(NoMember = {}) : type_(number_of<NoMember>) {}
    /// The member may belong to a base of T.
    template <class M, class Base>
    constexpr MemberOf(M Base::*member) : MemberSlot<T, M>{member}, type_(number_of<M>) {}

    /// The number of its type in the list.
    constexpr std::size_t type() const { return type_; }
    /// Precondition: M is its type.
    template <class M>
    constexpr M T::*pointer() const {
        return MemberSlot<T, M>::pointer;
    }

private:
    template <class M>
    static constexpr std::size_t number_of = [] {
        std::size_t number = 0;
        static_cast<void>(((std::is_same_v<M, V> || (++number, false)) || ...));
        return number;
    }();

    std::size_t type_;
};
template <class T>
using Member = MemberOf<T, MemberTypes>;

/// One parameter of the item T.
template <class T>
struct Field {
    std::string_view name;
    Member<T> member;
    Placement place;
    std::string_view help;
    Range range = {};
    /// Whether the text may omit the value, such as the hole of a disc.
    bool may_be_left_out = false;
    double chosen = 0;  ///< value that the word of a choice stands for
    int entries = 0;    ///< fixed number of entries of a counted field; 0: given in the text
    const PartsInfo* parts = nullptr;  ///< see parts.h
};

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
