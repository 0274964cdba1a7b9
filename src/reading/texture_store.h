// SPDX-License-Identifier: GPL-3.0-or-later
// Shares equal textures: a loop that writes the same plain texture a million times gets one. Stops
// searching if hardly any are equal, as in a loop of random colours. Called by the readers of
// objects.
#pragma once

#include "base/pool.h"
#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace candelabra {

class TextureStore {
public:
    /// A handle to an equal texture, perhaps the argument itself. Patterned textures are not
    /// compared, because they are rarely equal.
    Handle<Texture> share(Handle<Texture>);
    /// The same for a plain texture, which is allocated from the pool if it is new.
    Handle<Texture> share(Texture, Pool<Texture>&);

private:
    struct Slot {
        std::uint64_t hash = 0;
        Handle<Texture> texture;  ///< null: free
    };
    /// Number of lookups before the hit rate is judged.
    static constexpr std::size_t trial = 16384;
    /// Whether at least one lookup in 16 was a hit.
    bool pays() const { return asked_ < trial || 16 * (asked_ - count_) >= asked_; }
    Slot& slot(const Texture&);
    Slot& free_slot(std::uint64_t hash);
    void make_room();

    std::vector<Slot> slots_;  ///< open addressing; a power of two, at most half of them taken
    std::size_t count_ = 0;
    std::size_t asked_ = 0;
};

}  // namespace candelabra
