// SPDX-License-Identifier: GPL-3.0-or-later
// Passes questions about a picture to the thread that renders it. The renderer answers them between
// stretches, so that no thread reads data being written. Used between the preview's server and its
// renderer.
#pragma once

#include "preview/rendered_picture.h"

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace candelabra {

class Questions {
public:
    using Question = std::function<std::string(const RenderedPicture&)>;

    /// Returns the answer; empty if there is no picture, or no answer within 10 seconds.
    std::string ask(Question question) {
        std::future<std::string> answer;
        {
            const std::lock_guard lock(mutex_);
            if (!open_) return {};
            asked_.push_back({std::move(question), {}});
            answer = asked_.back().answer.get_future();
            waiting_ = true;
        }
        constexpr auto patience = std::chrono::seconds(10);
        return answer.wait_for(patience) == std::future_status::ready ? answer.get()
                                                                      : std::string();
    }

    /// Whether a question waits.
    bool waiting() const { return waiting_; }

    /// Answers all questions. Marks a picture as present.
    void answer(const RenderedPicture& picture) {
        for (Asked& each : taken(true)) each.answer.set_value(each.question(picture));
    }

    /// Marks the picture as gone; pending questions get empty answers.
    void close() {
        for (Asked& each : taken(false)) each.answer.set_value({});
    }

private:
    struct Asked {
        Question question;
        std::promise<std::string> answer;
    };

    std::vector<Asked> taken(bool open) {
        const std::lock_guard lock(mutex_);
        open_ = open;
        waiting_ = false;
        return std::exchange(asked_, {});
    }

    std::mutex mutex_;
    bool open_ = false;
    std::atomic<bool> waiting_ = false;
    std::vector<Asked> asked_;
};

}  // namespace candelabra
