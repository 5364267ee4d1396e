#include "core/shading/gloss_keeper.h"

#include <cstring>

namespace pentimento {
namespace {

bool same(const Field<float>& a, const Field<float>& b) {
  if (a.width() != b.width() || a.height() != b.height()) return false;
  for (int y = 0; y < a.height(); ++y) {
    const std::size_t bytes = static_cast<std::size_t>(a.width()) * sizeof(float);
    if (std::memcmp(a.row(y), b.row(y), bytes) != 0) return false;
  }
  return true;
}

bool same(const GlossSurface& a, const GlossSurface& b) {
  return a.roughness_dry == b.roughness_dry && a.roughness_wet == b.roughness_wet &&
         a.refractive_index == b.refractive_index;
}

}  // namespace

const GlossTable* GlossKeeper::table(const Lighting& lighting, const Threads& threads) {
  if (lighting.probe[0].empty()) return nullptr;
  const GlossSurface surface{lighting.roughness_dry, lighting.roughness_wet,
                             lighting.refractive_index};
  bool kept = !table_.rgb.empty() && same(surface, surface_);
  for (std::size_t c = 0; kept && c < 3; ++c) kept = same(lighting.probe[c], probe_[c]);
  if (kept) return &table_;
  surface_ = surface;
  for (std::size_t c = 0; c < 3; ++c) probe_[c] = lighting.probe[c].clone();
  table_ =
      make_gloss_table({probe_[0].view(), probe_[1].view(), probe_[2].view()}, surface, threads);
  return &table_;
}

}  // namespace pentimento
