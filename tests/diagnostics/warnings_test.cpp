// SPDX-License-Identifier: GPL-3.0-or-later
// Each warning that there is a name for: a scene that provokes it, and that the name switches it
// off.
#include "console/heard.h"
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
        {"lookalike", {all + "#include \"woods.inc\" #ifdef (T_Wood2) #end"}},
        {"user-warning", {all + "#warning \"mind the step\""}},
    };
    return scenes;
}

/// Runs the scene and returns what front ends hear: the page of the preview, for one.
Heard heard_of(Shell& shell, const std::vector<std::string>& scene,
               const std::vector<std::string>& options) {
    shell.write("careless.pov", "#version 3.7;\n" + scene[0] + "\n");
    std::vector<std::string> arguments = options;
    arguments.insert(arguments.end(), scene.begin() + 1, scene.end());
    arguments.insert(arguments.end(), {shell.path("careless.pov"), "--check"});
    Heard heard;
    shell.heard = [&](Stream stream, std::string_view text) { heard.take(stream, text); };
    CHECK(shell(arguments) == 0);
    shell.heard = {};
    return heard;
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

/// A folder in which all scenes of careless() warn.
struct Workshop : Shell {
    Workshop() {
        write("mixed.csv", "x\n1\n2\nn/a\n");
        std::filesystem::create_directories(path("library"));
        write("library/foreign.inc", "#declare Mine = 1;");
        library = path("library");
        write("library/woods.inc", "// Woods.\n// Only alike to POV-Ray's: T_Wood1 to T_Wood3\n");
        povray_library = path("povray");
        std::filesystem::create_directories(povray_library);
        write("povray/woods.inc", "");
        write("foreign.inc", "");
        const std::string another = "the mark of another scene";
        REQUIRE(::setxattr(path("foreign.inc").c_str(), "user.candelabra.scene", another.data(),
                           another.size(), 0) == 0);
    }
};

}  // namespace

TEST_CASE("each warning has a name, which switches it", "[diagnostics]") {
    Workshop shell;
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

TEST_CASE("each front end hears each warning as the terminal shows it", "[diagnostics]") {
    Workshop shell;
    for (const FaultInfo& info : all_faults()) {
        if (info.warns_of.empty()) continue;
        INFO(info.name);
        const std::vector<std::string>& scene = careless().at(info.name);
        const std::string start = "warning[" + std::string(info.name) + "]";
        const Heard heard = heard_of(shell, scene, {});
        std::string all;
        for (const std::string& each : heard.warnings) all += each;
        CHECK(all.find(start) != std::string::npos);
        CHECK(shell.err.find(all) != std::string::npos);
        // Programs that read messages as JSON do not keep them from other front ends.
        const Heard beside_json = heard_of(shell, scene, {"--diagnostics", "json"});
        CHECK(beside_json.warnings == heard.warnings);
        CHECK(shell.err.find("\"name\":\"" + std::string(info.name) + "\"") != std::string::npos);
    }
}

TEST_CASE("front ends hear what a scene says", "[diagnostics]") {
    Workshop shell;
    const std::vector<std::string> scene = {all + "#debug \"so it is\""};
    for (const char* form : {"text", "json"}) {
        CAPTURE(form);
        CHECK(heard_of(shell, scene, {"--diagnostics", form}).said.starts_with("so it is"));
    }
}

}  // namespace candelabra
