// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"

#include "options/subcommands.h"
#include "picture/read.h"
#include "support/shell.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include <unistd.h>

namespace candelabra {

namespace fs = std::filesystem;
TEST_CASE("explanations are results; usage errors are not") {
    Shell shell;
    CHECK(shell({"--help"}) == 0);
    CHECK(has(shell.out, "--light-sampler"));
    CHECK(shell({"--version"}) == 0);
    CHECK(shell.out.starts_with("Candelabra "));
    CHECK(shell({"--describe", "json"}) == 0);
    CHECK(nlohmann::json::parse(shell.out)["groups"].size() > 3);
    const std::string all = shell.out;
    CHECK(shell({"describe", "--json"}) == 0);
    CHECK(shell.out == all);
    CHECK(shell({"describe", "--roff", "missing"}) == 0);
    CHECK(shell.out.starts_with(".TP\n.B "));
    CHECK(shell({"describe", "colours"}) == 2);
    CHECK(shell({"describe", "--help"}) == 0);
    CHECK(has(shell.out, "usage: candelabra describe"));
    CHECK(shell.err.empty());

    CHECK(shell({}) == 2);
    CHECK(shell.out.empty());
    CHECK(shell.err.starts_with("usage: candelabra"));
    CHECK(shell({"--help", "nothing_like_it"}) == 2);
    CHECK(shell({"+W0", "+H0", shell.path("lit.pov")}) == 2);
    CHECK(has(shell.err, "`+W0`"));
    CHECK(has(shell.err, "`+H0`"));
    for (const std::string task : {"--check", "--dump=scene", "--export-mesh=m.ply"}) {
        CHECK(shell({"--preview=8081", task, shell.path("lit.pov")}) == 2);
        CHECK(has(shell.err, "one of them only"));
        CHECK(shell({task, "--preview=8081", shell.path("lit.pov")}) == 2);
        CHECK(has(shell.err, "one of them only"));
    }
}

TEST_CASE("a rendering leaves a picture and says what it did") {
    Shell shell;
    CHECK(shell.render({"+O" + shell.path("made.png")}) == 0);
    CHECK(has(shell.err, "made.png: 16 x 12 in "));
    CHECK(has(shell.err, "2 objects, 1 luminaire (light_octree)"));
    Diagnostics diagnostics;
    const auto picture = read_picture(shell.path("made.png"), diagnostics);
    REQUIRE(picture);
    CHECK(picture->width == 16);
    CHECK(picture->height == 12);
    CHECK(max_component(picture->at(8, 9)) > 0.01);

    CHECK(shell.render({"-V", "+O" + shell.folder.string(), "+FE"}) == 0);
    CHECK(fs::exists(shell.path("lit.exr")));
    CHECK(shell.err.empty());
    CHECK(shell.out.empty());
}

TEST_CASE("the picture is the same for any number of threads, and another for another seed") {
    Shell shell;
    for (const char* threads : {"1", "2", "7"})
        REQUIRE(shell.render({"-V", "--threads", threads,
                              "+O" + shell.path(std::string(threads) + ".png")}) == 0);
    CHECK_FALSE(shell.content("1.png").empty());
    CHECK(shell.content("1.png") == shell.content("2.png"));
    CHECK(shell.content("1.png") == shell.content("7.png"));
    REQUIRE(shell.render({"-V", "--seed", "1", "+O" + shell.path("other.png")}) == 0);
    CHECK(shell.content("1.png") != shell.content("other.png"));
}

TEST_CASE("assumed_gamma reaches the file") {
    Shell shell;
    const auto corner = [&](std::string_view first_line) {
        shell.write("flat.pov",
                    std::string(first_line) + "\nbackground { rgb 0.5 } camera { location 0 }\n");
        REQUIRE(shell({shell.path("flat.pov"), "-V", "+W2", "+H2",
                       "+O" + shell.path("flat.exr")}) == 0);
        Diagnostics diagnostics;
        return read_picture(shell.path("flat.exr"), diagnostics).value().at(0, 0).r;
    };
    CHECK(corner("#version 3.7; global_settings { assumed_gamma 1 }") == Approx(0.5));
    CHECK(corner("#version 3.7; global_settings { assumed_gamma 2 }") == Approx(0.25));
    CHECK(corner("#version 3.6;") == Approx(0.5));
}

TEST_CASE("no file is written with -F") {
    Shell shell;
    CHECK(shell.render({"-F", "+O" + shell.path("no/such/folder/x.png")}) == 0);
    CHECK(has(shell.err, "no file: "));
}

TEST_CASE("statistics hold what the run was") {
    Shell shell;
    CHECK(shell.render({"-V", "-F", "--stats", shell.path("stats.json"), "--light-sampler",
                        "linear_alpha", "--seed", "5", "+WT2"}) == 0);
    auto json = nlohmann::json::parse(shell.content("stats.json"));
    CHECK(json["rays"]["camera"] == 16 * 12 * 2);
    CHECK(json["luminaires"] == 1);
    CHECK(json["objects"] == 2);
    CHECK(json["light_sampler"] == "linear_alpha");
    CHECK(json["light_octree"]["bytes"] == 0);
    CHECK(json["seed"] == 5);
    CHECK(json["threads"] == 2);
    CHECK(json["peak_memory_bytes"] > 1000000);
    CHECK(json["seconds"]["total"] >= json["seconds"]["render"]);
    CHECK(shell.render({"-V", "-F", "--stats", "-"}) == 0);
    json = nlohmann::json::parse(shell.out);
    CHECK(json["light_sampler"] == "light_octree");
    CHECK(json["light_octree"]["bytes"] > 0);
    CHECK(json["kdtree"]["bytes"] > 0);
    CHECK(shell.render({"-V", "-F", "--index", "bounding_boxes", "--stats", "-"}) == 0);
    json = nlohmann::json::parse(shell.out);
    CHECK(json["index"] == "bounding_boxes");
    CHECK(json["bounding_boxes"]["bytes"] > 0);
}

TEST_CASE("names and clock from the command line reach the scene") {
    Shell shell;
    CHECK(shell.render({"--dump", "scene", "Declare=Size=0.25"}) == 0);
    CHECK(has(shell.out, "sphere { <0, 2, 0>, 0.25 "));
    shell.write("facts.pov",
                "#debug concat(Title, \" \", str(clock, 0, 1), \" \", str(image_width, 0, 0))\n");
    CHECK(shell({shell.path("facts.pov"), "--check", "Declare=Title=\"a b\"", "+K0.5", "+W77"}) ==
          0);
    CHECK(has(shell.err, "a b 0.5 77"));
}

TEST_CASE("warnings are switched by name", "[app]") {
    Shell shell;
    shell.write("careless.pov",
                "#version 3.7; #macro M(A) 1 #end #declare B = 1 / 0; camera { location y }\n"
                "sphere { 0, 1 } light_source { 0, 1 }");
    const auto said = [&](const std::vector<std::string>& switches) {
        std::vector<std::string> arguments = {shell.path("careless.pov"), "--check"};
        arguments.insert(arguments.end(), switches.begin(), switches.end());
        const int status = shell(arguments);
        std::string names;
        for (const char* name : {"unused-parameter", "division-by-zero", "error:"})
            if (shell.err.find(name) != std::string::npos) names += std::string(name) + ' ';
        return names + std::to_string(status);
    };
    CHECK(said({}) == "unused-parameter division-by-zero 0");
    CHECK(said({"--warn", "no-unused-parameter"}) == "division-by-zero 0");
    CHECK(said({"--warn", "none"}) == "0");
    CHECK(said({"+WL0"}) == "0");
    CHECK(said({"--warn=none,division-by-zero"}) == "division-by-zero 0");
    CHECK(said({"--warn=no-division-by-zero,error"}) == "error: 1");
    CHECK(said({"--warn=devision-by-zero"}) == "division-by-zero error: 2");
}

TEST_CASE("diagnostics as JSON are all that is said", "[app]") {
    Shell shell;
    shell.write("wrong.pov", "#version 3.7;\n#debug \"hello\"\nsphere { 0, Radius }\n");
    CHECK(shell({shell.path("wrong.pov"), "--check", "--diagnostics=json"}) == 1);
    std::istringstream lines(shell.err);
    std::vector<nlohmann::json> all;
    for (std::string line; std::getline(lines, line);) all.push_back(nlohmann::json::parse(line));
    REQUIRE(all.size() == 2);
    CHECK(all[0]["severity"] == "debug");
    CHECK(all[1]["name"] == "unknown-name");
    CHECK(all[1]["place"]["line"] == 3);
    CHECK(shell.render({"--diagnostics", "json", "+O" + shell.path("a.png")}) == 0);
    CHECK(shell.err.empty());
    CHECK(shell({"--diagnostics=xml"}) == 2);
}

TEST_CASE("an animation leaves a picture for each frame, each with its clock", "[app]") {
    Shell shell;
    shell.write("move.pov",
                "#debug concat(str(frame_number, 0, 0), \"/\", str(final_frame, 0, 0), "
                "\" \", str(clock, 0, 2), \"\\n\") camera { location -z } "
                "background { rgb clock }");
    const std::vector<std::string> words = {shell.path("move.pov"), "+W2", "+H2",
                                            "+O" + shell.path("out.png"), "+KFF11"};
    REQUIRE(shell(words) == exit_status::done);
    CHECK(has(shell.err, "3/11 0.20\n"));
    CHECK(has(shell.err, "frame 11 (11 of 11), clock 1"));
    CHECK(fs::exists(shell.path("out01.png")));
    Diagnostics none;
    CHECK(read_picture(shell.path("out11.png"), none)->pixels[0].r > 0.99);
    CHECK(read_picture(shell.path("out01.png"), none)->pixels[0].r == 0);

    fs::remove(shell.path("out07.png"));
    std::vector<std::string> again = words;
    again.push_back("--skip-existing");
    REQUIRE(shell(again) == exit_status::done);
    CHECK(has(shell.err, "frame 6 (6 of 11), clock 0.5: is there"));
    CHECK(has(shell.err, "7/11"));
    CHECK_FALSE(has(shell.err, "6/11"));
    CHECK(fs::exists(shell.path("out07.png")));
}

TEST_CASE("an error in a frame ends the animation", "[app]") {
    Shell shell;
    shell.write("bad.pov", "#if (frame_number = 2) #error \"no\" #end camera { location -z }");
    CHECK(shell({shell.path("bad.pov"), "+W2", "+H2", "+O" + shell.path("bad.png"), "+KFF3"}) ==
          exit_status::scene);
    CHECK(fs::exists(shell.path("bad1.png")));
    CHECK_FALSE(fs::exists(shell.path("bad2.png")));
    CHECK_FALSE(fs::exists(shell.path("bad3.png")));
}

TEST_CASE("a current folder that is the whole disk is left out, and named once", "[app]") {
    Shell shell;
    shell.write("t.pov", std::string(lit_scene) + "#include \"etc/hostname\"");
    const fs::path before = fs::current_path();
    fs::current_path("/");
    const int frames = shell.render({"-V", "+KFF2", "+O" + shell.path("f.png")});
    const std::string of_frames = shell.err;
    const int refused = shell({shell.path("t.pov"), "--check"});
    fs::current_path(before);
    const std::string named = "the scene reads nothing from the current directory, `/`";
    CHECK(frames == exit_status::done);
    const std::size_t at = of_frames.find(named);
    CHECK(at != std::string::npos);
    CHECK(of_frames.find(named, at + 1) == std::string::npos);
    CHECK(refused == exit_status::scene);
    CHECK(has(shell.err, "there is no file `etc/hostname`"));
    CHECK(has(shell.err, "the current directory, `/`, is not searched"));
}

TEST_CASE("options go to an INI file and come from it", "[app]") {
    Shell shell;
    shell.write("head.inc", "#declare Size = 3;");
    REQUIRE(shell({"--check", "+W77", "Declare=Size=2", "+HIhead.inc", shell.path("lit.pov"),
                   "+GI" + shell.path("all.ini")}) == exit_status::done);
    const std::string all = shell.content("all.ini");
    for (const char* line : {"Width=77\n", "Height=480\n", "Quality=9\n", "Antialias=on\n",
                             "Antialias_Threshold=0.3\n", "Jitter=on\n", "--samples=0\n",
                             "Declare=Size=2\nInclude_Header=head.inc\n"})
        CHECK(has("\n" + all, "\n" + std::string(line)));
    // It says nothing that the run did not do, and is read to the same settings.
    CHECK_FALSE(has(all, "skip-existing"));
    REQUIRE(shell({shell.path("all.ini"), "+GI" + shell.path("again.ini")}) == exit_status::done);
    CHECK(shell.content("again.ini") == all);
    REQUIRE(shell({shell.path("all.ini")}) == exit_status::done);
    CHECK(has(shell.err, "no errors"));
}

TEST_CASE("the manual shows the stages of a scene as they are", "[app]") {
    std::ifstream file(CANDELABRA_SOURCE_DIR "/man/candelabra.1.in");
    const std::string manual{std::istreambuf_iterator<char>(file), {}};
    const std::size_t begin = manual.find("#macro Lamp(X)");
    REQUIRE(begin != std::string::npos);
    Shell shell;
    shell.write("lamps.pov", manual.substr(begin, manual.find(".fi", begin) - begin));
    for (const char* stage : {"tree", "scene"}) {
        REQUIRE(shell({shell.path("lamps.pov"), "--dump", stage}) == 0);
        CHECK(has(manual, shell.out));
    }
}

TEST_CASE("each form of progress says it to those who listen") {
    struct Case {
        const char* form;
        bool on_out;
        const char* text;
    };
    const Case cases[] = {
        {"alf", true, "ALF_PROGRESS 100%\n"},
        {"openjd", true, "openjd_progress: 100\n"},
        {"json", false, "{\"progress\":1,\"seconds\":"},
    };
    for (const Case& each : cases) {
        Shell shell;
        CAPTURE(each.form, shell.err, shell.out);
        REQUIRE(shell.render({"-F", "--progress", each.form}) == 0);
        CHECK(has(each.on_out ? shell.out : shell.err, each.text));
        CHECK_FALSE(has(each.on_out ? shell.err : shell.out, each.text));
    }
    for (const char* form : {"none", "plain", "auto"}) {
        Shell shell;  // finishes before a line is due
        REQUIRE(shell.render({"-F", "--progress", form}) == 0);
        CHECK(shell.out.empty());
        CHECK(shell.err.starts_with("no file: 16 x 12 in "));
    }
    Shell shell;
    CHECK(shell.render({"-F", "--progress", "dots"}) == exit_status::usage);
    CHECK(has(shell.err, "auto, plain, json, alf, openjd, povray or none"));
}

TEST_CASE("exit statuses are as the manual has them") {
    Shell shell;
    const std::string file = "+O" + shell.path("a.png");
    CHECK(shell.render({"-V", file}) == 0);
    shell.write("bad.pov", "sphere { 0, Sise }");
    CHECK(shell({shell.path("bad.pov"), "-V", file}) == 1);
    CHECK(shell({shell.path("bad.pov"), "--check"}) == 1);
    CHECK(shell.render({"+Wx"}) == 2);
    CHECK(shell({}) == 2);
    CHECK(shell({shell.path("none.pov")}) == 3);
    CHECK(shell.render({"-V", "+O" + shell.path("none/a.png")}) == 3);
    shell.interrupts.take = [] { return Interrupt::stop; };
    CHECK(shell.render({"-V", file}) == 4);
    std::ifstream page(std::string(CANDELABRA_SOURCE_DIR) + "/man/candelabra.1.in");
    const std::string manual{std::istreambuf_iterator<char>(page), {}};
    const std::string statuses = manual.substr(manual.find(".SH EXIT STATUS"), 700);
    for (const char* status : {".B 0", ".B 1", ".B 2", ".B 3", ".B 4"})
        CHECK(has(statuses, status));
}

TEST_CASE("every picture says what made it, as far as its format has room") {
    Shell shell;
    for (const char* ending : {"png", "exr", "jpg", "tga", "ppm", "hdr"}) {
        CAPTURE(ending);
        const std::string name = std::string("a.") + ending;
        REQUIRE(shell.render({"-V", "--seed", "7", "+O" + shell.path(name)}) == 0);
        const std::string bytes = shell.content(name);
        for (const char* part : {"Candelabra ", "; scene lit.pov, sha256 ", " width=16;"})
            CHECK(has(bytes, part));
        if (std::string_view(ending) != "tga")  // with at most 324 characters of text
            for (const char* part : {" seed=7;", " samples=2;"}) CHECK(has(bytes, part));
        Diagnostics diagnostics;
        CHECK(read_picture(shell.path(name), diagnostics));  // the text does no harm
    }
}

TEST_CASE("each subcommand of the table has its help", "[app]") {
    Shell shell;
    for (const Subcommand& command : subcommands()) {
        const std::string name(command.name);
        INFO(name);
        CHECK(shell({name, "--help"}) == exit_status::done);
        CHECK(has(shell.out, "usage: candelabra " + name));
    }
}

}  // namespace candelabra
