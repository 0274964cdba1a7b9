// SPDX-License-Identifier: GPL-3.0-or-later
#include "scattering/bsdf.h"

#include "support/lights.h"

#include <catch2/catch.hpp>

#include <numbers>

namespace candelabra {

namespace {

using std::numbers::pi;

struct Look {
    Finish finish;
    Shading shading;

    explicit Look(const Finish& f, const Vec3& view = unit(Vec3(1, -1, 0.3))) : finish(f) {
        shading.view = view;
        shading.normal = shading.geometric_normal = Vec3(0, 1, 0);
        shading.finish = &finish;
        shading.colour = {Vec3(0.5)};
    }
    Look(const Look&) = delete;
    Look& operator=(const Look&) = delete;
};

Finish highlights(double diffuse, double phong, double phong_size, double specular,
                  double roughness) {
    Finish result;
    result.diffuse = diffuse;
    result.phong = phong;
    result.phong_size = phong_size;
    result.specular = specular;
    result.roughness = roughness;
    return result;
}

Finish facets(double roughness, double metallic, double coat = 0) {
    Finish result;
    result.microfacet.on = true;
    result.microfacet.roughness = roughness;
    result.microfacet.metallic = metallic;
    result.microfacet.coat = coat;
    result.microfacet.coat_roughness = 0.5;
    return result;
}

const std::vector<Finish>& looks() {
    static const std::vector<Finish> all = {highlights(0.6, 0, 40, 0, 0.05),
                                            highlights(0.6, 0.8, 40, 0, 0.05),
                                            highlights(0, 0, 40, 0.7, 0.1),
                                            highlights(0.3, 0.4, 5, 0.9, 0.04),
                                            facets(0.4, 1),
                                            facets(0.6, 0),
                                            facets(0.5, 0.3, 1),
                                            facets(0.1, 1)};
    return all;
}

/// Bin of a direction: 8 by height, 16 around.
std::size_t bin(const Vec3& d) {
    const auto row = std::min<std::size_t>(static_cast<std::size_t>((d.y + 1) * 4), 7),
               column = static_cast<std::size_t>((std::atan2(d.z, d.x) / pi + 1) * 8) % 16;
    return row * 16 + column;
}

}  // namespace

TEST_CASE("directions are drawn with the density that is said", "[render]") {
    for (const bool both : {false, true})
        for (const Vec3& view :
             {unit(Vec3(1, -1, 0.3)), unit(Vec3(0.1, -1, 0)), unit(Vec3(-1, -0.1, 0.5))})
            for (const Finish& finish : looks()) {
                Look look(finish, view);
                look.shading.both_sides = both;
                const Bsdf bsdf(look.shading, ShadingRules());
                std::vector<double> drawn(128, 0), said(128, 0);
                constexpr int count = 200000;
                Draw draw(1);
                for (int i = 0; i < count; ++i)
                    if (const auto d = bsdf.sample({draw.number(), draw.number()}))
                        drawn[bin(*d)] += 1.0 / count;
                constexpr int rows = 400, columns = 800;
                for (int i = 0; i < rows; ++i)
                    for (int j = 0; j < columns; ++j) {
                        const double y = 2 * (i + 0.5) / rows - 1,
                                     turn = 2 * pi * (j + 0.5) / columns;
                        const double across = std::sqrt(1 - y * y);
                        const Vec3 d(across * std::cos(turn), y, across * std::sin(turn));
                        said[bin(d)] += bsdf.pdf(d) * 4 * pi / (rows * columns);
                    }
                // Below the surface the response is 0, and facets that would reflect there give
                // nothing.
                for (std::size_t b = both ? 0 : 64; b < 128; ++b) {
                    CAPTURE(b, both, view.x, finish.phong, finish.specular, finish.microfacet.on,
                            finish.microfacet.roughness);
                    if (both && b < 64 && bsdf.specular_probability() > 0) continue;
                    CHECK(drawn[b] == Approx(said[b]).margin(0.004));
                }
            }
}

TEST_CASE("surfaces without highlights, or that leave them to reflection, draw none", "[render]") {
    const Look dull(looks().front()), mirror(facets(0.1, 1)), shiny(highlights(0, 1, 40, 0, 0.05));
    CHECK(Bsdf(dull.shading, ShadingRules()).specular_probability() == 0);
    CHECK(Bsdf(mirror.shading, ShadingRules()).specular_probability() == 0);
    CHECK(Bsdf(shiny.shading, ShadingRules()).specular_probability() > 0.5);
}

TEST_CASE("what the choice of luminaires knows of highlights is near what they answer",
          "[render]") {
    for (const Finish& finish : looks()) {
        const Look look(finish);
        const Bsdf bsdf(look.shading, ShadingRules());
        const BsdfLobes known = bsdf.lobes();
        const Vec3 mirrored(look.shading.view.x, -look.shading.view.y, look.shading.view.z);
        Draw draw(2);
        for (int i = 0; known.count > 0 && i < 50; ++i) {
            const Vec3 d = unit(mirrored + 0.3 * draw.between(0, 1) * draw.direction());
            if (d.y < 0.1) continue;
            double sum = known.diffuse * d.y;
            for (std::size_t k = 0; k < known.count; ++k) {
                const Highlight& h = known.highlights[k];
                const double fallen = 1 + h.sharpness * (1 - dot(h.axis, d)) / 2;
                sum += h.peak / (fallen * fallen);
            }
            const double answer = bsdf.evaluate(d, {.facets = FacetLobes::wide}, 0).x;
            CAPTURE(finish.phong, finish.specular, finish.microfacet.roughness, d.x, d.y, d.z);
            CHECK(sum > 0.3 * answer);
            CHECK(sum < 5 * answer + 0.05);
        }
    }
}

}  // namespace candelabra
