// SPDX-License-Identifier: GPL-3.0-or-later
// Reads media blocks, with their densities. Called by the readers of interiors, of scenes and of
// #declare.
#pragma once

#include "reading/binder.h"
#include "reading/block.h"

namespace candelabra {

/// Applies the block to the last argument. Returns false, after a diagnostic, if the block was
/// wrong.
bool read_media(Binder&, const Element& block, Media&);

/// Reads media { ... } blocks where several are allowed.
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
