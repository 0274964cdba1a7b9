// SPDX-License-Identifier: GPL-3.0-or-later
// Every scene of this folder has one fault, or a few of one kind; all that is said about it is in
// the file .expected beside it. UPDATE_EXPECTED=1 writes these files anew.
#include "bind/evaluate.h"
#include "text/excerpt.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace candelabra {

namespace fs = std::filesystem;

namespace {

const fs::path& folder() {
    static const fs::path path = fs::path(CANDELABRA_SOURCE_DIR) / "tests" / "diagnostics";
    return path;
}

std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::vector<fs::path> scenes() {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder()))
        if (entry.path().extension() == ".pov") found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

struct Said {
    std::string text;
    std::set<Fault> faults;
};

Said said_about(const fs::path& scene) {
    SourceStore sources;
    Diagnostics diagnostics;
    // Files are named as from this folder, so that the messages are the same everywhere.
    const Loader loader([disk = disk_reader()](const std::string& path) {
        return disk((folder() / path).string());
    });
    EvaluateOptions options;
    options.limits.steps = 20'000;
    options.limits.call_depth = 10'000;
    options.limits.objects = 25'000;
    options.limits.text_bytes = 1000;
    evaluate(sources, loader, sources.add(scene.filename().string(), read(scene)), options,
             diagnostics);
    Said said;
    for (const Diagnostic& diagnostic : diagnostics.all()) {
        said.text += format(diagnostic, sources, false);
        said.faults.insert(diagnostic.fault);
    }
    return said;
}

}  // namespace

TEST_CASE("every faulty scene is told what its expected file says", "[diagnostics]") {
    const bool update = std::getenv("UPDATE_EXPECTED") != nullptr;
    REQUIRE(scenes().size() > 20);
    for (const fs::path& scene : scenes()) {
        fs::path expected = scene;
        expected.replace_extension(".expected");
        const std::string text = said_about(scene).text;
        if (update) std::ofstream(expected, std::ios::binary) << text;
        INFO(scene.filename().string());
        CHECK_FALSE(text.empty());
        CHECK(text == read(expected));
    }
}

TEST_CASE("every expected file has its scene", "[diagnostics]") {
    for (const auto& entry : fs::directory_iterator(folder())) {
        if (entry.path().extension() != ".expected") continue;
        fs::path scene = entry.path();
        CHECK(fs::exists(scene.replace_extension(".pov")));
    }
}

TEST_CASE("every fault that a scene can have is among them", "[diagnostics]") {
    // These belong to files, to options of the run, and to the world that is made of a scene.
    std::set<Fault> missing;
    for (const FaultInfo& info : all_faults()) missing.insert(info.fault);
    for (const Fault fault :
         {Fault::file_access, Fault::io, Fault::option, Fault::no_camera, Fault::no_object,
          Fault::no_light, Fault::camera_inside, Fault::glowing_dome, Fault::aspect,
          Fault::lookalike})
        missing.erase(fault);
    for (const fs::path& scene : scenes())
        for (const Fault fault : said_about(scene).faults) missing.erase(fault);
    for (const Fault fault : missing) FAIL_CHECK(name(fault) << " is never reported");
}

}  // namespace candelabra
