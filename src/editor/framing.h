// SPDX-License-Identifier: GPL-3.0-or-later
// Messages in a stream of bytes, each behind a head that says how long it is (the base protocol of
// the Language Server Protocol). No length is believed: only bytes that have come take memory.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace candelabra {

class Framing {
public:
    static constexpr std::size_t longest_head = 4096;
    static constexpr std::uint64_t longest_message = std::uint64_t{1} << 26;
    /// Messages up to this length are passed over; a longer one is none.
    static constexpr std::uint64_t longest_skip = std::uint64_t{1} << 32;

    /// Nothing is taken after the stream was lost.
    void add(std::string_view bytes);

    struct Message {
        std::string text;
        bool skipped = false;  ///< it was too long, and the text is empty
    };
    /// The next message that is there as a whole.
    std::optional<Message> take();

    /// Whether bytes of a message wait for more.
    bool inside() const { return skip_ > 0 || !waiting_.empty(); }
    /// Why nothing behind a head can be found any more; or empty.
    const std::string& lost() const { return lost_; }

private:
    /// The length in a head; nothing when it has none, and the stream is lost.
    std::optional<std::uint64_t> length(std::string_view head);

    std::string waiting_;
    std::uint64_t skip_ = 0;  ///< bytes of a message that is too long
    bool skipping_ = false;
    std::string lost_;
};

}  // namespace candelabra
