// SPDX-License-Identifier: GPL-3.0-or-later
// The nodes of a model, numbered so that neighbours have numbers near one another.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/mesh.h"
#include "statics/model.h"
#include "statics/stiffness.h"

namespace featuremesh {

/// By new number the number that a node had: corners first, each kind along a Hilbert curve in the box round it.
std::vector<std::int32_t> order_along_curve(const Mesh& mesh);

/// A model in that order. Products of its matrix read of a vector what they have just read, and after an edit nodes
/// that are kept follow on one another as before.
class OrderedModel {
  public:
    explicit OrderedModel(const StaticsModel& given);
    OrderedModel(const OrderedModel&) = delete;
    OrderedModel& operator=(const OrderedModel&) = delete;

    const StaticsModel& model() const { return model_; }
    const TetsOfNodes& around() const { return around_; }

    /// Values by node, some for each, in the order of the model that was given.
    template <class Value>
    std::vector<Value> as_given(const std::vector<Value>& values) const {
        std::vector<Value> given(values.size());
        const std::size_t each = values.size() / order_.size();
        for (std::size_t i = 0; i < values.size(); ++i)
            given[each * std::size_t(order_[i / each]) + i % each] = values[i];
        return given;
    }

  private:
    std::vector<std::int32_t> order_;
    Mesh mesh_;
    StaticsModel model_;
    TetsOfNodes around_;
};

}  // namespace featuremesh
