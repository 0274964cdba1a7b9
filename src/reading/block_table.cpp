// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/block_table.h"

#include "scene/catalogue.h"
#include "text/ascii.h"

#include <algorithm>

namespace candelabra {

BlockTable::BlockTable(std::span<const BlockRow> rows, const BlockRow& shape, ReadObject read)
    : read_object(read), rows_(rows) {
    for (const Word& word : reserved_words()) {
        const bool is_shape = Kinds<Shape>::find(word.spelling) != Kinds<Shape>::count;
        by_number_.push_back(is_shape ? &shape : row(word.spelling));
    }
    for (const std::string_view word : own_words()) by_number_.push_back(row(word));
}

const BlockRow* BlockTable::row(std::string_view word) const {
    const auto found = std::ranges::find(rows_, word, &BlockRow::word);
    return found == rows_.end() ? nullptr : &*found;
}

const BlockRow* BlockTable::scene_row(std::string_view word) const {
    const BlockRow* const found = row(word);
    return found && found->in_scene ? found : nullptr;
}

std::vector<std::string_view> BlockTable::homes(std::string_view word) const {
    std::vector<std::string_view> result;
    const auto add = [&](std::string_view home) {
        if (!home.empty() && std::ranges::find(result, home) == result.end())
            result.push_back(home);
    };
    if (const BlockRow* found = row(word))
        for (std::string_view rest = main_homes(found->homes); !rest.empty();)
            add(take_until(rest, " "));
    for (const ItemGroup& group : catalogue())
        for (const ItemInfo* item : group.items) {
            const std::string_view home = group.block.empty() ? item->name : group.block;
            const auto is_word = [&](const FieldInfo& field) {
                return field.is_word() && field.name == word;
            };
            if (std::ranges::any_of(item->fields, is_word)) add(home);
            if (item->name == word) add(group.block);
        }
    return result;
}

bool BlockTable::knows(std::string_view word) const {
    const auto has_item = [&](const ItemGroup& group) {
        return std::ranges::find(group.items, word, &ItemInfo::name) != group.items.end();
    };
    return row(word) || std::ranges::any_of(catalogue(), has_item) || !homes(word).empty();
}

std::string_view main_homes(std::string_view homes) {
    return homes.starts_with('|') ? std::string_view() : homes.substr(0, homes.find(" |"));
}

}  // namespace candelabra
