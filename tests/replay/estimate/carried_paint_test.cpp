#include "replay/estimate/carried_paint.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

constexpr std::uint32_t kBlueSet = 1, kRedSet = 2;

/// A stamp upon cells that all have the channels in `mask`, ten under each band.
CarriedPaint::Contact upon(std::uint32_t mask) {
  CarriedPaint::Contact contact;
  for (int band = 0; band < CarriedPaint::kBands; ++band)
    for (int cell = 0; cell < 10; ++cell) contact.add(band, mask);
  return contact;
}

TEST(CarriedPaint, ABandLaysWhatItWasDippedInto) {
  CarriedPaint paint;
  paint.dip(kBlueSet, kAllRows);
  paint.dip(kRedSet, rows_across(0.5f, 1));
  for (int band = 0; band < CarriedPaint::kBands; ++band) {
    EXPECT_EQ(paint.deposited(band), band < CarriedPaint::kBands / 2 ? kBlueSet : kRedSet) << band;
    EXPECT_EQ(paint.loaded(band), paint.deposited(band));
  }
  paint.dip(kBlueSet, rows_across(0.5f, 0.5f));  // a row of the reservoir at least
  EXPECT_EQ(paint.deposited(CarriedPaint::kBands / 2), kBlueSet);
  EXPECT_EQ(paint.deposited(CarriedPaint::kBands / 2 + 1), kRedSet);
}

TEST(CarriedPaint, BandsDivideTheTipsWidth) {
  EXPECT_EQ(CarriedPaint::band_of(-0.5f), 0);
  EXPECT_EQ(CarriedPaint::band_of(-0.01f), CarriedPaint::kBands / 2 - 1);
  EXPECT_EQ(CarriedPaint::band_of(0.01f), CarriedPaint::kBands / 2);
  EXPECT_EQ(CarriedPaint::band_of(0.5f), CarriedPaint::kBands - 1);
}

TEST(CarriedPaint, LaysWhatItTookUpUntilTheLoadHasReplacedIt) {
  CarriedPaint paint;
  paint.dip(kBlueSet, kAllRows);
  paint.pass(upon(kRedSet), 0.25, 0.1);
  EXPECT_EQ(paint.deposited(3), kBlueSet | kRedSet);
  // 0.25 x 0.9 of it, then 0.9 of that each time: under 3e-4 after 63 more.
  int passes = 0;
  while (paint.deposited(3) != kBlueSet && passes < 100) {
    paint.pass(upon(0), 0.25, 0.1);
    ++passes;
  }
  EXPECT_EQ(passes, 63);
}

TEST(CarriedPaint, AKnifeLaysOnlyWhatItTookUp) {
  CarriedPaint paint;  // never dipped
  EXPECT_EQ(paint.deposited(0), 0u);
  paint.pass(upon(kRedSet), 0.25, 0);
  for (int i = 0; i < 100; ++i) paint.pass(upon(0), 0.25, 0);
  EXPECT_EQ(paint.deposited(0), kRedSet);
  EXPECT_EQ(paint.loaded(0), 0u);
}

}  // namespace
}  // namespace pentimento
