// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/quality.h"

#include "support/scripts.h"

#include "render/render.h"
#include "support/rgb.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("at full quality textures stay what they are", "[surface]") {
    const auto texture = make_handle<Texture>();
    CHECK(simplified(texture, quality_full) == texture);
    CHECK(simplified(texture, quality_reflection) == texture);
}

TEST_CASE("qualities show what POV-Ray 3.7 shows", "[surface]") {
    const Scene scene = scene_of(R"(
        #version 3.7; global_settings { assumed_gamma 1 }
        camera { orthographic location <0, 0, -5> right .0001*x up .0001*y direction z }
        background { rgb .5 }
        light_source { <3, 4, -5> rgb 1 area_light x, y, 3, 3 }
        plane {
            -z, 0
            pigment { rgb <.8, .5, .2> quick_color rgb <.1, .9, .3> }
            finish { ambient .1 diffuse .6 reflection .3 }
        }
        box { <.5, .5, -2>, <9, 9, -1> pigment { rgb 0 } }
    )");
    struct Case {
        int quality;
        Rgb seen;
    };
    const Case cases[] = {{0, Rgb(.1, .9, .3)},    {1, Rgb(.1, .9, .3)},    {4, Rgb(.01, .09, .03)},
                          {5, Rgb(.01, .09, .03)}, {6, Rgb(.08, .05, .02)}, {7, Rgb(.08, .05, .02)},
                          {8, Rgb(.23, .20, .17)}, {11, Rgb(.23, .20, .17)}};
    for (const Case& c : cases) {
        CAPTURE(c.quality);
        Diagnostics diagnostics;
        CompileOptions options;
        options.quality = c.quality;
        RenderSettings settings;
        settings.width = settings.height = 1;
        settings.antialias = false;
        const Rgb seen =
            render(Shot(compile(scene, options, diagnostics)), settings).image.at(0, 0);
        CHECK(length(seen - c.seen) < 1e-9);
    }
}

}  // namespace candelabra
