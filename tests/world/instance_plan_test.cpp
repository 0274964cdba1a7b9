// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/instance_plan.h"

#include "support/draw.h"
#include "support/twins.h"
#include "world/prototype.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <span>
#include <string>
#include <vector>

namespace candelabra {

namespace {

const std::string house = R"(
    #declare House = union {
        sphere { 0, 0.3 pigment { rgb <1, 0.5, 0.2> } }
        sphere { <0.5, 0.2, 0>, 0.2 }
        box { <-0.2, -0.5, -0.2>, <0.2, 0, 0.2> pigment { rgb 0.5 } }
        torus { 0.5, 0.05 rotate 40*z pigment { rgb <0, 1, 0> } }
        difference { sphere { 0.4*y, 0.3 } box { 0, 1 } pigment { rgb 0.1 } }
        mesh { smooth_triangle { -x, <-0.3, 0.2, 1>, y, <0, 0.1, 1>, 1.5*y, <0.2, 0.3, 1> } }
        mesh { triangle { -0.7*x, 0.7*z, 0.5*y } triangle { -0.7*x, 0.7*z, -0.5*y } }
        PART
        pigment { rgb 0.8 }
    }
)";
std::string house_with(const std::string& part) {
    return std::string(house).replace(house.find("PART"), 4, part);
}

/// Places that turn, mirror, stretch and shear.
const std::string places = R"(
    #for (I, 0, 5)
        object { House rotate <20*I, 35*I, 0> scale <1, 1 + 0.2*I, pow(-1, I)> translate <3*I, 0, 0> }
        object { House matrix <1, 0.3*I, 0, 0.1, 1, 0, 0, -0.2*I, 0.7, 3*I, 3, 0.5> }
    #end
    plane { y, -2 pigment { rgb 1 } }
)";

Ray ray_through_scene(Draw& draw) {
    const Vec3 from(draw.between(-2, 18), draw.between(-3, 5), -6),
        to(draw.between(-1, 17), draw.between(-2, 4), draw.between(-1, 1));
    return {from, unit(to - from)};
}

/// The layers of all textures where a ray has met a surface.
std::vector<Layer> layers_at(const World& world, const Hit& hit, const Ray& ray) {
    const bool behind = dot(hit.smooth_normal, ray.direction) > 0;
    const SurfaceView view{hit.position, behind ? -hit.smooth_normal : hit.smooth_normal,
                           ray.direction};
    PatternScene scene = world.pattern_scene(hit.primitive, hit.part, hit.position);
    scene.view = &view;
    std::vector<Layer> found;
    world.for_textures(hit.primitive, hit.part, hit.position, hit.side_towards(ray.direction),
                       [&](double, const Texture& texture, const Transform* place) {
                           for_layers(
                               texture, hit.position, view.normal, scene,
                               [&](double, std::span<const Layer> layers) {
                                   found.insert(found.end(), layers.begin(), layers.end());
                               },
                               place);
                       });
    return found;
}

/// Number of instances that a script makes of its houses.
std::size_t instances(const std::string& script) {
    return twins_of(script).shared->geometry.instances.size();
}

}  // namespace

TEST_CASE("rays meet instances where they meet what is taken apart", "[instances]") {
    const Twins twins = twins_of(house_with("") + places);
    const Geometry& geometry = twins.shared->geometry;
    REQUIRE(geometry.instances.size() == 12);
    REQUIRE(geometry.prototypes.size() == 1);
    REQUIRE(twins.apart->geometry.instances.empty());
    CHECK(geometry.primitive_count() == twins.apart->geometry.primitive_count());
    CHECK(twins.shared->provenance.object_count == twins.apart->provenance.object_count);
    Draw draw(1);
    const auto next_ray = [&] { return ray_through_scene(draw); };
    const auto same_surface = [&](const Ray& ray, const Hit& one, const Hit& other) {
        CHECK(std::abs(dot(one.normal, other.normal)) > 1 - 1e-9);
        CHECK(std::abs(dot(one.smooth_normal, other.smooth_normal)) > 1 - 1e-9);
        CHECK(twins.shared->material(one.primitive).texture->pigment.colour.rgb ==
              twins.apart->material(other.primitive).texture->pigment.colour.rgb);
        // A ray that leaves the surface does not meet it again at once.
        const Ray on{one.position, unit(ray.direction + 1.5 * Vec3(0.1, 0.7, -0.4))};
        Hit next, next_apart;
        const bool more = twins.shared->first_hit(on, one.tolerance, RayKind::reflected, next);
        REQUIRE(more == twins.apart->first_hit(on, one.tolerance, RayKind::reflected, next_apart));
        if (more) CHECK(length(next.position - next_apart.position) < 1e-8);
        const Ray shadow{ray.origin, ray.direction};
        for (const double share : {0.5, 0.999, 1.5}) {
            const double distance = share * length(one.position - ray.origin);
            CHECK(twins.shared->transmittance(shadow, 1e-9, distance) ==
                  twins.apart->transmittance(shadow, 1e-9, distance));
        }
    };
    CHECK(met_alike(twins, next_ray, same_surface) > 500);
}

TEST_CASE("each instance has its own numbers", "[instances]") {
    const Twins twins = twins_of(house_with("") + places);
    const Geometry& geometry = twins.shared->geometry;
    PrimitiveIndex next = geometry.instanced_begin();
    for (std::size_t i = 0; i < geometry.instances.size(); ++i) {
        const Instance& placed = geometry.instances[i];
        CHECK(placed.first == next);
        next += static_cast<PrimitiveIndex>(geometry.prototype_of(placed).primitive_count());
        for (PrimitiveIndex primitive = placed.first; primitive < next; ++primitive) {
            CHECK(&geometry.instance_of(primitive) == &placed);
            CHECK(geometry.item_of(primitive) == geometry.instances_begin() + i);
            CHECK_FALSE(geometry.is_leaf(primitive));
        }
    }
    CHECK(next == geometry.primitive_count());
}

TEST_CASE("the inside of an instance's solids is known where fog is kept out", "[instances]") {
    const Twins twins = twins_of(house_with("") + places + "fog { distance 5 rgb 0.5 }");
    REQUIRE(twins.shared->geometry.instances.size() == 12);
    int inside = 0;
    Draw draw(2);
    for (int i = 0; i < 20000; ++i) {
        const Ray ray = ray_through_scene(draw);
        const Vec3 point = ray.at(draw.between(2, 10));
        const EnteredSolids one = twins.shared->containing(point),
                            other = twins.apart->containing(point);
        REQUIRE(one.size() == other.size());
        for (const PrimitiveIndex primitive : one) {
            CHECK(twins.shared->contains_point(primitive, point));
            inside += twins.shared->geometry.is_instanced(primitive) ? 1 : 0;
        }
    }
    CHECK(inside > 20);
}

TEST_CASE("unions whose look depends on their place are taken apart", "[instances]") {
    CHECK(instances(house_with("") + places) == 12);
    for (const char* part : {
             "sphere { 0, 1 uv_mapping pigment { rgb 1 } normal { gradient x } }",
             "sphere { 0, 0.1 pigment { gradient x } finish { emission 5 } }",
             "triangle { 0, x, y pigment { rgbt 0.5 } }",
             "union { sphere { 0, 1 } sphere { x, 1 } pigment { rgbt 0.5 } interior { ior 1.5 } }",
             "sphere { 0, 1 pigment { rgbt 0.5 } finish { emission 1 } }",
             "sphere { 0, 1 hollow pigment { rgbt 1 } interior { media { emission 1 } } }",
             "sphere { 0, 1 clipped_by { plane { y, 0 } } }",
             "plane { y, -5 }",
             "smooth_triangle { -x, <-0.3, 0.2, 1>, y, <0, 0.1, 1>, 1.5*y, <0.2, 0.3, 1> }",
             "light_source { 2*y, rgb 1 }",
             "light_group { light_source { 2*y, rgb 1 } sphere { 0, 1 } }",
             "sphere { 0, 1 pigment { rgb 1 } finish { subsurface { translucency 0.1 } } }",
         }) {
        INFO(part);
        CHECK(instances(house_with(part) + places) == 0);
    }
    for (const char* around :
         {"no_shadow", "hollow", "pigment { checker rgb 1 rgb 0 }", "interior { ior 1.3 }",
          "clipped_by { plane { y, 1 } }", "photons { target }"}) {
        INFO(around);
        CHECK(instances(house_with("") + "union { " + places + around + " }") == 0);
    }
    CHECK(instances(house_with("") + "camera { shutter 1 } " + places) == 0);
    CHECK(instances(house_with("") + "global_settings { photons { count 100 } } " + places) == 0);
}

TEST_CASE("patterns and bumps move with instances", "[instances]") {
    const std::string textured = GENERATE(values<std::string>({
        "pigment { wood turbulence 0.1 scale 0.1 rotate 30*x }",
        "pigment { granite scale 0.4 } normal { bumps 1 scale 0.1 }",
        "pigment { gradient x pigment_map { [0 checker scale 0.2] [1 rgb 1] } scale 0.3 }",
        "pigment { rgb 1 } normal { wrinkles 0.5 scale <0.1, 0.3, 0.1> no_bump_scale }",
        "pigment { slope y } normal { bumps 0.7 scale 0.2 }",
        "pigment { aoi } normal { gradient x normal_map { [0 bumps 1] [1 dents 1] } rotate 20*z }",
        "uv_mapping pigment { checker scale 0.05 }",
        "texture { uv_mapping pigment { checker scale 0.05 } normal { gradient x 1 scale 0.1 } }",
        "texture { gradient y texture_map { [0 pigment { slope x } normal { dents 1 scale 0.1 }] "
        "[1 pigment { wood } normal { bumps 1 scale 0.2 }] } scale 0.3 rotate 10*x }",
        "texture { pigment { rgb 1 } } texture { pigment { checker rgb 0 rgbt 1 scale 0.2 } normal "
        "{ ripples 1 scale 0.1 } }",
        "no_luminaire pigment { gradient y scale 0.3 } finish { emission 1 }",
    }));
    const Twins twins =
        twins_of(house_with("torus { 0.3, 0.2 rotate 20*x " + textured + " }") + places);
    REQUIRE(twins.shared->geometry.instances.size() == 12);
    Draw draw(3);
    int textures = 0;
    for (int i = 0; i < 2000; ++i) {
        const Ray ray = ray_through_scene(draw);
        Hit one, other;
        if (!twins.shared->first_hit(ray, 0, RayKind::camera, one)) continue;
        REQUIRE(twins.apart->first_hit(ray, 0, RayKind::camera, other));
        const std::vector<Layer> here = layers_at(*twins.shared, one, ray),
                                 there = layers_at(*twins.apart, other, ray);
        REQUIRE(here.size() == there.size());
        for (std::size_t k = 0; k < here.size(); ++k) {
            CHECK(max_abs_component(here[k].colour.rgb - there[k].colour.rgb) < 1e-4);
            CHECK(length(here[k].normal - there[k].normal) < 1e-4);
        }
        const Side side = one.side_towards(ray.direction);
        CHECK(max_abs_component(twins.shared->emission(one.primitive, one.position, side) -
                                twins.apart->emission(other.primitive, other.position, side)) <
              1e-4);
        textures += twins.shared->material(one.primitive).texture->plain() ? 0 : 1;
    }
    CHECK(textures > 50);
}

TEST_CASE("light passes instances of clear surfaces as it passes what is taken apart",
          "[instances]") {
    const std::string clear = GENERATE(values<std::string>({
        "sphere { 0.3*y, 0.6 pigment { rgbt <0.9, 0.5, 0.7, 0.9> } interior { ior 1.5 } }",
        "torus { 0.5, 0.3 pigment { checker rgbf <1, 0.8, 0.5, 0.9> rgb 0 scale 0.2 } }",
        "difference { box { -0.7, 0.7 } sphere { 0, 0.6 } pigment { rgbf 0.9 } interior { ior 1.3 "
        "fade_distance 1 fade_power 1 fade_color rgb <0.8, 0.5, 0.3> } }",
        "mesh { triangle { -x, x, y } triangle { -x, x, z } triangle { -x, y, z } triangle { x, y, "
        "z } pigment { rgbt <1, 1, 0.5, 0.8> } interior { ior 1.4 } }",
        "mesh { smooth_triangle { -x, <-0.3, 0.2, 1>, y, <0, 0.1, 1>, 1.5*x, <0.2, 0.3, 1> } "
        "pigment { rgbt 0.5 } }",
        "sphere { 0, 0.7 pigment { rgbt <0.9, 0.8, 0.7, 0.9> } interior { ior 1.5 caustics 1 } "
        "normal { bumps 0.3 scale 0.2 } }",
        "box { -0.5, 0.5 no_shadow pigment { rgbt 0.5 } } sphere { y, 0.4 pigment { rgbf 0.7 } }",
        "cylinder { -0.4*z, 0.5*z, 0.6 open pigment { gradient x color_map { [0 rgbt 1] [1 rgb 0] "
        "} scale 0.3 } }",
    }));
    INFO(clear);
    const Twins twins =
        twins_of(house_with("union { " + clear + " translate <0.031, 0.073, 0.057> }") + places +
                 "sphere { 4*x, 2 pigment { rgbt 0.9 } }");
    REQUIRE(twins.shared->geometry.instances.size() == 12);
    Draw draw(4);
    int dimmed = 0, inside = 0;
    for (int i = 0; i < 3000; ++i) {
        const Ray ray = ray_through_scene(draw);
        const double distance = draw.between(4, 14);
        const EnteredSolids around = twins.shared->containing(ray.origin);
        const Rgb here = twins.shared->transmittance(ray, 1e-9, distance, {around.data(), 0}),
                  there = twins.apart->transmittance(ray, 1e-9, distance);
        CHECK(max_abs_component(here - there) < 1e-6);
        dimmed += here != Rgb(0) && here != Rgb(1) ? 1 : 0;
        // The solids that the ray enters on its way are told apart.
        const auto solids = [&](const World& world) {
            EnteredSolids entered;
            std::vector<std::size_t> counts;
            world.along(ray, 0, RayKind::camera, [&](const Hit& hit, double) {
                world.pass(hit.primitive, entered);
                counts.push_back(entered.size());
                return true;
            });
            return counts;
        };
        CHECK(solids(*twins.shared) == solids(*twins.apart));
        const Vec3 point = ray.at(draw.between(2, 10));
        const std::size_t count = twins.shared->containing(point).size();
        CHECK(count == twins.apart->containing(point).size());
        inside += static_cast<int>(count);
    }
    CHECK(dimmed > 50);
    CHECK(inside > 50);
}

TEST_CASE("unions of few parts, of very many, and in few places are taken apart", "[instances]") {
    const Scene scene = scene_of(house_with("") + places);
    const Object& house_object = *std::get<Union>(scene.objects.front()->form).children.front();
    const std::size_t parts = house_object.parts;
    CHECK(InstancePlan(scene, {parts, parts, 12 * parts}).shares(house_object));
    CHECK_FALSE(InstancePlan(scene, {parts + 1, parts, 12 * parts}).shares(house_object));
    CHECK_FALSE(InstancePlan(scene, {parts, parts - 1, 12 * parts}).shares(house_object));
    CHECK_FALSE(InstancePlan(scene, {parts, parts, 12 * parts + 1}).shares(house_object));
    CHECK_FALSE(InstancePlan(scene, {}).shares(house_object));
}

TEST_CASE("the largest union that is shared is stored once, with those in it", "[instances]") {
    const std::string block = house_with("") + R"(
        #declare Block = union { #for (I, 0, 3) object { House translate 2*I*z } #end }
        #for (I, 0, 9) object { Block translate 3*I*x } #end
        object { House translate -5*x }
    )";
    const Twins twins = twins_of(block);
    CHECK(twins.shared->geometry.instances.size() == 11);
    CHECK(twins.shared->geometry.prototypes.size() == 2);
    CHECK(twins.shared->geometry.primitive_count() == twins.apart->geometry.primitive_count());
    // Where the block is too large, its houses are.
    const SharedWorld houses = world_with(block, {2, 20, 2});
    CHECK(houses->geometry.instances.size() == 41);
    CHECK(houses->geometry.prototypes.size() == 1);
}

}  // namespace candelabra
