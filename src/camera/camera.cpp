// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera/camera.h"

#include "vocabulary/schema.h"

#include <numbers>

namespace {

template <class T>
consteval auto camera_schema(std::string_view name, std::string_view help) {
    using F = Field<T>;
    return schema<T>(name, help, F{"location", &T::location, item, "where it stands"},
                     F{"direction", &T::direction, item,
                       "towards the middle of the picture; its length is the distance of the "
                       "picture plane (default z)"},
                     F{"right", &T::right, item,
                       "from the left edge of the picture to the right (default 1.33 x)"},
                     F{"up", &T::up, item, "from the bottom of the picture to the top (default y)"},
                     F{"sky", &T::sky, item, "what look_at keeps upright"},
                     F{"look_at", &T::look_at, item, "the point in the middle of the picture"},
                     F{"angle", &T::angle, item, "degrees from the left edge to the right",
                       Range{0, 360, true}});
}

}  // namespace

const ItemInfo Perspective::vocabulary = described<Perspective>(
    [] { return camera_schema<Perspective>("perspective", "All rays start at the camera."); });

const ItemInfo Orthographic::vocabulary = described<Orthographic>(
    [] { return camera_schema<Orthographic>("orthographic", "All rays are parallel."); });

namespace {

constexpr double radians_per_degree = std::numbers::pi / 180;

Projection untransformed(const View& view, bool parallel) {
    Projection f{view.location, view.direction.value_or(Vec3(0, 0, 1)),
                 view.right.value_or(Vec3(1.33, 0, 0)), view.up.value_or(Vec3(0, 1, 0)), parallel};
    if (view.angle)
        f.direction = unit(f.direction) *
                      (0.5 * length(f.right) / std::tan(0.5 * *view.angle * radians_per_degree));
    if (view.look_at) {
        // Where up is along the direction, POV-Ray looks into a mirror.
        const double handedness = dot(cross(f.up, f.direction), f.right) > 0 ? 1 : -1;
        const Vec3 ahead = unit(*view.look_at - view.location);
        const Vec3 side = unit(cross(view.sky, ahead));
        f.direction = ahead * length(f.direction);
        if (side != Vec3(0)) {
            f.right = handedness * length(f.right) * side;
            f.up = length(f.up) * unit(cross(ahead, side));
        } else {
            f.up = length(f.up) * unit(cross(ahead, f.right));
        }
    }
    if (parallel && ((!view.up && !view.right) || view.angle)) {
        const double size =
            length(view.look_at.value_or(Vec3(0, 0, 1)) - view.location) / length(f.direction);
        f.right *= size;
        f.up *= size;
    }
    return f;
}

const View& view_of(const Camera& camera) {
    return std::visit([](const auto& c) -> const View& { return c; }, camera);
}

}  // namespace

std::string problem(const Camera& camera) {
    const View& view = view_of(camera);
    if (view.look_at && *view.look_at == view.location)
        return "`look_at` must not be the camera's own location";
    if (view.angle && *view.angle >= 180)
        return "`angle` of a flat picture must be below 180 degrees";
    for (const auto& vector : {view.direction, view.right, view.up})
        if (vector && *vector == Vec3(0)) return "`direction`, `right` and `up` must not be zero";
    const Projection f = untransformed(view, std::holds_alternative<Orthographic>(camera));
    if (dot(cross(f.right, f.up), f.direction) == 0)
        return "`direction`, `right` and `up` must not lie in one plane";
    return {};
}

Projection projection(const Camera& camera) {
    const View& view = view_of(camera);
    Projection f = untransformed(view, std::holds_alternative<Orthographic>(camera));
    f.location = view.transform.point(f.location);
    f.direction = view.transform.direction(f.direction);
    f.right = view.transform.direction(f.right);
    f.up = view.transform.direction(f.up);
    return f;
}

Ray Projection::ray(double u, double v) const {
    if (parallel) return {location + u * right + v * up, unit(direction)};
    return {location, unit(direction + u * right + v * up)};
}
