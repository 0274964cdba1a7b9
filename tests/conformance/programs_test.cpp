// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes as other programs write them, rendered as these call POV-Ray, beside POV-Ray 3.7's pictures.
#include "app/povray_command.h"

#include "app/sandbox.h"
#include "support/shell.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

const fs::path programs = CANDELABRA_SOURCE_DIR "/tests/conformance/programs";

/// A PPM file of 8 bits, which has a header of three lines and no comment.
struct Ppm {
    std::string header;
    std::vector<unsigned char> samples;

    explicit Ppm(const fs::path& path) {
        std::ifstream file(path, std::ios::binary);
        for (int i = 0; i < 3; ++i) {
            std::string line;
            do std::getline(file, line);
            while (line.starts_with('#'));
            header += line + "\n";
        }
        samples.assign(std::istreambuf_iterator<char>(file), {});
    }
};

}  // namespace

TEST_CASE("scenes that other programs write have POV-Ray 3.7's pixels", "[render]") {
    std::ifstream stream(programs.string() + ".json");
    const nlohmann::json cases = nlohmann::json::parse(stream);
    REQUIRE(cases.size() > 10);
    Shell shell;
    for (const fs::path& each : fs::directory_iterator(programs))
        fs::copy_file(each, shell.folder / each.filename());
    const fs::path before = fs::current_path();
    fs::current_path(shell.folder);  // INI files name scenes as from here
    shell.library = CANDELABRA_SOURCE_DIR "/stdlib";
    for (const auto& c : cases) {
        const fs::path scene = c["scene"].get<std::string>();
        INFO(c["by"] << ": " << scene);
        const std::string made = shell.path("made.ppm");
        std::vector<std::string> words = {"povray", shell.path(scene.string()), "-D", "+FP",
                                          "+O" + made};
        for (const std::string option : c["options"]) words.push_back(option);
        REQUIRE(shell(words) == exit_status::done);
        const Ppm found(made), expected((programs / scene).replace_extension(".ppm"));
        REQUIRE(found.header == expected.header);
        double squares = 0;
        int most = 0;
        for (std::size_t i = 0; i < expected.samples.size(); ++i) {
            const int difference = std::abs(int(found.samples[i]) - int(expected.samples[i]));
            most = std::max(most, difference);
            squares += difference * difference;
        }
        CHECK(most <= 1);
        CHECK(std::sqrt(squares / static_cast<double>(expected.samples.size())) < 0.1);
    }
    fs::current_path(before);
}

}  // namespace candelabra
