// SPDX-License-Identifier: GPL-3.0-or-later
// Files to pictures, in any format that OpenImageIO reads: as linear values, which tests compare,
// and as texels, which image maps are made of.
#pragma once

#include "base/image.h"
#include "base/texels.h"
#include "text/diagnostic.h"
#include "text/loader.h"

#include <optional>
#include <string>

namespace candelabra {

/// The picture of a file that the user names, or nothing with a diagnostic at the span. Whole
/// numbers are decoded as sRGB unless the file says otherwise; grey becomes equal red, green and
/// blue; alpha is left out.
std::optional<Image> read_picture(const std::string& path, Diagnostics&, Span asked_at = {});

/// How the stored values become the scene's, by POV-Ray 3.7's rules.
struct TexelCoding {
    enum Decode : std::uint8_t {
        as_stored,   ///< the values are the scene's already
        where_said,  ///< only files that say how they are coded are decoded
        always,      ///< whole numbers of other files are sRGB, but for PPM and PGM
    };
    Decode decode = always;
    double gamma = 0;            ///< instead of what the file says; 0: none, below 0: sRGB
    double working_gamma = 1;    ///< of the scene's values
    bool premultiplied = false;  ///< colours are stored times their alpha

    friend auto operator<=>(const TexelCoding&, const TexelCoding&) = default;
};

/// The texels, or nothing with a diagnostic at the span.
std::optional<Texels> read_texels(const Found&, const TexelCoding&, Diagnostics&,
                                  Span asked_at = {});

}  // namespace candelabra
