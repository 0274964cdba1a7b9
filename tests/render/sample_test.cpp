// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/sample.h"

#include "support/four_lamps.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// A lamp whose edge must not be moved by any pixel filter, on an evenly lit ground.
Shot filmed(const std::string& film) {
    return shot_of(R"(
        #version 3.7;
        camera { location -5*z right x up y film { )" +
                   film + R"( } }
        sphere { 0, 1.2 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 0.8 } }
        plane { z, 2 pigment { rgb 1 } finish { ambient 0.3 diffuse 0 } }
    )");
}

double mean_grey(const Image& image) {
    double sum = 0;
    for (const Rgb& pixel : image.pixels) sum += pixel.r;
    return sum / static_cast<double>(image.pixels.size());
}

}  // namespace

TEST_CASE("another seed gives other noise around the same mean", "[render]") {
    const Shot shot = shot_of(four_lamps);
    RenderSettings settings = small(0);
    settings.samples = 64;
    const Image first = render(shot, settings).image;
    settings.seed = 1;
    const Image second = render(shot, settings).image;
    CHECK(first.pixels != second.pixels);
    double sum1 = 0, sum2 = 0;
    for (std::size_t i = 0; i < first.pixels.size(); ++i) {
        sum1 += grey(first.pixels[i]);
        sum2 += grey(second.pixels[i]);
    }
    CHECK(sum1 == Approx(sum2).epsilon(0.01));
}

TEST_CASE("any number of samples sees all moments and all meshes of a camera alike", "[render]") {
    const auto of_light = [](double light, const std::string& camera) {
        return world_of("#version 3.7; camera { " + camera +
                        " } plane { z, 2 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission " +
                        std::to_string(light) + " } }");
    };
    // One of four moments is bright, and so is one of three rays of a pixel.
    World moving(*of_light(1, "location -5*z"));
    for (int later = 0; later < 3; ++later)
        moving.shutter.emplace_back(*of_light(0, "location -5*z"));
    const Shot four_moments(std::make_shared<World>(std::move(moving)));
    const auto faces = [](const char* corners) {
        std::string text = "mesh { ";
        for (int i = 0; i < 24 * 18; ++i) text += corners;
        return text + "}";
    };
    const std::string to_light = "triangle { <0, 0, 0>, <0, 1, 0>, <1, 0, 0> } ",
                      away = "triangle { <0, 0, 0>, <1, 0, 0>, <0, 1, 0> } ";
    const Shot three_rays(of_light(1, "mesh_camera { 3, 0 " + faces(to_light.c_str()) +
                                          faces(away.c_str()) + faces(away.c_str()) + "}"));
    for (int samples = 1; samples <= 9; ++samples) {
        RenderSettings settings = of_samples(samples);
        settings.width = 24, settings.height = 18;
        CAPTURE(samples);
        const auto check = [&](const Shot& shot, double share, int items) {
            const Image image = render(shot, settings).image;
            const double error =
                samples % items == 0 ? 1e-12 : 5 * std::sqrt(share / samples / (24 * 18));
            CHECK(mean_grey(image) == Approx(share).margin(error));
        };
        check(four_moments, 1.0 / 4, 4);
        check(three_rays, 1.0 / 3, 3);
    }
}

TEST_CASE("pixel filters keep even light as it is, and the mean of a picture", "[render][film]") {
    const Image box = render(filmed("pixel_filter box"), of_samples(64)).image;
    for (const std::string name : {"triangle", "mitchell", "blackman_harris"}) {
        INFO(name);
        const Image made = render(filmed("pixel_filter " + name), of_samples(64)).image;
        CHECK(mean_grey(made) == Approx(mean_grey(box)).epsilon(0.005));
        CHECK(made.at(16, 16).r == Approx(0.8).epsilon(1e-9));
        CHECK(made.at(1, 1).r == Approx(box.at(1, 1).r).epsilon(1e-9));
        CHECK(made.pixels != box.pixels);
    }
    // Negative lobes beside the edge: the ground is darker there, and the lamp brighter.
    const Image sharp = render(filmed("pixel_filter mitchell"), of_samples(256)).image;
    double least = 1, greatest = 0;
    for (const Rgb& pixel : sharp.pixels) {
        least = std::min(least, pixel.r);
        greatest = std::max(greatest, pixel.r);
    }
    CHECK(least < 0.295);
    CHECK(greatest > 0.805);
}

}  // namespace candelabra
