#include "core/fluid/brush_contact.h"

#include <algorithm>
#include <array>

#include "core/base/give_back.h"

namespace pentimento {

namespace {
std::array<Field<float>*, 5> planes_of(BrushContact& c) {
  return {&c.weight, &c.velocity_x_m_s, &c.velocity_y_m_s, &c.push_x_m, &c.push_y_m};
}
}  // namespace

BrushContact make_brush_contact(int width, int height) {
  BrushContact c;
  const auto planes = planes_of(c);
  PlaneMemory memory(static_cast<int>(planes.size()), width, height);
  for (Field<float>* f : planes) *f = Field<float>(width, height, memory);
  return c;
}

void clear(BrushContact& c) {
  for (Field<float>* f : planes_of(c))
    for (int y = c.row_begin; y < c.row_end; ++y)
      std::fill(f->row(y) + c.column_begin, f->row(y) + c.column_end, 0.0f);
  c.row_begin = c.row_end = 0;
  c.column_begin = c.column_end = 0;
}

void give_back(BrushContact& c) {
  PENTIMENTO_CHECK(c.empty());
  for (Field<float>* f : planes_of(c)) {
    const float* const end = f->row(f->height() - 1) + f->width();
    give_back(f->row(0), static_cast<std::size_t>(end - f->row(0)) * sizeof(float));
  }
}

BrushContact clone(const BrushContact& c) {
  return {c.weight.clone(),   c.velocity_x_m_s.clone(), c.velocity_y_m_s.clone(),
          c.push_x_m.clone(), c.push_y_m.clone(),       c.row_begin,
          c.row_end,          c.column_begin,           c.column_end};
}

}  // namespace pentimento
