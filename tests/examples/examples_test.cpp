// SPDX-License-Identifier: GPL-3.0-or-later
// Every example compiles without a word of complaint and renders to a picture that is neither black
// nor full of holes.
#include "render/render.h"
#include "support/scripts.h"
#include "text/message.h"
#include "world/compile.h"
#include "world/emitters.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>

namespace candelabra {

namespace fs = std::filesystem;

TEST_CASE("every example renders", "[examples]") {
    std::size_t count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(CANDELABRA_SOURCE_DIR "/examples")) {
        if (entry.path().extension() != ".pov") continue;
        ++count;
        const std::string path = fs::relative(entry.path(), CANDELABRA_SOURCE_DIR).string();
        INFO(path);
        const Shot shot = shot_of_file(path, {}, {});
        CHECK((shot.world->lights.luminaires.size() + shot.world->lights.sources.size() > 0 ||
               !receives_light(*shot.world)));
        RenderSettings settings;
        settings.width = 32;
        settings.height = 24;
        settings.samples = 1;
        // Where a medium's density varies, what one sample tells of its depth may be below 0: see
        // medium/transmittance.h.
        const bool estimates_depth = shot.world->appearance.any_drawn_media ||
                                     std::ranges::any_of(shot.world->sky.media, &Media::drawn);
        double sum = 0;
        for (const Rgb& pixel : render(shot, settings).image.pixels) {
            REQUIRE(std::isfinite(pixel.r + pixel.g + pixel.b));
            if (!estimates_depth) REQUIRE(min_component(pixel) >= 0);
            sum += grey(pixel);
        }
        CHECK(sum / (32 * 24) > 0.005);
    }
    CHECK(count >= 20);
}

TEST_CASE("pictures are the same by both indexes", "[examples]") {
    for (const char* name : {"gallery/ferris_wheel", "shapes/modelling", "shapes/sheet",
                             "looks/normals", "library/mtmandj", "paper/fig6"}) {
        INFO(name);
        const Scene scene = scene_of_file(message("examples/", name, ".pov"), {});
        const auto picture = [&](const RayIndex& index) {
            Diagnostics diagnostics;
            CompileOptions options;
            options.index = index;
            RenderSettings settings;
            settings.width = 32;
            settings.height = 24;
            settings.samples = 1;
            return render(Shot(compile(scene, options, diagnostics)), settings).image;
        };
        CHECK(picture(KdTree()).pixels == picture(BoundingBoxes()).pixels);
    }
}

TEST_CASE("the paper's flakes have its numbers of spheres and luminaires", "[examples]") {
    const auto luminaires = [](const Declares& declares) {
        return world_of_file("examples/paper/fig6.pov", declares, ConstantAlpha{})
            ->lights.luminaires.size();
    };
    const SharedWorld world = world_of_file("examples/paper/fig6.pov", {}, ConstantAlpha{});
    CHECK(world->geometry.spheres.size() == 2 * 7381);
    CHECK(world->lights.luminaires.size() == 7381);
    CHECK(luminaires({{"Luminaires", 1.0}}) == 1);
    CHECK(luminaires({{"Depth", 5.0}}) == 66430);
}

}  // namespace candelabra
