// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/block_words.h"

#include "bind/blocks.h"
#include "objects/object_draft.h"
#include "scene/catalogue.h"
#include "scene/scene.h"
#include "text/ascii.h"
#include "vocabulary/parts.h"

#include <algorithm>
#include <span>

namespace candelabra {

namespace {

constexpr std::string_view all_objects = "objects", any_object = "object";
/// Blocks that take the kinds of `pigment`, such as patterns and waves.
constexpr std::string_view takers_of_patterns = "normal density texture";
/// Shapes that are made of other objects.
constexpr std::string_view takers_of_objects = "mesh hull";
constexpr std::string_view takers_of_colours =
    "pigment density background fog light_source color_map colour_map";
constexpr std::string_view colour_words = "rgb rgbf rgbt rgbft srgb srgbf srgbt srgbft";

bool lists(std::string_view list, std::string_view word) {
    while (!list.empty())
        if (take_until(list, " ") == word) return true;
    return false;
}

bool is_shape(std::string_view word) { return Kinds<Shape>::find(word) != Kinds<Shape>::count; }

bool is_object(std::string_view block) {
    const BlockRow* row = block_table().row(block);
    return is_shape(block) || (row && row->makes_object() && block != "light_source");
}

class Words {
public:
    void add_block(std::string_view block) {
        if (block == all_objects) return add_objects();
        for (const ItemGroup& group : catalogue())
            for (const ItemInfo* item : group.items) {
                if (group.block.empty() && item->name == block) add_fields(*item);
                add_parts(*item, block);
            }
        add_kinds(block);
        if (lists(takers_of_patterns, block)) add_kinds("pigment");
        add_rows(block);
        if (block.empty() || lists(takers_of_objects, block)) add_objects();
        const BlockRow* row = block_table().row(block);
        const bool combines = row && row->form == BlockRow::Form::combination;
        if (combines) add_fields(UnionSettings::vocabulary);
        if (row && !row->like.empty()) add_block(row->like);
        if (is_object(block)) add_of_objects();
        if (lists(takers_of_colours, block))
            for (std::string_view rest = colour_words; !rest.empty();)
                add({take_until(rest, " "), nullptr, {}, {}});
    }

    std::vector<BlockWord> take() { return std::move(all_); }

private:
    void add(BlockWord word) {
        if (std::ranges::find(all_, word.word, &BlockWord::word) == all_.end())
            all_.push_back(word);
    }

    void add_field(const ItemInfo& item, std::size_t field) {
        if (item.fields[field].is_word()) add({item.fields[field].name, &item, field, {}});
    }

    void add_fields(const ItemInfo& item) {
        for (std::size_t i = 0; i < item.fields.size(); ++i) add_field(item, i);
    }

    void add_of_objects() {
        add_rows(any_object);
        add_fields(Switches::vocabulary);
    }

    /// Adds the words of a part that stands in a block of the item, such as a triangle of a mesh.
    void add_parts(const ItemInfo& item, std::string_view block) {
        for (const FieldInfo& field : item.fields) {
            if (field.place != Placement::parts || field.name != block) continue;
            add_fields(field.parts->info());
            if (field.parts->look)
                for (const std::string_view word : {"texture", "pigment", "normal", "finish"})
                    add({word, nullptr, {}, {}});
            if (field.parts->transform)
                for (const BlockRow& row : block_table().rows())
                    if (lists(row.homes, "transform")) add({row.word, nullptr, {}, {}});
        }
    }

    /// Adds the kinds that the block's first word names: the fields of all of them, the names, and
    /// the other fields.
    void add_kinds(std::string_view block) {
        if (block.empty()) return;
        for (const ItemGroup& group : catalogue()) {
            if (group.block != block) continue;
            const ItemInfo& first = *group.items.front();
            for (std::size_t i = 0; i < first.fields.size(); ++i)
                if (std::ranges::all_of(group.items, [&](const ItemInfo* item) {
                        return std::ranges::find(item->fields, first.fields[i].name,
                                                 &FieldInfo::name) != item->fields.end();
                    }))
                    add_field(first, i);
            for (const ItemInfo* item : group.items)
                if (std::ranges::all_of(item->name, in_name))
                    add({item->name, item, {}, group.block});
            for (const ItemInfo* item : group.items) add_fields(*item);
        }
    }

    void add_rows(std::string_view block) {
        for (const bool main : {true, false})
            for (const BlockRow& row : block_table().rows()) {
                const bool here = block.empty() ? row.in_scene != nullptr
                                                : lists(row.homes, block) &&
                                                      lists(main_homes(row.homes), block) == main;
                if (here) add({row.word, nullptr, {}, {}});
            }
    }

    void add_objects() {
        for (const ItemInfo* shape : Kinds<Shape>::infos) add({shape->name, shape, {}, {}});
        for (const BlockRow& row : block_table().rows())
            if (row.makes_object()) add({row.word, nullptr, {}, {}});
    }

    std::vector<BlockWord> all_;
};

}  // namespace

std::vector<BlockWord> block_words(std::string_view block) {
    Words words;
    words.add_block(block);
    return words.take();
}

}  // namespace candelabra
