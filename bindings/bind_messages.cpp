// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.h"
#include "core/entity_names.h"
#include "core/errors.h"
#include "core/messages.h"

namespace featuremesh {

namespace {

std::array<double, 3> numbers_of(const Vec3& v) { return {v.x, v.y, v.z}; }

struct ToPython {
    py::object operator()(std::int64_t count) const { return py::cast(count); }
    py::object operator()(double number) const { return py::cast(number); }
    py::object operator()(Length length) const { return py::cast(length.mm); }
    py::object operator()(Volume volume) const { return py::cast(volume.mm3); }
    py::object operator()(Extent extent) const { return py::cast(numbers_of(extent.mm)); }
    py::object operator()(const Vec3& point) const { return py::cast(numbers_of(point)); }
    py::object operator()(const std::vector<Entity>& entities) const { return names_of_entities(entities); }
    py::object operator()(const std::string& text) const {
        return py::reinterpret_steal<py::object>(
            PyUnicode_DecodeUTF8(text.data(), py::ssize_t(text.size()), "replace"));
    }
    py::object operator()(const std::vector<Message>& messages) const { return to_list(messages); }
};

}  // namespace

py::list names_of_entities(const std::vector<Entity>& entities) {
    py::list names;
    for (const Entity entity : entities) names.append(name_of(entity));
    return names;
}

std::vector<Entity> entities_from(const std::vector<std::string>& names) {
    std::vector<Entity> entities;
    for (const std::string& name : names) {
        const std::optional<Entity> entity = entity_named(name);
        if (!entity) throw InputError(say<Code::no_entity>(name));
        entities.push_back(*entity);
    }
    return entities;
}

py::object to_python(const Message& message) {
    if (message.empty()) return py::none();
    const MessageTemplate& words = template_of(message.code());
    py::dict parameters;
    std::string_view rest = words.english;
    for (const Parameter& parameter : message.parameters()) {
        Placeholder next = next_placeholder(rest);
        while (next.is_choice()) next = next_placeholder(rest);
        parameters[py::str(next.name)] = std::visit(ToPython(), parameter);
    }
    return py::dict(py::arg("code") = words.name, py::arg("template") = words.english,
                    py::arg("parameters") = parameters);
}

py::list to_list(const std::vector<Message>& messages) {
    py::list out;
    for (const Message& message : messages) out.append(to_python(message));
    return out;
}

void define_messages(py::module_& module) {
    module.def(
        "message_templates",
        [] {
            py::dict templates;
            for (const MessageTemplate& words : message_templates) templates[py::str(words.name)] = words.english;
            return templates;
        },
        "By code: the English words of every message, with {name:kind} where a parameter goes.");
}

}  // namespace featuremesh
