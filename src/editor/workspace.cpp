// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/workspace.h"

#include <algorithm>

namespace candelabra {

void Workspace::open(const std::string& path, std::string text) {
    documents_[path] = std::move(text);
}

void Workspace::close(const std::string& path) {
    documents_.erase(path);
    read_.erase(path);
}

std::vector<std::string> Workspace::open_files() const {
    std::vector<std::string> paths;
    for (const auto& [path, text] : documents_) paths.push_back(path);
    return paths;
}

Reader Workspace::reader(const FileAccess& access) const {
    const Reader disk = scene_reader(access);
    const auto read = [this, disk](const std::string& path) -> std::optional<std::string> {
        const auto document = documents_.find(path);
        if (document != documents_.end()) return document->second;
        return disk(path);
    };
    return {read, [this, disk](const std::string& path) {
                return documents_.contains(path) || disk.holds(path);
            }};
}

Loader Workspace::loader(const std::string& folder) const {
    FileAccess access(library_.empty() ? std::vector<std::string>() : std::vector{library_}, {});
    access.reads(scene_folders(folder, {}));
    for (const auto& [path, text] : documents_) access.reads(scene_folders(directory_of(path), {}));
    return loader(folder, access);
}

Loader Workspace::loader(const std::string& folder, const FileAccess& access) const {
    std::vector<std::string> library;
    if (!library_.empty()) library = {library_, library_ + "/pictures"};
    Loader result(reader(access), folder, std::move(library), access, disk_lister());
    result.set_standard_library(library_);
    return result;
}

bool Workspace::in_library(const std::string& path) const {
    return !library_.empty() && path.starts_with(library_ + "/");
}

FileHandle Workspace::file(const std::string& path) {
    std::optional<std::string> text = reader(FileAccess())(path);
    if (!text) return nullptr;
    FileHandle& known = read_[path];
    if (!known || known->text != *text) {
        EditedFile file = read_tokens(std::move(*text), names_);
        file.path = path;
        known = std::make_shared<const EditedFile>(std::move(file));
    }
    return known;
}

void Workspace::add_with_includes(const std::string& path, const std::string& folder,
                                  std::vector<FileHandle>& files) {
    if (files.size() >= max_files) return;
    const FileHandle one = file(path);
    if (!one || std::ranges::find(files, one) != files.end()) return;
    files.push_back(one);
    for (const std::string& name : one->includes)
        if (const auto found = loader(folder).load(name, directory_of(path)))
            add_with_includes(found->path, folder, files);
}

std::vector<FileHandle> Workspace::around(const std::string& path) {
    std::vector<FileHandle> files;
    add_with_includes(path, directory_of(path), files);
    for (const std::string& other : open_files())
        add_with_includes(other, directory_of(other), files);
    return files;
}

std::vector<Workspace::Found> Workspace::declarations(NameId name, const std::string& path,
                                                      std::uint32_t offset) {
    std::vector<Found> found;
    for (const FileHandle& file : around(path)) {
        const std::size_t before = found.size();
        for (const DeclaredName& each : file->declarations)
            if (each.name == name) found.push_back({file, &each});
        if (file->path != path) continue;
        const auto below = [&](const Found& one) { return one.declaration->place.first > offset; };
        const auto own = found.begin() + static_cast<std::ptrdiff_t>(before);
        const auto first_below = std::find_if(own, found.end(), below);
        std::reverse(own, first_below);
    }
    return found;
}

}  // namespace candelabra
