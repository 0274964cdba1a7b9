// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/loader.h"

#include "text/ascii.h"
#include "text/message.h"
#include "text/opened_file.h"
#include "text/scene_text.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include <fcntl.h>

namespace candelabra {

namespace {

// Spans hold 32-bit offsets (text/span.h).
constexpr std::size_t longest_text = std::numeric_limits<std::uint32_t>::max() - 1;

bool is_absolute(const std::string& name) { return name.starts_with('/'); }

/// Returns a canonical spelling of the folder, so that none is searched twice: "" is the current
/// directory.
std::string plain_directory(std::string directory) {
    while (directory.size() > 1 && directory.ends_with('/')) directory.pop_back();
    while (directory.starts_with("./")) directory.erase(0, 2);
    return directory == "." ? std::string() : directory;
}

std::string inside(const std::string& directory, const std::string& name) {
    if (directory.empty()) return name;
    return directory.ends_with('/') ? directory + name : directory + '/' + name;
}

/// An unknown extension is more likely part of a name whose .inc was omitted.
std::vector<std::string> candidates(const std::string& name, FileKind kind) {
    if (name.empty() || name.ends_with('/')) return {};
    if (kind == FileKind::data) return {name};
    const bool known = name.ends_with(".inc") || name.ends_with(".INC");
    if (known) return {name, name + ".inc", name + ".INC"};
    return {name + ".inc", name + ".INC", name};
}

void add_once(std::vector<std::string>& list, std::string entry) {
    if (std::find(list.begin(), list.end(), entry) == list.end()) list.push_back(std::move(entry));
}

}  // namespace

Reader disk_reader() {
    return {[](const std::string& path) { return content_of_file(path, longest_text); },
            [](const std::string& path) { return is_regular_file(path); }, scene_reader};
}

Reader scene_reader(const FileAccess& access) {
    const auto read = [access](const std::string& path) -> std::optional<std::string> {
        const auto real = path.empty() ? std::nullopt : access.place(path);
        // Only regular files are opened; a file that becomes another kind in the meantime is not
        // read.
        if (!real || !is_regular_file(*real)) return {};
        return content_of(open_without_links(*real, O_RDONLY), longest_text);
    };
    const auto holds = [access](const std::string& path) {
        const auto real = path.empty() ? std::nullopt : access.place(path);
        return real && is_regular_file(*real);
    };
    return {read, holds};
}

std::string directory_of(const std::string& path) {
    const std::size_t slash = path.find_last_of('/');
    if (slash == std::string::npos) return ".";
    return path.substr(0, std::max<std::size_t>(slash, 1));
}

Loader::Loader(Reader reader, std::string scene_directory, std::vector<std::string> library_paths,
               FileAccess access, Lister lister)
    : reader_(std::move(reader)),
      scene_directory_(std::move(scene_directory)),
      library_paths_(std::move(library_paths)),
      access_(std::move(access)),
      lister_(std::move(lister)) {}

std::vector<std::string> Loader::places(const std::string& name,
                                        const std::string& including_directory) const {
    if (is_absolute(name)) return {""};
    std::vector<std::string> places;
    // Files of a library, too, find their includes in the libraries in their order: files that come
    // with POV-Ray find those of the standard library.
    const std::string including = plain_directory(including_directory);
    const bool in_library =
        !including.empty() && std::ranges::any_of(library_paths_, [&](const std::string& path) {
            return plain_directory(path) == including;
        });
    if (!including_directory.empty() && !in_library) add_once(places, including);
    if (!scene_directory_.empty()) add_once(places, plain_directory(scene_directory_));
    add_once(places, "");
    if (const std::string own = access_.own_folder(); !own.empty())
        add_once(places, plain_directory(own));
    for (const std::string& path : library_paths_) add_once(places, plain_directory(path));
    return places;
}

std::vector<std::string> Loader::searched(const std::string& name,
                                          const std::string& including_directory,
                                          FileKind kind) const {
    std::vector<std::string> paths;
    const auto folders = places(name, including_directory);
    for (const std::string& candidate : candidates(name, kind)) {
        if (const auto own = written_.empty() ? std::nullopt : access_.destination(candidate);
            own && written_.contains(*own))
            add_once(paths, *own);
        for (const std::string& folder : folders) add_once(paths, inside(folder, candidate));
    }
    return paths;
}

std::optional<Found> Loader::load(const std::string& name, const std::string& including_directory,
                                  FileKind kind) const {
    std::vector<std::string> passed_over;
    for (std::string& path : searched(name, including_directory, kind)) {
        if (!access_.may_read(path)) continue;
        if (const auto own = written_.find(path); own != written_.end() && own->second)
            return Found{std::move(path), *own->second};
        if (passes_over(path, kind))
            passed_over.push_back(std::move(path));
        else if (auto text = reader_(path))
            return Found{std::move(path), std::move(*text), std::move(passed_over)};
    }
    return {};
}

std::string Loader::searched_note(const std::string& name,
                                  const std::string& including_directory) const {
    if (is_absolute(name)) return "an absolute name is looked for in its own place only";
    std::string note;
    for (const std::string& folder : places(name, including_directory)) {
        note += note.empty() ? "looked in " : ", ";
        note += folder.empty() ? "the current directory" : message("`", folder, "`");
    }
    return note;
}

std::optional<std::string> Loader::closed_path(const std::string& name,
                                               const std::string& including_directory,
                                               FileKind kind) const {
    for (const std::string& folder : places(name, including_directory)) {
        // The loader does not search folders that the scene may not read.
        if (!is_absolute(name) && !access_.may_read(folder)) continue;
        for (const std::string& candidate : candidates(name, kind))
            if (std::string path = inside(folder, candidate); !access_.may_read(path)) return path;
    }
    return {};
}

std::optional<std::string> Loader::odd_path(const std::string& name,
                                            const std::string& including_directory,
                                            FileKind kind) const {
    for (const std::string& path : searched(name, including_directory, kind))
        if (access_.is_special(path)) return path;
    return {};
}

std::vector<std::string> Loader::listed(const std::string& folder) const {
    return access_.may_read(folder) ? lister_(folder) : std::vector<std::string>();
}

std::optional<std::string> Loader::located(const std::string& name,
                                           const std::string& including_directory,
                                           FileKind kind) const {
    for (std::string& path : searched(name, including_directory, kind))
        if (keeps(path) ||
            (access_.may_read(path) && !passes_over(path, kind) && reader_.holds(path)))
            return std::move(path);
    return {};
}

bool Loader::finds(const std::string& name, const std::string& including_directory,
                   FileKind kind) const {
    return located(name, including_directory, kind).has_value();
}

bool Loader::refused(const std::string& name, const std::string& including_directory,
                     FileKind kind) const {
    return !finds(name, including_directory, kind) &&
           closed_path(name, including_directory, kind).has_value();
}

std::string Loader::passed_over(const std::string& path) {
    return message("`", clipped(path), "` is passed over, since another scene has made it");
}

Diagnostic Loader::problem(const std::string& name, Span span, FileKind kind,
                           const std::string& including_directory) const {
    if (const auto path = closed_path(name, including_directory, kind))
        return error(Fault::file_access, span,
                     message("a scene may not read `", clipped(*path), "`"))
            .with_note(FileAccess::reading_rule())
            .with_help(FileAccess::reading_help(*path));
    if (const auto path = odd_path(name, including_directory, kind))
        return error(Fault::file_access, span,
                     message("a scene may not read `", clipped(*path), "`"))
            .with_note("it is a pipe or a device, and a scene reads regular files only");
    Diagnostic result =
        error(Fault::include_not_found, span, message("there is no file `", clipped(name), "`"));
    result.with_note(searched_note(name, including_directory));
    if (const std::string note = access_.left_out_note(); !note.empty() && !is_absolute(name))
        result.with_note(note);
    for (const std::string& path : searched(name, including_directory, kind))
        if (access_.may_read(path) && passes_over(path, kind)) result.with_note(passed_over(path));
    constexpr std::size_t longest_name = 4096;
    if (name.size() > longest_name) return result;
    if (name.find('\\') != name.npos) {
        std::string meant = name;
        std::ranges::replace(meant, '\\', '/');
        return result.with_help(message("folders are separated by `/`: \"", meant, "\""));
    }
    if (!lister_) return result;
    std::vector<std::string> folders;
    for (const std::string& folder : places(name, including_directory))
        if (access_.may_read(folder)) folders.push_back(folder);
    const auto lister = [this](const std::string& folder) { return listed(folder); };
    if (const std::string near = similar_file(name, folders, lister); !near.empty())
        result.with_help(message("did you mean `", near, "`?"));
    return result;
}

namespace {

/// Whether a `#declare` or `#macro` in the text declares the name.
bool declares(std::string_view text, std::string_view name) {
    for (std::size_t at = text.find(name); at != text.npos; at = text.find(name, at + 1)) {
        const std::size_t end = at + name.size();
        if (end < text.size() && in_name(text[end])) continue;
        const std::string_view before = text.substr(0, at);
        const std::size_t word_end = before.find_last_not_of(" \t");
        if (word_end == before.npos || word_end + 1 == at) continue;
        const std::string_view line = before.substr(0, word_end + 1);
        if (line.ends_with("#declare") || line.ends_with("#macro")) return true;
    }
    return false;
}

}  // namespace

std::string Loader::library_file_declaring(std::string_view name) const {
    if (!lister_) return {};
    for (const std::string& folder : library_paths_) {
        std::vector<std::string> files = lister_(folder);
        std::ranges::sort(files);
        for (const std::string& file : files) {
            if (!file.ends_with(".inc")) continue;
            const std::string path = inside(folder, file);
            if (!access_.may_read(path)) continue;
            const std::optional<std::string> text = reader_(path);
            if (text && declares(*text, name)) return file;
        }
    }
    return {};
}

}  // namespace candelabra
