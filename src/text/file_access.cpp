// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/file_access.h"

#include "text/message.h"
#include "text/scene_text.h"
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
    for (const std::string& folder : writable) {
        std::error_code none;
        // A link in the place of the scene's own folder may have come with the scene.
        const bool link = writable_.empty() && fs::is_symlink(folder, none);
        writable_.push_back(link ? "" : path_without_links(folder).value_or("").string());
    }
    for (const std::string& folder : readable)
        if (const auto path = path_without_links(folder)) readable_.push_back(path->string());
    for (const std::string& folder : writable_)
        if (!folder.empty()) readable_.push_back(folder);
}

void FileAccess::reads(const SceneFolders& folders) {
    readable_.insert(readable_.end(), folders.whole.begin(), folders.whole.end());
    files_.insert(files_.end(), folders.files.begin(), folders.files.end());
    left_out_ = folders.left_out;
}

bool FileAccess::admits(const fs::path& real) const {
    const auto below = [&](const std::string& folder) {
        const auto part = part_below(folder, real);
        return part && unread_name(*part).empty();
    };
    const std::string name = real.filename().string();
    return std::ranges::any_of(readable_, below) ||
           std::ranges::any_of(files_, [&](const FolderFiles& each) {
               return real.parent_path() == each.folder && each.has(name) &&
                      unread_name(name).empty();
           });
}

std::optional<std::string> FileAccess::admitted(const std::string& path) const {
    if (!locked_) return path;
    const auto real = path_without_links(path);
    return real && admits(*real) ? std::optional(real->string()) : std::nullopt;
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

std::optional<fs::path> FileAccess::below_permitted(const fs::path& real) const {
    for (std::size_t i = 1; i < writable_.size(); ++i) {
        if (writable_[i].empty()) continue;
        if (auto part = part_below(writable_[i], real); part && !part->empty()) return part;
    }
    return std::nullopt;
}

std::optional<FileAccess::WritablePlace> FileAccess::writable_place(const std::string& name) const {
    if (writable_.empty()) return std::nullopt;
    for (const fs::path& path : {fs::path(name), fs::path(write_folder_) / name})
        if (const auto real = path_without_links(path.string()))
            if (const auto part = below_permitted(*real))
                return WritablePlace{real->string(), forbidden_name(*part)};
    const auto real = path_without_links((fs::path(write_folder_) / name).string());
    const auto part =
        real && !writable_[0].empty() ? part_below(writable_[0], *real) : std::nullopt;
    if (!part || part->empty()) return std::nullopt;
    return WritablePlace{real->string(), forbidden_data_name(*part)};
}

std::optional<std::string> FileAccess::destination(const std::string& name) const {
    if (name.empty() || name.ends_with('/')) return {};
    auto place = writable_place(name);
    if (!place || !place->rule.empty()) return {};
    return std::move(place->path);
}

bool FileAccess::overwrites(const std::string& destination) const {
    return !names_source(destination) && below_permitted(destination);
}

std::string FileAccess::rule_of_file(const std::string& destination) const {
    if (made_->may_write(destination, overwrites(destination))) return {};
    return "a scene creates files, and overwrites only those that it has made itself";
}

OpenedFile FileAccess::open(const std::string& destination, bool append) const {
    if (!below_permitted(destination)) {
        std::error_code none;  // opening the file fails, too
        fs::create_directory(writable_.front(), none);
    }
    return made_->open(destination, append, overwrites(destination));
}

std::string FileAccess::own_folder() const {
    std::error_code none;
    const bool there = !writable_.empty() && fs::is_directory(writable_.front(), none);
    return there ? write_folder_ : std::string();
}

bool FileAccess::is_of_another(const std::string& path) const {
    const auto real = locked_ ? path_without_links(path) : std::nullopt;
    return real && made_->made_by_another(real->string());
}

std::string FileAccess::reading_rule() {
    return "a scene reads files below its own folder and the folders of +L, and below the current "
           "directory if the scene lies there, but no hidden ones";
}

std::string FileAccess::left_out_note() const {
    if (left_out_.empty()) return {};
    return message("the current directory, `", left_out_,
                   "`, is not searched: a scene reads no whole home or disk");
}

std::string FileAccess::writing_rule(const std::string& name) const {
    if (writable_.empty()) return "this run writes no files";
    if (auto place = writable_place(name); place && !place->rule.empty()) return place->rule;
    if (writable_.front().empty())
        return message("`", write_folder_, "`, the folder for what the scene writes, is a link");
    const bool here = write_folder_.empty() || write_folder_ == ".";
    return message("a scene writes files only below ",
                   here ? "the current directory" : message("`", write_folder_, "`"),
                   ", and no names that begin with a point");
}

std::string FileAccess::reading_help(const std::string& path) {
    return message("`--allow-read ", clipped(folder_of(path)), "` allows it");
}

std::string FileAccess::writing_help(const std::string& name) const {
    if (!forbidden_name(fs::path(name).filename()).empty()) return {};
    const auto there = destination(name);
    if (there && names_source(*there)) return "remove that file before, or choose another name";
    return message("`--allow-write ", clipped(folder_of(name)), "` allows it",
                   there ? ", and to overwrite what others have made" : "");
}

}  // namespace candelabra
