// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/output.h"

#include "picture/file.h"
#include "text/ascii.h"
#include "text/message.h"
#include "text/printable.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <string_view>
#include <system_error>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

std::string scene_stem(const Options& options) {
    const std::string scene = options.scene.value_or("-");
    return scene == "-" ? "stdin" : fs::path(scene).stem().string();
}

bool is_folder(const std::string& path) {
    std::error_code none;
    return path.ends_with('/') || fs::is_directory(path, none);
}

std::string path_of(const Options& options, PictureType type) {
    const std::string& given = options.output;
    const std::string ending = message('.', extension(type));
    if (given.empty()) return scene_stem(options) + ending;
    if (is_stream(given)) return given;
    if (is_folder(given)) return (fs::path(given) / (scene_stem(options) + ending)).string();
    return type_of_name(given) == type ? given : given + ending;
}

/// Returns the extension of a format that other programs write but this one does not; empty for
/// others.
std::string other_format(const std::string& path) {
    static constexpr auto others = std::to_array<std::string_view>(
        {"apng", "avi", "avif", "cin", "dds", "dpx", "eps",  "fits", "gif", "heic",
         "heif", "ico", "iff",  "j2k", "jp2", "jpc", "jpx",  "jxl",  "jxr", "mkv",
         "mov",  "mp4", "pam",  "pbm", "pcx", "pdf", "pfm",  "pgm",  "pic", "ps",
         "psb",  "psd", "qoi",  "rgb", "sgi", "svg", "webm", "xbm",  "xcf", "xpm"});
    const std::string ending = lower_case(fs::path(path).extension().string());
    const bool other = ending.size() > 1 && std::ranges::binary_search(others, ending.substr(1));
    return other ? ending.substr(1) : std::string();
}

/// Returns the formats for which something holds, with their options, as a help says it.
template <class Holds>
std::string formats_with(const Holds& holds) {
    std::string text;
    for (const PictureTypeInfo& each : picture_types())
        if (holds(each))
            text += message(text.empty() ? "" : ", ", "+F", each.letter, ' ', each.name);
    return text;
}

/// The endings of file names that choose a format.
std::string endings() {
    std::string text;
    for (const PictureTypeInfo& each : picture_types())
        text += message(text.empty() ? "" : ", ", each.extension);
    return text;
}

}  // namespace

std::array<std::string*, 5> files_beside(Options& options) {
    return {&options.stats_file, &options.depfile, &options.kept_lights, &options.readings_file,
            &options.mesh_file};
}

bool is_stream(const std::string& path) {
    if (path == "-") return true;
    std::error_code none;
    const fs::file_status status = fs::status(path, none);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

namespace {

/// Returns the name of a draft, so that a draft never replaces the picture: "a.draft.png" for
/// "a.png". The names of a film's frames have it already.
std::string draft_path(const std::string& path) {
    const fs::path whole(path);
    const std::string stem = whole.stem().string();
    if (is_stream(path) || stem.find(".draft") != stem.npos) return path;
    return fs::path(whole)
        .replace_filename(message(stem, ".draft", whole.extension().string()))
        .string();
}

}  // namespace

Output output_of(const Options& options, Diagnostics& diagnostics) {
    Output output;
    output.format.type =
        options.type.value_or(type_of_name(options.output).value_or(PictureType::png));
    // Greys are usually heights, of which 256 are too few.
    const bool heights = options.grey && info(output.format.type).wide;
    output.format.bits = options.bits.value_or(heights ? 16 : 8);
    output.format.compressed = options.compressed;
    output.format.grey = options.grey;
    output.format.file_gamma = options.file_gamma;
    output.path = path_of(options, output.format.type);
    if (options.draft) output.path = draft_path(output.path);
    if (const auto other = other_format(options.output); !other.empty() && !options.type)
        diagnostics.add(error(Fault::option, {},
                              message("pictures are not written as ", other, ", the kind of `",
                                      printable(options.output), "`"))
                            .with_help(message("by the ending of the name: ", endings(),
                                               "; a film of frames is made by --movie")));
    const auto refuse = [&](std::string_view what, std::string help) {
        diagnostics.add(error(Fault::option, {},
                              message("a file of format ", extension(output.format.type), what))
                            .with_help(std::move(help)));
    };
    const PictureTypeInfo& type = info(output.format.type);
    if (options.alpha && !type.alpha)
        refuse(" has no alpha channel", formats_with(std::mem_fn(&PictureTypeInfo::alpha)));
    if (options.grey && !type.grey)
        refuse(" is not written in grey", formats_with(std::mem_fn(&PictureTypeInfo::grey)));
    const bool stored = options.to_file && !is_stream(output.path);
    const bool layered = output.format.type == PictureType::exr && options.to_file;
    if (!options.layers.empty() && !stored && !layered && !options.for_caller)
        diagnostics.add(
            error(Fault::option, {}, "layers need a file").with_help("+Oa.exr or +Oa.png"));
    if (output.format.bits == 16 && !type.wide)
        refuse(" cannot have 16 bits a channel",
               message(formats_with(std::mem_fn(&PictureTypeInfo::wide)),
                       "; +FE OpenEXR has 32 bits"));
    return output;
}

std::string own_folder(const Output& output, const Options& options) {
    const std::string name = scene_stem(options) + ".files";
    return is_stream(output.path) ? name : (fs::path(output.path).parent_path() / name).string();
}

std::string problem_with_output(const Options& options, const std::string& path) {
    if (path.empty()) return {};
    std::error_code none;
    if (options.scene && fs::equivalent(path, *options.scene, none))
        return message("`", printable(path), "` is the scene itself");
    if (options.strange_names && fs::is_symlink(path, none))
        return message("`", printable(path),
                       "` is a link, and names in an INI file that may have come with the scene "
                       "are not to lead elsewhere");
    return problem_with_destination(path);
}

}  // namespace candelabra
