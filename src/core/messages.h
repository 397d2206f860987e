// SPDX-License-Identifier: GPL-3.0-or-later
// The codes of all messages and how one is made; the table is messages.def.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "core/message.h"

namespace featuremesh {

#define MESSAGE(code, english) code,
enum class Code : std::uint16_t {
#include "core/messages.def"
};
#undef MESSAGE

struct MessageTemplate {
    std::string_view name;     ///< of the code
    std::string_view english;  ///< with {name:kind} where a parameter goes, and {name:one|many} behind a count
};

#define MESSAGE(code, english) MessageTemplate{#code, english},
/// By code.
constexpr MessageTemplate message_templates[] = {
#include "core/messages.def"
};
#undef MESSAGE

constexpr const MessageTemplate& template_of(Code code) { return message_templates[static_cast<std::size_t>(code)]; }

/// A {name:kind} of a template, or a choice of words {name:one|many}.
struct Placeholder {
    std::string_view before;  ///< what stands before it
    std::string_view name, kind;

    constexpr bool is_choice() const { return kind.find('|') != std::string_view::npos; }
    /// The words of a choice for so many.
    constexpr std::string_view chosen(std::int64_t count) const {
        const std::size_t bar = kind.find('|');
        return count == 1 ? kind.substr(0, bar) : kind.substr(bar + 1);
    }
};

/// The next one of a template, without a name at its end. `rest` becomes what follows.
constexpr Placeholder next_placeholder(std::string_view& rest) {
    const std::size_t begin = rest.find('{');
    Placeholder found{rest.substr(0, begin), {}, {}};
    if (begin == std::string_view::npos) {
        rest = {};
        return found;
    }
    const std::size_t end = rest.find('}', begin);
    const std::string_view inside = rest.substr(begin + 1, end - begin - 1);
    const std::size_t colon = inside.find(':');
    found.name = inside.substr(0, colon);
    if (colon != std::string_view::npos) found.kind = inside.substr(colon + 1);
    rest.remove_prefix(end + 1);
    return found;
}

/// Whether a template has just the parameters of these kinds, in this order.
constexpr bool takes(std::string_view english, std::span<const std::size_t> kinds) {
    std::size_t next = 0;
    while (!english.empty()) {
        const Placeholder found = next_placeholder(english);
        if (found.name.empty() || found.is_choice()) continue;
        if (next == kinds.size() || found.kind != kinds_of_parameters[kinds[next]]) return false;
        ++next;
    }
    return next == kinds.size();
}

/// say<Code::growth_below_one>(0.5). It does not compile with other parameters than those of the template.
template <Code code, class... Values>
Message say(const Values&... values) {
    static_assert(takes(template_of(code).english, std::array<std::size_t, sizeof...(Values)>{kind_of<Values>()...}),
                  "the parameters are not those of the template, in its order");
    return {code, {Parameter(as_parameter(values))...}};
}

/// Several messages as one; just the message where there is one, and none where there is none.
Message several(std::vector<Message> messages);
/// The same with commas between them.
Message listed(const std::vector<Message>& messages);

}  // namespace featuremesh
