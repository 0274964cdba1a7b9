// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/apart.h"

namespace candelabra {

MessageEnd::~MessageEnd() = default;

bool MessageEnd::send(char, std::string_view) { return false; }

std::optional<std::string> MessageEnd::receive(FunctionRef<void()>) { return std::nullopt; }

SharedMemory::SharedMemory(std::size_t) {}

SharedMemory::~SharedMemory() = default;

std::string work_apart(const ApartLimits&, FunctionRef<void(MessageEnd&)>,
                       FunctionRef<void(MessageEnd&)>) {
    return "the program as WebAssembly has no processes";
}

}  // namespace candelabra
