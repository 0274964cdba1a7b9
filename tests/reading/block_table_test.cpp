// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/block_table.h"

#include <catch2/catch.hpp>

#include <array>

namespace candelabra {

namespace {

constexpr std::array<BlockRow, 3> few_rows = {
    BlockRow{"union", "", BlockRow::Form::combination},
    BlockRow{"finish", "texture | object", BlockRow::Form::block}, BlockRow{"translate", "object"}};
constexpr BlockRow any_shape = {"shape", "", BlockRow::Form::object};

ObjectHandle no_object(Binder&, const Element&) { return nullptr; }

}  // namespace

TEST_CASE("a table of blocks finds rows by numbers and by words", "[reading]") {
    const BlockTable table(few_rows, any_shape, no_object);
    Names names;
    CHECK(table.rows().size() == 3);
    CHECK(table.row("finish") == table.row(names.find("finish")));
    CHECK(table.row(names.find("sphere"))->word == "shape");
    CHECK(table.row("sphere") == nullptr);
    CHECK(table.row(names.find("fog")) == nullptr);
    CHECK(table.row(no_name) == nullptr);
    CHECK(table.scene_row("finish") == nullptr);
    CHECK(table.read_object == no_object);
}

TEST_CASE("a table of blocks says what a word makes, and where it belongs", "[reading]") {
    const BlockTable table(few_rows, any_shape, no_object);
    Names names;
    CHECK(table.combines_objects(names.find("union")));
    CHECK_FALSE(table.combines_objects(names.find("box")));
    CHECK(table.makes_object(names.find("box")));
    CHECK_FALSE(table.makes_object(names.find("finish")));
    CHECK(table.takes_braces(names.find("finish")));
    CHECK_FALSE(table.takes_braces(names.find("translate")));
    CHECK(table.homes("finish") == std::vector<std::string_view>{"texture"});
    CHECK(table.homes("roughness") == std::vector<std::string_view>{"finish", "microfacet"});
    CHECK(table.homes("nothing").empty());
    CHECK(table.knows("translate"));
    CHECK(table.knows("sphere"));
    CHECK(table.knows("roughness"));
    CHECK_FALSE(table.knows("anisotropy"));
    CHECK(main_homes("texture | object") == "texture");
}

}  // namespace candelabra
