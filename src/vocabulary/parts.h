// SPDX-License-Identifier: GPL-3.0-or-later
// Items with parts in blocks of their own: the spheres of a blob, the triangles of a mesh. A part
// is an item with a vocabulary; the field names the list that holds it. Parts with a member
// `transform` can be transformed. Parts with a member `look` can have a texture: `look` is its
// number among the textures of the enclosing object, -1 for none. A member `looks` has three of
// them, one for each corner.
#pragma once

#include "base/transform.h"
#include "vocabulary/field.h"

namespace candelabra {

/// Untyped access to the parts in one list of an item.
struct PartsInfo {
    const ItemInfo& (*info)();
    void* (*add)(void* item);  ///< appends a part; valid until the next one
    std::size_t (*count)(const void* item);
    const void* (*at)(const void* item, std::size_t i);
    Transform* (*transform)(void* part);  ///< null: parts are not transformed
    int* (*look)(void* part);             ///< null: parts have no textures of their own
    int looks;                            ///< number of texture numbers at look()
};

namespace parts_detail {

template <class M>
struct ListOf;
template <class T, class P>
struct ListOf<std::vector<P> T::*> {
    using Item = T;
    using Part = P;
};

template <auto list>
struct Access {
    using Item = typename ListOf<decltype(list)>::Item;
    using Part = typename ListOf<decltype(list)>::Part;

    static std::vector<Part>& parts(void* item) { return static_cast<Item*>(item)->*list; }
    static const std::vector<Part>& parts(const void* item) {
        return static_cast<const Item*>(item)->*list;
    }
    static const ItemInfo& info() { return Part::vocabulary; }
    static void* add(void* item) { return &parts(item).emplace_back(); }
    static std::size_t count(const void* item) { return parts(item).size(); }
    static const void* at(const void* item, std::size_t i) { return &parts(item)[i]; }
    static Transform* transform(void* part) {
        if constexpr (requires(Part & p) { p.transform; })
            return &static_cast<Part*>(part)->transform;
        return nullptr;
    }
    static int* look(void* part) {
        if constexpr (requires(Part & p) { p.look; }) return &static_cast<Part*>(part)->look;
        if constexpr (requires(Part & p) { p.looks; })
            return static_cast<Part*>(part)->looks.data();
        return nullptr;
    }
    static constexpr bool moves = requires(Part & p) { p.transform; };
    static constexpr int looks = requires(Part & p) { p.looks; }
    ? 3 : requires(Part& p) { p.look; }
    ? 1 : 0;
    static constexpr PartsInfo all{
        info, add, count, at, moves ? transform : nullptr, looks > 0 ? look : nullptr, looks};
};

}  // namespace parts_detail

/// A word whose blocks are parts in that list: parts<&Blob::spheres>("sphere", "...").
template <auto list>
constexpr auto parts(std::string_view name, std::string_view help) {
    using Access = parts_detail::Access<list>;
    Field<typename Access::Item> field{name, NoMember{}, Placement::parts, help};
    field.parts = &Access::all;
    return field;
}

/// A word that precedes a part's values, which stand without braces.
template <auto list>
constexpr auto loose_parts(std::string_view name, std::string_view help) {
    auto field = parts<list>(name, help);
    field.place = Placement::loose_part;
    return field;
}

}  // namespace candelabra
