// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/composite.h"

#include "base/random.h"
#include "luminaire/glow.h"
#include "luminaire/guide.h"
#include "shape/tessellation.h"

#include <numbers>

namespace {

using std::numbers::pi;

/// Rays start this share of the size away from where they are asked from, so that a point of the
/// luminaire itself does not see itself.
constexpr double clearance = 1e-9;

/// Around the box in which the leaf is seen.
struct Around {
    Vec3 centre;
    double radius;

    explicit Around(const CompositeEmitter& e)
        : centre(e.composite->leaf_bounds(e.leaf).centre()),
          radius(0.5 * length(e.composite->leaf_bounds(e.leaf).size()) * (1 + 1e-9)) {}
};

/// The cone of directions that may meet the ball: 1 - cos of its half angle; 2 from within.
double rim(const Around& ball, double distance) {
    if (!(distance > ball.radius)) return 2;
    const double sine = ball.radius / distance;
    return sine * sine / (1 + std::sqrt((1 - sine) * (1 + sine)));
}

std::optional<double> meet(const CompositeEmitter& e, const Ray& ray, double from) {
    const auto own = [&](std::uint32_t leaf) { return leaf == e.leaf; };
    const auto met = e.composite->first(ray, Interval{from}, own);
    return met ? std::optional(met->t) : std::nullopt;
}

/// The direction for u, uniform over the cone around the middle.
Vec3 in_cone(const Vec3& middle, double widest, const Vec2& u) {
    const double versine = u.x * widest, sine = std::sqrt(versine * (2 - versine));
    const auto [x, y] = perpendiculars(middle);
    const double angle = 2 * pi * u.y;
    return (1 - versine) * middle + sine * (std::cos(angle) * x + std::sin(angle) * y);
}

/// Shares of the drawn directions that are looked for in the whole cone when there is a guide, and
/// with it.
constexpr double astray = 0.125, guided = 1 - astray;

/// Of a direction that meets the leaf, which is within the ball.
double density(const CompositeEmitter& e, const Around& ball, const Vec3& from,
               const Vec3& direction) {
    const double around = 1 / (2 * pi * rim(ball, length(ball.centre - from)));
    return e.guide ? astray * around + guided * e.guide->density(from, direction) : around;
}

/// Parallel rays through the ball from all sides, and those of them that meet the leaf.
struct Survey {
    static constexpr std::uint32_t rays = 512;
    std::vector<Ray> met;

    Survey(const CompositeEmitter& e, const Around& ball) {
        for (std::uint32_t i = 0; i < rays; ++i) {
            const auto number = [&](std::uint32_t branch, Purpose purpose) {
                return uniform(Key{0, i, 0, branch}, purpose);
            };
            const Vec3 direction = in_cone(
                Vec3(0, 0, 1), 2, {number(0, Purpose::light_u), number(0, Purpose::light_v)});
            const auto [x, y] = perpendiculars(direction);
            const double off = ball.radius * std::sqrt(number(1, Purpose::light_u));
            const double angle = 2 * pi * number(1, Purpose::light_v);
            const Vec3 through = ball.centre + off * (std::cos(angle) * x + std::sin(angle) * y);
            const Ray ray{through - 2 * ball.radius * direction, direction};
            if (meet(e, ray, 0)) met.push_back(ray);
        }
    }
};

/// The mesh with its corners moved outwards: triangles between points of a round surface do not
/// reach its rim.
Mesh grown(Mesh mesh, double by) {
    std::vector<Vec3> outward(mesh.vertices.size(), Vec3(0));
    for (const Face& face : mesh.faces) {
        const auto at = [&](int i) { return mesh.vertices[static_cast<std::size_t>(face[i])]; };
        const Vec3 normal = cross(at(1) - at(0), at(2) - at(0));
        for (const int corner : face) outward[static_cast<std::size_t>(corner)] += normal;
    }
    for (std::size_t i = 0; i < outward.size(); ++i) mesh.vertices[i] += by * unit(outward[i]);
    return mesh;
}

/// Triangles that nearly all rays meet which meet the leaf, as coarse as can be. What they do not
/// cover makes noise, what they cover beyond it costs rays.
Handle<Guide> guide_to(const CompositeEmitter& e, const Around& ball, const Survey& survey) {
    Handle<Guide> best;
    double most = 0.9;
    for (const int cells : {12, 24, 48}) {
        const Mesh mesh = seen_tessellation(*e.composite, e.leaf, cells);
        if (mesh.faces.empty()) continue;
        Guide guide(grown(mesh, ball.radius / (6 * cells)));
        const auto covered = std::ranges::count_if(survey.met, [&](const Ray& ray) {
            return guide.density(ray.origin, ray.direction) > 0;
        });
        const double reached =
            static_cast<double>(covered) / static_cast<double>(survey.met.size());
        if (reached > most) {
            most = reached;
            best = make_handle<Guide>(std::move(guide));
        }
        if (most >= 0.97) break;
    }
    return best;
}

}  // namespace

CompositeEmitter composite_emitter(Handle<Composite> composite, std::uint32_t leaf, bool guided) {
    CompositeEmitter e{std::move(composite), leaf, 0};
    const Around ball(e);
    const Survey survey(e, ball);
    const auto met = static_cast<double>(survey.met.size());
    e.seen_area = std::fmax(met, 0.5) / Survey::rays * pi * ball.radius * ball.radius;
    // What nearly fills the cone is found there soon enough.
    if (guided && met > 0 && met < 0.75 * Survey::rays) e.guide = guide_to(e, ball, survey);
    return e;
}

LightBounds bounds(const CompositeEmitter& e, double luminance) {
    const Around ball(e);
    LightBounds result;
    result.box = e.composite->leaf_bounds(e.leaf);
    result.centre = ball.centre;
    result.radius = ball.radius;
    result.intensity = luminance * e.seen_area;
    result.luminance = luminance;
    return result;
}

double unoccluded(const CompositeEmitter& e, double luminance, const ShadingPoint& point) {
    return irradiance(glow(bounds(e, luminance)), point);
}

std::optional<LightPoint> sample(const CompositeEmitter& e, const Vec3& from, const Vec2& u) {
    const Around ball(e);
    Vec3 direction;
    if (e.guide && u.x >= astray) {
        direction = unit(e.guide->point({(u.x - astray) / guided, u.y}) - from);
        if (direction == Vec3(0)) return {};
    } else {
        const Vec3 offset = ball.centre - from;
        const double to_centre = length(offset);
        const Vec3 middle = to_centre > 0 ? offset / to_centre : Vec3(0, 0, 1);
        const Vec2 left = e.guide ? Vec2(u.x / astray, u.y) : u;
        direction = unit(in_cone(middle, rim(ball, to_centre), left));
    }
    const auto distance = meet(e, {from, direction}, clearance * ball.radius);
    if (!distance) return {};
    return LightPoint{from + *distance * direction, direction, *distance,
                      density(e, ball, from, direction)};
}

void meet(const CompositeEmitter& e, const ShadingPoint& point, const Vec3& direction,
          LightMeetings& met) {
    const Around ball(e);
    const auto distance = meet(e, {point.position, direction}, clearance * ball.radius);
    if (distance) met.push_back({*distance, density(e, ball, point.position, direction)});
}

double emitting_area(const CompositeEmitter& e) { return 4 * e.seen_area; }
