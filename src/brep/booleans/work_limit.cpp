// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/booleans/work_limit.h"

#include <algorithm>

namespace featuremesh {

namespace {
constexpr Work price_of_a_question = 20;
}

Standard_Boolean WorkLimit::UserBreak() {
    if (is_stopped_) return true;
    spend(price_of_a_question);
    try {
        context_.progress(0.5);
    } catch (...) {
        const std::lock_guard<std::mutex> guard(thrown_mutex_);
        thrown_ = std::current_exception();
        is_stopped_ = true;
    }
    return is_stopped_ || spent_ >= most_;
}

bool WorkLimit::is_over() const {
    if (thrown_) std::rethrow_exception(thrown_);
    return spent_ >= most_;
}

Work WorkLimit::spent() const { return std::min<Work>(spent_, most_); }

}  // namespace featuremesh
