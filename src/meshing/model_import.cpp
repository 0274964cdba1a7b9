// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/model_import.h"

#include "base/apart.h"
#include "base/loaded_library.h"
#include "base/long_work.h"
#include "text/ascii.h"
#include "text/message.h"
#include "text/printable.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace candelabra {

namespace {

/// Kinds of messages: a file that is wanted, a file that is there or not, the model, its size in
/// the memory that is shared, a problem.
constexpr char wants_file = 'w', there = 't', missing = 'm', result = 'r', shared = 's',
               wrong = 'p';

/// Models take so many times the memory of their files while they are read; text takes more.
constexpr std::uint64_t memory_of_byte = 64, memory_of_any = std::uint64_t{512} << 20;
/// What is read usually takes less; more comes by messages.
constexpr std::uint64_t shared_of_byte = 4, shared_of_any = std::uint64_t{16} << 20;
/// Larger files than any machine reads in the time that is allowed.
constexpr std::uint64_t bytes_of_second = 500'000, seconds_of_any = 20;

const Imports* imports_library_of(Diagnostics& diagnostics, Span asked_at) {
    static const LoadedFunction library = load_function(imports_library, imports_function);
    if (!library.address) {
        diagnostics.add(
            error(Fault::io, asked_at,
                  message("the library of models cannot be opened: ", library.problem)));
        return nullptr;
    }
    static const Imports* const imports = reinterpret_cast<const Imports* (*)()>(library.address)();
    return imports;
}

const auto nothing = [] {};

/// In the process of its own: reads the model, and asks the program for files beside it.
void read_and_send(const Imports& imports, const Found& file, SharedMemory& memory,
                   MessageEnd& end) {
    const auto read = [](void* context, std::string_view name, std::string& bytes) {
        auto& program = *static_cast<MessageEnd*>(context);
        std::optional<std::string> answer;
        if (program.send(wants_file, name)) answer = program.receive(nothing);
        if (!answer || !answer->starts_with(there)) return false;
        bytes = answer->substr(1);
        return true;
    };
    ImportedModel model;
    const std::string problem = imports.read(file.path, file.text, {read, &end}, model);
    if (!problem.empty()) {
        end.send(wrong, problem);
        return;
    }
    const std::uint64_t size = packed_size(model);
    if (size <= memory.size()) {
        pack(model, memory.data());
        end.send(shared, std::string_view(reinterpret_cast<const char*>(&size), sizeof size));
        return;
    }
    std::string text(size, '\0');
    pack(model, text.data());
    end.send(result, text);
}

/// In the program: sends files until the model or a problem comes.
std::string answer_files(MessageEnd& end, ReadBeside read, SharedMemory& memory,
                         UnpackedModel& model) {
    // Enough to be asked whether to go on, and too little to be the work of a scene.
    constexpr std::uint64_t work_of_wait = 20'000;
    const auto waiting = [] { count_long_work(work_of_wait); };
    while (const std::optional<std::string> got = end.receive(waiting)) {
        const std::string_view text = std::string_view(*got).substr(1);
        if (got->front() == result) return unpack(text, model);
        if (got->front() == shared) {
            std::uint64_t size = 0;
            if (text.size() != sizeof size) break;
            std::memcpy(&size, text.data(), sizeof size);
            if (size > memory.size()) break;
            return unpack(std::string_view(memory.data(), size), model);
        }
        if (got->front() == wrong) return text.empty() ? "it is damaged" : std::string(text);
        const std::string name = name_beside(text);
        const auto found = name.empty() ? std::nullopt : read(name);
        if (!(found ? end.send(there, *found) : end.send(missing, {}))) break;
    }
    return "it is damaged";
}

}  // namespace

bool has_parts(std::string_view name) {
    static constexpr std::array<std::string_view, 6> endings = {".gltf", ".glb", ".obj",
                                                                ".fbx",  ".dae", ".3mf"};
    const std::string low = lower_case(name);
    return std::ranges::any_of(endings, [&](std::string_view each) { return low.ends_with(each); });
}

std::string name_beside(std::string_view name) {
    std::string path(name);
    std::ranges::replace(path, '\\', '/');
    while (path.starts_with("./")) path.erase(0, 2);
    const bool leads_out =
        path.starts_with('/') || path.find("..") != path.npos || path.find(':') != path.npos;
    if (leads_out) path.erase(0, path.find_last_of("/:") + 1);
    return path == ".." || path == "." ? std::string() : path;
}

std::optional<UnpackedModel> import_model(const Found& file, ReadBeside read,
                                          Diagnostics& diagnostics, Span asked_at) {
    const Imports* const imports = imports_library_of(diagnostics, asked_at);
    if (!imports) return std::nullopt;
    UnpackedModel model;
    std::string problem = "it is damaged";
    const std::uint64_t size = file.text.size();
    SharedMemory memory(shared_of_any + shared_of_byte * size);
    const std::string ended = work_apart(
        {memory_of_any + memory_of_byte * size, seconds_of_any + size / bytes_of_second},
        [&](MessageEnd& end) { read_and_send(*imports, file, memory, end); },
        [&](MessageEnd& end) { problem = answer_files(end, read, memory, model); });
    if (!ended.empty()) problem = ended;
    if (problem.empty()) return model;
    diagnostics.add(
        error(Fault::io, asked_at,
              message("cannot read the model `", printable(file.path), "`: ", printable(problem))));
    return std::nullopt;
}

}  // namespace candelabra
