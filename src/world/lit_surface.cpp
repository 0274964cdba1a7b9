// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/lit_surface.h"

#include "base/circle.h"
#include "luminaire/composite.h"
#include "luminaire/leaf_sides.h"
#include "shape/area.h"
#include "shape/face_normal.h"
#include "shape/watertight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

namespace candelabra {

namespace {

/// Points of a surface with a formula: for what differs from place to place, and for normals alone.
constexpr int many_points = 1 << 14, some_points = 1 << 10;
/// Lines along each of three axes, in batches, by which surfaces without a formula are found. More
/// batches follow until the standard error of the area is below a fraction of it. A surface that
/// fills little of its bounds gets more, since few lines cross it.
constexpr int lines_of_batch = 1 << 12, min_batches = 4, usual_batches = 24, max_batches = 120;
constexpr std::size_t enough_pieces = 50'000;
constexpr double wanted_error = 2e-4;

/// Point i of a sequence that fills the unit square evenly (Roberts' R2).
Vec2 spread(int i) {
    const Vec2 at =
        Vec2(0.5) + static_cast<double>(i) * Vec2(0.7548776662466927, 0.5698402909980532);
    return at - glm::floor(at);
}

bool is_open(const Cylinder& c) { return c.open; }
bool is_open(const Cone& c) { return c.open; }
bool is_open(const BuiltMesh& m) { return closure(*m.mesh) == Closure::none; }
template <ShapeKind T>
bool is_open(const T&) {
    return !std::is_same_v<T, Sphere> && !std::is_same_v<T, Cuboid>;
}

SurfacePiece placed_piece(const SurfacePoint& point, double area, const Transform* transform) {
    if (!transform) return {point.position, point.normal, area};
    // The length is the area that a unit of the shape's own area becomes.
    const Vec3 stretched = std::abs(transform->determinant()) * transform->normal(point.normal);
    const double by = length(stretched);
    return {transform->point(point.position), stretched / std::fmax(by, 1e-300), area * by};
}

/// The flat faces of a shape in its own space; none of a curved one.
std::vector<SurfacePiece> flat_pieces(const BuiltShape& shape) {
    if (const auto* cuboid = std::get_if<Cuboid>(&shape)) {
        std::vector<SurfacePiece> faces;
        const Box box = bounds(*cuboid);
        const Vec3 size = box.size();
        for (int axis = 0; axis < 3; ++axis)
            for (const int sign : {-1, 1}) {
                SurfacePiece face{box.centre(), Vec3(0),
                                  size[(axis + 1) % 3] * size[(axis + 2) % 3]};
                face.position[axis] = sign < 0 ? box.low[axis] : box.high[axis];
                face.normal[axis] = sign;
                faces.push_back(face);
            }
        return faces;
    }
    if (!std::holds_alternative<Disc>(shape)) return {};
    const SurfacePoint point = sample_area(shape, {0.5, 0.5});
    return {{point.position, point.normal, surface_area(shape)}};
}

LitSurface of_area(const BuiltShape& shape, const Transform* transform, const SurfaceUse& use) {
    LitSurface result;
    result.open = visit_shape([](const auto& s) { return is_open(s); }, shape);
    const double own = surface_area(shape);
    const double scale = transform ? transform->uniform_scale() : 1;
    const auto add = [&](const SurfacePoint& point, double area) {
        result.pieces.push_back(placed_piece(point, area, transform));
        result.area += result.pieces.back().area;
    };
    if (!use.places)
        for (const SurfacePiece& face : flat_pieces(shape))
            add({face.position, face.normal}, face.area);
    if (!result.pieces.empty()) return result;
    result.round = scale > 0 && std::holds_alternative<Sphere>(shape);
    const bool normals = use.normals && !result.round;
    const int count = use.places || !(scale > 0) ? many_points : normals ? some_points : 1;
    for (int i = 0; i < count; ++i) add(sample_area(shape, spread(i)), own / count);
    if (scale > 0) result.area = own * scale * scale;
    return result;
}

/// A flat piece for a triangle that glows evenly.
LitSurface of_triangle(const TrianglePrimitive& t, const SurfaceUse& use) {
    const Vec3 across = 0.5 * cross(t.corner2 - t.corner1, t.corner3 - t.corner1);
    const double area = length(across);
    const Vec3 normal = across / std::fmax(area, 1e-300);
    LitSurface result{{}, area, !use.sealed};
    const int count = use.places ? some_points : 1;
    for (int i = 0; i < count; ++i) {
        const Vec2 u = spread(i);
        const double s = std::sqrt(u.x);
        result.pieces.push_back({t.corner1 + s * (1 - u.y) * (t.corner2 - t.corner1) +
                                     s * u.y * (t.corner3 - t.corner1),
                                 normal, area / count});
    }
    return result;
}

/// Whether the normals of a shape are for shading, and the surface has no faces that know theirs.
bool has_shading_normals(const JuliaFractal&) { return true; }
bool has_shading_normals(const BuiltHeightField& h) { return h.smooth; }
template <ShapeKind T>
bool has_shading_normals(const T&) {
    return false;
}

/// The normal of the surface where a line meets a leaf: two lines beside it meet it, too. At an
/// edge, and where the line is very grazing, it is the normal of the meeting.
Vec3 found_normal(const Composite& whole, const Ray& line, const Composite::Meeting& met,
                  double apart) {
    constexpr double steepest = 50;
    const Vec3 own = unit(met.normal);
    const auto [x, y] = perpendiculars(line.direction);
    std::array<Vec3, 2> beside;
    const double deepest = steepest * apart;
    for (std::size_t i = 0; i < 2; ++i) {
        const Ray near{line.origin + apart * (i == 0 ? x : y), line.direction};
        double nearest = deepest;
        whole.all(
            near, Interval{std::fmax(met.t - deepest, 0), met.t + deepest},
            [&](std::uint32_t leaf) { return leaf == met.leaf; },
            [&](const Composite::Meeting& other) {
                if (!(std::abs(other.t - met.t) < std::abs(nearest))) return;
                nearest = other.t - met.t;
            });
        if (nearest == deepest) return own;
        beside[i] = near.origin - line.origin + nearest * line.direction;
    }
    const Vec3 normal = unit(cross(beside[0], beside[1]));
    const bool same_side = dot(normal, line.direction) * dot(own, line.direction) > 0;
    return same_side ? normal : -normal;
}

/// Lines through a ball along an axis, in both directions.
struct Lines {
    Vec3 centre;
    double radius, reach;

    Ray at(const Vec3& axis, int i) const {
        const auto [x, y] = perpendiculars(axis);
        const Vec2 off = radius * (2.0 * spread(i) - Vec2(1));
        const Vec3 along = i % 2 == 0 ? axis : -axis;
        return {centre + off.x * x + off.y * y - reach * along, along};
    }
    /// The area across that a line stands for if there are so many.
    double share(double lines) const { return 4 * radius * radius / lines; }
};

/// Where lines cross a leaf, a piece has the area that a line stands for over the cosine of its
/// normal. Along three axes at right angles the squares of the cosines add up to 1, so that each
/// crossing counts by its cosine, and none is large.
LitSurface by_lines(const Handle<Composite>& composite, std::uint32_t leaf) {
    const Composite& whole = *composite;
    LitSurface result;
    const Box box = whole.leaf_bounds(leaf);
    if (box.empty()) return result;
    const double away = finite(whole.bounds()) ? length(whole.bounds().centre() - box.centre()) +
                                                     length(whole.bounds().size())
                                               : 4 * length(box.size());
    const bool shaded =
        visit_shape([](const auto& s) { return has_shading_normals(s); }, whole.leaf(leaf).shape);
    const Lines lines{box.centre(), 0.5 * length(box.size()) * (1 + 1e-9), away};
    const LeafSides sides(whole, leaf, lines.radius);
    result.open = !composite_emitter(composite, leaf, false).closed;
    // No face of a shape is likely to lie along these axes.
    const Vec3 first = unit(Vec3(0.6245, 0.5432, 0.5611));
    const auto [second, third] = perpendiculars(first);
    double sum = 0, squares = 0;
    int batches = 0;
    const auto wants_more = [&] {
        return batches < usual_batches ||
               (batches < max_batches && result.pieces.size() < enough_pieces);
    };
    for (; wants_more(); ++batches) {
        double batch = 0;
        for (const Vec3& axis : {first, second, third})
            for (int i = 0; i < lines_of_batch; ++i) {
                const Ray line = lines.at(axis, batches * lines_of_batch + i);
                whole.all(
                    line, Interval{0}, [&](std::uint32_t each) { return each == leaf; },
                    [&](const Composite::Meeting& met) {
                        Vec3 normal = shaded ? found_normal(whole, line, met, 1e-5 * lines.radius)
                                             : surface_normal(whole.leaf(leaf), met);
                        const bool turned =
                            (dot(normal, line.direction) > 0) != sides.leaves(line, met);
                        if (turned) normal = -normal;
                        const double cosine = std::abs(dot(normal, line.direction));
                        result.pieces.push_back({line.at(met.t), normal, cosine, turned});
                        batch += cosine;
                    });
            }
        sum += batch;
        squares += batch * batch;
        const double n = batches + 1;
        const double variance = std::fmax(squares - sum * sum / n, 0) / (n * n);
        if (n >= min_batches && variance <= wanted_error * wanted_error * sum * sum / (n * n)) {
            ++batches;
            break;
        }
    }
    const double each = lines.share(static_cast<double>(batches) * lines_of_batch);
    for (SurfacePiece& piece : result.pieces) piece.area *= each;
    result.area = sum * each;
    return result;
}

LitSurface of_placed(const World& world, const PlacedShape& placed, const SurfaceUse& use) {
    if (surface_area(placed.shape) > 0) return of_area(placed.shape, placed.transform.get(), use);
    CompositeBuilder builder(world.rules.settings.index);
    const PartRef part = builder.add({placed.shape, placed.transform});
    return by_lines(make_handle<Composite>(builder.finish(part)), 0);
}

}  // namespace

LitSurface lit_surface(const World& world, PrimitiveIndex primitive, const SurfaceUse& use) {
    return world.geometry.visit_primitive(
        primitive,
        [&](const SpherePrimitive& s) {
            return of_area(Sphere{s.centre, s.radius}, nullptr, use);
        },
        [&](const TrianglePrimitive& t) { return of_triangle(t, use); },
        [&](const PlacedShape& placed) { return of_placed(world, placed, use); },
        [&](const PlacedComposite& placed, std::uint32_t leaf) {
            return by_lines(placed.composite, leaf);
        });
}

}  // namespace candelabra
