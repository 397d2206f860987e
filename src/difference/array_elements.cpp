// SPDX-License-Identifier: GPL-3.0-or-later
#include "difference/array_elements.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/geometry.h"
#include "core/tolerances.h"

namespace featuremesh {

namespace {

constexpr std::int64_t gone = -1;

/// By its number, the way to each element from the first one.
using Elements = std::map<std::int64_t, RigidMotion>;

/// None of what is no array.
Elements elements_of(const Feature& feature) {
    Elements elements;
    const bool is_by_shape = feature.role == Role::pattern && feature.volume_source == "shape";
    for (const FeatureVolume& volume : feature.volumes)
        if (is_of_element(feature, volume.copied_from))
            elements.try_emplace(volume.copied_from.front().instance, volume.motion);
        else if (is_by_shape)
            elements.try_emplace(volume.instance, volume.motion);
    if (elements.empty()) return elements;
    const RigidMotion to_first = elements.begin()->second.inverse();
    for (auto& [_, way] : elements) way = compose(way, to_first);
    return elements;
}

bool is_same_place(const RigidMotion& a, const RigidMotion& b) {
    for (std::size_t i = 0; i < a.rotation.size(); ++i)
        if (std::abs(a.rotation[i] - b.rotation[i]) > Tolerances::same_direction) return false;
    return distance(a.translation, b.translation) < Tolerances{}.same_geometry();
}

/// Is each as far from the one before as that from the one before it?
bool is_row(const Elements& elements) {
    if (elements.size() < 2) return true;
    const RigidMotion step = std::next(elements.begin())->second;
    for (auto it = elements.begin(); std::next(it) != elements.end(); ++it)
        if (!is_same_place(std::next(it)->second, compose(step, it->second))) return false;
    return true;
}

}  // namespace

bool is_of_element(const Feature& feature, const std::vector<VolumeName>& copied_from) {
    return !copied_from.empty() && copied_from.front().feature == feature.name;
}

ArrayElements::ArrayElements(const FeatureTree& was, const FeatureTree& is) {
    for (const Feature& feature : was.features) {
        const Elements old_elements = elements_of(feature);
        const auto id = is.find(feature.name);
        if (old_elements.empty() || !id) continue;
        const Elements new_elements = elements_of(is[*id]);
        if (new_elements.size() == old_elements.size()) continue;
        std::map<std::int64_t, std::int64_t> numbers;
        std::size_t staying = 0;
        for (const auto& [number, place] : old_elements) {
            const auto found =
                std::find_if(new_elements.begin(), new_elements.end(),
                             [&, &there = place](const auto& e) { return is_same_place(e.second, there); });
            numbers[number] = found == new_elements.end() ? gone : found->first;
            staying += found != new_elements.end();
        }
        const bool is_first_alone = staying == 1;
        if (!is_first_alone || !is_row(old_elements) || !is_row(new_elements))
            new_numbers_[feature.name] = std::move(numbers);
    }
}

VolumeName ArrayElements::now(const VolumeName& element) const {
    const auto found = new_numbers_.find(element.feature);
    if (found == new_numbers_.end() || !found->second.contains(element.instance)) return element;
    return {element.feature, found->second.at(element.instance)};
}

}  // namespace featuremesh
