// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/glare.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

namespace {

Rgb sum_of(const Image& image) {
    Rgb sum(0);
    for (const Rgb& pixel : image.pixels) sum += pixel;
    return sum;
}

Glare glare_of(double veil, double halo, double star) {
    Glare glare;
    glare.veil = veil;
    glare.halo = halo;
    glare.star = star;
    return glare;
}

}  // namespace

TEST_CASE("a kernel has all light, and is the same in opposite directions", "[film][glare]") {
    for (const int blades : {0, 5, 6}) {
        Glare glare = glare_of(0.3, 0.1, 0.05);
        glare.blades = blades;
        glare.angle = 17;
        const GlareKernel kernel(glare, 40, 31);
        Rgb sum(0);
        for (int dy = -30; dy <= 30; ++dy)
            for (int dx = -39; dx <= 39; ++dx) {
                const Rgb share = kernel.at(dx, dy);
                sum += share;
                for (int c = 0; c < 3; ++c) {
                    CHECK(share[c] >= 0);
                    CHECK(share[c] == Approx(kernel.at(-dx, -dy)[c]).epsilon(1e-9));
                }
            }
        for (int c = 0; c < 3; ++c) CHECK(sum[c] == Approx(1).epsilon(1e-9));
    }
}

TEST_CASE("glare keeps the energy of a lamp whose light cannot leave the picture",
          "[film][glare]") {
    // A kernel of a small picture, applied to a larger one with the lamp at its centre.
    const GlareKernel kernel(glare_of(0.4, 0.05, 0.1), 30, 24);
    Image image(96, 80);
    image.at(48, 40) = {1e6, 2e5, 3e4};
    image.at(45, 38) = {10, 0, 5};
    const Image made = spread(image, kernel, 1);
    const Rgb before = sum_of(image), after = sum_of(made);
    for (int c = 0; c < 3; ++c) CHECK(after[c] == Approx(before[c]).epsilon(1e-9));
    CHECK(made.at(48, 40).r < 0.8e6);
    CHECK(made.at(48, 40).r > 0.45e6);
    // Light is scattered within the kernel, and not beyond.
    CHECK(made.at(48 + 20, 40 + 10).r == Approx(1e6 * kernel.at(20, 10).r).epsilon(1e-4));
    CHECK(std::abs(made.at(48 + 35, 40).r) < 1e-6);
}

TEST_CASE("a spread picture is the sum that defines it", "[film][glare]") {
    const GlareKernel kernel(glare_of(0.3, 0.1, 0.1), 9, 7);
    Image image(9, 7);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = Rgb(static_cast<double>(i % 5), static_cast<double>(i % 7), 1);
    const Image made = spread(image, kernel, 2);
    CHECK(made.pixels == spread(image, kernel, 1).pixels);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            Rgb sum(0);
            for (int v = 0; v < image.height; ++v)
                for (int u = 0; u < image.width; ++u)
                    sum += kernel.at(x - u, y - v) * image.at(u, v);
            for (int c = 0; c < 3; ++c) CHECK(made.at(x, y)[c] == Approx(sum[c]).epsilon(1e-9));
        }
}

TEST_CASE("a veil falls as the eye's does", "[film][glare]") {
    // Spencer's parts at 4 and at 12 degrees: 0.478 f1 + 0.138 f2, per solid angle.
    Glare glare = glare_of(0.5, 0, 0);
    glare.field = 40;
    const int width = 400;
    const GlareKernel kernel(glare, width, 300);
    const double plane = width / 2.0 / std::tan(20 * M_PI / 180);
    const auto share = [&](int pixels) {
        const double angle = std::atan(pixels / plane);
        return kernel.at(pixels, 0).r / std::pow(std::cos(angle), 3);
    };
    const auto eye = [&](int pixels) {
        const double away = std::atan(pixels / plane) * 180 / M_PI + 0.02;
        return 0.478 * 20.91 / std::pow(away, 3) + 0.138 * 72.37 / std::pow(away, 2);
    };
    CHECK(share(120) / share(40) == Approx(eye(120) / eye(40)).epsilon(1e-9));
    CHECK(share(399) / share(10) == Approx(eye(399) / eye(10)).epsilon(1e-9));
}

TEST_CASE("a halo is a ring, wider and redder outside", "[film][glare]") {
    Glare glare = glare_of(0, 0.2, 0);
    glare.field = 20;
    const GlareKernel kernel(glare, 400, 300);
    const double per_degree = 200 / std::tan(10 * M_PI / 180) * M_PI / 180;
    const auto at = [&](double degrees) {
        return kernel.at(static_cast<int>(std::lround(degrees * per_degree)), 0);
    };
    CHECK(at(3).g > 2 * at(1.5).g);
    CHECK(at(3).g > 2 * at(4.5).g);
    CHECK(at(4.2).r > 1.5 * at(4.2).b);
    CHECK(at(1.6).b > 1.5 * at(1.6).r);
}

TEST_CASE("a star has rays by the blades of the aperture", "[film][glare]") {
    const auto rays = [](int blades) {
        Glare glare = glare_of(0, 0, 0.2);
        glare.blades = blades;
        glare.angle = 7;
        const GlareKernel kernel(glare, 200, 200);
        int count = 0;
        bool lit = false;
        double brightest = 0;
        for (int pass = 0; pass < 2; ++pass)
            for (int i = 0; i <= 720; ++i) {
                const double turn = i * M_PI / 360;
                const double here = kernel
                                        .at(static_cast<int>(std::lround(60 * std::cos(turn))),
                                            static_cast<int>(std::lround(60 * std::sin(turn))))
                                        .g;
                if (pass == 0) {
                    brightest = std::max(brightest, here);
                    continue;
                }
                const bool now = here > 0.05 * brightest;
                count += now && !lit && i > 0;
                lit = now;
            }
        return count;
    };
    CHECK(rays(6) == 6);
    CHECK(rays(8) == 8);
    CHECK(rays(5) == 10);
    Glare round = glare_of(0, 0, 0.2);
    round.blades = 0;
    CHECK(GlareKernel(round, 20, 20).at(0, 0) == Rgb(1));
}

TEST_CASE("pixels that are no numbers do not spread", "[film][glare]") {
    const GlareKernel kernel(glare_of(0.3, 0.1, 0.1), 8, 8);
    Image image(8, 8);
    image.at(2, 2) = Rgb(NAN);
    image.at(4, 4) = Rgb(INFINITY);
    image.at(6, 6) = Rgb(1);
    for (const Rgb& pixel : spread(image, kernel, 1).pixels)
        for (int c = 0; c < 3; ++c) CHECK(std::isfinite(pixel[c]));
    CHECK(spread(Image(1, 1), GlareKernel(Glare(), 1, 1), 1).at(0, 0) == Rgb(0));
}

}  // namespace candelabra
