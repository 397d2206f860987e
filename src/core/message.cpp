// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/message.h"

#include <algorithm>
#include <map>

#include "core/entity_names.h"
#include "core/messages.h"
#include "core/numbers_in_words.h"

namespace featuremesh {

namespace {

struct InEnglish {
    std::string operator()(std::int64_t count) const { return std::to_string(count); }
    std::string operator()(double number) const { return in_words(number); }
    std::string operator()(Length length) const { return in_words(length.mm) + " mm"; }
    std::string operator()(Volume volume) const { return volume_in_words(volume.mm3); }
    std::string operator()(Extent extent) const {
        return in_words(extent.mm.x) + " x " + in_words(extent.mm.y) + " x " + in_words(extent.mm.z) + " mm";
    }
    std::string operator()(const Vec3& point) const { return in_words(point) + " mm"; }
    std::string operator()(const std::string& text) const { return text; }

    std::string operator()(const std::vector<Entity>& entities) const {
        constexpr std::size_t most = 6;
        std::string names;
        for (std::size_t i = 0; i < std::min(most, entities.size()); ++i)
            names += (i == 0 ? "" : ", ") + name_of(entities[i]);
        if (entities.size() > most) names += " and " + std::to_string(entities.size() - most) + " more";
        return entities.empty() ? "the inside" : names;
    }

    std::string operator()(const std::vector<Message>& messages) const {
        std::string text;
        for (const Message& message : messages) text += (text.empty() ? "" : "; ") + message.in_english();
        return text;
    }
};

}  // namespace

Message::Message(Code code, std::vector<Parameter> parameters) : code_(code), parameters_(std::move(parameters)) {}

std::string Message::in_english() const {
    std::string text;
    std::string_view rest = template_of(code_).english;
    std::map<std::string_view, const Parameter*> by_name;
    while (!rest.empty()) {
        const Placeholder next = next_placeholder(rest);
        text += next.before;
        if (next.name.empty()) continue;
        if (!next.is_choice()) by_name[next.name] = &parameters_[by_name.size()];
        const Parameter& parameter = *by_name.at(next.name);
        text += next.is_choice() ? std::string(next.chosen(std::get<std::int64_t>(parameter)))
                                 : std::visit(InEnglish(), parameter);
    }
    return text;
}

Message several(std::vector<Message> messages) {
    if (messages.empty()) return {};
    if (messages.size() == 1) return std::move(messages.front());
    return say<Code::several>(messages);
}

Message listed(const std::vector<Message>& messages) {
    Message list;
    for (std::size_t i = messages.size(); i-- > 0;)
        list = list.empty() ? messages[i] : say<Code::listed>(messages[i], list);
    return list;
}

}  // namespace featuremesh
