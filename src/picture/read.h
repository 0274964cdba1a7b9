// SPDX-License-Identifier: GPL-3.0-or-later
// Reads pictures in any format that OpenImageIO reads: as linear values, for comparisons in tests,
// and as texels, for image maps.
#pragma once

#include "base/image.h"
#include "base/texels.h"
#include "text/diagnostic.h"
#include "text/loader.h"

#include <optional>
#include <string>

namespace candelabra {

/// Reads the picture of a file that the user names; returns nothing, with a diagnostic at the span,
/// on failure. Integer values are decoded as sRGB unless the file declares another encoding. Grey
/// becomes equal red, green and blue. Alpha is dropped.
std::optional<Image> read_picture(const std::string& path, Diagnostics&, Span asked_at = {});

/// Conversion of stored values to the scene's, by POV-Ray's rules.
struct TexelCoding {
    enum Decode : std::uint8_t {
        as_stored,   ///< the stored values are the scene's
        where_said,  ///< decode only files that declare their encoding
        always,      ///< also decode integers of other files, as sRGB, except in PPM and PGM
        always_all,  ///< also those, by the curve of ITU-R BT.709: version 3.8's rules
    };
    Decode decode = always;
    double gamma = 0;            ///< overrides the file's; 0: no override, below 0: a curve
    double working_gamma = 1;    ///< gamma of the scene's values
    bool premultiplied = false;  ///< colours are stored multiplied by alpha

    friend auto operator<=>(const TexelCoding&, const TexelCoding&) = default;
};

/// Returns the texels, or nothing with a diagnostic at the span.
std::optional<Texels> read_texels(const Found&, const TexelCoding&, Diagnostics&,
                                  Span asked_at = {});

}  // namespace candelabra
