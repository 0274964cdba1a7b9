// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/area.h"

#include "luminaire/emit.h"
#include "luminaire/light_proxy.h"
#include "luminaire/seen_faces.h"
#include "shape/area.h"
#include "shape/face_normal.h"

#include <utility>

namespace candelabra {

namespace {

bool closed(const Sphere&) { return true; }
bool closed(const Cuboid&) { return true; }
bool closed(const Cylinder& c) { return !c.open; }
bool closed(const Cone& c) { return !c.open; }
template <ShapeKind T>
bool closed(const T&) {
    return false;
}
/// Whether the shape is a convex solid, so that only faces turned to an outside point are visible.
bool closed(const AreaEmitter& e) {
    return visit_shape([](const auto& s) { return closed(s); }, e.shape);
}

Vec3 flat_normal(const Disc& d) { return unit(d.normal); }
Vec3 flat_normal(const Triangle& t) { return triangle_normal(t.corner1, t.corner2, t.corner3); }
Vec3 flat_normal(const SmoothTriangle& t) {
    return triangle_normal(t.corner1, t.corner2, t.corner3);
}
template <ShapeKind T>
Vec3 flat_normal(const T&) {
    return Vec3(0);
}
/// Geometric normal where a ray crosses the surface; the crossing's own may be a shading normal.
Vec3 own_normal(const AreaEmitter& e, const Crossing& met) {
    const Vec3 face = face_normal(e.shape, met.part);
    return face == Vec3(0) ? met.normal : face;
}

/// Unit normal of flat shapes in their own space, 0 for others. (Smooth triangles are flat: only
/// their shading is not.)
Vec3 flat_normal(const AreaEmitter& e) {
    return visit_shape([](const auto& s) { return flat_normal(s); }, e.shape);
}

Vec3 to_world_point(const AreaEmitter& e, const Vec3& p) {
    return e.transform ? e.transform->point(p) : p;
}
Vec3 to_world_normal(const AreaEmitter& e, const Vec3& n) {
    return e.transform ? e.transform->normal(n) : n;
}
Vec3 to_shape_point(const AreaEmitter& e, const Vec3& p) {
    return e.transform ? e.transform->inverse_point(p) : p;
}
double volume_scale(const AreaEmitter& e) {
    return e.transform ? std::abs(e.transform->determinant()) : 1;
}

/// World area per unit of the shape's own area around a point, times the unit normal in the world.
Vec3 stretched_normal(const AreaEmitter& e, const Vec3& normal) {
    return volume_scale(e) * to_world_normal(e, normal);
}

/// Which points of the surface shine on a receiver: solids hide their far side from outside, and
/// their near side from inside. A receiver on the surface counts as inside, since the outside of a
/// convex surface does not see itself.
class TurnedSide {
public:
    TurnedSide(const AreaEmitter& e, const Receiver& from)
        : solid_(closed(e)), within_(solid_ && within(e, from)) {}

    bool shows(const Vec3& normal, const Vec3& from_surface) const {
        return !solid_ || (dot(normal, from_surface) > 0) != within_;
    }

private:
    /// Whether the receiver is inside, or on the surface within rounding error.
    static bool within(const AreaEmitter& e, const Receiver& from) {
        const Vec3 here = to_shape_point(e, from.position);
        if (inside(e.shape, here)) return true;
        const Vec3 normal =
            unit(e.transform ? e.transform->inverse_direction(from.normal) : from.normal);
        const double rounding =
            1e-9 * (max_component(bounds(e.shape).size()) + max_abs_component(here));
        return inside(e.shape, here + rounding * normal) ||
               inside(e.shape, here - rounding * normal);
    }

    bool solid_, within_;
};

/// Upper bound, close to the least one (Gershgorin circles), of the factor by which the map
/// stretches lengths; exact for similarities.
double greatest_stretch(const Transform& transform) {
    const auto& rows = transform.forward().rows;
    double greatest = 0;
    for (const Vec3& row : rows)
        greatest = std::fmax(greatest, std::abs(dot(row, rows[0])) + std::abs(dot(row, rows[1])) +
                                           std::abs(dot(row, rows[2])));
    return std::sqrt(greatest);
}

/// A bounding sphere of the shape in its own space.
std::pair<Vec3, double> sphere_around(const Disc& d) { return {d.centre, d.radius}; }
template <ShapeKind T>
std::pair<Vec3, double> sphere_around(const T& shape) {
    const Box box = bounds(shape);
    return {box.centre(), length(box.size()) / 2};
}

/// The faces of a box that are visible above the horizon; nothing for other shapes.
std::optional<SeenFaces> seen_faces(const AreaEmitter& e, const Vec3& from, const Vec3* normal) {
    const Cuboid* box = std::get_if<Cuboid>(&e.shape);
    if (!box) return {};
    std::optional<SeenFaces> faces(std::in_place, bounds(*box), e.transform.get(), from, normal);
    if (!faces->any()) faces.reset();
    return faces;
}

/// Gives a thin box the axis and the area of its broad side, with some evenness for the others.
void flatten(const AreaEmitter& e, const Cuboid& box, LightBounds& result) {
    const Vec3 size = bounds(box).size();
    const Vec3 areas(size.y * size.z, size.z * size.x, size.x * size.y);
    std::array<Vec3, 3> face;
    int broad = 0;
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 normal(0);
        normal[axis] = areas[axis];
        face[axis] = stretched_normal(e, normal);
        sum += length(face[axis]);
        if (length(face[axis]) > length(face[broad])) broad = axis;
    }
    const double area = length(face[broad]), others = sum - area;
    if (!(others < 0.5 * area)) return;
    result.axis = face[broad] / area;
    result.intensity = result.luminance * area;
    result.evenness = 0.5 * others / area;
}

std::vector<BrightFace> own_faces(const Cuboid& cuboid) {
    const Box box = bounds(cuboid);
    std::vector<BrightFace> faces;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool high : {false, true}) {
            BrightFace face{box.low, Vec3(0), Vec3(0)};
            if (high) face.corner[axis] = box.high[axis];
            const int first = (axis + (high ? 1 : 2)) % 3, second = 3 - axis - first;
            face.side1[first] = box.size()[first];
            face.side2[second] = box.size()[second];
            faces.push_back(face);
        }
    return faces;
}
std::vector<BrightFace> own_faces(const Disc& d) {
    const auto [x, y] = perpendiculars(unit(d.normal));
    return {{d.centre - d.radius * (x + y), 2 * d.radius * x, 2 * d.radius * y, BrightFace::disc,
             d.hole / d.radius}};
}
std::vector<BrightFace> own_faces(const Triangle& t) {
    return {{t.corner1, t.corner2 - t.corner1, t.corner3 - t.corner1, BrightFace::triangle}};
}
std::vector<BrightFace> own_faces(const SmoothTriangle& t) {
    return own_faces(Triangle{t.corner1, t.corner2, t.corner3});
}
template <ShapeKind T>
std::vector<BrightFace> own_faces(const T&) {
    return {};
}

/// Converts a density per area in the shape's own space to one per steradian.
double solid_angle_density(double per_area, double distance, double seen) {
    return per_area * distance * distance / seen;
}

/// Normal of the plane below which no light counts; null if all directions count, as where there is
/// no surface.
const Vec3* horizon_of(const Receiver& point) {
    return point.horizon == Horizon::one_side ? &point.normal : nullptr;
}

double stretched_area(const AreaEmitter& e) {
    const double area = surface_area(e.shape);
    if (!(area > 0)) return 0;
    const double scale = e.transform ? e.transform->uniform_scale() : 1;
    if (scale > 0) return area * scale * scale;
    // Mean stretch of the surface over a grid. Exact for flat shapes; for others it only guides
    // sampling.
    constexpr int steps = 16;
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j)
            sum += length(stretched_normal(
                e, sample_area(e.shape, {(i + 0.5) / steps, (j + 0.5) / steps}).normal));
    return area * sum / (steps * steps);
}

}  // namespace

AreaEmitter::AreaEmitter(BuiltShape built, Handle<Transform> place, SealedSide kept)
    : shape(std::move(built)),
      transform(std::move(place)),
      area(stretched_area(*this)),
      sealed(kept) {}

LightBounds bounds(const AreaEmitter& e, double luminance) {
    LightBounds result;
    const Box box = bounds(e.shape);
    result.box = e.transform ? e.transform->box(box) : box;
    const auto [centre, radius] =
        visit_shape([](const auto& s) { return sphere_around(s); }, e.shape);
    result.centre = to_world_point(e, centre);
    const double stretched = radius * (e.transform ? greatest_stretch(*e.transform) : 1);
    const double size =
        std::fmax(max_abs_component(result.box.low), max_abs_component(result.box.high));
    result.radius = stretched * (1 + 1e-12) + 16 * std::numeric_limits<double>::epsilon() * size;
    result.axis = unit(to_world_normal(e, flat_normal(e)));
    // The mean projected area of a convex solid is a quarter of its surface (Cauchy); an open
    // surface shines on both sides.
    const double seen = result.axis != Vec3(0) ? 1 : closed(e) ? 0.25 : 0.5;
    result.intensity = luminance * seen * emitting_area(e);
    result.luminance = luminance;
    if (const auto* box = std::get_if<Cuboid>(&e.shape)) flatten(e, *box, result);
    return result;
}

double unoccluded(const AreaEmitter& e, double luminance, const Receiver& point) {
    return irradiance(light_proxy(bounds(e, luminance)), point);
}

std::optional<LightPoint> sample(const AreaEmitter& e, const Receiver& point, const Vec2& u) {
    if (const auto faces = seen_faces(e, point.position, horizon_of(point))) {
        const auto drawn = faces->draw(u);
        return drawn ? std::optional(drawn->point) : std::nullopt;
    }
    const SurfacePoint drawn = sample_area(e.shape, u);
    const double per_area = 1 / surface_area(e.shape);
    const Vec3 position = to_world_point(e, drawn.position), offset = position - point.position;
    const double distance = length(offset);
    if (!(distance > 0)) return {};
    const Vec3 direction = offset / distance, turned = stretched_normal(e, drawn.normal);
    if (!TurnedSide(e, point).shows(turned, -direction)) return {};
    const double seen = std::abs(dot(turned, direction));
    if (!(seen > 0)) return {};
    return LightPoint{position, direction, distance, solid_angle_density(per_area, distance, seen)};
}

std::optional<LightPoint> sample(const AreaEmitter& e, const Vec3& from, const Vec2& u) {
    return sample(e, Receiver{from, Vec3(0), Horizon::none}, u);
}

void intersect(const AreaEmitter& e, const Receiver& point, const Vec3& direction,
               LightHits& found) {
    const Ray ray{point.position, direction};
    Crossings met;
    crossings(e.shape, e.transform ? e.transform->inverse_ray(ray) : ray, met);
    if (met.size() == 0) return;
    const auto faces = seen_faces(e, point.position, horizon_of(point));
    std::optional<TurnedSide> side;
    if (!faces) side.emplace(e, point);
    const double per_area = 1 / surface_area(e.shape);
    const auto face_of = [](const Vec3& outward) {
        const Vec3 size = glm::abs(outward);
        const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        return SeenFaces::face(axis, outward[axis] > 0);
    };
    for (std::size_t i = 0; i < met.size(); ++i) {
        const double distance = met[i].t;
        const Vec3 normal = stretched_normal(e, own_normal(e, met[i]));
        const double seen = std::abs(dot(normal, direction));
        if (!(distance > 0 && seen > 0)) continue;
        if (side && !side->shows(normal, -direction)) continue;
        const double density = faces ? faces->density(face_of(met[i].normal), direction, distance)
                                     : solid_angle_density(per_area, distance, seen);
        if (density > 0) found.push_back({distance, density});
    }
}

std::optional<EmittedRay> emit(const AreaEmitter& e, double inner, const EmissionDraw& u) {
    const SurfacePoint drawn = sample_area(e.shape, u.where);
    const Vec3 stretched = stretched_normal(e, drawn.normal);
    const double per_area = 1 / (surface_area(e.shape) * length(stretched));
    return emitted_ray(to_world_point(e, drawn.position), unit(stretched), per_area,
                       closed(e) ? inner : inner_share(e.sealed, inner), u);
}

double emitting_area(const AreaEmitter& e) { return e.area; }

std::vector<BrightFace> flat_faces(const AreaEmitter& e) {
    auto faces = visit_shape([](const auto& s) { return own_faces(s); }, e.shape);
    if (!e.transform) return faces;
    const bool mirrored = e.transform->determinant() < 0;
    for (BrightFace& face : faces) {
        face.corner = e.transform->point(face.corner);
        face.side1 = e.transform->direction(face.side1);
        face.side2 = e.transform->direction(face.side2);
        if (mirrored) std::swap(face.side1, face.side2);
    }
    return faces;
}

}  // namespace candelabra
