// SPDX-License-Identifier: GPL-3.0-or-later
// A registry of the alternatives of a std::variant, from keyword to vocabulary to new value. The
// type list is the only list.
#pragma once

#include "base/shared.h"
#include "vocabulary/item_info.h"

#include <cstdint>

namespace candelabra {

namespace kinds_detail {

template <class T>
struct Content {
    using type = T;
};
template <class T>
struct Content<Shared<T>> {
    using type = T;
};

template <class T>
void* address(T& item) {
    return &item;
}
template <class T>
void* address(Shared<T>& item) {
    return &item.edit();
}

}  // namespace kinds_detail

/// The item type inside an alternative: T for T and for Shared<T>.
template <class T>
using ContentOf = typename kinds_detail::Content<T>::type;

template <class Variant>
struct Kinds;

template <class... T>
struct Kinds<std::variant<T...>> {
    using Variant = std::variant<T...>;
    static constexpr std::size_t count = sizeof...(T);

    /// Vocabularies in the order of the alternatives.
    static constexpr std::array<const ItemInfo*, count> infos = {&ContentOf<T>::vocabulary...};

    /// Index of the alternative with this keyword, or count if there is none.
    static std::size_t find(std::string_view keyword) {
        std::size_t i = 0;
        while (i < count && infos[i]->name != keyword) ++i;
        return i;
    }

    /// The same for the number of a reserved word.
    static std::size_t find(NameId word) {
        static const std::vector<std::uint8_t> by_word = indices_by_word();
        return static_cast<std::size_t>(word) < by_word.size()
                   ? by_word[static_cast<std::size_t>(word)]
                   : count;
    }

    /// A fresh alternative with its default values. Precondition: index < count.
    static Variant make(std::size_t index) {
        static constexpr std::array<Variant (*)(), count> makers = {[] { return Variant(T{}); }...};
        return makers[index]();
    }

    /// Replaces the value by a fresh alternative and returns that for ItemInfo::set. Precondition:
    /// index < count.
    static void* emplace(Variant& value, std::size_t index) {
        static constexpr std::array<void* (*)(Variant&), count> makers = {
            [](Variant& v) { return kinds_detail::address(v.template emplace<T>()); }...};
        return makers[index](value);
    }

    /// The active alternative, for ItemInfo::set.
    static void* address(Variant& value) {
        return std::visit([](auto& alternative) { return kinds_detail::address(alternative); },
                          value);
    }

private:
    static_assert(count < 256);

    static std::vector<std::uint8_t> indices_by_word() {
        std::vector<std::uint8_t> result;
        for (std::size_t i = 0; i < count; ++i) {
            const auto word = static_cast<std::size_t>(infos[i]->word);
            if (infos[i]->word == no_name) continue;
            if (word >= result.size()) result.resize(word + 1, count);
            result[word] = static_cast<std::uint8_t>(i);
        }
        return result;
    }
};

}  // namespace candelabra
