// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/library_folders.h"

#include "text/message.h"
#include "text/printable.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

namespace candelabra {

namespace fs = std::filesystem;

std::vector<std::string> library_folders(const std::vector<std::string>& first,
                                         const std::string& standard,
                                         const std::vector<std::string>& given,
                                         Diagnostics& diagnostics) {
    std::vector<std::string> paths;
    const auto add = [&](std::string path) {
        while (path.size() > 1 && path.ends_with('/')) path.pop_back();
        std::error_code none;
        if (!fs::is_directory(path, none))
            diagnostics.add(warning(
                Fault::option, {},
                message("there is no folder `", printable(path), "` to look for files in")));
        paths.push_back(std::move(path));
    };
    std::ranges::for_each(first, add);
    // POV-Ray's order: its settings name its own library before the command line is read.
    if (!standard.empty()) paths.push_back(standard);
    std::ranges::for_each(given, add);
    // The library's pictures and models come last, so that they never hide others of the same name.
    if (!standard.empty())
        for (const char* folder : {"/pictures", "/models"}) paths.push_back(standard + folder);
    return paths;
}

}  // namespace candelabra
