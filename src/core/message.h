// SPDX-License-Identifier: GPL-3.0-or-later
// What the engine has to say: a code and its parameters. Whoever shows it puts it into words; messages.h has the codes.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/geometry.h"
#include "core/ids.h"

namespace featuremesh {

enum class Code : std::uint16_t;
class Message;

struct Length {
    double mm;
};
struct Volume {
    double mm3;
};
/// Of a box.
struct Extent {
    Vec3 mm;
};

/// Points are in mm.
using Parameter = std::variant<std::int64_t, double, Length, Volume, Extent, Vec3, std::vector<Entity>, std::string,
                               std::vector<Message>>;
/// The kinds of parameters, in the same order: a template has {name:kind} where the parameter goes.
constexpr std::string_view kinds_of_parameters[] = {"count", "number",   "length", "volume",  "extent",
                                                    "point", "entities", "text",   "messages"};

class Message {
  public:
    /// Says nothing.
    Message() = default;
    Message(Code code, std::vector<Parameter> parameters);

    bool empty() const { return code_ == Code{}; }
    Code code() const { return code_; }
    const std::vector<Parameter>& parameters() const { return parameters_; }
    /// For logs, what() and the command line.
    std::string in_english() const;

    bool operator==(const Message& other) const { return in_english() == other.in_english(); }

  private:
    Code code_{};
    std::vector<Parameter> parameters_;
};

/// What becomes of a value that is given as a parameter.
inline std::int64_t as_parameter(std::integral auto value) { return static_cast<std::int64_t>(value); }
inline double as_parameter(double value) { return value; }
inline Length as_parameter(Length value) { return value; }
inline Volume as_parameter(Volume value) { return value; }
inline Extent as_parameter(Extent value) { return value; }
inline Vec3 as_parameter(const Vec3& value) { return value; }
inline std::string as_parameter(std::string value) { return value; }
inline std::string as_parameter(const char* value) { return value ? value : ""; }
inline std::vector<Entity> as_parameter(Entity value) { return {value}; }
inline std::vector<Entity> as_parameter(std::vector<Entity> value) { return value; }
inline std::vector<Message> as_parameter(const Message& value) { return {value}; }
inline std::vector<Message> as_parameter(std::vector<Message> value) { return value; }
template <class Kind>
std::vector<Entity> as_parameter(Id<Kind> id) {
    return {entity_of(id)};
}
template <class Ids>
requires requires(const Ids& ids) { entity_of(*ids.begin()); }
std::vector<Entity> as_parameter(const Ids& ids) {
    std::vector<Entity> entities;
    for (const auto id : ids) entities.push_back(entity_of(id));
    return entities;
}

template <class Value, std::size_t kind = 0>
constexpr std::size_t kind_of() {
    using Given = decltype(as_parameter(std::declval<Value>()));
    if constexpr (std::is_same_v<Given, std::variant_alternative_t<kind, Parameter>>)
        return kind;
    else
        return kind_of<Value, kind + 1>();
}

}  // namespace featuremesh
