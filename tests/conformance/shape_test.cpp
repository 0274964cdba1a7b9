// SPDX-License-Identifier: GPL-3.0-or-later
// What every shape promises, checked for each alternative of Shape with its default values and with
// a table of others. A shape that is added to the variant is tested here without a line of its own.
#include "shape/built_shape.h"

#include "formula/builder.h"
#include "support/axes.h"
#include "support/draw.h"
#include "support/hits.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// Solids are bounded and entered as often as they are left; the others are half spaces or have no
/// inside.
template <class T>
constexpr bool solid = true;
template <>
constexpr bool solid<Plane> = false;
template <>
constexpr bool solid<Disc> = false;
template <>
constexpr bool solid<Cubic> = false;
template <>
constexpr bool solid<Triangle> = false;
template <>
constexpr bool solid<SmoothTriangle> = false;
template <>
constexpr bool solid<Polygon> = false;

template <class T>
constexpr bool has_inside = true;
template <>
constexpr bool has_inside<Triangle> = false;
template <>
constexpr bool has_inside<SmoothTriangle> = false;
template <>
constexpr bool has_inside<Polygon> = false;

template <>
constexpr bool solid<Parametric> = false;
template <>
constexpr bool solid<HeightField> = false;
template <>
constexpr bool solid<BicubicPatch> = false;
template <>
constexpr bool has_inside<Parametric> = false;
template <>
constexpr bool has_inside<BicubicPatch> = false;

Mesh tetrahedron() {
    Mesh mesh;
    mesh.vertices = {o, x, y, z};
    mesh.faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {3, 2, 1}};
    mesh.inside_vector = Vec3(1, 2, 3);
    return mesh;
}

/// Instances besides the default one.
template <class T>
std::vector<T> others() {
    return {};
}
template <>
std::vector<Sphere> others() {
    return {{Vec3(1, 2, 3), 1e-6}, {Vec3(-5, 1e3, 0), 1e3}, {Vec3(0), 1e6}, {Vec3(1e6), 0.5}};
}
template <>
std::vector<Cuboid> others() {
    return {{Vec3(1), Vec3(-2, -3, -4)}, {Vec3(0), Vec3(1e-6, 1, 1e4)}, {Vec3(1e5), Vec3(1e5 + 1)}};
}
template <>
std::vector<Plane> others() {
    return {{Vec3(1, -2, 3), -4}, {Vec3(0, 0, -1e-5), 2}, {Vec3(1e5, 1, 1), 10}};
}
template <>
std::vector<Disc> others() {
    return {{Vec3(1, 2, 3), Vec3(1, 1, -5), 2, 1.5}, {Vec3(0), Vec3(-1, 0, 0), 1e3, 0}};
}
template <>
std::vector<Cylinder> others() {
    return {{Vec3(1, 2, 3), Vec3(-3, 0, 1), 0.3, false},
            {Vec3(0), Vec3(0, 0, -1e3), 0.01, false},
            {Vec3(0), Vec3(1e-3), 5, false}};
}
template <>
std::vector<Cone> others() {
    return {{Vec3(1, 2, 3), 0, Vec3(-3, 0, 1), 1, false},
            {Vec3(0), 2, Vec3(0, 0, 5), 1.999999, false},
            {Vec3(0), 1, Vec3(1, 0, 0), 1, false},
            {Vec3(0), 10, Vec3(0, 0.01, 0), 0, false},
            {Vec3(0), 0.01, Vec3(0, -100, 0), 0.02, false},
            {Vec3(0), 1, Vec3(0, 1, 0), 0.5, false}};
}
template <>
std::vector<Triangle> others() {
    return {{Vec3(1, 2, 3), Vec3(-1, 0, 5), Vec3(3, 3, 3)}, {o, Vec3(1e-3, 0, 0), Vec3(0, 1e3, 0)}};
}
template <>
std::vector<SmoothTriangle> others() {
    return {{Vec3(1, 2, 3), Vec3(0, 1, 1), Vec3(-1, 0, 5), y, Vec3(3, 3, 3), Vec3(1, 1, 1)}};
}
template <>
std::vector<Torus> others() {
    return {{2, 0.5}, {1e3, 1}, {1, 1}, {1e-4, 1e-6}};
}
template <>
std::vector<Quadric> others() {
    return {{Vec3(1, 2, 3), Vec3(0.5, 1, -1), Vec3(3, -1, 2), -6},
            {Vec3(1e-6), o, o, -1},
            {Vec3(1e6, 1, 1), o, Vec3(10), -1}};
}
template <>
std::vector<Cubic> others() {
    std::vector<double> c(20, 0);
    c[0] = 1, c[10] = -2, c[15] = 1, c[18] = 1, c[19] = -1;
    return {{c}};
}
template <>
std::vector<Quartic> others() {
    std::vector<double> c(35, 0);
    c[0] = c[20] = c[30] = 1, c[34] = -1;
    return {{c}};
}
template <>
std::vector<Poly> others() {
    std::vector<double> c(factor_count(6), 0);
    c[0] = c[56] = c[77] = 1, c.back() = -1;
    return {{6, c}};
}
template <>
std::vector<Polynomial> others() {
    return {{6, {{6, 0, 0, 1}, {0, 6, 0, 1}, {0, 0, 6, 1}, {2, 0, 2, -1}, {0, 0, 0, -1}}}};
}
template <>
std::vector<Superellipsoid> others() {
    return {{{0.25, 0.5}}, {{1.5, 0.2}}, {{0.1, 2}}, {{3, 3}}, {{0.5, 3}}};
}
template <>
std::vector<Polygon> others() {
    return {{{o, x, x + y, y, o}}, {{Vec3(1, 2, 3), Vec3(-1, 0, 5), Vec3(3, 3, 3)}}};
}
template <>
std::vector<Prism> others() {
    const std::vector<Vec2> ring = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}, {0, 1}};
    const std::vector<Vec2> frame = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0},
                                     {1, 1}, {3, 1}, {3, 3}, {1, 3}, {1, 1}};
    return {{linear_sweep, linear_curve, 0, 1, frame, false},
            {linear_sweep, cubic_curve, -1, 1e-3, ring, false},
            {conic_sweep, cubic_curve, 1, 3, ring, false},
            {conic_sweep, linear_curve, 0, 2, frame, false},
            {linear_sweep, quadratic_curve, 5, 3, {ring.begin(), ring.begin() + 6}, false},
            {linear_sweep,
             bezier_curve,
             0,
             1,
             {{1, 0}, {1, 1}, {-1, 1}, {-1, 0}, {-1, 0}, {-1, -1}, {1, -1}, {1, 0}},
             false}};
}
template <>
std::vector<Lathe> others() {
    return {{linear_curve, {{0, 0}, {1, 1}, {0, 2}}},
            {linear_curve, {{0, 0}, {1, 0}, {1, 1}, {0.5, 1}, {0.5, 0.2}, {0, 0.2}}},
            {linear_curve, {{1, 0}, {2, 1}, {3, 0}, {1, 0}}},
            {cubic_curve, {{-1, -1}, {0, 0}, {1, 1}, {0.3, 2}, {0, 3}, {-1, 4}}},
            {bezier_curve, {{0, 0}, {2, 0.5}, {0.5, 1}, {0, 2}}}};
}
template <>
std::vector<Sor> others() {
    return {{{{0.5, -1}, {1, 0}, {0.5, 1}, {1, 2}, {0.2, 3}}, false},
            {{{0, 0}, {0, 0.1}, {3, 4}, {0.01, 20}, {1, 30}}, false}};
}
template <>
std::vector<Ovus> others() {
    return {{1, 0.7}, {1, 1}, {1, 1.9}, {1, 3}, {1e3, 1}};
}
template <>
std::vector<Mesh> others() {
    return {tetrahedron()};
}

template <>
std::vector<TriangleMesh> others() {
    TriangleMesh mesh;
    for (const Face& f : tetrahedron().faces) {
        const auto corner = [&](std::size_t i) {
            return tetrahedron().vertices[static_cast<std::size_t>(f[i])];
        };
        mesh.triangles.push_back({corner(0), corner(1), corner(2)});
    }
    mesh.inside_vector = Vec3(1, 2, 3);
    return {mesh};
}
template <>
std::vector<Isosurface> others() {
    // x^2 + y^2 + z^2 - 0.5, which is searched, and the same as code, whose gradient is given.
    ProgramBuilder builder;
    std::array<ProgramBuilder::Operand, 4> terms;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto place = builder.input();
        terms[i] = builder.emit(Operation::multiply, place, place);
    }
    terms[3] = builder.constant(-0.5);
    const auto sum = builder.fold(Operation::add, terms);
    Isosurface written, coded;
    written.function = make_handle<Formula>(builder.finish({&sum, 1}));
    coded.function = make_handle<Formula>(3, 1, [](const double* p, double* value) {
        *value = std::hypot(p[0], p[1], p[2]) - 1;
        return true;
    });
    coded.containers = {{{}, {{Vec3(0.5, 0, 0), 0.9}}}};
    return {written, coded};
}
template <>
std::vector<Parametric> others() {
    const auto function = [](double (*code)(double, double)) {
        return make_handle<Formula>(2, 1, [code](const double* p, double* value) {
            *value = code(p[0], p[1]);
            return true;
        });
    };
    Parametric ball;
    ball.x = function([](double u, double v) { return std::cos(u) * std::cos(v); });
    ball.y = function([](double, double v) { return std::sin(v); });
    ball.z = function([](double u, double v) { return std::sin(u) * std::cos(v); });
    ball.first = {0, -1.5};
    ball.last = {6, 1.5};
    return {ball};
}
template <>
std::vector<HeightField> others() {
    HeightGrid grid{5, 4, {}};
    for (int i = 0; i < 20; ++i)
        grid.values.push_back(static_cast<std::uint16_t>(i * i * 7919 % 65536));
    HeightField land, flooded;
    land.grid = flooded.grid = make_handle<HeightGrid>(grid);
    flooded.water_level = 0.4;
    return {land, flooded};
}
template <>
std::vector<BicubicPatch> others() {
    BicubicPatch sheet;
    sheet.type = 0;
    sheet.u_steps = sheet.v_steps = 3;
    for (int i = 0; i < 16; ++i)
        sheet.points.push_back(Vec3(i % 4, i / 4 % 3 == 0 ? 0 : i % 3, i / 4));
    return {sheet};
}
template <>
std::vector<JuliaFractal> others() {
    JuliaFractal julia;
    julia.parameter = Vec4(0.1, 0.1, 0, 0);
    julia.max_iteration = 5;
    julia.precision = 100;
    return {julia};
}
template <>
std::vector<Text> others() {
    Text text;
    text.font = "none";
    text.thickness = -0.3;
    Letters letters;  // a triangle beside a square with a hole
    const auto loop = [&](const std::vector<Vec2>& corners) {
        letters.loops.push_back(curve(linear_curve, corners));
    };
    loop({{0, 0}, {1, 0}, {0.5, 1}, {0, 0}});
    loop({{2, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 0}});
    loop({{2.2, 0.2}, {2.8, 0.2}, {2.8, 0.8}, {2.2, 0.8}, {2.2, 0.2}});
    text.letters = make_handle<Letters>(letters);
    return {text};
}

template <class T>
std::vector<T> instances() {
    std::vector<T> result = others<T>();
    if (problem(T{}).empty()) result.push_back(T{});
    return result;
}

/// The default fractal has no points.
template <>
std::vector<JuliaFractal> instances() {
    return others<JuliaFractal>();
}

/// The default polynomial has no surface.
template <>
std::vector<Polynomial> instances() {
    return others<Polynomial>();
}

/// Where rays should go to: the bounds, or a part of what has no bounds.
template <class T>
Box region(const T& shape) {
    const Box box = bounds(shape);
    return finite(box) ? box : Box{Vec3(-5), Vec3(5)};
}

/// Shapes cross a ray once when they are half spaces or surfaces without an inside.
template <class T>
constexpr bool crossed_once = !solid<T>;
template <>
constexpr bool crossed_once<Cubic> = false;
template <>
constexpr bool crossed_once<Parametric> = false;
template <>
constexpr bool crossed_once<HeightField> = false;
template <>
constexpr bool crossed_once<BicubicPatch> = false;

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
