// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds and reads the files that a scene names, for the evaluator. The reader of paths is an
// argument, so that tests need no disk. A relative name is looked for in the folder of the
// including file, the folder of the scene, the current directory, the folder of what the scene has
// written, and the library paths in order; a file that it has written in this run comes first.
// Files that FileAccess does not permit are not opened, and files to be included that another scene
// has made are passed over. Existence is tested without reading.

#include "text/diagnostic.h"
#include "text/file_access.h"
#include "text/similar_file.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace candelabra {

/// Reads the text at a path, or returns nothing if it cannot be read; and tests whether there is
/// one, without reading it.
class Reader {
public:
    using Read = std::function<std::optional<std::string>(const std::string& path)>;
    using Holds = std::function<bool(const std::string& path)>;
    using Within = std::function<Reader(const FileAccess&)>;

    Reader() = default;
    /// For texts in memory, which are cheap to read: existence is tested by reading.
    template <class F>
    requires(std::is_invocable_r_v<std::optional<std::string>, const F&, const std::string&> &&
             !std::is_same_v<F, Reader>) Reader(F read)
        : read_(read), holds_([read](const std::string& path) {
              return std::optional<std::string>(read(path)).has_value();
          }) {}
    Reader(Read read, Holds holds, Within within = {})
        : read_(std::move(read)), holds_(std::move(holds)), within_(std::move(within)) {}

    explicit operator bool() const { return bool(read_); }
    std::optional<std::string> operator()(const std::string& path) const { return read_(path); }
    bool holds(const std::string& path) const { return holds_(path); }
    /// Returns this reader restricted to files that may be read; texts in memory are not
    /// restricted.
    Reader within(const FileAccess& access) const { return within_ ? within_(access) : *this; }

private:
    Read read_;
    Holds holds_;
    Within within_;
};

/// Returns a reader of files that the user names: regular files and pipes. It returns nothing for
/// folders, devices and unreadable files.
Reader disk_reader();

/// Returns a reader of files that a scene names: regular files that may be read. The file that it
/// checks is the one that it opens.
Reader scene_reader(const FileAccess&);

/// Returns the folder part of a path: "." for a bare name, "/" for an entry of the root.
std::string directory_of(const std::string& path);

/// The kind of file that a name refers to. The name of an include file may omit .inc or .INC; a
/// data file is found under its exact name only.
enum class FileKind { include, data };

struct Found {
    std::string path;
    std::string text;
    std::vector<std::string> passed_over = {};  ///< paths of other scenes' files before this one
};

/// Folders are spelt as directory_of() returns them; "" stands for none.
class Loader {
public:
    /// The lister is used for messages only.
    explicit Loader(Reader reader, std::string scene_directory = {},
                    std::vector<std::string> library_paths = {}, FileAccess access = {},
                    Lister lister = {});

    std::optional<Found> load(const std::string& name, const std::string& including_directory = {},
                              FileKind kind = FileKind::include) const;

    /// Returns the path of the file that load() would read. Reads nothing.
    std::optional<std::string> located(const std::string& name,
                                       const std::string& including_directory = {},
                                       FileKind kind = FileKind::include) const;

    /// Whether load() would find a file. Reads nothing.
    bool finds(const std::string& name, const std::string& including_directory = {},
               FileKind kind = FileKind::include) const;

    /// Returns every path that load() tries, in order and without duplicates.
    std::vector<std::string> searched(const std::string& name,
                                      const std::string& including_directory = {},
                                      FileKind kind = FileKind::include) const;

    /// Explains why load() found nothing: the places searched and a similar name, or the rule that
    /// forbids it.
    Diagnostic problem(const std::string& name, Span, FileKind kind = FileKind::include,
                       const std::string& including_directory = {}) const;

    /// Says that a file of another scene is passed over.
    static std::string passed_over(const std::string& path);

    /// Whether the name leads to a path that the scene may not read, and to no file elsewhere. Does
    /// not look at that path.
    bool refused(const std::string& name, const std::string& including_directory = {},
                 FileKind kind = FileKind::include) const;

    /// Returns the first file of the library that declares the name, or "". For messages.
    std::string library_file_declaring(std::string_view name) const;

    /// Sets the folder of the standard library. Errors in files below it are reported at the place
    /// where the scene calls them.
    void set_standard_library(std::string folder) { standard_ = std::move(folder); }
    bool in_standard_library(std::string_view path) const {
        return !standard_.empty() && path.size() > standard_.size() &&
               path.starts_with(standard_) && path[standard_.size()] == '/';
    }

    const FileAccess& file_access() const { return access_; }
    /// Records that the scene has written the file at this destination, whose text is found under
    /// this name from now on. If `text` is given, the content is there and not on the disk, and may
    /// still grow.
    void written(const std::string& destination, std::shared_ptr<const std::string> text = {}) {
        written_[destination] = std::move(text);
    }
    /// Keeps all files that the scene writes from now on in memory: this run must not change the
    /// disk.
    void keep_off_disk() { off_disk_ = true; }
    bool keeps_off_disk() const { return off_disk_; }
    /// Whether the scene has written to this destination and the text is kept in memory.
    bool keeps(const std::string& destination) const {
        const auto own = written_.find(destination);
        return own != written_.end() && own->second;
    }

private:
    /// Whether a file is not included because another scene has made it.
    bool passes_over(const std::string& path, FileKind kind) const {
        return kind == FileKind::include && access_.is_of_another(path);
    }
    /// Returns the first pipe or device among the paths that may be read.
    std::optional<std::string> odd_path(const std::string& name,
                                        const std::string& including_directory,
                                        FileKind kind) const;
    /// Lists only files that may be read, so that messages name no others.
    std::vector<std::string> listed(const std::string& folder) const;
    std::vector<std::string> places(const std::string& name,
                                    const std::string& including_directory) const;
    std::string searched_note(const std::string& name,
                              const std::string& including_directory) const;
    /// Returns the first path that may not be read.
    std::optional<std::string> closed_path(const std::string& name,
                                           const std::string& including_directory,
                                           FileKind kind) const;

    Reader reader_;
    std::string scene_directory_;
    std::vector<std::string> library_paths_;
    std::string standard_;
    FileAccess access_;
    Lister lister_;
    std::map<std::string, std::shared_ptr<const std::string>> written_;  ///< null: on the disk
    bool off_disk_ = false;
};

}  // namespace candelabra
