// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/written_name.h"

#include "text/ascii.h"
#include "text/message.h"
#include "text/printable.h"

#include <algorithm>
#include <array>
#include <system_error>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

bool has_ending(std::string_view name, std::string_view ending) {
    return name.size() >= ending.size() &&
           same_letters(name.substr(name.size() - ending.size()), ending);
}

/// Endings of data, of pictures that scenes write byte by byte, and of scenes. None of them is run,
/// or read without being asked for, under every name in a folder of the scene's own.
constexpr auto data_endings = std::to_array<std::string_view>(
    {"txt", "csv", "tsv", "dat", "json", "log", "tmp", "xyz", "pts", "df3", "obj",
     "ply", "stl", "off", "pgm", "ppm",  "tga", "bmp", "inc", "mcr", "pov"});

/// Letters of every script are allowed, but no sign that a shell, a list or a file system obeys.
bool is_data_character(char c) {
    return in_name(c) || c == '-' || c == '.' || static_cast<unsigned char>(c) >= 0x80;
}

bool is_plain(char c) { return c >= ' ' && c < 0x7F; }

/// Whether some file system may equate the name with another: NTFS and FAT drop trailing points and
/// blanks and have streams after `:`, others ignore invisible characters.
bool is_doubtful(std::string_view name) {
    const std::string_view ending = name.substr(std::min(name.find('.'), name.size()));
    return name.ends_with('.') || name.ends_with(' ') || name.find_first_of(":\\") != name.npos ||
           !std::ranges::all_of(ending, is_plain) ||
           std::ranges::any_of(name, [](unsigned char c) { return c < ' ' || c == 0x7F; });
}

}  // namespace

std::optional<fs::path> path_without_links(const std::string& path) {
    if (path.find('\0') != std::string::npos) return {};
    std::error_code failed;
    fs::path real = fs::weakly_canonical(fs::absolute(path.empty() ? "." : path, failed), failed);
    if (failed) return {};
    // The path of "folder/" ends in an empty part.
    if (!real.has_filename()) real = real.parent_path();
    // Parts that do not exist are kept as written, dangling links included, so look for those.
    for (fs::path part = real; part.has_relative_path(); part = part.parent_path()) {
        const fs::file_status state = fs::symlink_status(part, failed);
        if (fs::is_symlink(state)) return {};
        if (fs::exists(state)) break;
    }
    return real;
}

std::optional<fs::path> part_below(const std::string& folder, const fs::path& path) {
    const fs::path root = folder;
    const auto [mismatch, rest] = std::mismatch(root.begin(), root.end(), path.begin(), path.end());
    if (mismatch != root.end()) return {};
    fs::path part;
    for (auto each = rest; each != path.end(); ++each) part /= *each;
    return part;
}

bool names_settings(std::string_view name) { return has_ending(name, ".ini"); }

bool names_source(std::string_view name) {
    return has_ending(name, ".pov") || has_ending(name, ".inc");
}

namespace {

bool is_hidden_part(const fs::path& part) {
    return std::ranges::any_of(part, [](const fs::path& p) { return p.string().starts_with('.'); });
}

}  // namespace

std::string unread_name(const fs::path& part) {
    if (is_hidden_part(part))
        return "names that begin with a point belong to other programs and are not read";
    if (std::ranges::any_of(part.string(), [](unsigned char c) { return c < ' ' || c == 0x7F; }))
        return "names with control characters are not read";
    return {};
}

std::string forbidden_data_name(const fs::path& part) {
    if (std::string rule = forbidden_name(part); !rule.empty()) return rule;
    const std::string name = part.filename().string();
    for (const fs::path& each : part) {
        const std::string text = each.string();
        if (text.starts_with('-') || !std::ranges::all_of(text, is_data_character) ||
            printable(text) != text)
            return "a scene writes names of letters, digits, `_`, `-` and points, which do not "
                   "begin with `-`";
    }
    const std::size_t point = name.rfind('.');
    const std::string_view ending =
        point == name.npos ? std::string_view() : std::string_view(name).substr(point + 1);
    if (std::ranges::any_of(data_endings,
                            [&](std::string_view each) { return same_letters(each, ending); }))
        return {};
    std::string known;
    for (const std::string_view each : data_endings)
        known += message(known.empty() ? "" : ", ", each);
    return message("a scene writes files of data, whose names end in ", known);
}

std::string forbidden_name(const fs::path& part) {
    if (is_hidden_part(part))
        return "names that begin with a point belong to other programs and are not written";
    const std::string name = part.filename().string();
    if (is_doubtful(name))
        return "a name that ends in a point or a blank, or has signs in it that not every disk "
               "keeps, is not written";
    if (names_settings(name))
        return "INI files are never written by a scene: the next run might believe them";
    if (has_ending(name, ".state.exr"))
        return "states of pictures are never written by a scene: the next run might believe them";
    return {};
}

}  // namespace candelabra
