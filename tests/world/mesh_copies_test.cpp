// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/mesh_copies.h"

#include "render/render.h"
#include "support/scripts.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// Eight copies of a wavy sheet of 51,200 faces with two looks; `copy` is the sheet.
std::string sheets(const std::string& copy) {
    return R"(
        #version 3.7;
        global_settings { assumed_gamma 1 }
        camera { location <0, 3, -7> look_at 0 angle 40 }
        light_source { <5, 20, -10>, 1 }
        #declare N = 160;
        #macro Sheet()
            mesh2 {
                vertex_vectors { (N + 1)*(N + 1)
                    #for (I, 0, N) #for (J, 0, N)
                        <I/N - 0.5, 0.1*sin(I*0.2)*cos(J*0.1), J/N - 0.5>
                    #end #end }
                normal_vectors { (N + 1)*(N + 1)
                    #for (I, 0, N) #for (J, 0, N) <sin(I*0.2)/4, 1, sin(J*0.1)/4> #end #end }
                texture_list { 2 texture { pigment { checker rgb 0.9 rgb 0.2 scale 0.1 } }
                                 texture { pigment { rgbf <1, 0.6, 0.2, 0.6> } } }
                face_indices { 2*N*N
                    #for (I, 0, N - 1) #for (J, 0, N - 1)
                        #local A = I*(N + 1) + J;
                        <A, A + 1, A + N + 1>, 0, 0, (mod(I, 20) < 10)
                        <A + 1, A + N + 2, A + N + 1>, (mod(J, 40) < 20)
                    #end #end }
            }
        #end
        #declare Copy = Sheet()
        #for (K, 0, 7)
            object { )" +
           copy + R"( rotate <20*K, 50*K, 0> scale <1, 1, (mod(K, 2) ? 1.4 : -1)>
                     translate <mod(K, 4)*1.2 - 1.8, K/7 - 0.5, (K > 3)>
                     #if (K = 6) no_shadow #end }
        #end
        plane { y, -1 pigment { rgb 0.5 } finish { reflection 0.3 } }
    )";
}

/// Two copies of a globe of 160,000 faces over a floor, both of which glow; `copy` is the globe.
std::string globes(const std::string& copy) {
    return R"(
        #version 3.7;
        global_settings { assumed_gamma 1 }
        camera { location <0, 3, -7> look_at 0 angle 40 }
        #declare N = 400;
        #macro Globe()
            mesh2 {
                vertex_vectors { (N + 1)*(N/2 + 1)
                    #for (I, 0, N/2) #for (J, 0, N)
                        vrotate(vrotate(y, I*360/N*x), J*360/N*y)
                    #end #end }
                face_indices { N*N
                    #for (I, 0, N/2 - 1) #for (J, 0, N - 1)
                        #local A = I*(N + 1) + J;
                        <A, A + 1, A + N + 1>, <A + 1, A + N + 2, A + N + 1>
                    #end #end }
            }
        #end
        #declare Copy = Globe()
        #for (K, 0, 1)
            object { )" +
           copy + R"( pigment { rgb 1 } finish { emission 2 diffuse 0 }
                     scale <0.5, 0.5 + K/4, 0.5> translate <2*K - 1, 0, 0> }
        #end
        plane { y, -1 pigment { rgb 0.5 } finish { diffuse 1 emission 0 } }
    )";
}

}  // namespace

TEST_CASE("the first copies of a mesh are taken apart", "[world]") {
    Mesh small, large;
    small.faces.resize(3);
    large.faces.resize(100);
    MeshCopies copies(10);
    CHECK(copies.takes_apart(large));
    CHECK_FALSE(copies.takes_apart(large));
    for (int i = 0; i < 5; ++i) CHECK(copies.takes_apart(small) == (i < 3));
}

TEST_CASE("copies of a mesh that are whole look as those that are taken apart", "[world]") {
    const Shot copies = shot_of(sheets("Copy")), others = shot_of(sheets("Sheet()"));
    CHECK(copies.world->geometry.shapes.size() == others.world->geometry.shapes.size() + 7);
    CHECK(copies.world->geometry.triangles.size() == others.world->geometry.triangles.size() / 8);
    RenderSettings settings;
    settings.width = 64;
    settings.height = 48;
    settings.antialias = false;
    const Rendering a = render(copies, settings), b = render(others, settings);
    int differing = 0;
    for (std::size_t i = 0; i < a.image.pixels.size(); ++i)
        differing += max_abs_component(a.image.pixels[i] - b.image.pixels[i]) > 1e-6;
    CHECK(differing == 0);
}

TEST_CASE("a whole copy of a mesh is one luminaire, and as bright as its faces are", "[world]") {
    const Shot copies = shot_of(globes("Copy")), others = shot_of(globes("Globe()"));
    CHECK(copies.world->lights.luminaires.size() == others.world->lights.luminaires.size() / 2 + 1);
    RenderSettings settings;
    settings.width = 32;
    settings.height = 24;
    settings.samples = 16;
    const Rendering a = render(copies, settings), b = render(others, settings);
    Rgb sum_a(0), sum_b(0);
    for (std::size_t i = 0; i < a.image.pixels.size(); ++i) {
        sum_a += a.image.pixels[i];
        sum_b += b.image.pixels[i];
    }
    CHECK(sum_a.r == Approx(sum_b.r).epsilon(0.01));
}

}  // namespace candelabra
