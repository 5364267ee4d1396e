#include "tests/core/fluid/shallow_water.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

// The exact solutions that the schemes are measured with, against tables by other hands
// (tests/data/shallow-water/SOURCE.txt). The tables are rounded to 6 digits and more.

namespace pentimento::shallow_water {
namespace {

std::vector<std::vector<std::string>> rows_of(const std::string& name) {
  std::ifstream in(std::string(PENTIMENTO_TEST_DATA) + "/shallow-water/" + name);
  std::vector<std::vector<std::string>> rows;
  std::string line;
  std::getline(in, line);  // names of the columns
  while (std::getline(in, line)) {
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

TEST(ShallowWater, DamBreaksAgreeWithTheTables) {
  const DamBreak wet(0.005, 0.001), dry(0.005, 0);
  const auto rows = rows_of("dam_break_swashes_T6.csv");
  ASSERT_EQ(rows.size(), 100u);
  for (const auto& r : rows) {
    const double x = std::stod(r[0]) - 5;
    EXPECT_NEAR(wet.at(x, 6).depth_m, std::stod(r[1]), 1e-9) << x;
    EXPECT_NEAR(wet.at(x, 6).u_m_s, std::stod(r[2]), 1e-6) << x;
    EXPECT_NEAR(dry.at(x, 6).depth_m, std::stod(r[3]), 1e-9) << x;
  }
}

TEST(ShallowWater, BowlsAgreeWithTheTables) {
  const auto rows = rows_of("thacker_centreline_y2.csv");
  ASSERT_EQ(rows.size(), 400u);
  for (const auto& r : rows) {
    const bool planar = r[0] == "planar";
    const double t = std::stod(r[2]), x = std::stod(r[3]);
    const Flow f = planar ? thacker_planar(x, 2, t) : thacker_radial(x, 2, t);
    EXPECT_NEAR(f.depth_m, std::stod(r[4]), 1e-7) << r[0] << " " << t << " " << x;
    EXPECT_NEAR(bowl_m(x, 2), std::stod(r[7]), 1e-9);
    if (f.depth_m > 0) {
      EXPECT_NEAR(f.u_m_s, std::stod(r[5]), 1e-6);
      EXPECT_NEAR(f.v_m_s, std::stod(r[6]), 1e-6);
    }
  }
}

}  // namespace
}  // namespace pentimento::shallow_water
