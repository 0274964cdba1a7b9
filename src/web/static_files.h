// SPDX-License-Identifier: GPL-3.0-or-later
// Files below a folder, to be read by the server's pages: a manual with its pictures. Names are as
// plain as those files have; nothing is decoded, no link is followed, nothing is listed.
#pragma once

#include "web/request.h"

namespace candelabra {

/// The file at a path such as "shapes/box.png" below the folder; "" and what ends in a slash stand
/// for the index.html there. Status 404 for a path that is none of them, for a name that begins
/// with a point, an ending that is not known, a link, and what is no regular file.
WebAnswer static_file(const std::string& folder, std::string_view path);

}  // namespace candelabra
