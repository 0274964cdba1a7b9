// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/mesh_export.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a scene becomes a mesh in a file, which scenes can read") {
    Shell shell;
    shell.write("a.pov",
                "#version 3.7; #declare Cube = box { 0, 1 }\n"
                "difference { box { 0, 2 } box { 1, 3 } } object { Cube translate 5*x }\n");
    CHECK(shell({shell.path("a.pov"), "--export-mesh", shell.path("a.ply"), "-V"}) == 0);
    CHECK(shell.err.empty());
    shell.write("b.pov", "#version 3.7; mesh { file \"a.ply\" }");
    CHECK(shell({shell.path("b.pov"), "--check"}) == 0);
    CHECK(shell({shell.path("a.pov"), "--export-mesh", shell.path("c.ply"), "--export-object",
                 "Cube"}) == 0);
    CHECK(has(shell.content("c.ply"), "element vertex 8\n"));
    CHECK(has(shell.content("c.ply"), "element face 12\n"));
}

TEST_CASE("what has no end is left out of a mesh, and said") {
    Shell shell;
    const auto run = [&](std::vector<std::string> more) {
        more.insert(more.end(),
                    {shell.path("lit.pov"), "--export-mesh", shell.path("a.ply"), "-V"});
        return shell(more);
    };
    CHECK(run({}) == 0);
    CHECK(has(shell.err, "it has no end, or is too thin"));
    CHECK(run({"--export-object", "None"}) == 1);
    CHECK(has(shell.err, "no object is declared as `None`"));
    shell.write("lit.pov", "#version 3.7; plane { y, 0 }");
    CHECK(run({}) == 3);
    CHECK(has(shell.err, "there is no surface to write"));
}

TEST_CASE("the ending of a mesh's file says its format") {
    CHECK(mesh_format("a.ply") == MeshFormat::ply);
    CHECK(mesh_format("a.b/c.OBJ") == MeshFormat::obj);
    for (const char* other : {"a.stl", "a", "", "obj", "a.obj.gz"}) CHECK_FALSE(mesh_format(other));
    Shell shell;
    shell.write("a.pov", "#version 3.7; box { 0, 1 }");
    REQUIRE(shell({shell.path("a.pov"), "--export-mesh", shell.path("a.obj"), "-V"}) == 0);
    CHECK(shell.content("a.obj").starts_with("v "));
    CHECK(has(shell.content("a.obj"), "\nf "));
    shell.write("b.pov", "#version 3.7; mesh { file \"a.obj\" }");
    CHECK(shell({shell.path("b.pov"), "--check"}) == 0);
    CHECK(shell({shell.path("a.pov"), "--export-mesh", shell.path("a.stl")}) == exit_status::usage);
    CHECK(has(shell.err, "a mesh is written as PLY or OBJ"));
    CHECK(shell.content("a.stl").empty());
}

}  // namespace candelabra
