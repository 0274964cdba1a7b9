// SPDX-License-Identifier: GPL-3.0-or-later
// A luminaire whose glow varies lights as the parts would that it could be made of, asked one by
// one; and where few parts of it are bright, its noise is small.
#include "render/render.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

constexpr int screen_size = 24;

/// A screen of 12 x 8 fields, of which three are bright, over a floor.
const std::string screen_room = R"(#version 3.7;
    global_settings { assumed_gamma 1 }
    camera { location <0, 3, -6> look_at <0, 0.5, 0> right x up y angle 50 }
    box { <-5, -0.2, -5>, <5, 0, 5> pigment { rgb 0.8 } finish { ambient 0 diffuse 1 } }
    sphere { <0.6, 0.5, -1>, 0.4 pigment { rgb 0.8 } finish { ambient 0 diffuse 1 } }
    #macro Bright(I, J) ((I = 2 & J = 5) | (I = 9 & J = 1) | (I = 6 & J = 3)) #end
    #declare LightProxy = finish { ambient 0 diffuse 0 emission 20 }
)";
const std::string whole = R"(
    #declare Field = function(x, y) { select(abs(x - 2) + abs(y - 5), 0, 1, 0)
        + select(abs(x - 9) + abs(y - 1), 0, 1, 0) + select(abs(x - 6) + abs(y - 3), 0, 1, 0) }
    box {
        <-1.5, 0.3, 1>, <1.5, 2.3, 1.05>
        pigment {
            function { Field(floor(4*x + 6), floor(4*(y - 0.3))) }
            colour_map { [0 rgb 0.005] [1 rgb 1] }
        }
        finish { LightProxy }
    }
)";
const std::string parts = R"(
    #for (I, 0, 11)
        #for (J, 0, 7)
            box {
                <0.25*I - 1.5, 0.25*J + 0.3, 1>, <0.25*I - 1.25, 0.25*J + 0.55, 1.05>
                pigment { #if (Bright(I, J)) rgb 1 #else rgb 0.005 #end }
                finish { LightProxy }
            }
        #end
    #end
)";

struct Picture {
    double mean = 0, noise = 0;  ///< of a sample, over the mean
};
Picture picture(const std::string& script, const LightSampler& sampler, int samples) {
    const Shot shot(world_of(scene_of(script), sampler));
    RenderSettings settings;
    settings.width = settings.height = screen_size;
    settings.antialias = false;
    settings.samples = samples;
    settings.shadow_rays = 1;
    const Image a = render(shot, settings).image;
    settings.seed = 1;
    const Image b = render(shot, settings).image;
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        // What looks at the luminaires has no noise and says nothing of light on other things.
        const double x = grey(a.pixels[i]), y = grey(b.pixels[i]);
        if (x > 5) continue;
        sum += (x + y) / 2;
        squares += (x - y) * (x - y) / 2;
    }
    const double pixels = screen_size * screen_size, mean = sum / pixels;
    return {mean, std::sqrt(squares / pixels * samples) / mean};
}

}  // namespace

TEST_CASE("a screen lights as its fields would one by one", "[statistics]") {
    const Picture exact = picture(screen_room + parts, EveryLight{}, 2);
    LightOctree alone;
    alone.alone = true;
    for (const LightSampler& sampler :
         {LightSampler(EveryLight{}), LightSampler(LightOctree{}), LightSampler(alone)}) {
        const Picture found = picture(screen_room + whole, sampler, 256);
        CAPTURE(exact.mean, found.mean, exact.noise, found.noise);
        CHECK(found.mean == Approx(exact.mean).epsilon(0.01));
        CHECK(found.noise < 2.5);
    }
}

}  // namespace candelabra
