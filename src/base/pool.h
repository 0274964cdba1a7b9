// SPDX-License-Identifier: GPL-3.0-or-later
// Allocates many shared values consecutively in large blocks of memory. This is cheaper than
// separate allocations, and a block returns to the system as soon as its last value is destroyed.
// For values that are created and destroyed together, such as the objects of a scene.
#pragma once

#include "base/handle.h"
#include "base/memory_pages.h"

#include <new>

namespace candelabra {

template <class T>
class Pool {
public:
    Pool() = default;
    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;
    ~Pool() { leave_block(); }

    /// Returns a handle to a new value, which may outlive the pool.
    template <class... Arguments>
    Handle<T> make(Arguments&&... arguments) {
        if (!block_ || used_ == capacity) start_block();
        void* const place = block_->places + used_++ * sizeof(Place);
        return Handle<T>::adopt(new (place) Place(std::forward<Arguments>(arguments)...));
    }

private:
    struct Place : handle_detail::Holder<T> {
        template <class... Arguments>
        explicit Place(Arguments&&... arguments)
            : handle_detail::Holder<T>(std::forward<Arguments>(arguments)...) {
            this->destroy = [](const handle_detail::Header* header) {
                const auto* place = static_cast<const Place*>(header);
                place->~Place();
                // Blocks are aligned to their size.
                release(reinterpret_cast<Block*>(reinterpret_cast<std::uintptr_t>(place) &
                                                 ~(block_size - 1)),
                        1);
            };
        }
    };
    static constexpr std::size_t block_size = page_block;
    static constexpr std::size_t capacity = (block_size - 16) / sizeof(Place);
    struct Block {
        /// Places that hold a value, or are still free; one more while the pool uses the block.
        std::atomic<std::size_t> claimed = capacity + 1;
        alignas(16) std::byte places[block_size - 16];
    };
    static_assert(sizeof(Block) == block_size && alignof(Place) <= 16);

    static void release(Block* block, std::size_t places) {
        if (block->claimed.fetch_sub(places) > places) return;
        block->~Block();
        free_pages(block);
    }
    void leave_block() {
        if (block_) release(block_, capacity - used_ + 1);
    }
    void start_block() {
        // Where values are made in passing, the block may have none left.
        if (block_ && block_->claimed == 1) {
            block_->claimed = capacity + 1;
            used_ = 0;
            return;
        }
        // The first block may be the only one, and nearly empty.
        void* const pages = new_pages(block_ != nullptr);
        if (block_) release(block_, 1);
        block_ = new (pages) Block;
        used_ = 0;
    }

    Block* block_ = nullptr;
    std::size_t used_ = 0;  ///< places of the block in use
};

}  // namespace candelabra
