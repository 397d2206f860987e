// SPDX-License-Identifier: GPL-3.0-or-later
// Messages about what is wrong, a few per kind: the first ones say what, the rest only how much.
#pragma once

#include <string>
#include <vector>

namespace featuremesh {

class Findings {
  public:
    void add(const std::string& kind, const std::string& detail);
    void add(const Findings& others);
    bool empty() const { return kinds_.empty(); }
    /// One line per kind.
    std::vector<std::string> messages() const;

  private:
    static constexpr std::size_t most_details = 5;
    struct Kind {
        std::string name;
        std::vector<std::string> details;
        std::size_t count = 0;
    };
    Kind& kind(const std::string& name);
    std::vector<Kind> kinds_;
};

}  // namespace featuremesh
