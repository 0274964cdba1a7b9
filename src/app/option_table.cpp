// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/option_table.h"

#include "text/harmless.h"
#include "text/message.h"

#include <array>

namespace {

using enum Takes;

constexpr std::string_view one_picture = "one picture is made at a time; set clock with +K";
constexpr std::string_view whole_pictures = "only whole pictures are rendered";
constexpr std::string_view no_commands = "no commands are run";
constexpr std::string_view no_radiosity = "there is no radiosity";
constexpr std::string_view no_preview = "no preview is shown";
constexpr std::string_view kd_tree = "a kd-tree is always used";

constexpr auto offered = std::to_array<OptionRow>({
    {"I", "Input_File_Name", "", "file", value, "scene to read; - for standard input; a bare file name does the same", {}, store::scene},
    {"O", "Output_File_Name", "", "file", value,
     "picture to write; a folder keeps the scene's name; - for standard output; the ending says the format where +F does not", {},
     store::output},
    {"F", "Output_to_File", "", "x", sign_and_value,
     "format: N png (N16: 16 bits a channel), E OpenEXR and H Radiance HDR (linear), P ppm, T tga, C compressed tga, J jpeg, B bmp; "
     "-F writes no file",
     {}, store::to_file},
    {"", "Output_File_Type", "", "x", value, "the same format letters", {}, store::type},
    {"", "Bits_Per_Color", "", "n", value, "8 or 16 (png)", {}, store::bits},
    {"W", "Width", "", "n", value, "", "width"},
    {"H", "Height", "", "n", value, "", "height"},
    {"A", "Antialias", "", "t", sign_and_value,
     "spreads the camera rays over each pixel (the default) with this threshold; -A sends all through its middle", {}, store::antialias},
    {"", "Antialias_Threshold", "", "t", value, "", "antialias_threshold"},
    {"R", "Antialias_Depth", "", "n", value, "", "antialias_depth"},
    {"", "", "samples", "n", value, "", "samples"},
    {"", "", "shadow-rays", "n", value, "", "shadow_rays"},
    {"", "", "light-sampler", "name", value, "way to choose luminaires, instead of the scene's; see LIGHT SAMPLERS", {}, store::sampler},
    {"", "", "seed", "n", value, "", "seed"},
    {"WT", "Work_Threads", "threads", "n", value, "", "threads"},
    {"L", "Library_Path", "", "folder", value, "folder to look for included files in; may be given several times", {},
     store::library},
    {"", "Declare", "", "name=value", value, "declares a name for the scene: a number, or a string in quotes", {}, store::declare},
    {"K", "Clock", "", "n", value, "value of clock in the scene", {}, store::clock},
    {"V", "Verbose", "", "", sign, "progress and a summary (the default); -V: warnings and errors only", {},
     store::verbose},
    {"", "", "check", "syntax", maybe_value, "everything but rendering; =syntax: reads the scene, but does not evaluate it", {}, store::check},
    {"", "", "dump", "stage", value, "prints what the scene is at a stage: tokens, tree, scene or world", {}, store::dump},
    {"", "", "stats", "file", value, "writes what the run cost as JSON; - for standard output", {},
     store::stats},
    {"", "", "help", "topic", maybe_words, "this text, or what there is to say about an option, an item or a group of items", {}, store::help},
    {"", "", "version", "", nothing, "name and version", {},
     store::version},
    {"", "", "describe", "form part", maybe_words,
     "options and vocabulary as text, roff or json; part: items, functions, options, compatibility or words", {}, store::describe},
    {"D", "Display", "", "", sign_and_value, "accepted without effect: no preview is shown", {}, nullptr, Unoffered::accepted},
    {"P", "Pause_When_Done", "", "", sign, "accepted without effect", {}, nullptr, Unoffered::accepted},
    {"Q", "Quality", "", "n", value, "9 to 11 are what is offered; less is ignored with a warning", {}, store::quality},
    {"", "File_Gamma", "", "g", value, "sRGB is what is offered", {}, store::gamma},
    {"HR", "High_Reproducibility", "", "", sign, "pictures are always reproducible", {}, nullptr, Unoffered::accepted},
    {"AM", "Sampling_Method", "", "n", value, "one method is offered, which is adaptive", {}, nullptr, Unoffered::ignored},
    {"AG", "Antialias_Gamma", "", "g", value, "noise is judged as displayed", {}, nullptr, Unoffered::ignored},
    {"J", "Jitter", "", "a", sign_and_value, "camera rays are always spread at random", {}, nullptr, Unoffered::ignored},
    {"", "Jitter_Amount", "", "a", value, "camera rays are always spread over the whole pixel", {}, nullptr, Unoffered::ignored},
    {"BS", "Render_Block_Size", "", "n", value, "", {}, nullptr, Unoffered::ignored},
    {"RP", "Render_Pattern", "", "n", value, "", {}, nullptr, Unoffered::ignored},
    {"RS", "Render_Block_Step", "", "n", value, "", {}, nullptr, Unoffered::ignored},
    {"SP", "Preview_Start_Size", "", "n", value, no_preview, {}, nullptr, Unoffered::ignored},
    {"EP", "Preview_End_Size", "", "n", value, no_preview, {}, nullptr, Unoffered::ignored},
    {"X", "Test_Abort", "", "n", sign_and_value, "Ctrl-C stops", {}, nullptr, Unoffered::ignored},
    {"", "Test_Abort_Count", "", "n", value, "Ctrl-C stops", {}, nullptr, Unoffered::ignored},
    {"MB", "Bounding", "", "n", sign_and_value, kd_tree, {}, nullptr, Unoffered::ignored},
    {"", "Bounding_Threshold", "", "n", value, kd_tree, {}, nullptr, Unoffered::ignored},
    {"BM", "Bounding_Method", "", "n", value, kd_tree, {}, nullptr, Unoffered::ignored},
    {"UR", "Remove_Bounds", "", "", sign, "", {}, nullptr, Unoffered::ignored},
    {"SU", "Split_Unions", "", "", sign, "", {}, nullptr, Unoffered::ignored},
    {"UL", "Light_Buffer", "", "", sign, "", {}, nullptr, Unoffered::ignored},
    {"UV", "Vista_Buffer", "", "", sign, "", {}, nullptr, Unoffered::ignored},
    {"RVP", "Radiosity_Vain_Pretrace", "", "", sign, "", {}, nullptr, Unoffered::ignored},
    {"MI", "Max_Image_Buffer_Memory", "", "n", value, "", {}, nullptr, Unoffered::ignored},
    {"WL", "Warning_Level", "", "n", value, "all warnings are given", {}, nullptr, Unoffered::ignored},
    {"SS", "Stochastic_Seed", "", "n", value, "see --seed", {}, nullptr, Unoffered::ignored},
    {"AC", "Antialias_Confidence", "", "n", value, "", {}, nullptr, Unoffered::ignored},
    {"", "Display_Gamma", "", "g", value, no_preview, {}, nullptr, Unoffered::ignored},
    {"GA", "All_Console", "", "", sign_and_value, "see -V", {}, nullptr, Unoffered::ignored},
    {"GD", "Debug_Console", "", "file", sign_and_value, "see -V", {}, nullptr, Unoffered::ignored},
    {"GF", "Fatal_Console", "", "file", sign_and_value, "see -V", {}, nullptr, Unoffered::ignored},
    {"GR", "Render_Console", "", "file", sign_and_value, "see -V", {}, nullptr, Unoffered::ignored},
    {"GS", "Statistic_Console", "", "file", sign_and_value, "see --stats", {}, nullptr, Unoffered::ignored},
    {"GW", "Warning_Console", "", "file", sign_and_value, "see -V", {}, nullptr, Unoffered::ignored},
    {"SR", "Start_Row", "", "n", value, whole_pictures, {}, nullptr, Unoffered::refused},
    {"ER", "End_Row", "", "n", value, whole_pictures, {}, nullptr, Unoffered::refused},
    {"SC", "Start_Column", "", "n", value, whole_pictures, {}, nullptr, Unoffered::refused},
    {"EC", "End_Column", "", "n", value, whole_pictures, {}, nullptr, Unoffered::refused},
    {"C", "Continue_Trace", "", "", sign, "a stopped rendering cannot be continued", {}, nullptr, Unoffered::refused},
    {"UA", "Output_Alpha", "", "", sign, "pictures have no alpha channel", {}, nullptr, Unoffered::refused},
    {"", "Grayscale_Output", "", "", sign, "pictures have colours", {}, nullptr, Unoffered::refused},
    {"TH", "Dither", "", "x", sign_and_value, "pictures are not dithered", {}, nullptr, Unoffered::refused},
    {"", "Dither_Method", "", "x", value, "pictures are not dithered", {}, nullptr, Unoffered::refused},
    {"HI", "Include_Header", "", "file", value, "write #include into the scene", {}, nullptr, Unoffered::refused},
    {"MV", "Version", "", "n", value, "write #version into the scene", {}, nullptr, Unoffered::refused},
    {"GI", "Create_Ini", "", "file", sign_and_value, "", {}, nullptr, Unoffered::refused},
    {"KFI", "Initial_Frame", "", "n", value, one_picture, {}, nullptr, Unoffered::refused},
    {"KFF", "Final_Frame", "", "n", value, one_picture, {}, nullptr, Unoffered::refused},
    {"KI", "Initial_Clock", "", "n", value, one_picture, {}, nullptr, Unoffered::refused},
    {"KF", "Final_Clock", "", "n", value, one_picture, {}, nullptr, Unoffered::refused},
    {"SF", "Subset_Start_Frame", "", "n", value, one_picture, {}, nullptr, Unoffered::refused},
    {"EF", "Subset_End_Frame", "", "n", value, one_picture, {}, nullptr, Unoffered::refused},
    {"STP", "Frame_Step", "", "n", value, one_picture, {}, nullptr, Unoffered::refused},
    {"KC", "Cyclic_Animation", "", "", sign, one_picture, {}, nullptr, Unoffered::refused},
    {"UF", "Field_Render", "", "", sign, "", {}, nullptr, Unoffered::refused},
    {"UO", "Odd_Field", "", "", sign, "", {}, nullptr, Unoffered::refused},
    {"RF", "Radiosity_File_Name", "", "file", value, no_radiosity, {}, nullptr, Unoffered::refused},
    {"RFI", "Radiosity_From_File", "", "", sign, no_radiosity, {}, nullptr, Unoffered::refused},
    {"RFO", "Radiosity_To_File", "", "", sign, no_radiosity, {}, nullptr, Unoffered::refused},
    {"", "Pre_Scene_Command", "", "command", value, no_commands, {}, nullptr, Unoffered::refused},
    {"", "Pre_Frame_Command", "", "command", value, no_commands, {}, nullptr, Unoffered::refused},
    {"", "Post_Scene_Command", "", "command", value, no_commands, {}, nullptr, Unoffered::refused},
    {"", "Post_Frame_Command", "", "command", value, no_commands, {}, nullptr, Unoffered::refused},
    {"", "User_Abort_Command", "", "command", value, no_commands, {}, nullptr, Unoffered::refused},
    {"", "Fatal_Error_Command", "", "command", value, no_commands, {}, nullptr, Unoffered::refused},
});

}  // namespace

std::span<const OptionRow> option_table() {
    return offered;
}

void apply(const OptionRow& row, Options& options, const Given& given, Diagnostics& diagnostics) {
    const std::string why = row.help.empty() ? "" : message(": ", row.help);
    switch (row.unoffered) {
        case Unoffered::no: break;
        case Unoffered::accepted: return;
        case Unoffered::ignored:
            diagnostics.add(warning(Fault::option, {}, message("`", harmless(given.argument), "` is ignored", why)));
            return;
        case Unoffered::refused:
            if (given.on) refuse(given, diagnostics, message("is not offered", why));
            return;
    }
    if (row.store) row.store(options, given, diagnostics);
    else store::field(row.field, options, given, diagnostics);
}

ManualEntry manual_entry(const OptionRow& row) {
    const bool valued = row.takes == value;
    std::string term;
    const auto add = [&](const std::string& piece) { term += (term.empty() ? "" : ", ") + piece; };
    if (!row.letters.empty()) {
        add(message("+", row.letters, row.parameter));
        if (row.takes == sign || row.takes == sign_and_value) add(message("-", row.letters));
    }
    if (!row.keyword.empty()) add(message(row.keyword, "=", valued ? row.parameter : "on"));
    if (!row.word.empty()) {
        const std::string_view open = row.takes == maybe_value ? "[=" : valued ? " " : " [";
        add(row.parameter.empty() ? message("--", row.word) : message("--", row.word, open, row.parameter, valued ? "" : "]"));
    }
    if (row.field.empty()) return {term, std::string(row.help)};
    const std::size_t field = settings_field(row.field);
    return {term, message(item_info<RenderSettings>().fields[field].help, " (", values(item_info<RenderSettings>(), field), ")")};
}
