// SPDX-License-Identifier: GPL-3.0-or-later
#include "scattering/microfacet.h"

#include "base/random.h"

#include <catch2/catch.hpp>

#include <numbers>

namespace candelabra {

namespace {

using std::numbers::pi;

struct MicrofacetBench {
    Finish finish;
    Shading shading;

    explicit MicrofacetBench(double roughness, double metallic = 1, double coat = 0) {
        finish.microfacet.on = true;
        finish.microfacet.roughness = roughness;
        finish.microfacet.metallic = metallic;
        finish.microfacet.coat = coat;
        shading.view = unit(Vec3(1, -1, 0.3));
        shading.normal = shading.geometric_normal = Vec3(0, 1, 0);
        shading.finish = &finish;
        shading.colour = {Vec3(1, 1, 1)};
    }
};

/// Light from a white sky reflected by the surface, by uniform directions.
double by_response(const Shading& s, bool wide_only) {
    double sum = 0;
    const int rows = 300, columns = 300;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const double y = (i + 0.5) / rows, turn = 2 * pi * (j + 0.5) / columns;
            const double across = std::sqrt(1 - y * y);
            sum +=
                facet_response(s, {across * std::cos(turn), y, across * std::sin(turn)}, wide_only)
                    .x;
        }
    return sum / pi * 2 * pi / (rows * columns);
}

/// The same by sampled directions.
double by_scattering(const Shading& s) {
    double sum = 0;
    const int count = 20000;
    for (std::uint32_t i = 0; i < count; ++i) {
        Key key;
        key.sample = i;
        const auto drawn =
            scatter(s, uniform(key, Purpose::facet_choice),
                    {uniform(key, Purpose::facet_u), uniform(key, Purpose::facet_v)});
        if (drawn) sum += drawn->weight.x;
    }
    return sum / count;
}

}  // namespace

TEST_CASE("drawn directions reflect as much as all directions do", "[render]") {
    for (const double roughness : {0.35, 0.5, 0.7, 1.0}) {
        const MicrofacetBench metal(roughness);
        CAPTURE(roughness);
        const double reflected = by_response(metal.shading, false);
        CHECK(by_scattering(metal.shading) == Approx(reflected).epsilon(0.02));
        CHECK(reflected <= 1);
        CHECK(reflected > 0.3);
    }
    const MicrofacetBench coated(0.6, 1, 1);
    MicrofacetBench dull = coated;
    dull.finish.microfacet.coat_roughness = 0.5;
    dull.shading.finish = &dull.finish;
    CHECK(by_scattering(dull.shading) == Approx(by_response(dull.shading, false)).epsilon(0.02));
}

TEST_CASE("a smooth metal is a mirror of its colour", "[render]") {
    MicrofacetBench mirror(0);
    mirror.shading.colour = {Vec3(0.9, 0.6, 0.3)};
    mirror.shading.view = Vec3(0, -1, 0);
    const auto drawn = scatter(mirror.shading, 0.5, {0.3, 0.7});
    REQUIRE(drawn);
    CHECK(drawn->narrow);
    CHECK(drawn->direction.y > 0.999);
    CHECK(length(drawn->weight - Vec3(0.9, 0.6, 0.3)) < 1e-2);
    CHECK(facet_response(mirror.shading, Vec3(0, 1, 0), true) == Vec3(0));
    CHECK(facet_response(mirror.shading, Vec3(0, 1, 0), false).x > 1);
}

TEST_CASE("the response is the same both ways", "[render]") {
    MicrofacetBench there(0.5, 0.3, 0.5);
    MicrofacetBench back = there;
    back.shading.finish = &back.finish;
    const Vec3 light = unit(Vec3(-0.2, 0.5, 0.8));
    back.shading.view = -light;
    const double one = facet_response(there.shading, light, false).x / light.y;
    const double other =
        facet_response(back.shading, -there.shading.view, false).x / -there.shading.view.y;
    CHECK(one == Approx(other));
    CHECK(facet_response(there.shading, -light, false) == Vec3(0));
}

}  // namespace candelabra
