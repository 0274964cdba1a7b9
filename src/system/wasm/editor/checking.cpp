// SPDX-License-Identifier: GPL-3.0-or-later
// There is one process, which checks the scene itself, within the limits of the language.
#include "editor/checking.h"

#include <new>

namespace candelabra {

std::map<std::string, std::vector<Json>> check(const Workspace& workspace, const std::string& path,
                                               const std::string& folder_for_writing,
                                               const CheckLimits&, const Meanwhile&) {
    try {
        Report result;
        report(workspace, path, folder_for_writing, result);
        return problems(result, workspace, path);
    } catch (const std::bad_alloc&) {
        const Json top = {{"line", 0}, {"character", 0}};
        return {
            {path,
             {{{"range", {{"start", top}, {"end", top}}},
               {"severity", 2},
               {"source", "candelabra"},
               {"message", "this scene is not checked: that takes more than there is memory"}}}}};
    }
}

}  // namespace candelabra
