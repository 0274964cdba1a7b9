// SPDX-License-Identifier: GPL-3.0-or-later
// The open macro calls and include files, which tell in diagnostics how the evaluation got here.
#pragma once

#include "text/diagnostic.h"
#include "text/source.h"
#include "vocabulary/words.h"

#include <string>
#include <vector>

namespace candelabra {

class Frames {
public:
    struct Open {
        Frame::Kind kind;
        NameId macro;   ///< of a macro
        SourceId file;  ///< of an include
        Span called_at;
    };

    void push(const Open& frame) { open_.push_back(frame); }
    void pop() { open_.pop_back(); }
    std::size_t depth() const { return open_.size(); }

    /// All frames, the innermost first. Printing them omits the middle of a very long list.
    std::vector<Frame> list(const Names& names, const SourceStore& sources) const {
        std::vector<Frame> result;
        for (std::size_t i = open_.size(); i-- > 0;) {
            const Open& open = open_[i];
            result.push_back({open.kind,
                              open.kind == Frame::macro ? std::string(names.spelling(open.macro))
                                                        : sources.name(open.file),
                              open.called_at});
        }
        return result;
    }

private:
    std::vector<Open> open_;
};

}  // namespace candelabra
