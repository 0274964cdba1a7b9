// SPDX-License-Identifier: GPL-3.0-or-later
#include "scattering/microfacet.h"

#include "base/degrees.h"
#include "support/draw.h"
#include "support/rgb.h"

#include <catch2/catch.hpp>

#include <numbers>

namespace candelabra {

namespace {

using std::numbers::pi;

struct MicrofacetBench {
    Finish finish;
    Shading shading;

    explicit MicrofacetBench(double roughness, double metallic = 1, double coat = 0,
                             double coat_roughness = 0.03) {
        finish.microfacet.on = true;
        finish.microfacet.roughness = roughness;
        finish.microfacet.metallic = metallic;
        finish.microfacet.coat = coat;
        finish.microfacet.coat_roughness = coat_roughness;
        shading.view = unit(Vec3(1, -1, 0.3));
        shading.normal = shading.geometric_normal = Vec3(0, 1, 0);
        shading.finish = &finish;
        shading.colour = {Rgb(1, 1, 1)};
    }
    MicrofacetBench(const MicrofacetBench&) = delete;
    MicrofacetBench& operator=(const MicrofacetBench&) = delete;

    /// Seen from this many degrees above the real surface.
    void look_from(double elevation) {
        const double angle = elevation * radians_per_degree;
        shading.view = Vec3(std::cos(angle), -std::sin(angle), 0);
    }
};

/// Light from a white sky reflected by the surface, by uniform directions.
double by_response(const Shading& s) {
    double sum = 0;
    const Microfacets facets(s);
    const int rows = 300, columns = 300;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const double y = (i + 0.5) / rows, turn = 2 * pi * (j + 0.5) / columns;
            const double across = std::sqrt(1 - y * y);
            sum += facets.response({across * std::cos(turn), y, across * std::sin(turn)}, false).r;
        }
    return sum / pi * 2 * pi / (rows * columns);
}

/// The same by sampled directions, which are spread evenly (Roberts, "The Unreasonable
/// Effectiveness of Quasirandom Sequences", 2018). Fails if one leads into the surface.
Rgb by_scattering(const Shading& s, int count = 8000) {
    const Microfacets facets(s);
    Rgb sum(0);
    for (int i = 0; i < count; ++i) {
        const auto step = [&](double size) { return i * size - std::floor(i * size); };
        const Vec2 place(step(0.7548776662466927), step(0.5698402909980532));
        const Vec3 diffuse = facets.draw_diffuse(place);
        if (const double density = facets.diffuse_density(diffuse); density > 0)
            sum += facets.base_response(diffuse) / (pi * density);
        const auto drawn = facets.scatter((i + 0.5) / count, place);
        if (drawn) sum += drawn->weight;
        if (drawn && dot(drawn->direction, s.geometric_normal) < 0) FAIL();
    }
    return sum / static_cast<double>(count);
}

}  // namespace

TEST_CASE("drawn directions reflect as much as all directions do", "[render]") {
    struct Row {
        double roughness, metallic, coat, tilt;
    };
    for (const Row& row :
         {Row{0.35, 1, 0, 0}, Row{0.5, 0, 0, 0}, Row{0.7, 0.5, 0, 0}, Row{1, 1, 0, 0},
          Row{0.6, 1, 1, 0}, Row{0.5, 0, 0.5, 0}, Row{0.5, 1, 0, 0.5}, Row{0.6, 0.3, 1, -1}}) {
        MicrofacetBench bench(row.roughness, row.metallic, row.coat, 0.5);
        bench.shading.normal = unit(Vec3(row.tilt, 1, 0.2 * row.tilt));
        CAPTURE(row.roughness, row.metallic, row.coat, row.tilt);
        CHECK(by_scattering(bench.shading).r == Approx(by_response(bench.shading)).epsilon(0.005));
    }
}

TEST_CASE("white facets reflect all light at every angle", "[scattering]") {
    struct Row {
        double metallic, coat, coat_roughness, lost;
    };
    // A coat takes the lesser share of both directions from lobes below it.
    for (const Row& row :
         {Row{0, 0, 0, 0}, Row{1, 0, 0, 0}, Row{0.4, 0, 0, 0}, Row{0, 1, 0.03, 0.02},
          Row{0, 1, 0.4, 0.02}, Row{0, 0.5, 0.2, 0.02}, Row{1, 1, 0.1, 0.03}})
        for (const double roughness : {0.0, 0.05, 0.3, 0.6, 1.0})
            for (const double elevation : {90.0, 60.0, 30.0, 10.0, 3.0}) {
                MicrofacetBench bench(roughness, row.metallic, row.coat, row.coat_roughness);
                bench.look_from(elevation);
                CAPTURE(row.metallic, row.coat, row.coat_roughness, roughness, elevation);
                const double reflected = by_scattering(bench.shading).r;
                CHECK(reflected < 1.01);
                CHECK(reflected > 0.99 - row.lost);
            }
}

TEST_CASE("facets with a bent normal lose no light", "[scattering]") {
    for (const double metallic : {0.0, 1.0})
        for (const double roughness : {0.05, 0.3, 1.0})
            for (const double elevation : {80.0, 30.0, 5.0})
                for (const double tilt : {0.3, 1.0, 3.0})
                    for (const double turn : {0.0, 1.5, 3.0}) {
                        MicrofacetBench bench(roughness, metallic);
                        bench.look_from(elevation);
                        bench.shading.normal =
                            unit(Vec3(tilt * std::cos(turn), 1, tilt * std::sin(turn)));
                        CAPTURE(metallic, roughness, elevation, tilt, turn);
                        CHECK(by_scattering(bench.shading, 5000).r == Approx(1).margin(0.015));
                    }
}

TEST_CASE("a smooth normal that was turned to the viewer is turned back", "[scattering]") {
    MicrofacetBench bench(0.3);
    bench.look_from(5);
    bench.shading.normal = -unit(Vec3(0.3, 1, 0));
    const Microfacets facets(bench.shading);
    CHECK(facets.response(Vec3(0, 1, 0), false).r > 0);
    CHECK(by_scattering(bench.shading).r == Approx(1).margin(0.015));
}

TEST_CASE("light that goes from facet to facet takes the metal's colour", "[scattering]") {
    MicrofacetBench gold(1);
    gold.shading.colour = {Rgb(0.9, 0.6, 0.3)};
    gold.look_from(60);
    const Rgb rough = by_scattering(gold.shading);
    MicrofacetBench smooth(0.1);
    smooth.shading.colour = gold.shading.colour;
    smooth.look_from(60);
    const Rgb clear = by_scattering(smooth.shading);
    for (int i = 0; i < 3; ++i) CHECK(rough[i] < clear[i]);
    CHECK(rough.r / rough.b > 1.1 * clear.r / clear.b);
    CHECK(rough.r > 0.7);
}

TEST_CASE("a smooth metal is a mirror of its colour", "[render]") {
    MicrofacetBench mirror(0);
    mirror.shading.colour = {Rgb(0.9, 0.6, 0.3)};
    mirror.shading.view = Vec3(0, -1, 0);
    const Microfacets facets(mirror.shading);
    const auto drawn = facets.scatter(0.5, {0.3, 0.7});
    REQUIRE(drawn);
    CHECK(drawn->narrow);
    CHECK(drawn->direction.y > 0.999);
    CHECK(length(drawn->weight - Rgb(0.9, 0.6, 0.3)) < 1e-2);
    CHECK(length(facets.response(Vec3(0, 1, 0), true)) < 1e-3);
    CHECK(facets.response(Vec3(0, 1, 0), false).r > 1);
}

TEST_CASE("the response is the same both ways", "[render]") {
    Draw draw(3);
    struct Row {
        double roughness, metallic, coat;
    };
    for (const auto& [roughness, metallic, coat] :
         {Row{0.5, 0.3, 0.5}, Row{0.3, 1, 0}, Row{1, 0, 0}, Row{0.7, 1, 1}, Row{0.2, 0, 1}})
        for (int i = 0; i < 20; ++i) {
            MicrofacetBench there(roughness, metallic, coat, 0.4),
                back(roughness, metallic, coat, 0.4);
            there.shading.colour = back.shading.colour = {Rgb(0.8, 0.5, 0.2)};
            const Vec3 light = unit(draw.direction() + Vec3(0, 1.01, 0)),
                       viewer = unit(draw.direction() + Vec3(0, 1.01, 0));
            there.shading.view = -viewer;
            back.shading.view = -light;
            const Rgb one = Microfacets(there.shading).response(light, false) / light.y,
                      other = Microfacets(back.shading).response(viewer, false) / viewer.y;
            CAPTURE(roughness, metallic, coat, light.y, viewer.y);
            CHECK(length(one - other) < 1e-9 * (1 + length(one)));
            CHECK(Microfacets(there.shading).response(-light, false) == Rgb(0));
        }
}

}  // namespace candelabra
