// SPDX-License-Identifier: GPL-3.0-or-later
// Serves files below a folder to the server's pages: a manual with its pictures. Names must be
// plain: nothing is decoded, no link is followed, no folder is listed.
#pragma once

#include "web/request.h"

namespace candelabra {

/// The file at a path such as "shapes/box.png" below the folder. "" and a path that ends in a slash
/// stand for the index.html there. Status 404 for a missing or malformed path, a name that begins
/// with a dot, an unknown extension, a link, or anything but a regular file.
WebAnswer static_file(const std::string& folder, std::string_view path);

}  // namespace candelabra
