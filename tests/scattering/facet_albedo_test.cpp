// SPDX-License-Identifier: GPL-3.0-or-later
#include "scattering/facet_albedo.h"

#include "scattering/ggx.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

namespace {

/// By the visible facets, on a fine grid.
FacetAlbedo summed(double width, double cosine) {
    constexpr int steps = 200;
    const Vec3 viewer(std::sqrt(1 - cosine * cosine), 0, cosine);
    FacetAlbedo sum{0, 0};
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const Vec3 facet =
                visible_facet(viewer, width, Vec2((i + 0.5) / steps, (j + 0.5) / steps));
            const double between = dot(viewer, facet), light = 2 * between * facet.z - viewer.z;
            if (light <= 0 || between <= 0) continue;
            sum.all += 2 * light * unhidden(width, light) / (steps * steps);
            sum.grazing +=
                2 * light * unhidden(width, light) * grazing_share(between) / (steps * steps);
        }
    return sum;
}

}  // namespace

TEST_CASE("albedos of facets are the sums over their directions", "[scattering]") {
    for (const double roughness : {0.0, 0.04, 0.1, 0.2, 0.33, 0.5, 0.72, 1.0})
        for (const double cosine : {0.01, 0.05, 0.1, 0.17, 0.3, 0.5, 0.8, 1.0}) {
            CAPTURE(roughness, cosine);
            const FacetAlbedo found = facet_albedo(roughness, cosine),
                              expected = summed(facet_width(roughness), cosine);
            const double bound = cosine < 0.05 ? 0.01 : cosine < 0.1 ? 0.007 : 0.004;
            CHECK(std::abs(found.all - expected.all) < bound);
            CHECK(std::abs(found.grazing - expected.grazing) < bound);
            CHECK(found.all <= 1);
            CHECK(found.schlick(1) == Approx(found.all));
            CHECK(found.schlick(0) == Approx(found.grazing));
        }
}

TEST_CASE("mean albedos are weighted by the cosine", "[scattering]") {
    for (const double roughness : {0.05, 0.3, 0.65, 1.0}) {
        FacetAlbedo sum{0, 0};
        constexpr int steps = 2000;
        for (int i = 0; i < steps; ++i) {
            const double cosine = (i + 0.5) / steps;
            const FacetAlbedo there = facet_albedo(roughness, cosine);
            sum.all += 2 * cosine * there.all / steps;
            sum.grazing += 2 * cosine * there.grazing / steps;
        }
        CHECK(mean_facet_albedo(roughness).all == Approx(sum.all).epsilon(1e-4));
        CHECK(mean_facet_albedo(roughness).grazing == Approx(sum.grazing).epsilon(1e-3));
    }
}

}  // namespace candelabra
