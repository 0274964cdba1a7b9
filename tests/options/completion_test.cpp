// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/completion.h"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace candelabra {

TEST_CASE("shells get every option that is offered, and nothing else") {
    struct Case {
        const char* shell;
        std::vector<const char*> parts;
    };
    const Case cases[] = {
        {"bash",
         {" --samples ", " --width ", " +W ", " Width= ", " +C ", " -C ", "complete -F _candelabra",
          "relight) words='--smooth "}},
        {"zsh",
         {"#compdef candelabra", "'--samples=[", "'--width=[", "'+W-[", "'+C[", ":file:_files'",
          "'relight:", "'--set=[", "'--lux=["}},
        {"fish",
         {"-l samples -x -d '", "-l start-row -x -d '", "-a '+W' -d", "-l stats -rF", "-l help -d",
          "-n '__fish_seen_subcommand_from relight' -l set -x -d '",
          "-n '__fish_seen_subcommand_from solve' -l lux -x -d '"}},
    };
    for (const Case& each : cases) {
        const auto script = completion(each.shell);
        REQUIRE(script);
        for (const char* part : each.parts) {
            CAPTURE(each.shell, part);
            CHECK(script->find(part) != std::string::npos);
        }
        CHECK(script->find("Field_Render") == std::string::npos);
    }
    CHECK_FALSE(completion("csh"));
}

TEST_CASE("bash completes options, scenes and folders") {
    namespace fs = std::filesystem;
    const fs::path folder = fs::temp_directory_path() / "candelabra_completion";
    fs::create_directories(folder / "sub");
    std::ofstream(folder / "b.sh") << *completion("bash");
    std::ofstream(folder / "scene.pov") << "";
    std::ofstream(folder / "scene.txt") << "";
    std::ofstream(folder / "x.lights") << "";
    const std::string command =
        "cd " + folder.string() +
        " && bash -c '. ./b.sh; t() { COMP_WORDS=(candelabra \"$@\"); COMP_CWORD=$#; "
        "_candelabra 2>/dev/null; echo \"${COMPREPLY[*]}\"; }; t --samp; t s; t Wid; t me; t re; t "
        "relight --cs; t relight x; t solve --lu; t solve s; t solve --samp; t relight --csv "
        "scene.t' > out";
    REQUIRE(std::system(command.c_str()) == 0);
    std::ifstream out(folder / "out");
    std::string line;
    for (const char* expected :
         {"--sampling-method --samples", "scene.pov sub/ solve share", "Width=", "merge", "relight",
          "--csv", "x.lights", "--lux --luminaires", "scene.pov sub/",
          "--sampling-method --samples", "scene.txt"}) {
        std::getline(out, line);
        CHECK(line == expected);
    }
    fs::remove_all(folder);
}

}  // namespace candelabra
