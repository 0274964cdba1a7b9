// SPDX-License-Identifier: GPL-3.0-or-later
// Items made of blocks of their own: the spheres of a blob, the triangles of a mesh. A part is an
// item with a vocabulary; the field says in which list of the whole it is kept. Parts that have a
// member `transform` may be moved; those that have a member `look` may have a texture: it is the
// texture's number in the object that the whole belongs to, -1 for none; a member `looks` has three
// of them, for the corners.
#pragma once

#include "base/transform.h"
#include "vocabulary/field.h"

namespace candelabra {

/// Access to the parts in one list of an item, without their type.
struct PartsInfo {
    const ItemInfo& (*info)();
    void* (*add)(void* item);  ///< a fresh part at the end; valid until the next one
    std::size_t (*count)(const void* item);
    const void* (*at)(const void* item, std::size_t i);
    Transform* (*transform)(void* part);  ///< null: they are not moved
    int* (*look)(void* part);             ///< null: they have no textures of their own
    int looks;                            ///< how many numbers are there
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

/// A word after which a part's values stand without braces.
template <auto list>
constexpr auto loose_parts(std::string_view name, std::string_view help) {
    auto field = parts<list>(name, help);
    field.place = Placement::loose_part;
    return field;
}

}  // namespace candelabra
