// SPDX-License-Identifier: GPL-3.0-or-later
#include "sizing/zones.h"

#include "sizing/size_zone.h"
#include "sizing/zone_field.h"

namespace featuremesh {
namespace {

class ZoneProvider : public SizeProvider {
  public:
    ZoneProvider(const Brep& brep, const SizingOptions& options) : brep_(brep), options_(options) {}

    void cover(SizePlaces& out, const RunContext& context) const override {
        for (const SizeZone& zone : options_.zones) {
            context.check_cancelled();
            ZoneField field(brep_, zone, options_.size, options_.growth - 1);
            if (field.asks_for_less_than(options_.size)) out.zones.push_back(std::move(field));
        }
    }

  private:
    const Brep& brep_;
    const SizingOptions& options_;
};

}  // namespace

std::unique_ptr<SizeProvider> zone_provider(const Brep& brep, const SizingOptions& options) {
    return std::make_unique<ZoneProvider>(brep, options);
}

}  // namespace featuremesh
