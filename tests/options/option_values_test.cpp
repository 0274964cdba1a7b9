// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/option_values.h"

#include "options/command_line.h"
#include "options/option_table.h"
#include "options/output.h"
#include "options/read_words.h"
#include "production/identity.h"
#include "support/shell.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

namespace candelabra {

namespace fs = std::filesystem;

namespace {

using GivenWords = std::vector<std::string>;

/// The name by which the examples below know a row.
std::string row_name(const OptionRow& row) {
    for (const std::string_view each : {row.field, row.word, row.keyword, row.letters})
        if (!each.empty()) return std::string(each);
    return {};
}

constexpr auto no_picture = "no picture";

/// An unusual value of every supported option; `no_picture` if the option makes a run that makes
/// none, or several.
const std::map<std::string, GivenWords>& examples() {
    static const std::map<std::string, GivenWords> all = {
        {"Input_File_Name", {no_picture}},
        {"output", {"+Oout/other.exr"}},
        {"Output_to_File", {"+FT"}},
        {"Output_File_Type", {"Output_File_Type=C"}},
        {"Bits_Per_Color", {"Bits_Per_Color=16"}},
        {"Grayscale_Output", {"Grayscale_Output=on"}},
        {"Output_Alpha", {"+UA"}},
        {"width", {"+W9"}},
        {"height", {"+H5"}},
        {"antialias", {"-A"}},
        {"antialias_threshold", {"Antialias_Threshold=0.05"}},
        {"sampling_method", {"+AM2"}},
        {"antialias_depth", {"+R2"}},
        {"antialias_gamma", {"+AG1.5"}},
        {"jitter", {"-J"}},
        {"jitter_amount", {"Jitter_Amount=0.5"}},
        {"samples", {"--samples", "3"}},
        {"noise", {"--noise", "0.3"}},
        {"time", {"--time", "2s"}},
        {"shadow_rays", {"--shadow-rays", "3"}},
        {"light-report", {"--light-report"}},
        {"layers", {"--layers", "normal,lights"}},
        {"Start_Row", {"+SR2"}},
        {"End_Row", {"+ER0.5"}},
        {"Start_Column", {"+SC3"}},
        {"End_Column", {"+EC5"}},
        {"Continue_Trace", {"+C"}},
        {"checkpoint", {"--checkpoint", "5"}},
        {"keep-state", {"--keep-state"}},
        {"shard", {no_picture}},
        {"shard-by", {"--shard-by", "tiles"}},
        {"light-sampler", {"--light-sampler", "light_bvh"}},
        {"index", {"--index", "bounding_boxes"}},
        {"integrator", {"--integrator", "path_traced"}},
        {"denoise", {"--denoise"}},
        {"draft", {"--draft"}},
        {"sheet", {no_picture}},
        {"preview-host", {no_picture}},
        {"film", {"--film", "on"}},
        {"exposure", {"--exposure", "auto+1"}},
        {"white-balance", {"--white-balance", "3200"}},
        {"response", {"--response", "agx"}},
        {"pixel-filter", {"--pixel-filter", "mitchell"}},
        {"smooth-edges", {"--response", "filmic", "--smooth-edges", "off"}},
        {"glare", {"--glare", "veil=0.2,blades=5", "--glare", "on"}},
        {"vignette", {"--vignette", "0.4"}},
        {"key", {"--exposure", "auto", "--key", "0.1"}},
        {"contrast", {"--contrast", "1.2"}},
        {"saturation", {"--saturation", "0.5"}},
        {"grain", {"--grain", "0.3"}},
        {"seed", {"--seed", "7"}},
        {"threads", {"+WT2"}},
        {"Library_Path", {"+Llib"}},
        {"library", {"--library", "lib"}},
        {"allow-read", {"--allow-read", "lib"}},
        {"allow-write", {"--allow-write", "lib"}},
        {"sandbox", {"--sandbox", "off"}},
        {"memory", {"--memory", "2G"}},
        {"Declare", {"Declare=Size=0.7", "Declare=Word=\"a 'b'\"", "Declare=At=<1,-2,0.5>"}},
        {"preset", {no_picture}},
        {"Clock", {"+K0.3"}},
        {"initial_frame", {no_picture, "+KFI2"}},
        {"final_frame", {no_picture, "+KFF7"}},
        {"initial_clock", {no_picture, "+KI3"}},
        {"final_clock", {no_picture, "+KF4"}},
        {"cyclic_animation", {no_picture, "+KC"}},
        {"subset_start_frame", {"+SF2"}},
        {"subset_end_frame", {"+EF2"}},
        {"frame_step", {"+STP2"}},
        {"frames", {no_picture, "--frames", "2"}},
        {"skip_existing", {"--skip-existing"}},
        {"movie", {no_picture}},
        {"frame-rate", {"--frame-rate", "9"}},
        {"Include_Header", {"+HIlib/head.inc"}},
        {"language-version", {"+MV3.6"}},
        {"Include_Ini", {no_picture}},
        {"GI", {"+GIall.ini"}},
        {"Create_Ini", {"Create_Ini=all.ini"}},
        {"Verbose", {"-V"}},
        {"All_Console", {"-GA"}},
        {"All_File", {"All_File=log.txt"}},
        {"Debug_Console", {"-GD"}},
        {"Debug_File", {"Debug_File=log.txt"}},
        {"Fatal_Console", {"-GF"}},
        {"Fatal_File", {"Fatal_File=log.txt"}},
        {"Render_Console", {"-GR"}},
        {"Render_File", {"Render_File=log.txt"}},
        {"Statistic_Console", {"-GS"}},
        {"Statistic_File", {"Statistic_File=log.txt"}},
        {"Warning_Console", {"-GW"}},
        {"Warning_File", {"Warning_File=log.txt"}},
        {"allow-commands", {"--allow-commands"}},
        {"warn", {"--warn", "none"}},
        {"Warning_Level", {"+WL0"}},
        {"diagnostics", {"--diagnostics", "json"}},
        {"check", {no_picture}},
        {"dump", {no_picture}},
        {"pick", {no_picture}},
        {"export-mesh", {no_picture}},
        {"export-object", {"--export-object", "Ball"}},
        {"measure", {no_picture}},
        {"light-balance", {no_picture}},
        {"until", {"--until", "lux 1%"}},
        {"progress", {"--progress", "plain"}},
        {"preview", {no_picture}},
        {"depfile", {"--depfile", "a.d"}},
        {"keep-lights", {"--keep-lights", "a.lights"}},
        {"keep-lights-size", {"--keep-lights-size", "20M"}},
        {"stats", {"--stats", "a.json"}},
        {"help", {no_picture}},
        {"version", {no_picture}},
        {"describe", {no_picture}},
        {"completion", {no_picture}},
        {"quality", {"+Q3"}},
        {"luminaires", {"--luminaires", "none"}},
        {"ambient_luminaires", {"--ambient-luminaires"}},
        {"File_Gamma", {"File_Gamma=1.8"}},
    };
    return all;
}

GivenWords words_for(const OptionRow& row) {
    const std::string name = row_name(row);
    if (name.starts_with("limit-")) return {"--" + name, "1000"};
    if (name.ends_with("_Command")) return {name + "=true"};
    if (name.ends_with("_Return")) return {name + "=I"};
    const auto found = examples().find(name);
    INFO("no example of " << name);
    REQUIRE(found != examples().end());
    return found->second;
}

Options options_with(const GivenWords& more) {
    GivenWords words = {"scene.pov", "+W8", "+H6"};
    for (const std::string& each : more)
        if (each != no_picture) words.push_back(each);
    return read({words.begin(), words.end()});
}

bool is_supported(const OptionRow& row) { return row.unoffered == Unoffered::no; }

bool is_of_animation(const OptionRow& row) {
    return find_setting(row.field).item == &AnimationSettings::vocabulary;
}

/// A folder with a scene to which most options matter.
struct OptionRuns : Shell {
    OptionRuns() {
        fs::create_directories(path("lib"));
        write("lib/head.inc", "#declare Size = 0.9;");
        write("lib/part.inc", "#declare Word = \"in the library\";");
        write("scene.pov", R"(#version 3.7; global_settings { assumed_gamma 1 }
            #ifndef (Size) #declare Size = 0.5; #end
            #if (file_exists("part.inc")) #include "part.inc" #end
            #ifndef (Word) #declare Word = ""; #end
            camera { location <0, 1, -5> look_at 0 }
            light_source { <2, 5, -4>, 0.4 }
            sphere { <0, 1, 0>, Size + clock / 3 pigment { rgb <1, 0.5, 0.2> }
                     finish { ambient 0 emission 3 } }
            sphere { <1, 0, 0>, 0.3 pigment { rgb 0.5 } finish { ambient 2 } }
            plane { y, -1 pigment { checker rgb 1, rgb <strlen(Word) / 20, 0, 0> }
                    finish { ambient 0 reflection 0.2 } })");
    }

    /// Runs the program in the folder. Returns its pictures by the ends of their names.
    std::map<std::string, std::string> pictures(const std::string& words) const {
        fs::remove_all(folder / "out");
        fs::create_directories(folder / "out");
        INFO(words);
        REQUIRE(
            std::system(("cd " + folder.string() + " && { " CANDELABRA_BINARY " --sandbox off " +
                         words + "; } >said.txt 2>&1")
                            .c_str()) == 0);
        std::map<std::string, std::string> files;
        for (const auto& each : fs::directory_iterator(folder / "out")) {
            const std::string name = each.path().filename().string();
            if (name.ends_with(".state.exr")) continue;
            files[name.substr(name.find('.'))] = content("out/" + name);
        }
        return files;
    }
};

std::string quoted(const GivenWords& words) {
    std::string text;
    for (const std::string& each : words) {
        std::string inner = each;
        for (std::size_t at = 0; (at = inner.find('\'', at)) != inner.npos; at += 4)
            inner.replace(at, 1, "'\\''");
        text += " '" + inner + "'";
    }
    return text;
}

}  // namespace

TEST_CASE("what each option changes is what the identity and the command of a picture tell",
          "[app]") {
    const Options usual = options_with({});
    const Identity before = identity_of(usual, {}, {});
    const auto sampling = [](const Identity& identity) { return fact(identity, "sampling"); };
    std::set<std::string> names;
    for (const OptionRow& row : option_table()) {
        if (!is_supported(row)) continue;
        CAPTURE(row_name(row));
        CHECK(names.insert(row_name(row)).second);
        const GivenWords words = words_for(row);
        if (words == GivenWords{no_picture}) {
            CHECK(row.changes == Changes::none);
            continue;
        }
        const Options options = options_with(words);
        const Identity now = identity_of(options, {}, {});
        const bool of_samples = row.changes == Changes::samples || row.changes == Changes::adaptive;
        const bool sets_samples = of_samples || row.field == "antialias" || row.word == "draft";
        CHECK((sampling(before) != sampling(now)) == sets_samples);
        // States with few samples may get more, if all pixels get the same number.
        CHECK(difference(before, now).empty() ==
              (row.changes != Changes::picture && (!of_samples || sampling(now) == "even")));
        const auto format = [](const Options& of) {
            Diagnostics none;
            return format_options(output_of(of, none).format);
        };
        CHECK((format(options) != format(usual)) == (row.changes == Changes::format));
        CHECK((command_line(options) != command_line(usual)) ==
              (row.changes != Changes::none && row.changes != Changes::format));
    }
}

TEST_CASE("the command that a picture records makes an equal file, whatever option was given",
          "[app][slow]") {
    const OptionRuns runs;
    const std::string start = "scene.pov +W8 +H6 +Oout/";
    const auto usual = runs.pictures(start);
    for (const OptionRow& row : option_table()) {
        if (!is_supported(row)) continue;
        const GivenWords words = words_for(row);
        if (words.front() == no_picture || row_name(row) == "time") continue;
        CAPTURE(row_name(row));
        const auto given = runs.pictures(start + quoted(words));
        if (row.changes == Changes::none) {
            CHECK((given == usual));
            continue;
        }
        CHECK((given != usual));
        const Options options = options_with(words);
        Diagnostics none;
        const std::string command =
            command_line(options) + format_options(output_of(options, none).format);
        const std::string_view program = "candelabra ";
        REQUIRE(command.starts_with(program));
        CHECK((runs.pictures("+Oout/ " + command.substr(program.size())) == given));
    }
}

TEST_CASE("+C and merge refuse a picture with any option that changes it", "[app][slow]") {
    OptionRuns runs;
    const std::string picture = runs.path("a.png");
    const GivenWords start = {runs.path("scene.pov"), "-V", "+W8", "+H6", "+O" + picture};
    const auto run = [&](GivenWords more) {
        GivenWords words = start;
        words.insert(words.end(), more.begin(), more.end());
        return runs(words);
    };
    REQUIRE(run({"--samples", "2", "--keep-state"}) == 0);
    REQUIRE(run({"--samples", "2", "--shard", "1/2"}) == 0);
    for (const OptionRow& row : option_table()) {
        if (row.changes != Changes::picture || is_of_animation(row)) continue;
        if (row.word == "draft") continue;  // its picture and its state have another name
        CAPTURE(row_name(row));
        GivenWords more = words_for(row);
        more.insert(more.end(), {"--samples", "2"});
        GivenWords again = more, other = more;
        again.push_back("+C");
        CHECK(run(again) == exit_status::file);
        CHECK(has(runs.err, "cannot go on from"));
        other.insert(other.end(), {"--shard", "2/2"});
        REQUIRE(run(other) == 0);
        CHECK(runs({"merge", picture + ".1of2.state.exr", picture + ".2of2.state.exr",
                    "+O" + runs.path("m.png")}) == exit_status::usage);
        CHECK_FALSE(fs::exists(runs.path("m.png")));
    }
}

TEST_CASE("a film that is off in the end has no other options", "[app]") {
    const auto command = [](const GivenWords& words) {
        const std::string text = command_line(options_with(words));
        return text.substr(text.find("+H6") + 3);
    };
    CHECK(command({"--exposure", "2", "--film", "off"}) == " --film off");
    CHECK(command({"--film", "off", "--exposure", "2"}) == " --film on --exposure 2");
    CHECK(command({"--film", "off", "--glare", "off"}) == " --film off");
    CHECK(command({"--exposure", "1", "--exposure", "2"}) == " --exposure 2");
}

TEST_CASE("files and folders are named as from the folder of the scene", "[app]") {
    const auto words = [](std::vector<std::string_view> given) {
        const std::string text = command_line(read(std::move(given)));
        return text.substr(text.find("+H480") + 5);
    };
    CHECK(words({"x/a.pov", "+Lx/lib"}) == " +Llib");
    CHECK(words({"x/a.pov", "+Llib", "+HIx/h.inc"}) == " +L../lib +HIh.inc");
    CHECK(words({"a.pov", "+L/usr/lib"}) == " +L/usr/lib");
}

TEST_CASE("a merged picture records the format that merge has given it", "[app]") {
    Shell shell;
    for (const char* shard : {"1/2", "2/2"})
        REQUIRE(shell.render({"-V", "--shard", shard, "+O" + shell.path("a.png")}) == 0);
    REQUIRE(shell({"merge", shell.path("a.png.1of2.state.exr"), shell.path("a.png.2of2.state.exr"),
                   "+FP", "+O" + shell.path("b.ppm")}) == 0);
    CHECK(has(shell.content("b.ppm"), "--samples 2 +FP\n"));
}

}  // namespace candelabra
