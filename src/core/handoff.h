// SPDX-License-Identifier: GPL-3.0-or-later
// How one thread's work reaches others, in words that the thread sanitizer understands.
#pragma once

#include <atomic>

namespace featuremesh {

/// What a thread wrote before it gave is seen by those that take after it. oneTBB sees to that itself, but in a library
/// that is built without the sanitizer.
class Handoff {
  public:
    void give();
    void take() const;

  private:
    std::atomic<unsigned> given_{0};
};

}  // namespace featuremesh
