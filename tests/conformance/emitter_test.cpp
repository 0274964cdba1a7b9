// SPDX-License-Identifier: GPL-3.0-or-later
// What every kind of emitter must do: the rays that leave it bring as much light through any sphere
// as the points that are sampled from the sphere's surface.
#include "support/lights.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candelabra {

namespace {

using std::numbers::pi;

struct LitBall {
    Vec3 centre;
    double radius;
};

bool meets(const LitBall& ball, const Ray& ray) {
    const Vec3 to = ball.centre - ray.origin;
    const double along = dot(to, ray.direction);
    const bool inside = dot(to, to) < ball.radius * ball.radius;
    return inside || (along > 0 && dot(to, to) - along * along < ball.radius * ball.radius);
}

/// Whether the luminaire itself is on the way.
bool hides_itself(const Luminaire& luminaire, const Vec3& from, const Vec3& direction, double end) {
    constexpr double step = 1e-6;
    LightHits met;
    intersect(luminaire, {from + step * direction, Vec3(0), Horizon::none}, direction, met);
    return std::ranges::any_of(met, [&](const LightHit& hit) {
        return hit.distance > step && hit.distance < end - 3 * step;
    });
}

/// A mean and its standard error.
struct Mean {
    double sum = 0, squares = 0, count = 0;

    void add(double value) { sum += value, squares += value * value, ++count; }
    double mean() const { return sum / count; }
    double error() const {
        return std::sqrt(std::fmax(squares / count - mean() * mean(), 0) / count);
    }
};

/// Power through the ball of the rays that leave the luminaire.
Mean sent_through(const LitBall& ball, const Luminaire& luminaire, Draw& draw) {
    Mean power;
    for (int i = 0; i < 40000; ++i) {
        const Vec2 where{draw.number(), draw.number()}, direction{draw.number(), draw.number()};
        const auto ray = emit(luminaire, 0.5, {where, direction, draw.number()});
        const bool counts = ray && meets(ball, ray->ray) &&
                            !hides_itself(luminaire, ray->ray.origin, ray->ray.direction, INFINITY);
        power.add(counts ? std::abs(dot(ray->normal, ray->ray.direction)) / ray->density : 0);
    }
    return power;
}

/// The same from points of the ball's surface: on the outside or, if the luminaire is in the ball,
/// on the inside.
Mean received_by(const LitBall& ball, const Luminaire& luminaire, bool from_inside, Draw& draw) {
    Mean power;
    const double area = 4 * pi * ball.radius * ball.radius;
    for (int i = 0; i < 40000; ++i) {
        const Vec3 out = draw.direction();
        const Receiver point{ball.centre + ball.radius * out, from_inside ? -out : out};
        const auto drawn = sample(luminaire, point, {draw.number(), draw.number()});
        const bool counts =
            drawn && !hides_itself(luminaire, point.position, drawn->direction, drawn->distance);
        const double cosine = counts ? std::fmax(point.cosine(drawn->direction), 0) : 0;
        power.add(counts ? area * cosine / drawn->density : 0);
    }
    return power;
}

}  // namespace

TEST_CASE("rays of an emitter bring through any sphere what its samples bring", "[luminaire]") {
    Draw draw(31);
    for (int kind = 0; kind < emitter_kinds; ++kind) {
        const Luminaire luminaire = glowing(emitter(kind, Vec3(0.3, 0.2, -0.1), 0.5, draw));
        for (const LitBall& ball : {LitBall{Vec3(0), 4}, LitBall{Vec3(2.5, 0, 0), 1},
                                    LitBall{Vec3(0, -2, 1), 0.7}, LitBall{Vec3(-1, 2, -2), 1.2}}) {
            const bool inside = ball.radius == 4;
            const Mean sent = sent_through(ball, luminaire, draw),
                       received = received_by(ball, luminaire, inside, draw);
            INFO("kind " << kind << ", ball of " << ball.radius << ": " << sent.mean() << " and "
                         << received.mean());
            CHECK(sent.mean() > 0);
            CHECK(std::abs(sent.mean() - received.mean()) <= 5 * (sent.error() + received.error()));
        }
    }
}

}  // namespace candelabra
