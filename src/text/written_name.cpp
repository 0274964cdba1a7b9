// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/written_name.h"

#include "text/ascii.h"

#include <algorithm>
#include <system_error>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

bool has_ending(std::string_view name, std::string_view ending) {
    return name.size() >= ending.size() &&
           same_letters(name.substr(name.size() - ending.size()), ending);
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

std::string forbidden_name(const fs::path& part) {
    if (std::ranges::any_of(part, [](const fs::path& p) { return p.string().starts_with('.'); }))
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
