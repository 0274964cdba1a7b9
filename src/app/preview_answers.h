// SPDX-License-Identifier: GPL-3.0-or-later
// The addresses of the preview: what each gives or changes. A change is asked for by
// POST, for which the server wants the page's token; all else gives and changes nothing.
#pragma once

#include "app/preview_desk.h"
#include "web/request.h"

namespace candelabra {

/// What stays the same in a run.
struct PreviewFacts {
    std::string page;    ///< the page itself, with its token
    std::string scene;   ///< the path of the scene
    std::string manual;  ///< the folder of the manual as HTML; empty: there is none
};

WebAnswer answer_of(const WebRequest&, const PreviewFacts&, PreviewDesk&);

/// The page on which something can be changed.
std::string page_with(const std::string& token, const std::string& scene);

/// Where the manual lies, for a program in that folder; empty when it has not been made.
std::string manual_folder(const std::string& program_folder);

}  // namespace candelabra
