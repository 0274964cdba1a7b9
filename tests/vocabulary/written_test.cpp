// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/written.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("values are written as a scene would give them") {
    struct Case {
        FieldValue value;
        FieldType type;
        std::string expected;
    };
    const Case cases[] = {
        {FieldValue(), FieldType::number, ""},
        {0.1, FieldType::number, "0.1"},
        {-0.0, FieldType::number, "-0"},
        {Vec3(0, -0.0, 0), FieldType::vector3, "<0, -0, 0>"},
        {3.0, FieldType::integer, "3"},
        {1.0, FieldType::boolean, "on"},
        {0.0, FieldType::boolean, "off"},
        {Vec2(1, 2), FieldType::vector2, "<1, 2>"},
        {Vec3(1, 2, 3), FieldType::vector3, "<1, 2, 3>"},
        {Vec3(2), FieldType::vector3, "2"},
        {Vec3(2), FieldType::rgb, "rgb 2"},
        {Colour{Rgb(1, 0, 0)}, FieldType::colour, "rgb <1, 0, 0>"},
        {Colour{Rgb(1, 0, 0), 0.5, 0.25}, FieldType::colour, "rgbft <1, 0, 0, 0.5, 0.25>"},
        {std::string("a \"b\" \\c"), FieldType::text, "\"a \\\"b\\\" \\\\c\""},
        {std::vector<Vec3>{Vec3(0), Vec3(1, 2, 3)}, FieldType::vectors, "2, <0, 0, 0>, <1, 2, 3>"},
        {std::vector<Vec2>{Vec2(0), Vec2(1, 2)}, FieldType::points, "2, <0, 0>, <1, 2>"},
        {std::vector<Ball>{{Vec3(1), 2}}, FieldType::balls, "1, <1, 1, 1>, 2"},
        {std::vector<double>{1, 2.5, 3}, FieldType::numbers, "<1, 2.5, 3>"},
        {std::vector<Face>{{0, 1, 2}}, FieldType::faces, "1, <0, 1, 2>"},
    };
    for (const Case& each : cases) CHECK(written(each.value, each.type) == each.expected);
}

namespace {

struct Item {
    Vec3 centre = Vec3(0);
    double radius = 1;
    double angle = 30;
    bool open = false;
    bool closed = true;
    std::optional<double> wide;

    static const ItemInfo vocabulary;
};

const ItemInfo Item::vocabulary = described<Item>([] {
    using F = Field<Item>;
    return schema<Item>("item", "An item.", F{"centre", &Item::centre, positional, "a"},
                        maybe(F{"radius", &Item::radius, positional, "b"}),
                        F{"angle", &Item::angle, item, "c"}, F{"open", &Item::open, flag, "d"},
                        F{"closed", &Item::closed, flag, "e"}, F{"wide", &Item::wide, item, "f"});
});

}  // namespace

TEST_CASE("fields that have their defaults are left out, places never are") {
    Item thing;
    CHECK(written_fields(Item::vocabulary, &thing) == "0, 1");
    thing.angle = 45;
    thing.open = true;
    thing.closed = false;
    thing.wide = 2;
    CHECK(written_fields(Item::vocabulary, &thing) == "0, 1 angle 45 open closed off wide 2");
}

}  // namespace candelabra
