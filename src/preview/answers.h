// SPDX-License-Identifier: GPL-3.0-or-later
// The HTTP interface of the preview. Requests that change something use POST with the page's token;
// all others only return data.
#pragma once

#include "preview/state.h"
#include "web/request.h"

namespace candelabra {

/// Constants of a run.
struct PreviewFacts {
    std::string page;    ///< its HTML, with the token
    std::string scene;   ///< the path of the scene
    std::string manual;  ///< folder of the manual as HTML; empty: none
};

WebAnswer answer_of(const WebRequest&, const PreviewFacts&, PreviewState&);

/// Returns the page with the token that permits changes, and the name of the scene.
std::string page_with(const std::string& token, const std::string& scene);

/// Returns the folder of the manual for a program in that folder; empty if it has not been built.
std::string manual_folder(const std::string& program_folder);

}  // namespace candelabra
