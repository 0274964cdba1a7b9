// SPDX-License-Identifier: GPL-3.0-or-later
// Opens the library of picture formats when it is first needed.
#pragma once

#include "formats/formats.h"
#include "text/diagnostic.h"

/// The entry points; null, with a diagnostic at the span, when the library cannot be opened.
const Formats* picture_formats(Diagnostics&, Span asked_at = {});
