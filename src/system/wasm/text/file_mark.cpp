// SPDX-License-Identifier: GPL-3.0-or-later
// Neither node nor pages give such attributes: only the files of this run are known.
#include "text/file_mark.h"

namespace candelabra {

std::string mark_of(const OpenedFile&) { return {}; }
bool set_mark(const OpenedFile&, const std::string&) { return false; }

}  // namespace candelabra
