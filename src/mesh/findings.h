// SPDX-License-Identifier: GPL-3.0-or-later
// Messages about what is wrong, a few per kind: the first ones say what, the rest only how much.
#pragma once

#include <array>
#include <vector>

#include "core/message.h"
#include "core/messages.h"

namespace featuremesh {

class Findings {
  public:
    /// `kind` is the code of a message whose only parameter is {...:messages}: where it was found.
    template <Code kind>
    void add(Message place) {
        static_assert(takes(template_of(kind).english, std::array{kind_of<std::vector<Message>>()}));
        add(kind, 1, {std::move(place)});
    }
    void add(const Findings& others);
    bool empty() const { return kinds_.empty(); }
    /// One per kind, in the order in which they were found.
    std::vector<Message> messages() const;

  private:
    struct Kind {
        Code code;
        std::vector<Message> places;
        std::size_t count = 0;
    };
    void add(Code code, std::size_t count, const std::vector<Message>& places);
    std::vector<Kind> kinds_;
};

}  // namespace featuremesh
