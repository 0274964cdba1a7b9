// SPDX-License-Identifier: GPL-3.0-or-later
// Reads film { ... } in a camera.
#pragma once

#include "reading/block.h"

namespace candelabra {

class FilmReader : public SimpleReader {
public:
    /// Both arguments outlive the reader. The film starts as that of the default or declared
    /// camera.
    FilmReader(OpenBlock& camera, FilmSettings& film) : camera_(camera), film_(film) {}

    bool take(const Element&);
    void add_words(WordList& words) const { words.push_back("film"); }

private:
    OpenBlock& camera_;
    FilmSettings& film_;
};

}  // namespace candelabra
