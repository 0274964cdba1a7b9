// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/scene_folders.h"

#include "text/ascii.h"
#include "text/written_name.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include <pwd.h>
#include <unistd.h>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

bool is_below(const fs::path& folder, const fs::path& path) {
    return part_below(folder.string(), path).has_value();
}

/// Whether the kernel makes up the files of the folder.
bool is_of_system(const fs::path& folder) {
    if (is_below("/dev/shm", folder)) return false;
    return std::ranges::any_of(std::array{"/proc", "/sys", "/dev"},
                               [&](const char* each) { return is_below(each, folder); });
}

/// Found once, before the sandbox closes the list of users.
const std::vector<fs::path>& known_homes() {
    static const std::vector<fs::path> homes = [] {
        std::vector<fs::path> found = {"/root"};
        const passwd* const user = ::getpwuid(::getuid());
        for (const char* each : {static_cast<const char*>(std::getenv("HOME")),
                                 user ? static_cast<const char*>(user->pw_dir) : nullptr})
            if (const auto home = path_without_links(each ? each : ""); each && *each && home)
                found.push_back(*home);
        return found;
    }();
    return homes;
}

}  // namespace

bool is_wide(const fs::path& folder) {
    return folder == folder.root_path() || folder == "/home" || folder.parent_path() == "/home" ||
           is_of_system(folder) || std::ranges::any_of(known_homes(), [&](const fs::path& home) {
               return is_below(folder, home);
           });
}

bool FolderFiles::has(const std::string& name) const {
    if (!name.starts_with(stem)) return false;
    return stem.empty() || name.size() == stem.size() || !is_letter(name[stem.size()]);
}

SceneFolders scene_folders(const std::string& scene, const std::string& picture) {
    SceneFolders result;
    const auto own = path_without_links(scene);
    const auto here = path_without_links("");
    const auto add = [&](const fs::path& folder) {
        if (!is_wide(folder))
            result.whole.push_back(folder.string());
        else if (!is_of_system(folder))
            result.files.push_back({folder.string()});
    };
    if (own) add(*own);
    if (own && here && *own != *here && is_below(*here, *own)) {
        if (is_wide(*here))
            result.left_out = here->string();
        else
            add(*here);
    }
    const fs::path path(picture);
    const auto beside = path_without_links(path.parent_path().string());
    if (picture.empty() || !beside || is_of_system(*beside)) return result;
    if (own && !is_wide(*beside) && is_below(*beside, *own))
        add(*beside);
    else
        result.files.push_back({beside->string(), path.stem().string()});
    return result;
}

}  // namespace candelabra
