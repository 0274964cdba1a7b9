// SPDX-License-Identifier: GPL-3.0-or-later
// Splits a stream of bytes into messages, each after a header that states its length (the base
// protocol of the Language Server Protocol). Memory is allocated only for bytes that have arrived,
// whatever length a header states.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace candelabra {

class Framing {
public:
    static constexpr std::size_t longest_head = 4096;
    static constexpr std::uint64_t longest_message = std::uint64_t{1} << 26;
    /// Messages up to this length are skipped; a greater length is an error.
    static constexpr std::uint64_t longest_skip = std::uint64_t{1} << 32;

    /// Appends bytes of the stream; ignores them after the stream was lost.
    void add(std::string_view bytes);

    struct Message {
        std::string text;
        bool skipped = false;  ///< the message was too long; the text is empty
    };
    /// Returns the next complete message, if any.
    std::optional<Message> take();

    /// Whether bytes of an incomplete message are waiting for the rest.
    bool inside() const { return skip_ > 0 || !waiting_.empty(); }
    /// Returns the reason why the stream cannot be read any further; empty if it can.
    const std::string& lost() const { return lost_; }

private:
    /// Returns the length that a header states; nothing if it is invalid, which loses the stream.
    std::optional<std::uint64_t> length(std::string_view head);

    std::string waiting_;
    std::uint64_t skip_ = 0;  ///< remaining bytes of a message that is too long
    bool skipping_ = false;
    std::string lost_;
};

}  // namespace candelabra
