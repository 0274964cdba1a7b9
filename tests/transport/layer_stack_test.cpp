// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/layer_stack.h"

#include "scattering/microfacet.h"
#include "support/rgb.h"
#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("layers are seen through those above them", "[transport]") {
    const SharedWorld world = world_of(R"(sphere { 0, 1
        texture { pigment { rgb 0.5 } finish { reflection 0.3 } }
        texture { pigment { rgbt <1, 0, 0, 0.5> } }
        texture { pigment { rgbf <0.5, 1, 1, 0.8> } } })");
    PathState path;
    path.ray = {Vec3(0, 0, -3), Vec3(0, 0, 1)};
    Hit hit;
    REQUIRE(world->first_hit(path.ray, 0, RayKind::camera, hit));
    const Vertex vertex = vertex_at(*world, path.ray, hit);
    std::vector<Rgb> through, reflected;
    for (const auto& [weight, layers] : visible_textures(*world, vertex)) {
        const LayerStack stack(*world, path, vertex, layers);
        CHECK_FALSE(stack.is_clear());  // the lowest layer is opaque
        stack.visit([&](const LayerStack::Seen& seen) {
            through.push_back(seen.through);
            reflected.push_back(seen.reflected);
        });
    }
    REQUIRE(through.size() == 3);
    CHECK(through[0] == Rgb(1));
    CHECK(length(through[1] - Rgb(0.4, 0.8, 0.8)) < 1e-6);
    CHECK(length(through[2] - Rgb(0.2, 0.4, 0.4)) < 1e-6);
    CHECK(reflected[0] == Rgb(0));
    CHECK(reflected[2] == Rgb(0.3));
}

namespace {

/// Sum of the fractions of all ways on which light comes to the viewer from a vertex: by mirrors,
/// by facets, by what is below them, and from behind.
Rgb sum_of_ways(const World& world, const PathState& path) {
    Hit hit;
    REQUIRE(world.first_hit(path.ray, 0, RayKind::camera, hit));
    const Vertex vertex = vertex_at(world, path.ray, hit, {path.media.data(), path.media.size()});
    Rgb sum(0);
    for (const auto& [weight, layers] : visible_textures(world, vertex)) {
        const LayerStack stack(world, path, vertex, layers);
        stack.visit([&](const LayerStack::Seen& seen) {
            const Shading s = seen.scattering();
            const Finish& f = *s.finish;
            Rgb scattered = s.colour.rgb * s.opacity * (f.diffuse + f.diffuse_back);
            if (f.microfacet.on)
                scattered = Microfacets(s).facets_albedo() +
                            s.colour.rgb * s.opacity * Microfacets(s).base_albedo();
            sum += seen.reflected + seen.through * seen.below_mirror * scattered;
        });
        sum += stack.behind();
    }
    return sum;
}

}  // namespace

TEST_CASE("all ways from a vertex together have no more than all light", "[transport]") {
    const std::string glossy = " reflection { 0, 1 fresnel } conserve_energy ";
    std::vector<std::string> finishes = {"diffuse 1", "diffuse 0.6, 0.4",
                                         "diffuse 1 reflection 0.4 conserve_energy",
                                         "diffuse 0.7" + glossy};
    for (const char* const facets :
         {"roughness 0.05", "roughness 0.3", "roughness 0.6 specular 1", "roughness 0.3 coat 1",
          "roughness 0.3 metallic 0.5", "roughness 0.2 metallic 1",
          "roughness 0.6 metallic 0.3 coat 0.5 coat_roughness 0.4"})
        for (const std::string& more : {std::string(), glossy})
            finishes.push_back("microfacet { " + std::string(facets) + " }" + more);
    for (const std::string& finish : finishes)
        for (const char* const colour : {"rgb 1", "rgbt <1, 1, 1, 0.3>", "rgbt <1, 1, 1, 0.9>",
                                         "rgbf <0.9, 1, 0.8, 0.7>", "rgbft <1, 0.5, 1, 0.3, 0.6>"})
            for (const bool twice : {false, true})
                for (const char* const ior : {"1", "1.05", "1.5", "2", "0.7"}) {
                    const std::string texture = "texture { pigment { " + std::string(colour) +
                                                " } finish { ambient 0 " + finish + " } } ";
                    const SharedWorld world = world_of(
                        "#version 3.7; global_settings { max_trace_level 20 adc_bailout 0 "
                        "integrator { path_traced } } sphere { 0, 1 " +
                        texture + (twice ? texture : "") + "interior { ior " + ior + " } }");
                    const bool white =
                        colour == std::string("rgb 1") || std::string(colour).starts_with("rgbt");
                    CAPTURE(finish, colour, ior, twice);
                    for (const double aside : {0.0, 0.5, 0.9, 0.99}) {
                        PathState path;
                        path.ray = {Vec3(aside, 0, -3), Vec3(0, 0, 1)};
                        const Rgb outside = sum_of_ways(*world, path);
                        path.ray = {Vec3(0, 0, -aside), Vec3(1, 0, 0)};
                        path.media.push_back(0);
                        const Rgb inside = sum_of_ways(*world, path);
                        CAPTURE(aside, outside.r, inside.r);
                        CHECK(max_component(outside) <= 1 + 1e-9);
                        CHECK(max_component(inside) <= 1 + 1e-9);
                        if (!white || !finish.starts_with("microfacet")) continue;
                        CHECK(min_component(outside) >= 1 - 1e-3);
                        CHECK(min_component(inside) >= 1 - 1e-3);
                    }
                }
}

}  // namespace candelabra
