// SPDX-License-Identifier: GPL-3.0-or-later
// A table of the shapes: what each kind is, and instances of it besides the default one. Tests of
// what every shape promises walk over it, so that a new kind is tested without a line of its own.
#pragma once

#include "formula/builder.h"
#include "shape/built_shape.h"
#include "support/axes.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace candelabra::shape_table {

/// Solids are bounded and entered as often as they are left; the others are half spaces or have no
/// inside.
template <class T>
inline constexpr bool solid = true;
template <>
inline constexpr bool solid<Plane> = false;
template <>
inline constexpr bool solid<Disc> = false;
template <>
inline constexpr bool solid<Cubic> = false;
template <>
inline constexpr bool solid<Triangle> = false;
template <>
inline constexpr bool solid<SmoothTriangle> = false;
template <>
inline constexpr bool solid<Polygon> = false;

template <class T>
inline constexpr bool has_inside = true;
template <>
inline constexpr bool has_inside<Triangle> = false;
template <>
inline constexpr bool has_inside<SmoothTriangle> = false;
template <>
inline constexpr bool has_inside<Polygon> = false;

template <>
inline constexpr bool solid<Parametric> = false;
template <>
inline constexpr bool solid<HeightField> = false;
template <>
inline constexpr bool solid<BicubicPatch> = false;
template <>
inline constexpr bool has_inside<Parametric> = false;
template <>
inline constexpr bool has_inside<BicubicPatch> = false;

inline Mesh tetrahedron() {
    Mesh mesh;
    mesh.vertices = {o, x, y, z};
    mesh.faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {3, 2, 1}};
    mesh.inside_vector = Vec3(1, 2, 3);
    return mesh;
}

/// Instances besides the default one, all of which are valid.
template <class T>
std::vector<T> others() {
    return {};
}
template <>
inline std::vector<Sphere> others() {
    return {{Vec3(1, 2, 3), 1e-6}, {Vec3(-5, 1e3, 0), 1e3}, {Vec3(0), 1e6}, {Vec3(1e6), 0.5}};
}
template <>
inline std::vector<Cuboid> others() {
    return {{Vec3(1), Vec3(-2, -3, -4)}, {Vec3(0), Vec3(1e-6, 1, 1e4)}, {Vec3(1e5), Vec3(1e5 + 1)}};
}
template <>
inline std::vector<Plane> others() {
    return {{Vec3(1, -2, 3), -4}, {Vec3(0, 0, -1e-5), 2}, {Vec3(1e5, 1, 1), 10}};
}
template <>
inline std::vector<Disc> others() {
    return {{Vec3(1, 2, 3), Vec3(1, 1, -5), 2, 1.5}, {Vec3(0), Vec3(-1, 0, 0), 1e3, 0}};
}
template <>
inline std::vector<Cylinder> others() {
    return {{Vec3(1, 2, 3), Vec3(-3, 0, 1), 0.3, false},
            {Vec3(0), Vec3(0, 0, -1e3), 0.01, false},
            {Vec3(0), Vec3(1e-3), 5, false}};
}
template <>
inline std::vector<Cone> others() {
    return {{Vec3(1, 2, 3), 0, Vec3(-3, 0, 1), 1, false},
            {Vec3(0), 2, Vec3(0, 0, 5), 1.999999, false},
            {Vec3(0), 1, Vec3(1, 0, 0), 1, false},
            {Vec3(0), 10, Vec3(0, 0.01, 0), 0, false},
            {Vec3(0), 0.01, Vec3(0, -100, 0), 0.02, false},
            {Vec3(0), 1, Vec3(0, 1, 0), 0.5, false}};
}
template <>
inline std::vector<Triangle> others() {
    return {{Vec3(1, 2, 3), Vec3(-1, 0, 5), Vec3(3, 3, 3)}, {o, Vec3(1e-3, 0, 0), Vec3(0, 1e3, 0)}};
}
template <>
inline std::vector<SmoothTriangle> others() {
    return {{Vec3(1, 2, 3), Vec3(0, 1, 1), Vec3(-1, 0, 5), y, Vec3(3, 3, 3), Vec3(1, 1, 1)}};
}
template <>
inline std::vector<Torus> others() {
    return {{2, 0.5}, {1e3, 1}, {1, 1}, {1e-4, 1e-6}};
}
template <>
inline std::vector<Quadric> others() {
    return {{Vec3(1, 2, 3), Vec3(0.5, 1, -1), Vec3(3, -1, 2), -6},
            {Vec3(1e-6), o, o, -1},
            {Vec3(1e6, 1, 1), o, Vec3(10), -1}};
}
template <>
inline std::vector<Cubic> others() {
    std::vector<double> c(20, 0);
    c[0] = 1, c[10] = -2, c[15] = 1, c[18] = 1, c[19] = -1;
    return {{c}};
}
template <>
inline std::vector<Quartic> others() {
    std::vector<double> c(35, 0);
    c[0] = c[20] = c[30] = 1, c[34] = -1;
    return {{c}};
}
template <>
inline std::vector<Poly> others() {
    std::vector<double> c(factor_count(6), 0);
    c[0] = c[56] = c[77] = 1, c.back() = -1;
    return {{6, c}};
}
template <>
inline std::vector<Polynomial> others() {
    return {{6, {{6, 0, 0, 1}, {0, 6, 0, 1}, {0, 0, 6, 1}, {2, 0, 2, -1}, {0, 0, 0, -1}}}};
}
template <>
inline std::vector<Superellipsoid> others() {
    return {{{0.25, 0.5}}, {{1.5, 0.2}}, {{0.1, 2}}, {{3, 3}}, {{0.5, 3}}};
}
template <>
inline std::vector<Polygon> others() {
    return {{{o, x, x + y, y, o}}, {{Vec3(1, 2, 3), Vec3(-1, 0, 5), Vec3(3, 3, 3)}}};
}
template <>
inline std::vector<Prism> others() {
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
inline std::vector<Lathe> others() {
    return {{linear_curve, {{0, 0}, {1, 1}, {0, 2}}},
            {linear_curve, {{0, 0}, {1, 0}, {1, 1}, {0.5, 1}, {0.5, 0.2}, {0, 0.2}}},
            {linear_curve, {{1, 0}, {2, 1}, {3, 0}, {1, 0}}},
            {cubic_curve, {{-1, -1}, {0, 0}, {1, 1}, {0.3, 2}, {0, 3}, {-1, 4}}},
            {bezier_curve, {{0, 0}, {2, 0.5}, {0.5, 1}, {0, 2}}}};
}
template <>
inline std::vector<Sor> others() {
    return {{{{0.5, -1}, {1, 0}, {0.5, 1}, {1, 2}, {0.2, 3}}, false},
            {{{0, 0}, {0, 0.1}, {3, 4}, {0.01, 20}, {1, 30}}, false}};
}
template <>
inline std::vector<Ovus> others() {
    return {{1, 0.7}, {1, 1}, {1, 1.9}, {1, 3}, {1e3, 1}};
}
template <>
inline std::vector<Mesh> others() {
    return {tetrahedron()};
}

template <>
inline std::vector<TriangleMesh> others() {
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
inline std::vector<Isosurface> others() {
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
inline std::vector<Parametric> others() {
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
inline std::vector<HeightField> others() {
    HeightGrid grid{5, 4, {}};
    for (int i = 0; i < 20; ++i)
        grid.values.push_back(static_cast<std::uint16_t>(i * i * 7919 % 65536));
    HeightField land, flooded;
    land.grid = flooded.grid = make_handle<HeightGrid>(grid);
    flooded.water_level = 0.4;
    return {land, flooded};
}
template <>
inline std::vector<BicubicPatch> others() {
    BicubicPatch sheet;
    sheet.type = 0;
    sheet.u_steps = sheet.v_steps = 3;
    for (int i = 0; i < 16; ++i)
        sheet.points.push_back(Vec3(i % 4, i / 4 % 3 == 0 ? 0 : i % 3, i / 4));
    return {sheet};
}
template <>
inline std::vector<JuliaFractal> others() {
    JuliaFractal julia;
    julia.parameter = Vec4(0.1, 0.1, 0, 0);
    julia.max_iteration = 5;
    julia.precision = 100;
    return {julia};
}
template <>
inline std::vector<Text> others() {
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

/// All instances of the table. The default one is among them if it has a surface.
template <class T>
std::vector<T> instances() {
    std::vector<T> result = others<T>();
    if (problem(T{}).empty()) result.push_back(T{});
    return result;
}

/// The default fractal has no points.
template <>
inline std::vector<JuliaFractal> instances() {
    return others<JuliaFractal>();
}

/// The default polynomial has no surface.
template <>
inline std::vector<Polynomial> instances() {
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
inline constexpr bool crossed_once = !solid<T>;
template <>
inline constexpr bool crossed_once<Cubic> = false;
template <>
inline constexpr bool crossed_once<Parametric> = false;
template <>
inline constexpr bool crossed_once<HeightField> = false;
template <>
inline constexpr bool crossed_once<BicubicPatch> = false;

}  // namespace candelabra::shape_table
