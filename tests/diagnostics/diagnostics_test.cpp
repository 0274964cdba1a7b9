// SPDX-License-Identifier: GPL-3.0-or-later
// Every scene of this folder has one fault, or a few of one kind. Its messages stand in the scene
// itself, in comments `//!` below the line that they are about. These are no part of the scene that
// is read: lines are counted without them. Messages about other files stand at the end, and so do
// all where they are not in the order of the lines. UPDATE_EXPECTED=1 writes the comments anew.
#include "bind/evaluate.h"
#include "text/excerpt.h"
#include "text/message.h"

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

constexpr std::string_view comment_sign = "//!";

/// The lines of a text, each with its end.
std::vector<std::string> whole_lines(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find('\n', from), text.size() - 1) + 1;
        lines.push_back(text.substr(from, end - from));
        from = end;
    }
    return lines;
}

std::string without_comments(const std::string& text) {
    std::string scene;
    for (const std::string& line : whole_lines(text))
        if (!line.starts_with(comment_sign)) scene += line;
    return scene;
}

/// What is said, and the number of the scene's line that it is about.
struct Comment {
    std::size_t line;
    std::string text;
};

struct Said {
    std::vector<Comment> comments;
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
    const SourceId main = sources.add(scene.filename().string(), without_comments(read(scene)));
    evaluate(sources, loader, main, options, diagnostics);
    Said said;
    for (const Diagnostic& diagnostic : diagnostics.all()) {
        const Span& span = diagnostic.span;
        const bool here = span.known() && span.source == main;
        const int line = here ? sources.place(main, span.first).line : sources.line_count(main);
        said.comments.push_back(
            {static_cast<std::size_t>(line), format(diagnostic, sources, false)});
        said.faults.insert(diagnostic.fault);
    }
    return said;
}

/// The scene with the comments below their lines.
std::string with_comments(const std::string& scene, std::vector<Comment> comments) {
    const std::vector<std::string> lines = whole_lines(scene);
    const bool ordered = std::ranges::is_sorted(comments, {}, &Comment::line);
    std::string text;
    for (std::size_t i = 1; i <= lines.size(); ++i) {
        text += lines[i - 1];
        for (const Comment& comment : comments)
            if ((ordered ? std::min(comment.line, lines.size()) : lines.size()) == i)
                for (const std::string& line : whole_lines(comment.text))
                    text += message(comment_sign, line == "\n" ? "" : " ", line);
    }
    return text;
}

}  // namespace

TEST_CASE("every faulty scene is told what its comments say", "[diagnostics]") {
    const bool update = std::getenv("UPDATE_EXPECTED") != nullptr;
    REQUIRE(scenes().size() > 20);
    for (const fs::path& scene : scenes()) {
        const Said said = said_about(scene);
        const std::string text = with_comments(without_comments(read(scene)), said.comments);
        if (update) std::ofstream(scene, std::ios::binary) << text;
        INFO(scene.filename().string());
        CHECK_FALSE(said.comments.empty());
        CHECK(text == read(scene));
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
