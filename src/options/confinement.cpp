// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/confinement.h"

#include "options/memory_limit.h"
#include "text/loader.h"
#include "text/message.h"
#include "text/opened_file.h"
#include "text/printable.h"
#include "text/scene_folders.h"
#include "text/written_name.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <system_error>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

constexpr auto own_settings =
    "on the command line, or in the settings of your own that lie in "
    "~/.config/candelabra/candelabra.ini";

void add_real(std::vector<std::string>& folders, const std::string& folder) {
    if (const auto real = path_without_links(folder)) folders.push_back(real->string());
}

/// Returns the part of a path below one of the folders.
std::optional<fs::path> below_one(const std::vector<std::string>& folders, const fs::path& path) {
    for (const std::string& folder : folders) {
        auto part = part_below(folder, path);
        // The first is that of the INI file. Of a whole home or disk, only the files that lie
        // directly in it are the INI file's.
        std::error_code none;
        const bool deep = path.parent_path() != folder || fs::is_directory(path, none);
        if (part && !(&folder == &folders.front() && deep && is_wide(folder))) return part;
    }
    return std::nullopt;
}

/// Whether the value of an option for file names means no file or the default one.
bool is_switch_word(const OptionRow& row, const std::string& value) {
    const bool may_be = row.keyword.ends_with("_File") || row.keyword == "Create_Ini";
    return value.empty() || (may_be && truth(value));
}

/// The way out for a path outside of the folders that are permitted.
std::string permission(std::string_view option, const std::string& path) {
    std::error_code none;
    return message("name it on the command line, or permit it there: ", option, ' ',
                   printable(fs::is_directory(path, none) ? path : directory_of(path)));
}

/// Whether a name is searched for in folders that the scene may read in any case.
bool is_searched(const std::string& name) {
    const fs::path path(name);
    return path.is_relative() && std::ranges::find(path, fs::path("..")) == path.end();
}

}  // namespace

Confinement::Confinement(const std::string& ini_file, const Options& outside)
    : folder_(directory_of(ini_file)),
      limits_(outside.limits),
      memory_bytes_(outside.memory_bytes.value_or(
          usual_memory_limit().value_or(std::numeric_limits<std::uint64_t>::max()))) {
    add_real(writable_, folder_);
    for (const std::string& folder : outside.writable) add_real(writable_, folder);
    readable_ = writable_;
    for (const std::string& folder : outside.readable) add_real(readable_, folder);
}

std::string Confinement::folder_rule() const {
    return message("it leads out of ",
                   folder_ == "." ? "the current directory" : message("`", printable(folder_), "`"),
                   ", the folder of this INI file, which may have come with a scene");
}

BrokenRule Confinement::of_file(const std::string& path) const {
    const auto real = path == "-" ? std::nullopt : path_without_links(path);
    const auto part = real ? below_one(readable_, *real) : std::nullopt;
    if (!part) return {folder_rule(), permission("--allow-read", path)};
    if (const std::string rule = unread_name(*part); !rule.empty()) return {rule, {}};
    std::error_code none;
    if (fs::is_other(*real, none)) return {"it is no regular file", {}};
    return {};
}

BrokenRule Confinement::of_read(const std::string& path) const {
    BrokenRule broken = of_file(path);
    return broken.rule.empty() ? of_file(path + ".pov") : broken;
}

BrokenRule Confinement::of_written(const std::string& path, bool ini) const {
    if (path == "-") return {};
    const auto real = path_without_links(path);
    const auto part = real ? below_one(writable_, *real) : std::nullopt;
    if (!part) return {folder_rule(), permission("--allow-write", path)};
    std::error_code none;
    const bool there = fs::exists(*real, none);
    if (fs::is_directory(*real, none)) return {};
    if (ini && there) return {"there is such a file already", "name it on the command line"};
    fs::path name = *part;
    if (ini && names_settings(name.string())) name.replace_extension(".txt");
    if (const std::string rule = forbidden_name(name); !rule.empty()) return {rule, {}};
    if (there && names_source(real->string()))
        return {"it would overwrite a scene or a part of one", {}};
    if (there && (!fs::is_regular_file(*real, none) || fs::hard_link_count(*real, none) > 1))
        return {"it is no regular file, or has another name, too", {}};
    return {};
}

BrokenRule Confinement::of_option(const OptionRow& row, const Given& given) const {
    const std::string path = given.value.value_or("");
    switch (row.touches) {
        case Touches::nothing:
            return {};
        case Touches::permits:
            return {message("this is said ", own_settings), {}};
        case Touches::reads:
            return row.store == store::scene ? of_read(path) : of_file(path);
        case Touches::searches:
            return is_searched(path) ? BrokenRule() : of_file(path);
        case Touches::writes:
            return is_switch_word(row, path) ? BrokenRule() : of_written(path, false);
        case Touches::writes_ini:
            return is_switch_word(row, path) ? BrokenRule() : of_written(path, true);
    }
    return {};
}

bool Confinement::exceeded(const Options& options) const {
    return !options.limits.within(limits_) ||
           options.memory_bytes.value_or(memory_bytes_) > memory_bytes_;
}

std::string Confinement::limit_rule() {
    return message("limits are not raised by a file that may have come with a scene, but ",
                   own_settings);
}

}  // namespace candelabra
