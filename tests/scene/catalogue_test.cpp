// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/catalogue.h"

#include <catch2/catch.hpp>

#include <set>
#include <string_view>

namespace candelabra {

TEST_CASE("every group and item has a name and an explanation, no name twice in a group") {
    std::set<std::string_view> groups;
    for (const ItemGroup& group : catalogue()) {
        CAPTURE(group.name);
        CHECK(groups.insert(group.name).second);
        CHECK(group.help.ends_with('.'));
        CHECK_FALSE(group.items.empty());
        std::set<std::string_view> items;
        for (const ItemInfo* item : group.items) {
            CAPTURE(item->name);
            CHECK(items.insert(item->name).second);
            CHECK(item->help.ends_with('.'));
            std::set<std::string_view> fields;
            for (const FieldInfo& field : item->fields) {
                CAPTURE(field.name);
                CHECK(fields.insert(field.name).second);
                CHECK_FALSE(field.help.empty());
            }
        }
    }
    for (const char* expected :
         {"Shapes", "Cameras", "Lights", "Patterns", "Surfaces", "Settings", "Light samplers"})
        CHECK(groups.count(expected) == 1);
}

TEST_CASE("the parser knows each word that is not reserved and takes values with a sign") {
    const auto takes_negative = [](const FieldInfo& field) {
        const bool numbers = field.type == FieldType::number || field.type == FieldType::integer ||
                             field.type == FieldType::vector2 ||
                             field.type == FieldType::vector3 || field.type == FieldType::vector4;
        return numbers && field.place == Placement::item && field.range.low < 0;
    };
    for (const ItemGroup& group : catalogue())
        for (const ItemInfo* item : group.items)
            for (const FieldInfo& field : item->fields) {
                if (!field.is_word() || field.word != no_name) continue;
                INFO(group.name << ": " << item->name << ": " << field.name);
                const std::string_view block = group.block.empty() ? item->name : group.block;
                CHECK(takes_sign(block, field.name) == takes_negative(field));
            }
    CHECK_FALSE(takes_sign("sphere", "exposure"));
}

TEST_CASE("the default values of numbers lie in their ranges") {
    for (const ItemGroup& group : catalogue()) {
        for (const ItemInfo* item : group.items) {
            for (std::size_t i = 0; i < item->fields.size(); ++i) {
                const FieldValue value = item->default_value(i);
                const auto* number = std::get_if<double>(&value);
                CAPTURE(item->name, item->fields[i].name);
                CHECK((!number || item->fields[i].range.contains(*number)));
            }
        }
    }
}

}  // namespace candelabra
