// SPDX-License-Identifier: GPL-3.0-or-later
// tests/conformance/programs has scenes of programs that call POV-Ray.
#include "app/povray_command.h"

#include "app/sandbox.h"
#include "support/shell.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <set>

namespace candelabra {

namespace {

constexpr auto drawn = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -3> look_at 0 }
background { rgb <0, 0, 0.4> }
sphere { 0, 1 pigment { rgb <1, 0.5, 0.2> } finish { ambient 0 diffuse 0 emission 0.8 } }
)";

struct Calling : Shell {
    Calling() { write("drawn.pov", drawn); }
    int call(std::vector<std::string> words) {
        words.insert(words.begin(), "povray");
        return (*this)(words);
    }
    /// The size that a PNG file states.
    std::pair<int, int> size(const std::string& name) const {
        const std::string bytes = content(name);
        const auto number = [&](std::size_t at) {
            int value = 0;
            for (std::size_t i = at; i < at + 4 && i < bytes.size(); ++i)
                value = value * 256 + static_cast<unsigned char>(bytes[i]);
            return value;
        };
        return {number(16), number(20)};
    }
};

}  // namespace

TEST_CASE("the name of the program says that it stands in for POV-Ray's") {
    for (const char* name : {"candelabra-povray", "/usr/bin/candelabra-povray", "../bin/povray"})
        CHECK(command_named(name) == "povray");
    for (const char* name : {"candelabra", "/opt/povray/candelabra", "povray3", ""})
        CHECK(command_named(name).empty());
}

TEST_CASE("programs that ask for POV-Ray's version find one, on the stream that POV-Ray uses") {
    Calling shell;
    for (const char* word : {"--version", "-version"}) {
        CHECK(shell.call({word}) == exit_status::done);
        CHECK(shell.err.starts_with("POV-Ray 3.7 scenes are rendered by Candelabra "));
        CHECK(shell.out.empty());
    }
}

TEST_CASE("arguments of programs that call POV-Ray are taken as POV-Ray takes them") {
    struct Call {
        std::vector<std::string> words;
        std::string made;
        std::pair<int, int> size;
    };
    Calling shell;
    const std::string scene = shell.path("drawn.pov");
    shell.write("run.ini",
                "Input_File_Name=drawn.pov\nOutput_To_File=True\nOutput_File_Type=N\n"
                "Output_File_Name=by_ini.png\nWidth=40\nHeight=30\nAntialias=True\n"
                "Antialias_Threshold=0.1\nDisplay=False\nPause_When_Done=True\n"
                "Verbose=False\nWarning_Console=false\n");
    const std::string out = shell.path("made.png");
    const std::vector<Call> calls = {
        // LeoCAD quotes the name of the scene, and wants the picture in a pipe by -O-.
        {{"+I\"" + scene + "\"", "+W40", "+H30", "+O\"" + out + "\"", "+Q11", "+R3", "+A0.1",
          "+J0.5", "+FN", "-D"},
         "made.png",
         {40, 30}},
        // VMD, with its dashes.
        {{"+W40", "+H30", "-I" + scene, "-O" + out, "+D", "+X", "+A", "+FN"}, "made.png", {40, 30}},
        // OVITO.
        {{"+W40", "+H30", "Pause_When_Done=off", "Output_to_File=on", "-V", "Output_File_Type=N",
          "Output_File_Name=" + out, "Input_File_Name=" + scene, "Output_Alpha=on", "Display=off"},
         "made.png",
         {40, 30}},
        // Programs that call the one for Windows.
        {{"/RENDER", scene, "+W40", "+H30", "+O" + out, "-D", "-V", "+A", "/EXIT"},
         "made.png",
         {40, 30}},
        // As few as possible: the name without its ending, and the usual size.
        {{"+I" + shell.path("drawn"), "+O" + out, "+P"}, "made.png", {800, 600}},
    };
    for (const Call& call : calls) {
        CAPTURE(call.words);
        std::filesystem::remove(shell.path(call.made));
        CHECK(shell.call(call.words) == exit_status::done);
        CHECK(shell.err.find("error") == std::string::npos);
        CHECK(shell.err.find("warning") == std::string::npos);
        CHECK(shell.size(call.made) == call.size);
    }
}

TEST_CASE("nothing that glows lights the others, as in POV-Ray, unless it is asked for") {
    Calling shell;  // lit.pov has no light but a glowing ball
    const auto floor = [&](std::vector<std::string> words) {
        const std::string made = shell.path("floor.ppm");
        words.insert(words.begin(), {shell.path("lit.pov"), "+W4", "+H4", "+FP", "+O" + made});
        REQUIRE(shell.call(words) == exit_status::done);
        const std::string bytes = shell.content("floor.ppm");
        return static_cast<unsigned char>(bytes[bytes.size() - 3]);  // red of the last pixel
    };
    CHECK(floor({}) == 0);
    CHECK(floor({"--luminaires", "0"}) > 50);
}

TEST_CASE("antialiasing is off unless it is asked for") {
    Calling shell;
    const auto colours = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {shell.path("drawn.pov"), "+W40", "+H30", "+FP",
                                     "+O" + shell.path("edges.ppm")});
        REQUIRE(shell.call(words) == exit_status::done);
        const std::string bytes = shell.content("edges.ppm");
        std::vector<std::string> found;
        for (std::size_t i = bytes.size() - 3 * 40 * 30; i < bytes.size(); i += 3)
            found.push_back(bytes.substr(i, 3));
        return std::set(found.begin(), found.end()).size();
    };
    CHECK(colours({}) == 2);
    CHECK(colours({"+A0.1"}) > 5);
}

TEST_CASE("what a format cannot hold is left out with a word, as POV-Ray leaves it out silently") {
    Calling shell;
    const std::string scene = shell.path("drawn.pov"), made = shell.path("plain");
    for (const auto& [options, said] :
         std::vector<std::pair<std::vector<std::string>, std::string>>{
             {{"+FP", "+UA"}, "the alpha channel is left out: files of format ppm"},
             {{"+FJ", "+UA"}, "the alpha channel is left out: files of format jpg"},
             {{"+FJ", "Bits_Per_Color=16"}, "16 bits a channel are left out"},
             {{"+FB", "Grayscale_Output=on"}, "grey alone is left out"}}) {
        std::vector<std::string> words = {scene, "+W8", "+H6", "+O" + made};
        words.insert(words.end(), options.begin(), options.end());
        CHECK(shell.call(words) == exit_status::done);
        CHECK(has(shell.err, said));
    }
}

TEST_CASE("programs read the progress in POV-Ray's words") {
    Calling shell;
    const std::string scene = shell.path("drawn.pov");
    REQUIRE(shell.call({scene, "+W40", "+H30", "+KFF2", "+O" + shell.path("f.png")}) ==
            exit_status::done);
    CHECK(has(shell.err, "Rendering frame 1 of 2 (#1)\n"));
    CHECK(has(shell.err, "Rendered 1200 of 1200 pixels (100%)\n"));
    REQUIRE(shell.call({scene, "+W40", "+H30", "-V", "+O" + shell.path("f.png")}) ==
            exit_status::done);
    CHECK(shell.err.empty());
}

TEST_CASE("POV-Ray's own include files come first where they are installed") {
    Calling shell;
    std::filesystem::create_directory(shell.path("include"));
    shell.write("include/stones1.inc", "#declare T_Stone1 = texture { pigment { rgb 1 } }\n");
    shell.write("stone.pov",
                "#version 3.7;\n#include \"stones1.inc\"\ncamera { location -3*z }\n"
                "light_source { -9*z, rgb 1 }\nsphere { 0, 1 texture { T_Stone1 } }\n");
    shell.povray_library = shell.path("include");
    CHECK(shell.call({shell.path("stone.pov"), "+W8", "+H6", "-F"}) == exit_status::done);
    CHECK(shell.err.find("warning") == std::string::npos);
}

TEST_CASE("the command has help, and an error ends it as one") {
    Calling shell;
    CHECK(shell.call({"--help"}) == exit_status::done);
    CHECK(has(shell.out, "usage: candelabra-povray"));
    CHECK(shell.call({shell.path("none.pov"), "+W8", "+H6"}) != exit_status::done);
    CHECK(has(shell.err, "none.pov"));
    CHECK(shell.call({shell.path("drawn.pov"), "+WHAT"}) == exit_status::usage);
}

}  // namespace candelabra
