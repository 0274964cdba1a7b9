// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/output.h"

#include "support/folder.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Output of(std::string scene, std::string output = {}, std::optional<PictureType> type = {}) {
    Options options;
    options.scene = std::move(scene);
    options.output = std::move(output);
    options.type = type;
    Diagnostics diagnostics;
    const Output result = output_of(options, diagnostics);
    CHECK(diagnostics.all().empty());
    return result;
}

}  // namespace

TEST_CASE("endings of formats that are not written are refused") {
    const auto errors = [](std::string output, std::optional<PictureType> type) {
        Options options;
        options.scene = "a.pov";
        options.output = std::move(output);
        options.type = type;
        Diagnostics diagnostics;
        output_of(options, diagnostics);
        return diagnostics.all().size();
    };
    for (const char* name : {"a.jp2", "b/a.AVIF", "a.mp4", "a.gif", "a.jxl"}) {
        CHECK(errors(name, {}) == 1);
        CHECK(errors(name, PictureType::png) == 0);
    }
    for (const char* name : {"a.png", "a.jpeg", "a.2", "jp2", "a.webp", "b/a.TIFF", "a.tif"})
        CHECK(errors(name, {}) == 0);
}

TEST_CASE("a draft never takes the name of the picture") {
    const auto draft_of = [](std::string output) {
        Options options;
        options.scene = "dir/scene.pov";
        options.output = std::move(output);
        options.draft = true;
        Diagnostics diagnostics;
        return output_of(options, diagnostics).path;
    };
    CHECK(draft_of("") == "scene.draft.png");
    CHECK(draft_of("out/a.exr") == "out/a.draft.exr");
    CHECK(draft_of("a.b") == "a.b.draft.png");
    CHECK(draft_of("a.draft01.png") == "a.draft01.png");
    CHECK(draft_of("-") == "-");
}

TEST_CASE("the picture's name comes from the scene's and the options") {
    struct Case {
        std::string scene, output;
        std::optional<PictureType> type;
        std::string expected;
        PictureType format;
    };
    using enum PictureType;
    const Case cases[] = {
        {"scene.pov", "", {}, "scene.png", png},
        {"dir/scene.pov", "", {}, "scene.png", png},
        {"a b=c.pov", "", exr, "a b=c.exr", exr},
        {"-dash.pov", "", {}, "-dash.png", png},
        {"scene", "", hdr, "scene.hdr", hdr},
        {"-", "", {}, "stdin.png", png},
        {"scene.pov", "x.png", {}, "x.png", png},
        {"scene.pov", "x.exr", {}, "x.exr", exr},
        {"scene.pov", "x.JPEG", {}, "x.JPEG", jpeg},
        {"scene.pov", "x.TIFF", {}, "x.TIFF", tiff},
        {"scene.pov", "x.webp", {}, "x.webp", webp},
        {"scene.pov", "", tiff, "scene.tif", tiff},
        {"scene.pov", "x.jpg", png, "x.jpg.png", png},
        {"scene.pov", "x", {}, "x.png", png},
        {"scene.pov", "x.y", {}, "x.y.png", png},
        {"scene.pov", "/tmp", {}, "/tmp/scene.png", png},
        {"scene.pov", "/tmp/", exr, "/tmp/scene.exr", exr},
        {"scene.pov", "new/", {}, "new/scene.png", png},
        {"scene.pov", "-", {}, "-", png},
        {"scene.pov", "-", hdr, "-", hdr},
        {"scene.pov", "/dev/null", {}, "/dev/null", png},
    };
    for (const Case& each : cases) {
        CAPTURE(each.scene, each.output);
        const Output output = of(each.scene, each.output, each.type);
        CHECK(output.path == each.expected);
        CHECK(output.format.type == each.format);
    }
}

TEST_CASE("16 bits a channel are for formats that have them") {
    Options options;
    options.scene = "a.pov";
    options.bits = 16;
    Diagnostics diagnostics;
    CHECK(output_of(options, diagnostics).format.bits == 16);
    options.output = "a.tiff";
    CHECK(output_of(options, diagnostics).format.bits == 16);
    CHECK_FALSE(diagnostics.failed());
    options.output = "a.exr";
    output_of(options, diagnostics);
    REQUIRE(diagnostics.error_count() == 1);
    CHECK(diagnostics.all()[0].message == "a file of format exr cannot have 16 bits a channel");
    CHECK(diagnostics.all()[0].help == "+FN png, +FI tiff; +FE OpenEXR has 32 bits");
}

TEST_CASE("a scene has a folder of its own beside the picture") {
    const auto folder = [](const std::string& scene, const std::string& picture) {
        Options options;
        options.scene = scene;
        return own_folder({picture, {}}, options);
    };
    CHECK(folder("a.pov", "b.png") == "a.files");
    CHECK(folder("scenes/a.pov", "out/b.png") == "out/a.files");
    CHECK(folder("a", "/b.png") == "/a.files");
    CHECK(folder("-", "b.png") == "stdin.files");
    CHECK(folder("x/a.pov", "-") == "a.files");
    CHECK(folder("x/a.pov", "/dev/null") == "a.files");
}

TEST_CASE("alpha, grey and layers are for files that can have them") {
    const auto complaint = [](const char* output, bool alpha, bool grey, bool layers) {
        Options options;
        options.scene = "a.pov";
        options.output = output;
        options.alpha = alpha;
        options.grey = grey;
        if (layers) options.layers = {PictureLayer::depth};
        Diagnostics diagnostics;
        output_of(options, diagnostics);
        return diagnostics.all().empty() ? "" : diagnostics.all()[0].message;
    };
    for (const char* name : {"a.png", "a.tga", "a.exr", "a.tif", "a.webp"})
        CHECK(complaint(name, true, false, false) == "");
    for (const char* name : {"a.png", "a.ppm", "a.tif"})
        CHECK(complaint(name, false, true, false) == "");
    CHECK(complaint("a.bmp", true, false, false) == "a file of format bmp has no alpha channel");
    CHECK(complaint("a.exr", false, true, false) == "a file of format exr is not written in grey");
    for (const char* name : {"a.exr", "a.png"}) CHECK(complaint(name, false, false, true) == "");
    CHECK(complaint("-", false, false, true) == "layers need a file");
}

TEST_CASE("a name that a stranger has chosen leads nowhere else", "[app]") {
    const Folder folder;
    folder.put("a.pov", "");
    folder.put("victim.png", "");
    std::filesystem::create_symlink("victim.png", folder / "a.png");
    Options options;
    options.scene = folder / "a.pov";
    CHECK(problem_with_output(options, folder / "a.png") == "");
    CHECK(problem_with_output(options, folder / "b.png") == "");
    CHECK(problem_with_output(options, folder / "a.pov").ends_with("is the scene itself"));
    options.strange_names = true;
    CHECK(problem_with_output(options, folder / "a.png").find("is a link") != std::string::npos);
    CHECK(problem_with_output(options, folder / "victim.png") == "");
}

}  // namespace candelabra
