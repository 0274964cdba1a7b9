// SPDX-License-Identifier: GPL-3.0-or-later
// media blocks, with their densities. Called by the readers of interiors, of scenes and of
// #declare.
#pragma once

#include "bind/binder.h"
#include "bind/block.h"

namespace candelabra {

/// Changes the last argument to what the block makes of it. False: the block was wrong, and has
/// been reported.
bool read_media(Binder&, const Element& block, Media&);

/// media { ... } blocks of what may have several of them.
class MediaReader : public SimpleReader {
public:
    MediaReader(OpenBlock& block, std::vector<Media>& media) : block_(block), media_(media) {}

    bool take(const Element&);
    void add_words(WordList& words) const { words.push_back("media"); }

private:
    OpenBlock& block_;
    std::vector<Media>& media_;
};

}  // namespace candelabra
