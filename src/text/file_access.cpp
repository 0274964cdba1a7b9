// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/file_access.h"

#include "text/message.h"
#include "text/written_name.h"

#include <algorithm>
#include <system_error>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

std::string folder_of(const std::string& path) {
    const std::string folder = fs::path(path).parent_path().string();
    return folder.empty() ? "." : folder;
}

}  // namespace

FileAccess::FileAccess(const std::vector<std::string>& readable, std::vector<std::string> writable)
    : write_folder_(writable.empty() ? std::string() : writable.front()), locked_(true) {
    for (const std::string& folder : writable)
        writable_.push_back(path_without_links(folder).value_or("").string());
    for (const std::string& folder : readable)
        if (const auto path = path_without_links(folder)) readable_.push_back(path->string());
    for (const std::string& folder : writable_)
        if (!folder.empty()) readable_.push_back(folder);
}

std::optional<std::string> FileAccess::admitted(const std::string& path) const {
    if (!locked_) return path;
    const auto real = path_without_links(path);
    const bool allowed = real && std::ranges::any_of(readable_, [&](const std::string& folder) {
                             return part_below(folder, *real).has_value();
                         });
    return allowed ? std::optional(real->string()) : std::nullopt;
}

std::optional<std::string> FileAccess::place(const std::string& path) const {
    if (locked_) return admitted(path);
    const auto real = path_without_links(path);
    return real ? std::optional(real->string()) : std::nullopt;
}

bool FileAccess::is_special(const std::string& path) const {
    if (!locked_) return false;
    const auto real = admitted(path);
    std::error_code none;
    return real && fs::is_other(*real, none);
}

std::optional<std::size_t> FileAccess::writable_folder(const std::string& real) const {
    for (std::size_t i = 0; i < writable_.size(); ++i) {
        if (writable_[i].empty()) continue;
        if (const auto part = part_below(writable_[i], real); part && !part->empty()) return i;
    }
    return std::nullopt;
}

std::optional<std::string> FileAccess::destination(const std::string& name) const {
    if (name.empty() || name.ends_with('/')) return {};
    const auto real = path_without_links((fs::path(write_folder_) / name).string());
    const auto folder = real ? writable_folder(real->string()) : std::nullopt;
    if (!folder || !forbidden_name(*part_below(writable_[*folder], *real)).empty()) return {};
    return real->string();
}

bool FileAccess::overwrites(const std::string& destination) const {
    if (names_source(destination)) return false;
    for (std::size_t i = 1; i < writable_.size(); ++i)
        if (!writable_[i].empty() && part_below(writable_[i], destination)) return true;
    return false;
}

std::string FileAccess::rule_of_file(const std::string& destination) const {
    if (made_->may_write(destination, overwrites(destination))) return {};
    return "a scene creates files, and overwrites only those that it has made itself";
}

OpenedFile FileAccess::open(const std::string& destination, bool append) const {
    return made_->open(destination, append, overwrites(destination));
}

std::string FileAccess::reading_rule() const {
    return "a scene reads files below its own folder, the current directory, the folder of its "
           "picture and the folders of +L";
}

std::string FileAccess::writing_rule(const std::string& name) const {
    if (writable_.empty()) return "this run writes no files";
    if (const auto real = path_without_links((fs::path(write_folder_) / name).string()))
        if (const auto folder = writable_folder(real->string()))
            if (std::string rule = forbidden_name(*part_below(writable_[*folder], *real));
                !rule.empty())
                return rule;
    const bool here = write_folder_.empty() || write_folder_ == ".";
    return message("a scene writes files only below the folder of its picture, ",
                   here ? "the current directory" : message("`", write_folder_, "`"),
                   ", and no names that begin with a point");
}

std::string FileAccess::reading_help(const std::string& path) {
    return message("`--allow-read ", folder_of(path), "` allows it");
}

std::string FileAccess::writing_help(const std::string& name) const {
    if (!forbidden_name(fs::path(name).filename()).empty()) return {};
    const auto there = destination(name);
    if (there && names_source(*there)) return "remove that file before, or choose another name";
    return message("`--allow-write ", folder_of(name), "` allows it",
                   there ? ", and to overwrite what others have made" : "");
}

}  // namespace candelabra
