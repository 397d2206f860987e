// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "volume/improvement/local_mesh.h"

namespace featuremesh {

/// The vertices that an operation has tried in vain since their stars last changed. What it can do for a vertex depends
/// on the star alone, so threads may share one list: whoever comes first spares the others the same try.
class TriedMarks {
  public:
    /// Not at the same time as what other threads ask or note, unless there is room already.
    void make_room(const LocalMesh& mesh) { tried_at_.resize(mesh.complex().points.size(), 0); }
    bool has(int vertex, const LocalMesh& mesh) { return at(vertex).load(relaxed) >= mesh.changed_at(vertex); }
    void note(int vertex, const LocalMesh& mesh) { at(vertex).store(mesh.now(), relaxed); }

  private:
    static constexpr std::memory_order relaxed = std::memory_order_relaxed;
    std::atomic_ref<std::uint32_t> at(int vertex) {
        return std::atomic_ref<std::uint32_t>(tried_at_[static_cast<std::size_t>(vertex)]);
    }
    std::vector<std::uint32_t> tried_at_;
};

}  // namespace featuremesh
