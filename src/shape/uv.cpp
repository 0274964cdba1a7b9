// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/uv.h"

#include "base/elementary.h"
#include "base/revolution.h"
#include "shape/triangle.h"

#include <algorithm>

namespace candelabra {

namespace {

using std::numbers::pi;

/// Spherical mapping; `p` is relative to the centre of the ball.
Vec2 around_ball(const Vec3& p) {
    const Vec3 n = unit(p);
    const bool pole = n.x * n.x + n.z * n.z < 1e-10;
    return {pole ? 0 : turn(n.x, n.z), 0.5 + math::asin(std::clamp(n.y, -1.0, 1.0)) / pi};
}

double turn_around_axis(const Vec3& p) { return p.x == 0 && p.z == 0 ? 0 : turn(p.x, p.z); }

/// A place on a curve, with its distance from a point.
struct CurvePlace {
    double distance = std::numeric_limits<double>::infinity();
    double at = 0;
};

/// The place on a piece nearest to a point, which lies on the piece up to rounding.
CurvePlace nearest_on(const CurvePiece& piece, const Vec2& point) {
    CurvePlace best;
    const auto consider = [&](double at) {
        const double distance = length(piece.at(at) - point);
        if (distance < best.distance) best = {distance, at};
    };
    consider(0);
    consider(1);
    for (const Vec2& axis : {Vec2(1, 0), Vec2(0, 1)}) {
        const double off = -dot(axis, point);
        for (const double at :
             sign_changes(piece.combined(axis, off), {0, 1}, dot(axis, piece.start) + off,
                          dot(axis, piece.end) + off))
            consider(at);
    }
    return best;
}

/// The facet of a surface that contains a point; corners_of(i) returns its corners.
template <class CornersOf>
std::uint32_t facet_at(const PartIndex& index, const Vec3& point, CornersOf corners_of) {
    std::uint32_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    index.around(point, [&](std::uint32_t i) {
        const std::array<Vec3, 3> corners = corners_of(i);
        const Vec3 w = corner_weights(corners, point);
        const double beyond = std::fmax(0, -std::min({w.x, w.y, w.z}));
        const Vec3 nearest = w.x * corners[0] + w.y * corners[1] + w.z * corners[2];
        const double off = beyond + length(point - nearest);
        if (off < least) least = off, best = i;
    });
    return best;
}

Vec2 mixed(const std::array<Vec2, 3>& corners, const Vec3& weights) {
    return weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2];
}

}  // namespace

std::optional<Vec2> uv(const Sphere& sphere, const Vec3& point, std::uint32_t) {
    return around_ball(point - sphere.centre);
}

std::optional<Vec2> uv(const Ovus& ovus, const Vec3& point, std::uint32_t) {
    return around_ball(point - bounds(ovus).centre());
}

/// The faces form a cross of four by three: -x, +z, +x, -z in a row, +y above +z, -y below it.
std::optional<Vec2> uv(const Cuboid& cuboid, const Vec3& point, std::uint32_t) {
    const Box box = bounds(cuboid);
    const Vec3 p = (point - box.low) / box.size();
    int axis = 0;
    bool high = false;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i)
        for (const bool top : {false, true})
            if (const double off = std::abs(p[i] - (top ? 1 : 0)) * box.size()[i]; off < least) {
                least = off;
                axis = i;
                high = top;
            }
    if (axis == 1) return Vec2((1 + p.x) / 4, high ? 1 - p.z / 3 : p.z / 3);
    const double height = (1 + p.y) / 3;
    if (axis == 0) return Vec2(high ? (3 - p.z) / 4 : p.z / 4, height);
    return Vec2(high ? (1 + p.x) / 4 : 1 - p.x / 4, height);
}

std::optional<Vec2> uv(const Torus& torus, const Vec3& point, std::uint32_t) {
    const double outwards = math::hypot(point.x, point.z) - torus.major;
    return Vec2(0.5 - math::atan2(point.z, point.x) / (2 * pi),
                0.5 + math::atan2(point.y, outwards) / (2 * pi));
}

std::optional<Vec2> uv(const BuiltLathe& lathe, const Vec3& point, std::uint32_t) {
    const Vec2 flat(math::hypot(point.x, point.z), point.y);
    CurvePlace best;
    std::size_t piece = 0;
    for (std::size_t i = 0; i < lathe.parts.size(); ++i)
        if (const CurvePlace at = nearest_on(lathe.parts[i].piece, flat);
            at.distance < best.distance) {
            best = at;
            piece = i;
        }
    const auto count = static_cast<double>(lathe.parts.size());
    return Vec2(turn_around_axis(point), (static_cast<double>(piece) + best.at) / count);
}

std::optional<Vec2> uv(const BuiltSor& sor, const Vec3& point, std::uint32_t) {
    const double low = sor.parts.front().low, high = sor.parts.back().high;
    const double share = (point.y - low) / (high - low), radius = math::hypot(point.x, point.z);
    for (const bool top : {false, true}) {
        const double rim = std::sqrt(top ? sor.parts.back().high2 : sor.parts.front().low2);
        const bool on_end = !sor.open && std::abs(share - (top ? 1 : 0)) < 1e-9;
        // As in POV-Ray, v continues beyond 0 and 1 towards the middle of an end.
        if (on_end && radius < rim * (1 - 1e-9))
            return Vec2(turn_around_axis(point), top ? 2 - radius / rim : radius / rim - 1);
    }
    // All pieces of the curve have an equal part of v, as in POV-Ray.
    const auto above = std::ranges::find_if(
        sor.parts, [&](const BuiltSor::Part& part) { return point.y < part.high; });
    const auto& part = above == sor.parts.end() ? sor.parts.back() : *above;
    const double number = static_cast<double>(&part - sor.parts.data()),
                 within = std::clamp((point.y - part.low) / (part.high - part.low), 0.0, 1.0);
    return Vec2(turn_around_axis(point), (number + within) / static_cast<double>(sor.parts.size()));
}

std::optional<Vec2> uv(const BuiltBicubicPatch& patch, const Vec3& point, std::uint32_t part) {
    if (part == any_part)
        part =
            facet_at(patch.index, point, [&](std::uint32_t i) { return patch.facets[i].corners; });
    const auto& facet = patch.facets[part];
    return mixed(facet.uvs, corner_weights(facet.corners, point));
}

std::optional<Vec2> uv(const BuiltMesh& built, const Vec3& point, std::uint32_t part) {
    if (part == any_part) part = face_at(built, point);
    return mixed(face_uvs(*built.mesh, part),
                 corner_weights(face(*built.mesh, part).corners, point));
}

std::uint32_t face_at(const BuiltMesh& built, const Vec3& point) {
    return facet_at(built.index, point,
                    [&](std::uint32_t i) { return face(*built.mesh, i).corners; });
}

std::optional<Vec2> uv(const BuiltParametric& surface, const Vec3& point, std::uint32_t part) {
    return parameters_at(surface, point, part == any_part ? std::nullopt : std::optional(part));
}

std::optional<Vec2> uv(const BuiltShape& shape, const Vec3& point, std::uint32_t part) {
    return visit_shape([&](const auto& s) { return uv(s, point, part); }, shape);
}

}  // namespace candelabra
