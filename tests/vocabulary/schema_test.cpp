// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/schema.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// One field of each type.
struct Sample {
    double number = 1.5;
    int whole = 3;
    bool on = true;
    Vec2 pair = Vec2(1, 2);
    Vec3 place = Vec3(1, 2, 3);
    Rgb light = Rgb(0.5);
    Colour tint = {Rgb(1), 0.25, 0};
    std::string text = "word";
    std::optional<double> perhaps;
    std::optional<Vec3> somewhere = Vec3(7);
    std::vector<Vec3> points = {Vec3(1)};
    std::vector<Face> faces = {{0, 1, 2}};

    static const ItemInfo vocabulary;
};

const ItemInfo Sample::vocabulary = described<Sample>([] {
    using F = Field<Sample>;
    return schema<Sample>(
        "sample", "One field of each type.",
        F{"number", &Sample::number, positional, "a number", above(1)},
        F{"whole", &Sample::whole, item, "an integer", between(0, 9)},
        F{"on", &Sample::on, flag, "a switch"}, F{"pair", &Sample::pair, item, "two numbers"},
        maybe(F{"place", &Sample::place, positional, "three numbers"}),
        F{"light", &Sample::light, item, "a colour without transparency"},
        F{"tint", &Sample::tint, item, "a colour"}, F{"text", &Sample::text, item, "a text"},
        F{"perhaps", &Sample::perhaps, item, "a number or none", at_least(0)},
        F{"somewhere", &Sample::somewhere, item, "a point or none"},
        F{"points", &Sample::points, list, "points"}, F{"faces", &Sample::faces, list, "faces"});
});

struct Plain {
    static const ItemInfo vocabulary;
};

const ItemInfo Plain::vocabulary =
    described<Plain>([] { return schema<Plain>("plain", "Has no fields."); });

}  // namespace

TEST_CASE("a vocabulary keeps its fields in order, with their types", "[vocabulary]") {
    const ItemInfo& info = Sample::vocabulary;
    CHECK(info.name == "sample");
    CHECK(info.help == "One field of each type.");
    struct Row {
        std::string_view name;
        FieldType type;
        Placement place;
        bool may_be_left_out;
    };
    const std::vector<Row> table = {
        {"number", FieldType::number, positional, false},
        {"whole", FieldType::integer, item, false},
        {"on", FieldType::boolean, flag, false},
        {"pair", FieldType::vector2, item, false},
        {"place", FieldType::vector3, positional, true},
        {"light", FieldType::rgb, item, false},
        {"tint", FieldType::colour, item, false},
        {"text", FieldType::text, item, false},
        {"perhaps", FieldType::number, item, true},
        {"somewhere", FieldType::vector3, item, true},
        {"points", FieldType::vectors, list, false},
        {"faces", FieldType::faces, list, false},
    };
    REQUIRE(info.fields.size() == table.size());
    for (std::size_t i = 0; i < table.size(); ++i) {
        INFO(table[i].name);
        CHECK(info.fields[i].name == table[i].name);
        CHECK(info.fields[i].type == table[i].type);
        CHECK(info.fields[i].place == table[i].place);
        CHECK(info.fields[i].may_be_left_out == table[i].may_be_left_out);
    }
    CHECK(Plain::vocabulary.fields.empty());
}

TEST_CASE("what is stored in a field is read from it", "[vocabulary]") {
    const ItemInfo& info = Sample::vocabulary;
    const std::vector<FieldValue> values = {
        2.5,
        7.0,
        0.0,
        Vec2(5, 6),
        Vec3(4),
        Vec3(9),
        Colour{Rgb(2), 0, 1},
        std::string("other"),
        8.0,
        Vec3(3),
        std::vector<Vec3>{Vec3(1), Vec3(2)},
        std::vector<Face>{{3, 4, 5}},
    };
    Sample sample;
    for (std::size_t i = 0; i < values.size(); ++i) {
        INFO(info.fields[i].name);
        CHECK_FALSE(info.get(&sample, i) == values[i]);
        info.set(&sample, i, values[i]);
        CHECK(info.get(&sample, i) == values[i]);
    }
    CHECK(sample.whole == 7);
    CHECK_FALSE(sample.on);
    CHECK(sample.perhaps == 8.0);
}

TEST_CASE("default values are those of the members", "[vocabulary]") {
    const ItemInfo& info = Sample::vocabulary;
    CHECK(info.default_value(0) == FieldValue(1.5));
    CHECK(info.default_value(2) == FieldValue(1.0));
    CHECK(info.default_value(7) == FieldValue(std::string("word")));
    CHECK(info.default_value(8) == FieldValue());
    CHECK(info.default_value(9) == FieldValue(Vec3(7)));
}

TEST_CASE("ranges contain their ends unless they exclude them, and no NaN", "[vocabulary]") {
    CHECK(Range{}.contains(-1e300));
    CHECK(at_least(0).contains(0));
    CHECK_FALSE(at_least(0).contains(-1e-300));
    CHECK_FALSE(above(0).contains(0));
    CHECK(above(0).contains(1e-300));
    CHECK(between(0, 9).contains(9));
    CHECK_FALSE(between(0, 9).contains(9.1));
    CHECK_FALSE(Range{}.contains(std::nan("")));
}

}  // namespace candelabra
