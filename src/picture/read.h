// SPDX-License-Identifier: GPL-3.0-or-later
// Files to pictures, in any format that OpenImageIO reads, as linear values: what image maps will
// be made of, and how tests compare pictures.
#pragma once

#include "base/image.h"
#include "text/diagnostic.h"

#include <optional>
#include <string>

/// The picture, or nothing with a diagnostic at the span. Whole numbers are decoded as sRGB unless
/// the file says otherwise; grey becomes equal red, green and blue; alpha is left out.
std::optional<Image> read_picture(const std::string& path, Diagnostics&, Span asked_at = {});
