// SPDX-License-Identifier: GPL-3.0-or-later
// A callback parameter: refers to any callable without owning it, so it costs two pointers and no
// allocation. Valid only during the call to which it is passed.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>

namespace candelabra {

template <class Signature>
class FunctionRef;

template <class Result, class... Arguments>
class FunctionRef<Result(Arguments...)> {
public:
    template <class F>
    requires(!std::is_same_v<std::remove_cvref_t<F>, FunctionRef> &&
             std::is_invocable_r_v<Result, F&, Arguments...>) FunctionRef(F&& callable)
        : target_(const_cast<void*>(static_cast<const void*>(std::addressof(callable)))),
          call_([](void* target, Arguments... arguments) -> Result {
              return (*static_cast<std::remove_reference_t<F>*>(target))(
                  std::forward<Arguments>(arguments)...);
          }) {}

    Result operator()(Arguments... arguments) const {
        return call_(target_, std::forward<Arguments>(arguments)...);
    }

private:
    void* target_;
    Result (*call_)(void*, Arguments...);
};

}  // namespace candelabra
