// SPDX-License-Identifier: GPL-3.0-or-later
#include "medium/transmittance.h"

#include "support/media.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>

namespace candelabra {

namespace {

struct Estimate {
    Rgb mean;
    double deviation = 0;  ///< standard deviation of one sample of the red channel
};

Estimate left_behind(const Media& media, const Ray& ray, double distance, std::uint32_t count) {
    const std::array<const Media*, 1> view = {&media};
    Estimate result;
    double squares = 0;
    Key key;
    for (key.sample = 0; key.sample < count; ++key.sample) {
        const Rgb left = transmittance(view, ray, {0, distance}, {}, key);
        result.mean += left;
        squares += left.r * left.r;
    }
    result.mean /= count;
    result.deviation = std::sqrt(std::fmax(0, squares / count - result.mean.r * result.mean.r));
    return result;
}

}  // namespace

TEST_CASE("transmittance is exact where the density is the same everywhere", "[medium]") {
    const Media media = media_of("absorption <1, 0.5, -0.2> scattering { 1, 0.3 extinction 2 }");
    const Estimate found = left_behind(media, {Vec3(0), Vec3(0, 0, 1)}, 2, 3);
    CHECK(found.mean.r == Approx(std::exp(-3.2)));
    CHECK(found.mean.g == Approx(std::exp(-2.2)));
    CHECK(found.mean.b == Approx(std::exp(-0.8)));
    CHECK(found.deviation < 1e-9);
}

TEST_CASE("transmittance is unbiased where densities differ", "[medium]") {
    struct Case {
        const char* words;
        Vec3 depth;  ///< optical depth of three units along x from the origin
    };
    const Case cases[] = {
        {"absorption <2, 1, 0.1> density { gradient x scale 3 }", Vec3(3, 1.5, 0.15)},
        {"absorption 8 density { gradient x color_map { [0 rgb 0] [0.9 rgb 0] [0.9 rgb 1] } "
         "scale 3 }",
         Vec3(2.4)},
        {"absorption 1 density { gradient x color_map { [0 rgb 1] [0.5 rgb 1] [0.5 rgb 0] } }",
         Vec3(1.5)},
        {"absorption <0.02, 0.01, 0> density { checker density { rgb 0 } density { rgb 5 } "
         "scale 0.1 translate 0.03 }",
         Vec3(0.15, 0.075, 0)},
    };
    for (const Case& c : cases) {
        constexpr int count = 20000;
        const Estimate found = left_behind(
            media_of(c.words), {Vec3(0.001, 0.01, 0.02), Vec3(1, 0, 0)}, 3 - 0.002, count);
        INFO(c.words << ": deviation " << found.deviation);
        const double error = 5 * found.deviation / std::sqrt(count) + 0.003;
        CHECK(found.mean.r == Approx(std::exp(-c.depth.x)).margin(error));
        CHECK(found.mean.g == Approx(std::exp(-c.depth.y)).margin(error));
        CHECK(found.deviation < 1);
    }
}

TEST_CASE("bounds of extinction hold", "[medium]") {
    const Media media = media_of("absorption 2 density { bozo color_map { [0 rgb 0] [1 rgb 3] } }");
    const std::array<const Media*, 1> view = {&media};
    CHECK(max_extinction(view) == Approx(6));
    CHECK_FALSE(homogeneous(view));
}

}  // namespace candelabra
