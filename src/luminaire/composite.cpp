// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/composite.h"

#include "base/circle.h"
#include "base/order.h"
#include "base/random.h"
#include "base/short_list.h"
#include "luminaire/leaf_sides.h"
#include "luminaire/light_proxy.h"
#include "luminaire/proxy_mesh.h"
#include "shape/face_normal.h"
#include "shape/tessellation.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <map>
#include <numbers>
#include <utility>

namespace candelabra {

namespace {

using std::numbers::pi;

/// Offset of ray origins as a fraction of the luminaire's size, so that a point of the luminaire
/// does not see itself.
constexpr double clearance = 1e-9;
/// Distance between faces that lie in the same place, as a fraction of that size.
constexpr double same_face = 1e-9;

/// Bounding sphere of the leaf's bounding box.
struct Around {
    Vec3 centre;
    double radius;

    explicit Around(const CompositeEmitter& e)
        : centre(e.composite->leaf_bounds(e.leaf).centre()),
          radius(0.5 * length(e.composite->leaf_bounds(e.leaf).size()) * (1 + 1e-9)) {}
};

/// 1 - cos of the half angle of the cone of directions that may meet the ball; 2 from inside.
double rim(const Around& ball, double distance) {
    if (!(distance > ball.radius)) return 2;
    const double sine = ball.radius / distance;
    return sine * sine / (1 + std::sqrt((1 - sine) * (1 + sine)));
}

std::optional<Composite::Meeting> first_of(const CompositeEmitter& e, const Ray& ray, double from) {
    return e.composite->first(ray, Interval{from},
                              [&](std::uint32_t leaf) { return leaf == e.leaf; });
}

/// Returns the direction for u, uniform in the cone around `middle`.
Vec3 in_cone(const Vec3& middle, double widest, const Vec2& u) {
    const double versine = u.x * widest, sine = std::sqrt(versine * (2 - versine));
    const auto [x, y] = perpendiculars(middle);
    const double angle = 2 * pi * u.y;
    return (1 - versine) * middle + sine * on_circle(angle, x, y);
}

/// Fractions of the directions that are drawn, if there is a proxy mesh, in the whole cone and by
/// the proxy mesh.
constexpr double astray = 0.125, at_proxy = 1 - astray;

/// For varying radiance: maximum edge of a triangle as a fraction of the size, and weight of the
/// neighbours in a triangle's luminance.
constexpr double longest_edge = 1.0 / 12, neighbour_share = 0.25;
/// For varying radiance: a mesh with more triangles than this is replaced by one of larger cells.
constexpr std::size_t many_faces = 1 << 15;

/// Density of a direction that meets the leaf, which is inside the ball.
double density(const CompositeEmitter& e, const Around& ball, const Vec3& from,
               const Vec3& direction) {
    const double around = 1 / (2 * pi * rim(ball, length(ball.centre - from)));
    return e.proxy ? astray * around + at_proxy * e.proxy->density(from, direction) : around;
}

/// Parallel rays through the ball from all sides, of which those that meet the leaf are kept.
struct SeenRays {
    static constexpr std::uint32_t rays = 512;
    std::vector<Ray> met;
    bool closed = true;  ///< whether none of them shows the inner side

    SeenRays(const CompositeEmitter& e, const Around& ball) {
        const LeafSides sides(*e.composite, e.leaf, ball.radius);
        for (std::uint32_t i = 0; i < rays; ++i) {
            const auto number = [&](std::uint32_t branch, Purpose purpose) {
                return uniform(Key::of(Survey::seen_area, 0, i, branch), purpose);
            };
            const Vec3 direction = in_cone(
                Vec3(0, 0, 1), 2, {number(0, Purpose::survey_u), number(0, Purpose::survey_v)});
            const auto [x, y] = perpendiculars(direction);
            const double off = ball.radius * std::sqrt(number(1, Purpose::survey_u));
            const double angle = 2 * pi * number(1, Purpose::survey_v);
            const Vec3 through = ball.centre + off * on_circle(angle, x, y);
            const Ray ray{through - 2 * ball.radius * direction, direction};
            const auto hit = first_of(e, ray, 0);
            if (!hit) continue;
            met.push_back(ray);
            closed = closed && (!sides.leaves(ray, *hit) || is_hidden(e, ray, hit->t));
        }
    }

    /// Whether another leaf of the whole is in front of the point, or all around the ray's start.
    static bool is_hidden(const CompositeEmitter& e, const Ray& ray, double t) {
        return e.composite->inside(ray.origin) ||
               e.composite->first(ray, Interval{0, t * (1 - same_face)},
                                  [&](std::uint32_t leaf) { return leaf != e.leaf; });
    }
};

/// Returns the mesh with its vertices moved outwards: triangles between points of a round surface
/// do not reach its silhouette.
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

/// Adds a proxy mesh that nearly all rays that meet the leaf meet too, from the first number of
/// cells that gives one. Parts of the leaf outside the proxy mesh make noise, and parts of the
/// proxy mesh outside the leaf waste rays. `make` returns nothing if the next number is to be
/// tried; its second argument is whether there is a next one.
void add_proxy(CompositeEmitter& e, const Around& ball, const SeenRays& survey,
               std::initializer_list<int> cell_numbers,
               FunctionRef<std::optional<ProxyMesh>(const Mesh&, bool)> make) {
    double most = 0.9;
    for (const int& cells : cell_numbers) {
        const Mesh mesh = seen_tessellation(*e.composite, e.leaf, cells);
        if (mesh.faces.empty()) continue;
        std::optional<ProxyMesh> made =
            make(grown(mesh, ball.radius / (6 * cells)), std::next(&cells) != cell_numbers.end());
        if (!made) continue;
        const auto covered =
            std::ranges::count_if(survey.met, [&](const Ray& ray) { return made->met_by(ray); });
        const double reached =
            static_cast<double>(covered) / static_cast<double>(survey.met.size());
        if (reached > most) {
            most = reached;
            e.proxy = make_handle<ProxyMesh>(std::move(*made));
        }
        if (most >= 0.97) break;
    }
}

/// Returns the mesh with long triangles divided so that no edge exceeds `longest`.
Mesh divided(const Mesh& mesh, double longest) {
    Mesh result;
    result.vertices = mesh.vertices;
    std::vector<Face> left = mesh.faces;
    std::map<std::pair<int, int>, int> middles;
    while (!left.empty()) {
        const Face f = left.back();
        left.pop_back();
        const auto length_from = [&](std::size_t i) {
            return length(result.vertices[static_cast<std::size_t>(f[(i + 1) % 3])] -
                          result.vertices[static_cast<std::size_t>(f[i])]);
        };
        const std::size_t at = length_from(0) > length_from(1)
                                   ? (length_from(0) > length_from(2) ? 0 : 2)
                                   : (length_from(1) > length_from(2) ? 1 : 2);
        if (!(length_from(at) > longest)) {
            result.faces.push_back(f);
            continue;
        }
        const int first = f[at], second = f[(at + 1) % 3], other = f[(at + 2) % 3];
        const auto [place, fresh] = middles.try_emplace(std::minmax(first, second),
                                                        static_cast<int>(result.vertices.size()));
        if (fresh)
            result.vertices.push_back(0.5 * (result.vertices[static_cast<std::size_t>(first)] +
                                             result.vertices[static_cast<std::size_t>(second)]));
        left.push_back({first, place->second, other});
        left.push_back({place->second, second, other});
    }
    return result;
}

/// Luminance sampled at some points of each face.
struct Brightnesses {
    std::vector<double> mean;    ///< mean luminance
    std::vector<double> square;  ///< mean squared luminance, blended with the neighbours': bright
                                 ///< spots may reach into faces whose sample points miss them

    Brightnesses(const Mesh& mesh, FunctionRef<double(const Vec3&)> luminance) {
        const auto at = [](int i) { return static_cast<std::size_t>(i); };
        std::vector<double> around(mesh.vertices.size(), 0), count(mesh.vertices.size(), 0);
        for (const Face& f : mesh.faces) {
            const Vec3 a = mesh.vertices[at(f[0])], b = mesh.vertices[at(f[1])],
                       c = mesh.vertices[at(f[2])];
            double sum = 0, squares = 0;
            for (const Vec3& p : {(a + b + c) / 3.0, (4.0 * a + b + c) / 6.0,
                                  (a + 4.0 * b + c) / 6.0, (a + b + 4.0 * c) / 6.0}) {
                const double l = std::fmax(luminance(p), 0);
                sum += l / 4;
                squares += l * l / 4;
            }
            mean.push_back(sum);
            square.push_back(squares);
            for (const int corner : f) {
                around[at(corner)] += squares;
                count[at(corner)] += 1;
            }
        }
        for (std::size_t i = 0; i < square.size(); ++i) {
            double beside = 0;
            for (const int corner : mesh.faces[i]) beside += around[at(corner)] / count[at(corner)];
            square[i] = (1 - neighbour_share) * square[i] + neighbour_share * beside / 3;
        }
    }
};

/// An emitter without a proxy mesh, and the rays by which it was measured.
struct Measured {
    CompositeEmitter emitter;
    Around ball;
    SeenRays survey;

    Measured(Handle<Composite> composite, std::uint32_t leaf)
        : emitter{std::move(composite), leaf, 0}, ball(emitter), survey(emitter, ball) {
        const auto met = static_cast<double>(survey.met.size());
        emitter.seen_area = std::fmax(met, 0.5) / SeenRays::rays * pi * ball.radius * ball.radius;
        emitter.closed = survey.closed;
    }
};

}  // namespace

CompositeEmitter composite_emitter(Handle<Composite> composite, std::uint32_t leaf,
                                   bool with_proxy) {
    Measured made(std::move(composite), leaf);
    const auto met = static_cast<double>(made.survey.met.size());
    // The cone finds a leaf that nearly fills it soon enough.
    if (with_proxy && met > 0 && met < 0.75 * SeenRays::rays)
        add_proxy(made.emitter, made.ball, made.survey, {12, 24, 48},
                  [](const Mesh& mesh, bool) { return ProxyMesh(mesh); });
    return made.emitter;
}

CompositeEmitter bright_composite_emitter(Handle<Composite> composite, std::uint32_t leaf,
                                          FunctionRef<double(const Vec3&)> luminance) {
    Measured made(std::move(composite), leaf);
    if (made.survey.met.empty()) return made.emitter;
    add_proxy(
        made.emitter, made.ball, made.survey, {64, 32},
        [&](const Mesh& coarse, bool is_next) -> std::optional<ProxyMesh> {
            if (is_next && coarse.faces.size() > many_faces) return {};
            const Mesh mesh = divided(coarse, longest_edge * made.ball.radius);
            const Brightnesses found(mesh, luminance);
            const double area = MeshArea(mesh).total(), sum = MeshArea(mesh, found.mean).total();
            if (!(sum > 0)) return ProxyMesh(mesh);
            made.emitter.mean = sum / area;
            made.emitter.unevenness = MeshArea(mesh, found.square).total() * area / (sum * sum);
            // This weight minimises the noise where the luminance varies within a face.
            std::vector<double> worth;
            for (const double square : found.square) worth.push_back(std::sqrt(square));
            return ProxyMesh(mesh, std::move(worth));
        });
    return made.emitter;
}

CompositeEmitter unmeasured_emitter(Handle<Composite> composite, std::uint32_t leaf) {
    CompositeEmitter result{std::move(composite), leaf};
    const double radius = Around(result).radius;
    result.seen_area = pi * radius * radius;
    return result;
}

CompositeEmitter placed_emitter(const CompositeEmitter& original, Handle<Composite> composite,
                                const Handle<Transform>& place) {
    Measured made(std::move(composite), 0);
    if (original.proxy)
        made.emitter.proxy = make_handle<ProxyMesh>(ProxyMesh(*original.proxy, place));
    return made.emitter;
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

double unoccluded(const CompositeEmitter& e, double luminance, const Receiver& point) {
    return irradiance(light_proxy(bounds(e, luminance)), point);
}

std::optional<LightDirection> draw_direction(const CompositeEmitter& e, const Vec3& from,
                                             const Vec2& u) {
    const Around ball(e);
    Vec3 direction;
    if (e.proxy && u.x >= astray) {
        direction = unit(e.proxy->point({(u.x - astray) / at_proxy, u.y}) - from);
        if (direction == Vec3(0)) return {};
    } else {
        const Vec3 offset = ball.centre - from;
        const double to_centre = length(offset);
        const Vec3 middle = to_centre > 0 ? offset / to_centre : Vec3(0, 0, 1);
        const Vec2 left = e.proxy ? Vec2(u.x / astray, u.y) : u;
        direction = unit(in_cone(middle, rim(ball, to_centre), left));
    }
    return LightDirection{direction, density(e, ball, from, direction)};
}

double direction_density(const CompositeEmitter& e, const Vec3& from, const Vec3& direction) {
    return density(e, Around(e), from, direction);
}

std::optional<LightPoint> sample(const CompositeEmitter& e, const Vec3& from, const Vec2& u) {
    const auto drawn = draw_direction(e, from, u);
    if (!drawn) return {};
    const Ray ray{from, drawn->direction};
    const auto met = first_of(e, ray, clearance * Around(e).radius);
    if (!met) return {};
    return LightPoint{ray.at(met->t), ray.direction, met->t, drawn->density};
}

void intersect(const CompositeEmitter& e, const Receiver& point, const Vec3& direction,
               LightHits& met) {
    const Around ball(e);
    const auto first = first_of(e, {point.position, direction}, clearance * ball.radius);
    if (first) met.push_back({first->t, density(e, ball, point.position, direction)});
}

std::optional<EmittedRay> emit(const CompositeEmitter& e, double inner, const EmissionDraw& u) {
    // A directed line through the ball, followed from one of the points where it meets the leaf:
    // every point has light in every direction, also where the leaf itself is in the way.
    const Around ball(e);
    const Vec3 along = in_cone(Vec3(0, 0, 1), 2, u.direction);
    const auto [x, y] = perpendiculars(along);
    const double off = ball.radius * std::sqrt(u.where.x), angle = 2 * pi * u.where.y;
    const Vec3 through = ball.centre + off * on_circle(angle, x, y);
    const Ray line{through - 2 * ball.radius * along, along};
    const LeafSides sides(*e.composite, e.leaf, ball.radius);
    const auto weight = [&](const Composite::Meeting& met) {
        if (!e.closed) return 0.5;
        return sides.leaves(line, met) ? 1 - inner : inner;
    };
    struct Found {
        Composite::Meeting met;
        double weight;
    };
    ShortList<Composite::Meeting, 8> all;
    ShortList<Found, 8> found;
    e.composite->all(
        line, Interval{0}, [&](std::uint32_t leaf) { return leaf == e.leaf; },
        [&](const Composite::Meeting& met) { all.push_back(met); });
    sort_stably(all, {}, &Composite::Meeting::t);
    double sum = 0;
    for (const Composite::Meeting& met : all) {
        // Faces in the same place, as a mesh may have them, glow once.
        if (!found.empty() && met.t - found.back().met.t <= same_face * ball.radius) continue;
        found.push_back({met, weight(met)});
        sum += found.back().weight;
    }
    const Found* drawn = nullptr;
    double left = u.side * sum;
    for (const Found& each : found) {
        drawn = &each;
        left -= each.weight;
        if (left < 0) break;
    }
    if (!drawn || !(sum > 0)) return {};
    Vec3 normal = surface_normal(e.composite->leaf(e.leaf), drawn->met);
    if (dot(normal, along) < 0) normal = -normal;
    // Lines have a uniform density per area perpendicular to them.
    const double per_crossed_area = 1 / (pi * ball.radius * ball.radius);
    const double of_point = drawn->weight / sum * per_crossed_area * dot(normal, along);
    return EmittedRay{{line.at(drawn->met.t), along}, normal, of_point / (4 * pi), of_point};
}

double emitting_area(const CompositeEmitter& e) { return 4 * e.seen_area; }

}  // namespace candelabra
