// SPDX-License-Identifier: GPL-3.0-or-later
// What every shape promises, checked for each alternative of Shape with the instances of the table
// (support/shapes.h). A shape that is added to the variant is tested here without a line of its own.
#include "shape/built_shape.h"

#include "support/draw.h"
#include "support/hits.h"
#include "support/shapes.h"

#include <catch2/catch.hpp>

namespace candelabra {

using namespace shape_table;

namespace {

struct Aim {
    Ray ray;
    double size;  ///< of the shape, in lengths of the ray's direction
};

/// Rays through the region: from near and far, skew and along the axes, with directions of any
/// length.
template <class T>
std::vector<Aim> shots(const T& shape, int count) {
    const Box box = region(shape);
    const double size = length(box.size());
    Draw draw(11);
    std::vector<Aim> result;
    for (int i = 0; i < count; ++i) {
        const Vec3 u(draw.number(), draw.number(), draw.number());
        const Vec3 target = box.low + u * box.size();
        Vec3 direction = draw.direction();
        if (i % 4 == 0) {
            direction = Vec3(0);
            direction[i / 4 % 3] = i % 8 == 0 ? 1 : -1;
        }
        const Vec3 origin = target - draw.between(-1, i % 5 == 0 ? 1000 : 2) * size * direction;
        const double scale = std::pow(10, draw.between(-3, 3));
        result.push_back({Ray{origin, scale * direction}, size / scale});
    }
    return result;
}

/// Rounding that the numbers of a ray and a shape allow in lengths.
double rounding(const Ray& ray, const Box& box) {
    return 1e-13 * (max_abs_component(ray.origin) + max_abs_component(box.low) +
                    max_abs_component(box.high));
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("every shape is found by its keyword, and its defaults lie in their ranges",
                        "[shape]", Shape) {
    using T = ContentOf<TestType>;
    const ItemInfo& info = T::vocabulary;
    const std::size_t index = Kinds<Shape>::find(info.name);
    REQUIRE(index < Kinds<Shape>::count);
    const Shape fresh = Kinds<Shape>::make(index);
    CHECK(std::holds_alternative<TestType>(fresh));
    CHECK_FALSE(info.help.empty());
    for (std::size_t i = 0; i < info.fields.size(); ++i) {
        INFO(info.name << " " << info.fields[i].name);
        CHECK_FALSE(info.fields[i].help.empty());
        const FieldValue value = info.default_value(i);
        const Range& range = info.fields[i].range;
        if (const auto* number = std::get_if<double>(&value)) CHECK(range.contains(*number));
        if (const auto* v = std::get_if<Vec3>(&value))
            CHECK((range.contains(v->x) && range.contains(v->y) && range.contains(v->z)));
    }
}

TEMPLATE_LIST_TEST_CASE("every shape says what is wrong with it, also through Shape", "[shape]",
                        Shape) {
    using T = ContentOf<TestType>;
    for (const T& shape : others<T>()) CHECK((problem(shape).empty() && vanishes(shape).empty()));
    for (const T& shape : instances<T>()) CHECK(problem(Shape(TestType(shape))).empty());
    // All numbers 0 is the worst that a text can say; where no range rejects it, the sentence names
    // the keyword.
    const ItemInfo& info = T::vocabulary;
    T zero{};
    bool in_range = true;
    for (std::size_t i = 0; i < info.fields.size(); ++i) {
        if (info.fields[i].type == FieldType::number) info.set(&zero, i, 0.0);
        if (info.fields[i].type == FieldType::vector3) info.set(&zero, i, Vec3(0));
        if (info.fields[i].type == FieldType::vector2) info.set(&zero, i, Vec2(0));
        const bool ranged =
            info.fields[i].type == FieldType::number || info.fields[i].type == FieldType::vector2;
        in_range = in_range && (!ranged || info.fields[i].range.contains(0));
    }
    const std::string said = problem(Shape(TestType(zero)));
    INFO(info.name << ": " << said);
    if (!said.empty()) CHECK(said.find(info.name) != std::string::npos);
    // A box and an egg without any size are allowed: they are met nowhere but in one point.
    const bool left_out = said.empty() && !vanishes(Shape(TestType(zero))).empty();
    const bool point = info.name == "box" || info.name == "ovus";
    if (in_range && !point && !left_out) CHECK_FALSE(said.empty());
}

TEMPLATE_LIST_TEST_CASE(
    "every shape crosses rays within its bounds, with unit normals that face outward", "[shape]",
    Shape) {
    using T = ContentOf<TestType>;
    for (const T& instance : instances<T>()) {
        const auto& shape = ready(instance);
        const Box box = bounds(shape);
        std::size_t met = 0;
        for (const Aim& shot : shots(shape, 800))
            for (const Crossing& c : hits(shape, shot.ray)) {
                ++met;
                // What a ray meets at a small angle, it meets less exactly.
                const double slant = std::abs(dot(unit(shot.ray.direction), c.normal));
                const Vec3 pad(rounding(shot.ray, region(shape)) / slant);
                CHECK(contains(Box{box.low - pad, box.high + pad}, shot.ray.at(c.t)));
                CHECK(std::abs(length(c.normal) - 1) < 1e-12);
                CHECK(c.entering == (dot(shot.ray.direction, c.normal) < 0));
            }
        CHECK(met > 50);
    }
}

TEMPLATE_LIST_TEST_CASE("every solid is entered and left in turn", "[shape]", Shape) {
    using T = ContentOf<TestType>;
    for (const T& instance : instances<T>()) {
        const auto& shape = ready(instance);
        for (const Aim& shot : shots(shape, 800)) {
            const std::vector<Crossing> found = hits(shape, shot.ray);
            if (crossed_once<T>) CHECK(found.size() <= 1);
            if (!solid<T>) continue;
            CHECK(found.size() % 2 == 0);
            for (std::size_t i = 0; i < found.size(); ++i) CHECK(found[i].entering == (i % 2 == 0));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("inside agrees with the crossings of every shape", "[shape]", Shape) {
    using T = ContentOf<TestType>;
    for (const T& instance : instances<T>()) {
        const auto& shape = ready(instance);
        for (const Aim& shot : shots(shape, 800)) {
            const std::vector<Crossing> found = hits(shape, shot.ray);
            const double step = 1e-4 * shot.size, unsure = 100 * rounding(shot.ray, region(shape)) /
                                                           length(shot.ray.direction);
            for (std::size_t i = 0; i < found.size(); ++i) {
                const double before = i > 0 ? found[i].t - found[i - 1].t : step;
                const double after = i + 1 < found.size() ? found[i + 1].t - found[i].t : step;
                if (0.5 * std::fmin(before, after) < unsure) continue;
                const Vec3 in_front = shot.ray.at(found[i].t - 0.5 * std::fmin(before, step));
                const Vec3 behind = shot.ray.at(found[i].t + 0.5 * std::fmin(after, step));
                CHECK(inside(shape, behind) == (has_inside<T> && found[i].entering));
                CHECK(inside(shape, in_front) == (has_inside<T> && !found[i].entering));
            }
            if (!solid<T>) continue;
            // From any point, the crossings ahead are odd in number exactly when it is inside.
            const bool near_surface =
                std::any_of(found.begin(), found.end(),
                            [&](const Crossing& c) { return std::abs(c.t) < unsure; });
            const auto ahead = std::count_if(found.begin(), found.end(),
                                             [](const Crossing& c) { return c.t > 0; });
            if (!near_surface) CHECK(inside(shape, shot.ray.origin) == (ahead % 2 == 1));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("no shape is crossed by a ray without direction", "[shape]", Shape) {
    using T = ContentOf<TestType>;
    for (const T& shape : instances<T>())
        CHECK(hits(ready(shape), Ray{Vec3(0.1, 0.2, 0.3), Vec3(0)}).empty());
}

}  // namespace candelabra
