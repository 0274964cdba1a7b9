// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/door.h"

#include "text/message.h"

#include <algorithm>
#include <filesystem>

namespace {

namespace fs = std::filesystem;

/// The absolute path without links and `..`, or nothing if that cannot be told.
std::optional<fs::path> resolved(const std::string& path) {
    if (path.find('\0') != std::string::npos) return {};
    std::error_code failed;
    fs::path real = fs::weakly_canonical(fs::absolute(path.empty() ? "." : path, failed), failed);
    if (failed) return {};
    // "folder/" ends in an empty part.
    if (!real.has_filename()) real = real.parent_path();
    return real;
}

/// The part of the path below the folder, or nothing if it lies elsewhere.
std::optional<fs::path> below(const std::string& folder, const fs::path& path) {
    const fs::path root = folder;
    const auto [mismatch, rest] = std::mismatch(root.begin(), root.end(), path.begin(), path.end());
    if (mismatch != root.end()) return {};
    fs::path part;
    for (auto each = rest; each != path.end(); ++each) part /= *each;
    return part;
}

bool has_hidden_part(const fs::path& path) {
    return std::any_of(path.begin(), path.end(),
                       [](const fs::path& part) { return part.string().starts_with('.'); });
}

std::string folder_of(const std::string& path) {
    const std::string folder = fs::path(path).parent_path().string();
    return folder.empty() ? "." : folder;
}

}  // namespace

Door::Door(const std::vector<std::string>& readable, std::vector<std::string> writable)
    : write_folder_(writable.empty() ? std::string() : writable.front()), locked_(true) {
    for (const std::string& folder : writable)
        if (const auto path = resolved(folder)) writable_.push_back(path->string());
    readable_ = writable_;
    for (const std::string& folder : readable)
        if (const auto path = resolved(folder)) readable_.push_back(path->string());
}

bool Door::may_read(const std::string& path) const {
    if (!locked_) return true;
    const auto real = resolved(path);
    return real && std::any_of(readable_.begin(), readable_.end(), [&](const std::string& folder) {
               return below(folder, *real).has_value();
           });
}

std::optional<std::string> Door::destination(const std::string& name) const {
    if (name.empty() || name.ends_with('/')) return {};
    const auto real = resolved((fs::path(write_folder_) / name).string());
    if (!real) return {};
    for (const std::string& folder : writable_)
        if (const auto part = below(folder, *real); part && !part->empty())
            return has_hidden_part(*part) ? std::nullopt : std::optional(real->string());
    return {};
}

std::string Door::reading_rule() const {
    return "a scene reads files below its own folder, the current directory, the folder of its "
           "picture and the folders of +L";
}

std::string Door::writing_rule() const {
    if (writable_.empty()) return "this run writes no files";
    const bool here = write_folder_.empty() || write_folder_ == ".";
    return message("a scene writes files only below the folder of its picture, ",
                   here ? "the current directory" : message("`", write_folder_, "`"),
                   ", and no names that begin with a point");
}

std::string Door::reading_help(const std::string& path) {
    return message("`--allow-read ", folder_of(path), "` allows it");
}

std::string Door::writing_help(const std::string& path) {
    return message("`--allow-write ", folder_of(path), "` allows it");
}
