// SPDX-License-Identifier: GPL-3.0-or-later
// The program's commands as tests run them: in a folder of their own, with what was said kept.
#pragma once

#include "app/commands.h"

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include <unistd.h>

namespace candelabra {

inline constexpr const char* lit_scene = R"(#version 3.7;
#ifndef (Size) #declare Size = 1; #end
camera { location <0, 1, -5> look_at 0 }
sphere { <0, 2, 0>, Size pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 3 } }
plane { y, -1 pigment { checker rgb 1, rgb <1, 0, 0> } finish { ambient 0 } }
)";

/// A folder with scenes, and everything that the program says.
struct Shell {
    std::filesystem::path folder = std::filesystem::temp_directory_path() /
                                   ("candelabra_shell_test_" + std::to_string(::getpid()));
    std::string out, err, library, povray_library;
    Interrupts interrupts;
    std::function<bool(const SandboxRules&)> confine;
    std::function<void(Stream, std::string_view)> heard;

    Shell() {
        std::filesystem::create_directories(folder);
        write("lit.pov", lit_scene);
    }
    ~Shell() { std::filesystem::remove_all(folder); }

    std::string path(const std::string& name) const { return (folder / name).string(); }
    void write(const std::string& name, std::string_view text) const {
        std::ofstream(path(name)) << text;
    }
    std::string content(const std::string& name) const {
        std::ifstream file(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    int operator()(const std::vector<std::string>& arguments) {
        out.clear();
        err.clear();
        Console console;
        console.out = [&](std::string_view text) { out += text; };
        console.err = [&](std::string_view text) { err += text; };
        console.library = library;
        console.povray_library = povray_library;
        console.interrupts = interrupts;
        console.confine = confine;
        console.heard = heard;
        const std::vector<std::string_view> views(arguments.begin(), arguments.end());
        return run(views, console);
    }
    int render(std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {path("lit.pov"), "+W16", "+H12", "--samples", "2"});
        return (*this)(arguments);
    }
};

inline bool has(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

}  // namespace candelabra
