// SPDX-License-Identifier: GPL-3.0-or-later
// Work in a process of its own, for libraries that read files of strangers: where such a library
// crashes, hangs or takes too much memory, only this process ends. Both sides exchange messages.
// Used for models.
#pragma once

#include "base/function_ref.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace candelabra {

/// One end of a connection between two processes. A message that cannot be sent or received ends
/// the connection.
class MessageEnd {
public:
    /// Takes over the descriptor of a stream socket.
    explicit MessageEnd(int descriptor) : descriptor_(descriptor) {}
    ~MessageEnd();
    MessageEnd(const MessageEnd&) = delete;
    MessageEnd& operator=(const MessageEnd&) = delete;

    bool send(char kind, std::string_view text);
    /// A message, whose first byte is its kind; nothing at the end of the connection. While it
    /// waits, `waiting` is called some times a second, and may throw.
    std::optional<std::string> receive(FunctionRef<void()> waiting);

private:
    bool fill(char* to, std::size_t size, FunctionRef<void()> waiting);
    int descriptor_;
};

/// Memory that a process made by work_apart() shares with this one. What a stranger's file may have
/// broken can write to it at any time: what is checked must have been copied from it.
class SharedMemory {
public:
    /// Reserves room for so many bytes; those that nobody touches take no memory.
    explicit SharedMemory(std::size_t most);
    ~SharedMemory();
    SharedMemory(const SharedMemory&) = delete;
    SharedMemory& operator=(const SharedMemory&) = delete;

    char* data() { return data_; }
    /// 0: the system has no such room.
    std::size_t size() const { return size_; }

private:
    char* data_ = nullptr;
    std::size_t size_ = 0;
};

struct ApartLimits {
    std::uint64_t memory = 0;   ///< bytes beyond what the program has already
    std::uint64_t seconds = 0;  ///< of processor time
};

/// Runs `work` in a process of its own, which ends when it returns, and `answer` in this one.
/// Returns why the process has ended in another way, as a sentence about it; empty if it has not.
/// Exceptions of `work` end the process in another way, those of `answer` end it and are passed on.
std::string work_apart(const ApartLimits&, FunctionRef<void(MessageEnd&)> work,
                       FunctionRef<void(MessageEnd&)> answer);

}  // namespace candelabra
