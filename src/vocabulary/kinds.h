// SPDX-License-Identifier: GPL-3.0-or-later
// The alternatives of a std::variant as a registry: keyword to vocabulary to a fresh value. The
// type list is the only list.
#pragma once

#include "vocabulary/schema.h"

#include <utility>

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
    static constexpr std::array<const ItemInfo*, count> infos = {&item_info<ContentOf<T>>()...};

    /// Index of the alternative with this keyword; count when there is none.
    static constexpr std::size_t find(std::string_view keyword) {
        std::size_t i = 0;
        while (i < count && infos[i]->name != keyword) ++i;
        return i;
    }

    /// The same for the number of a reserved word.
    static constexpr std::size_t find(NameId word) {
        return static_cast<std::size_t>(word) < by_word.size()
                   ? by_word[static_cast<std::size_t>(word)]
                   : count;
    }

    /// A fresh alternative with its default values. Precondition: index < count.
    static Variant make(std::size_t index) {
        static constexpr std::array<Variant (*)(), count> makers = {[] { return Variant(T{}); }...};
        return makers[index]();
    }

    /// Makes the value a fresh alternative; gives it for ItemInfo::set. Precondition: index <
    /// count.
    static void* emplace(Variant& value, std::size_t index) {
        static constexpr std::array<void* (*)(Variant&), count> makers = {
            [](Variant& v) { return kinds_detail::address(v.template emplace<T>()); }...};
        return makers[index](value);
    }

    /// The active alternative for ItemInfo::set.
    static void* address(Variant& value) {
        return std::visit([](auto& alternative) { return kinds_detail::address(alternative); },
                          value);
    }

private:
    static constexpr auto by_word = [] {
        static_assert(count < 256);
        std::array<std::uint8_t, reserved_detail::words.size()> result{};
        result.fill(count);
        for (std::size_t i = 0; i < count; ++i)
            if (infos[i]->word != no_name) result[static_cast<std::size_t>(infos[i]->word)] = i;
        return result;
    }();

    static constexpr bool distinct() {
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t j = 0; j < i; ++j)
                if (infos[i]->name == infos[j]->name) return false;
        return true;
    }
    static_assert(distinct(), "two kinds of a variant have the same keyword");
};
