// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds and reads the files that a scene names. The evaluator asks; how a path is read is an
// argument, so that tests need no disk. A relative name is looked for in the folder of the
// including file, the folder of the scene, the current directory, and the library paths in order.

#include <functional>
#include <optional>
#include <string>
#include <vector>

/// The text behind a path, or nothing if there is none that can be read.
using Reader = std::function<std::optional<std::string>(const std::string& path)>;

/// Reads regular files and pipes; folders, devices and whatever cannot be read give nothing.
Reader disk_reader();

/// The folder part of a path: "." for a bare name, "/" for what is in the root.
std::string directory_of(const std::string& path);

/// What a name is asked for as. An include file may leave out its .inc or .INC; a data file is
/// found under its exact name only.
enum class FileKind { include, data };

struct Found {
    std::string path;
    std::string text;
};

/// Folders are given as directory_of() writes them; "" stands for none.
class Loader {
public:
    explicit Loader(Reader reader, std::string scene_directory = {},
                    std::vector<std::string> library_paths = {});

    std::optional<Found> load(const std::string& name, const std::string& including_directory = {},
                              FileKind kind = FileKind::include) const;

    /// Every path that load() tries, in order, each once.
    std::vector<std::string> searched(const std::string& name,
                                      const std::string& including_directory = {},
                                      FileKind kind = FileKind::include) const;

    /// The places in one line for a note: "looked in `scenes`, the current directory, `lib`".
    std::string searched_note(const std::string& name,
                              const std::string& including_directory = {}) const;

private:
    std::vector<std::string> places(const std::string& name,
                                    const std::string& including_directory) const;

    Reader reader_;
    std::string scene_directory_;
    std::vector<std::string> library_paths_;
};
