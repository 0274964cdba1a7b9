// SPDX-License-Identifier: GPL-3.0-or-later
// What the table says of the effects of options is true of all rows: what changes a picture changes
// its identity, what changes nothing changes no byte, and the recorded command makes the same file.
#include "options/option_table.h"
#include "options/option_values.h"
#include "options/read_words.h"
#include "production/identity.h"
#include "support/shell.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace candelabra {

namespace {

using Words = std::vector<std::string>;

/// Things that each option of pictures changes: a lamp, a thing that glows faintly, ambient light,
/// edges, a mirror, a clock, a frame and a declared name.
constexpr const char* sensitive_scene = R"(#ifndef (Shift) #declare Shift = 0; #end
camera { location <0, 1, -5> look_at 0 }
background { rgb 0.2 }
sphere { <Shift, 2, 0>, 0.8 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 3 } }
sphere { <1 - clock, 0, version - 3.8>, 0.7 pigment { rgb <1, 0.5, 0.2> } finish { ambient 0.3 reflection 0.4 } }
plane { y, -1 pigment { checker rgb 1, rgb <1, 0, 0> } finish { ambient 0.1 } }
light_source { <4, 5, -5>, rgb 0.4 area_light x, z, 2, 2 jitter }
)";

struct Sample {
    std::string_view name;  ///< keyword of a row, else its word, else its letters
    std::string_view value;
    Words beside = {};  ///< without which it has no effect; the picture is compared with theirs
};

/// A value of each option that is no setting.
const Sample samples[] = {
    {"Grayscale_Output", "on"},
    {"time", "1000s", {"--samples", "2"}},
    {"light-report", ""},
    {"layers", "normal"},
    {"Start_Row", "3"},
    {"End_Row", "8"},
    {"Start_Column", "3"},
    {"End_Column", "8"},
    {"Continue_Trace", "on"},
    {"checkpoint", "0.01s"},
    {"keep-state", ""},
    {"light-sampler", "light_bvh"},
    {"index", "bounding_boxes"},
    {"integrator", "path_traced"},
    {"denoise", ""},
    {"film", "on"},
    {"exposure", "1"},
    {"key", "0.1", {"--exposure", "auto"}},
    {"contrast", "1.3"},
    {"saturation", "0.5"},
    {"white-balance", "4000"},
    {"response", "filmic"},
    {"pixel-filter", "mitchell"},
    {"smooth-edges", "on"},
    {"glare", "veil=0.2"},
    {"vignette", "0.5"},
    {"grain", "0.3"},
    {"limit-steps", "10000"},
    {"limit-depth", "100"},
    {"limit-nesting", "100"},
    {"limit-objects", "100"},
    {"limit-includes", "10"},
    {"limit-files", "10"},
    {"limit-elements", "100"},
    {"limit-written", "1"},
    {"limit-said", "1"},
    {"limit-text", "1"},
    {"limit-function", "1000"},
    {"limit-work", "100"},
    {"limit-memory", "4000"},
    {"memory", "4G"},
    {"Declare", "Shift=0.4"},
    {"Clock", "0.5"},
    {"Initial_Frame", "2", {"+KFF3"}},
    {"Final_Frame", "3"},
    {"Initial_Clock", "0.3", {"+KFF3"}},
    {"Final_Clock", "0.6", {"+KFF3"}},
    {"Cyclic_Animation", "on", {"+KFF3"}},
    {"frame-rate", "30"},
    {"Version", "3.5"},
    {"Verbose", "on"},
    {"warn", "none"},
    {"Warning_Level", "0"},
    {"diagnostics", "json"},
    {"progress", "plain"},
    {"keep-lights-size", "20M"},
    {"luminaires", "none"},
    {"File_Gamma", "1.8"},
    {"sandbox", "off"},
    {"allow-commands", ""},
};

/// Options of files, of other tasks and of what is around a run, which tests of their own have.
const std::string_view not_tried[] = {"Input_File_Name",
                                      "Output_File_Name",
                                      "Output_to_File",
                                      "Output_File_Type",
                                      "Bits_Per_Color",
                                      "Output_Alpha",
                                      "frames",
                                      "shard",
                                      "shard-by",
                                      "Library_Path",
                                      "library",
                                      "preset",
                                      "draft",
                                      "allow-read",
                                      "allow-write",
                                      "movie",
                                      "sheet",
                                      "Include_Header",
                                      "Include_Ini",
                                      "GI",
                                      "Create_Ini",
                                      "check",
                                      "dump",
                                      "pick",
                                      "export-mesh",
                                      "export-object",
                                      "measure",
                                      "light-balance",
                                      "keep-lights",
                                      "until",
                                      "preview",
                                      "preview-host",
                                      "depfile",
                                      "stats",
                                      "help",
                                      "version",
                                      "describe",
                                      "completion",
                                      "benchmark"};

std::string_view name_of(const OptionRow& row) {
    return !row.keyword.empty() ? row.keyword : !row.word.empty() ? row.word : row.letters;
}

bool is_tried(const OptionRow& row) {
    const std::string_view name = name_of(row);
    return row.unoffered == Unoffered::no && std::ranges::count(not_tried, name) == 0 &&
           !name.ends_with("_Console") && !name.ends_with("_File") && !name.ends_with("_Command") &&
           !name.ends_with("_Return");
}

/// A value of a setting that is not the usual one.
std::string another_value(const FieldInfo& field) {
    if (field.type == FieldType::boolean) return "off";
    if (field.type == FieldType::number) return "0.7";
    const double value = std::clamp(5.0, field.range.low, std::fmin(field.range.high, 1e6));
    return std::to_string(static_cast<int>(value == 3 ? 2 : value));
}

/// The option with a value, and what it stands beside.
std::optional<Sample> sample_of(const OptionRow& row, std::string& value) {
    const auto found = std::ranges::find(samples, name_of(row), &Sample::name);
    if (found != std::end(samples)) return *found;
    const Setting setting = find_setting(row.field);
    if (!setting.item) return {};
    value = another_value(setting.info());
    return Sample{name_of(row), value};
}

struct Picture {
    std::string file;  ///< without the text about its origin
    std::string origin;
};

/// The picture that these options make, as the newest ppm file of the folder.
std::optional<Picture> picture_of(Shell& shell, const Words& options) {
    namespace fs = std::filesystem;
    for (const auto& entry : fs::directory_iterator(shell.folder))
        if (entry.path().extension() == ".ppm") fs::remove(entry.path());
    Words all = {shell.path("scene.pov"), "+O" + shell.path("picture.ppm")};
    all.insert(all.end(), options.begin(), options.end());
    if (shell(all) != exit_status::done) return {};
    std::vector<std::string> files;
    for (const auto& entry : fs::directory_iterator(shell.folder))
        if (entry.path().extension() == ".ppm") files.push_back(entry.path().filename().string());
    if (files.empty()) return {};
    Picture picture;
    picture.file = shell.content(*std::ranges::max_element(files));
    while (true) {
        const std::size_t begin = picture.file.find("\n#");
        if (begin == std::string::npos) return picture;
        const std::size_t end = picture.file.find('\n', begin + 1);
        picture.origin += picture.file.substr(begin, end - begin);
        picture.file.erase(begin, end - begin);
    }
}

/// The file that the command which a picture records makes.
std::string made_again(Shell& shell, const Picture& picture) {
    const std::string_view sign = "made by: candelabra ";
    std::istringstream command(picture.origin.substr(picture.origin.find(sign) + sign.size()));
    Words words = {"-V"};
    for (std::string word; command >> word;)
        if (word != "scene.pov") words.push_back(word);
    const auto again = picture_of(shell, words);
    return again ? again->file : "";
}

Identity identity_with(const Words& options) {
    const std::vector<std::string_view> words(options.begin(), options.end());
    return identity_of(read({words.begin(), words.end()}), {}, {});
}

}  // namespace

TEST_CASE("every option changes what its row says", "[app]") {
    Shell shell;
    shell.write("scene.pov", sensitive_scene);
    int changed = 0;
    for (const OptionRow& row : option_table()) {
        if (!is_tried(row)) continue;
        std::string value;
        const std::optional<Sample> sample = sample_of(row, value);
        CAPTURE(name_of(row), value);
        REQUIRE(sample);
        Words usual = {"-V", "+W10", "+H8"};
        usual.insert(usual.end(), sample->beside.begin(), sample->beside.end());
        Words with = usual;
        const Words words = words_of(row, std::string(sample->value));
        with.insert(with.end(), words.begin(), words.end());
        const auto before = picture_of(shell, usual), after = picture_of(shell, with);
        INFO(shell.err);
        REQUIRE(before);
        CHECK(after);
        if (!after) continue;
        CHECK(made_again(shell, *after) == after->file);
        const bool same = before->file == after->file;
        if (row.changes == Changes::none) CHECK(same);
        if (same) continue;
        ++changed;
        const bool of_picture = row.changes != Changes::format && row.changes != Changes::samples;
        if (of_picture) CHECK(difference(identity_with(usual), identity_with(with)) != "");
    }
    CHECK(changed > 25);
}

}  // namespace candelabra
