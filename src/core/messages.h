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
    std::string_view english;  ///< with {name:kind} where a parameter goes
};

#define MESSAGE(code, english) MessageTemplate{#code, english},
/// By code.
constexpr MessageTemplate message_templates[] = {
#include "core/messages.def"
};
#undef MESSAGE

constexpr const MessageTemplate& template_of(Code code) { return message_templates[static_cast<std::size_t>(code)]; }

/// The next {name:kind} of a template, without the braces; empty at its end. `rest` becomes what follows, `before` what
/// stands before it.
constexpr std::string_view next_placeholder(std::string_view& rest, std::string_view& before) {
    const std::size_t begin = rest.find('{');
    before = rest.substr(0, begin);
    if (begin == std::string_view::npos) return rest = {};
    const std::size_t end = rest.find('}', begin);
    const std::string_view found = rest.substr(begin + 1, end - begin - 1);
    rest.remove_prefix(end + 1);
    return found;
}

/// Whether a template has just the parameters of these kinds, in this order.
constexpr bool takes(std::string_view english, std::span<const std::size_t> kinds) {
    std::string_view before;
    for (const std::size_t kind : kinds) {
        const std::string_view found = next_placeholder(english, before);
        if (found.substr(found.find(':') + 1) != kinds_of_parameters[kind]) return false;
    }
    return next_placeholder(english, before).empty();
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

}  // namespace featuremesh
