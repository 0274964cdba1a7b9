// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sandbox.h"

#include "app/child.h"
#include "tasks/library.h"
#include "console/console.h"
#include "options/output.h"
#include "text/scene_folders.h"
#include "text/written_name.h"

#include <array>
#include <filesystem>
#include <span>
#include <system_error>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

std::string folder_around(const std::string& path) {
    const std::string folder = fs::path(path).parent_path().string();
    return folder.empty() ? "." : folder;
}

/// Returns the libraries, fonts and status files of the system, and the files of the program.
std::vector<std::string> system_files(const std::string& library) {
    std::vector<std::string> files = {"/usr",
                                      "/lib",
                                      "/lib64",
                                      "/etc/ld.so.cache",
                                      "/etc/localtime",
                                      "/etc/fonts",
                                      "/sys/devices/system",
                                      "/sys/fs/cgroup",
                                      "/proc/self",
                                      "/proc/cpuinfo",
                                      "/proc/meminfo",
                                      "/dev/urandom",
                                      library};
    if (const std::string program = own_path(); !program.empty())
        files.insert(files.end(), {folder_around(program), folder_around(program) + "/../lib"});
    return files;
}

/// Adds what the scene may read. Files that lie directly in a folder are added one by one.
void add_scene_folders(SandboxRules& rules, const SceneFolders& folders) {
    rules.readable.insert(rules.readable.end(), folders.whole.begin(), folders.whole.end());
    for (const FolderFiles& each : folders.files) {
        // The preview reads a scene again, which its editor may have replaced by another file.
        if (rules.sockets && each.stem.empty()) rules.readable.push_back(each.folder);
        std::error_code failed;
        for (fs::directory_iterator entry(each.folder, failed), end; !failed && entry != end;
             entry.increment(failed)) {
            std::error_code none;
            if (each.has(entry->path().filename().string()) && entry->is_regular_file(none))
                rules.readable.push_back(entry->path().string());
        }
    }
}

/// Adds the folder of the picture. Files in a folder that is too wide are not readable because of
/// it, unless frames, films and pages read what the run itself makes.
void add_picture_folder(SandboxRules& rules, const Options& options, const std::string& picture) {
    const std::string folder = folder_around(picture);
    const auto real = path_without_links(folder);
    const bool wide = real && is_wide(*real);
    const bool reads_frames =
        options.animation.final_frame || options.animation.initial_frame || !options.page.empty();
    if (!wide || reads_frames) return rules.writable.push_back(folder);
    rules.written.push_back(folder);
    // What the scene has written it may read again.
    std::error_code none;
    Diagnostics said_elsewhere;
    const std::string own = own_folder(output_of(options, said_elsewhere), options);
    if (fs::is_symlink(own, none)) return;
    if (!fs::exists(own, none)) rules.made = own;
    rules.writable.push_back(own);
}

}  // namespace

SandboxRules sandbox_rules(const Options& options, const std::string& library) {
    SandboxRules rules;
    rules.sockets = options.preview_port.has_value();
    rules.programs = !options.movie.empty();
    rules.readable = system_files(library);
    Diagnostics said_elsewhere;
    const Output output = output_of(options, said_elsewhere);
    const bool makes_picture = options.task == Task::render || options.task == Task::export_mesh;
    const std::string scene = options.scene.value_or("-");
    add_scene_folders(rules, scene_folders(scene == "-" ? "" : folder_around(scene), output.path));
    if (scene != "-") rules.readable.insert(rules.readable.end(), {scene, scene + ".pov"});
    for (const auto* folders : {&options.libraries, &options.library_paths, &options.readable})
        rules.readable.insert(rules.readable.end(), folders->begin(), folders->end());
    if (rules.programs) rules.readable.push_back(folder_around(find_program("ffmpeg")));
    rules.writable = options.writable;
    if (makes_picture) add_picture_folder(rules, options, output.path);
    for (const std::string& file : {options.stats_file, options.depfile, options.mesh_file,
                                    options.readings_file, options.kept_lights, options.movie})
        if (!file.empty() && file != "-") rules.writable.push_back(folder_around(file));
    return rules;
}

SandboxRules sandbox_rules(const Options& options, const std::string& library,
                           std::span<const std::string> files) {
    SandboxRules rules;
    rules.readable = system_files(library);
    rules.readable.insert(rules.readable.end(), files.begin(), files.end());
    rules.programs = !options.movie.empty();
    if (rules.programs) {
        rules.readable.push_back(folder_around(find_program("ffmpeg")));
        rules.writable.push_back(folder_around(options.movie));
    }
    rules.sockets = options.preview_port.has_value();
    if (rules.sockets) {
        // A preview writes nothing, and reads again what editors may have replaced by other files.
        for (const std::string& file : files) rules.readable.push_back(folder_around(file));
        return rules;
    }
    std::error_code none;
    const std::string& output = options.output;
    if (fs::is_directory(output, none)) {
        rules.writable.push_back(output);
    } else if (!output.empty()) {
        rules.writable.push_back(folder_around(output));
    } else {
        for (const std::string& file : files) rules.writable.push_back(folder_around(file));
    }
    for (const std::string& file : {options.readings_file, options.kept_lights})
        if (!file.empty() && file != "-") rules.writable.push_back(folder_around(file));
    return rules;
}

bool confined(const Options& options, const SandboxRules& rules, const Console& console,
              Diagnostics& diagnostics) {
    const bool wanted = options.sandbox.value_or(!options.commands.any());
    if (!wanted || !console.confine) return true;
    std::error_code none;
    if (!rules.made.empty()) fs::create_directory(rules.made, none);
    if (console.confine(rules)) return true;
    if (!options.sandbox) {
        diagnostics.add(
            warning(
                Fault::option, {},
                "this system has no whole sandbox, Landlock and seccomp: only the program's own "
                "rules keep the scene from other files")
                .with_help("--sandbox off accepts this"));
        return true;
    }
    diagnostics.add(
        error(Fault::option, {}, "this system has no sandbox: Landlock or seccomp is missing")
            .with_help("--sandbox off"));
    return false;
}

}  // namespace candelabra
