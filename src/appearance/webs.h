// SPDX-License-Identifier: GPL-3.0-or-later
// Loads the photometric files that lamps name, and reads `luminaire { ... }`. Called by the readers
// of lights, finishes and objects.
#pragma once

#include "reading/block.h"
#include "reading/item_reader.h"
#include "surface/lamp_data.h"

namespace candelabra {

/// Reads a photometric file, which messages call by `name`. Its web is null if that fails, for the
/// reason in `wrong`. Warns of repairs. `lamp_set`: of EULUMDAT, from 1.
LoadedWeb read_web(OpenBlock&, std::string_view name, std::string_view bytes, int lamp_set,
                   std::string& wrong);

/// Loads the file of a lamp if it names one: a file is read once, and its lamps share its table.
/// Reports what is wrong, and warns once of what has been repaired.
void load_web(OpenBlock&, WebPlace&);

/// Reads `luminaire { ... }` of a finish or an object.
class LampReader : public SimpleReader {
public:
    /// Both arguments outlive the reader.
    LampReader(OpenBlock& block, Handle<LampData>& lamp) : block_(block), lamp_(lamp) {}

    bool take(const Element&);
    void add_words(WordList& words) const { words.push_back("luminaire"); }
    /// Whether the block has been read.
    bool given() const { return given_; }

private:
    OpenBlock& block_;
    Handle<LampData>& lamp_;
    bool given_ = false;
};

}  // namespace candelabra
