// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/scene_steps.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace fs = std::filesystem;

TEST_CASE("errors in the scene are shown with their place, and nothing is rendered") {
    Shell shell;
    shell.write("wrong.pov", "sphere { 0, 1 }\nshpere { 0, 1 }\n");
    for (const char* task : {"--check", "-V", "--dump=scene", "--dump=world"}) {
        CAPTURE(task);
        CHECK(shell({shell.path("wrong.pov"), task, "+O" + shell.path("wrong.png")}) == 1);
        CHECK(has(shell.err, "wrong.pov:2:1"));
        CHECK(has(shell.err, "`sphere`"));
        CHECK(shell.out.empty());
    }
    CHECK_FALSE(fs::exists(shell.path("wrong.png")));
}

TEST_CASE("files that cannot be read or written are told of before any work") {
    Shell shell;
    CHECK(shell({shell.path("missing.pov")}) == 3);
    CHECK(has(shell.err, "missing.pov"));
    CHECK(shell({shell.path("LIT.pov")}) == 3);
    CHECK(has(shell.err, "did you mean `" + shell.path("lit.pov") + "`?"));
    CHECK(shell({shell.folder.string()}) == 3);
    CHECK(shell.render({"+O" + shell.path("no/such/x.png")}) == 3);
    CHECK(has(shell.err, "there is no folder"));
    CHECK_FALSE(has(shell.err, "state"));  // which would lie beside the picture
    CHECK_FALSE(has(shell.err, "16 x 12"));
    CHECK(shell.render({"-F", "--stats", shell.path("no/such/x.json")}) == 3);
    CHECK(shell.render({"-F", "--stats", shell.path("lit.pov")}) == 3);
    CHECK(has(shell.err, "is the scene itself"));
    CHECK(shell.content("lit.pov") == lit_scene);
}

TEST_CASE("scenes have awkward names, or no ending") {
    Shell shell;
    for (const std::string name :
         {"with space.pov", "a=b.pov", "-dash.pov", "a%s%%.pov", "bücher.pov"}) {
        CAPTURE(name);
        shell.write(name, lit_scene);
        CHECK(shell({"-V", "+W4", "+H3", "--samples", "1", "+O" + shell.folder.string(), "--",
                     shell.path(name)}) == 0);
        CHECK(fs::exists(shell.path(name.substr(0, name.size() - 4) + ".png")));
    }
    CHECK(shell({shell.path("lit"), "--check"}) == 0);
}

TEST_CASE("included files are found beside the scene, in +L and in the standard library") {
    Shell shell;
    fs::create_directories(shell.folder / "extra");
    fs::create_directories(shell.folder / "library");
    shell.write("beside.inc", "#declare A = 1;\n");
    shell.write("extra/other.inc", "#declare B = 2;\n");
    shell.write("library/standard.inc", "#declare C = 3;\n");
    shell.write("user.pov",
                "#include \"beside.inc\"\n#include \"other.inc\"\n#include "
                "\"standard.inc\"\nsphere { A, B + C }\n");
    shell.library = shell.path("library");
    CHECK(shell({shell.path("user.pov"), "+L" + shell.path("extra/"), "--dump", "scene"}) == 0);
    CHECK(has(shell.out, "sphere { 1, 5 "));
    // Other folders of include files are fallbacks; files beside the scene take precedence.
    shell.write("extra/standard.inc", "#declare C = 4;\n");
    CHECK(shell({shell.path("user.pov"), "+L" + shell.path("extra/"), "--dump", "scene"}) == 0);
    CHECK(has(shell.out, "sphere { 1, 5 "));
    CHECK(shell({shell.path("user.pov"), "--library", shell.path("extra"), "--dump", "scene"}) ==
          0);
    CHECK(has(shell.out, "sphere { 1, 6 "));
    shell.write("standard.inc", "#declare C = 4;\n");
    CHECK(shell({shell.path("user.pov"), "+L" + shell.path("extra/"), "--dump", "scene"}) == 0);
    CHECK(has(shell.out, "sphere { 1, 6 "));
    CHECK(shell({shell.path("user.pov"), "--check"}) == 1);
    CHECK(has(shell.err, "other.inc"));
    CHECK(shell({shell.path("lit.pov"), "+L" + shell.path("nowhere"), "--check"}) == 0);
    CHECK(has(shell.err, "there is no folder"));
}

}  // namespace candelabra
