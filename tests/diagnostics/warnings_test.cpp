// SPDX-License-Identifier: GPL-3.0-or-later
// Each warning that there is a name for: a scene that provokes it, and that the name switches it
// off.
#include "support/shell.h"
#include "text/diagnostic.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <map>

#include <sys/xattr.h>

namespace candelabra {

namespace {

const std::string camera = "camera { location <0, 0, -5> look_at 0 } ";
const std::string light = "light_source { <9, 9, -9>, 1 } ";
const std::string ball = "sphere { 0, 1 } ";
const std::string all = camera + light + ball;

/// A scene for each name, and for some an option.
const std::map<std::string_view, std::vector<std::string>>& careless() {
    static const std::map<std::string_view, std::vector<std::string>> scenes = {
        {"syntax", {all + "#\n;"}},
        {"unknown-name", {all + "#undef Nothing"}},
        {"wrong-type", {all + "#declare A = read_csv(\"mixed.csv\");"}},
        {"wrong-count", {all + "#declare A = rgb <1, 2, 3, 4>;"}},
        {"duplicate", {all + camera}},
        {"semicolon", {all + ";"}},
        {"domain", {all + "#declare A = asin(2);"}},
        {"division-by-zero", {all + "#declare A = 1 / 0;"}},
        {"degenerate", {all + "triangle { 0, x, 2*x }"}},
        {"file-access", {all + "#include \"foreign.inc\" #if (Mine) #end"}},
        {"option", {all, "+L/no/such/folder"}},
        {"deprecated", {all + "max_trace_level 5"}},
        {"unused-parameter", {all + "#macro M(A) 1 #end"}},
        {"no-effect", {all + "union { }"}},
        {"no-camera", {light + ball}},
        {"no-object", {camera + light}},
        {"no-light", {camera + ball}},
        {"camera-inside", {all + "sphere { 0, 9 }"}},
        {"glowing-dome", {all + "sphere { 0, 9 inverse pigment { rgb 1 } finish { emission 1 } }"}},
        {"aspect", {light + ball + "camera { location -5*z right 2*x }"}},
        {"user-warning", {all + "#warning \"mind the step\""}},
    };
    return scenes;
}

bool warned(Shell& shell, const std::vector<std::string>& scene, std::string_view name,
            const std::vector<std::string>& switches) {
    shell.write("careless.pov", "#version 3.7;\n" + scene[0] + "\n");
    std::vector<std::string> arguments = switches;
    arguments.insert(arguments.end(), scene.begin() + 1, scene.end());
    arguments.insert(arguments.end(), {shell.path("careless.pov"), "--check"});
    CHECK(shell(arguments) == 0);
    return shell.err.find("warning[" + std::string(name) + "]") != std::string::npos;
}

}  // namespace

TEST_CASE("each warning has a name, which switches it", "[diagnostics]") {
    Shell shell;
    shell.write("mixed.csv", "x\n1\n2\nn/a\n");
    std::filesystem::create_directories(shell.path("library"));
    shell.write("library/foreign.inc", "#declare Mine = 1;");
    shell.library = shell.path("library");
    shell.write("foreign.inc", "");
    const std::string another = "the mark of another scene";
    REQUIRE(::setxattr(shell.path("foreign.inc").c_str(), "user.candelabra.scene", another.data(),
                       another.size(), 0) == 0);
    for (const FaultInfo& info : all_faults()) {
        if (info.warns_of.empty()) continue;
        INFO(info.name);
        const auto scene = careless().find(info.name);
        REQUIRE(scene != careless().end());
        const std::string name(info.name);
        CHECK(warned(shell, scene->second, name, {}));
        CHECK_FALSE(warned(shell, scene->second, name, {"--warn", "no-" + name}));
        CHECK(warned(shell, scene->second, name, {"--warn", "none," + name}));
    }
}

}  // namespace candelabra
