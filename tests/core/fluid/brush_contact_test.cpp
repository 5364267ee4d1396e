#include "core/fluid/brush_contact.h"

#include <gtest/gtest.h>

#include "tests/core/base/resident_memory.h"

namespace pentimento {
namespace {

bool is_untouched(const BrushContact& c) {
  for (const Field<float>* f :
       {&c.weight, &c.velocity_x_m_s, &c.velocity_y_m_s, &c.push_x_m, &c.push_y_m})
    for (int y = 0; y < f->height(); ++y)
      for (const float value : f->view().row_span(y))
        if (value != 0) return false;
  return true;
}

/// Writes to the corners of a box, and says so.
void touch_corners(BrushContact& c, int x0, int x1, int y0, int y1) {
  for (Field<float>* f :
       {&c.weight, &c.velocity_x_m_s, &c.velocity_y_m_s, &c.push_x_m, &c.push_y_m})
    for (const int y : {y0, y1 - 1})
      for (const int x : {x0, x1 - 1}) (*f)(x, y) = 0.5f;
  c.touch(x0, x1, y0, y1);
}

TEST(BrushContact, HoldsTheBoxAroundAllTouches) {
  BrushContact c = make_brush_contact(40, 30);
  EXPECT_TRUE(c.empty());
  c.touch(20, 25, 10, 12);
  c.touch(5, 8, 11, 20);
  EXPECT_FALSE(c.empty());
  EXPECT_EQ(c.column_begin, 5);
  EXPECT_EQ(c.column_end, 25);
  EXPECT_EQ(c.row_begin, 10);
  EXPECT_EQ(c.row_end, 20);
  const BrushContact copy = clone(c);
  EXPECT_EQ(copy.column_begin, 5);
  EXPECT_EQ(copy.column_end, 25);
}

TEST(BrushContact, IsUntouchedWhenCleared) {
  BrushContact c = make_brush_contact(40, 30);
  // The corners of the canvas, and then a box inside: what came before does not count.
  for (const int times : {1, 2}) {
    touch_corners(c, 0, 40, 0, 30);
    if (times == 2) touch_corners(c, 3, 9, 4, 7);
    clear(c);
    EXPECT_TRUE(is_untouched(c));
    EXPECT_TRUE(c.empty());
    touch_corners(c, 17, 18, 29, 30);
    EXPECT_EQ(c.column_begin, 17);
    EXPECT_EQ(c.column_end, 18);
    clear(c);
    EXPECT_TRUE(is_untouched(c));
  }
}

TEST(BrushContact, GivesItsMemoryBackAndStaysUntouched) {
  BrushContact c = make_brush_contact(4096, 2048);  // planes of 32 MiB
  for (Field<float>* f :
       {&c.weight, &c.velocity_x_m_s, &c.velocity_y_m_s, &c.push_x_m, &c.push_y_m})
    f->fill(0.5f);
  c.touch(0, 4096, 0, 2048);
  clear(c);
  const long before_mib = resident_mib();
  give_back(c);
  EXPECT_LE(resident_mib() - before_mib, is_marked_when_given() ? 0 : -150);
  EXPECT_TRUE(is_untouched(c));
}

}  // namespace
}  // namespace pentimento
