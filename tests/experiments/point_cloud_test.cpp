// SPDX-License-Identifier: BSD-3-Clause
// Promises: PLY and PCD give the same points in text and in bytes of either order; what is malformed is
// refused in one line that says where; missing measurements are left out.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/fixtures.h"
#include "experiments/placement/point_cloud.h"
#include "robots/input_error.h"

namespace b4p::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

std::string cloudRefusal(const std::string& text) {
  const TemporaryFolder folder;
  writeText(folder / "cloud.ply", text);
  try {
    readPointCloud(folder / "cloud.ply");
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), AllOf(HasSubstr("cloud.ply"), Not(HasSubstr("\n"))));
    return e.what();
  }
  return "accepted";
}

const char* const kPly =
    "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 2\nproperty float x\nproperty uchar red\n"
    "property float y\nproperty float z\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n"
    "0.5 255 1 2\n-0.25 0 1e-1 3\n";
const char* const kPcd =
    "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH 2\nHEIGHT "
    "1\n"
    "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA ascii\n0.5 1 2 7\n-0.25 0.1 3 7\n";

TEST(PointCloud, PlyAndPcdGiveTheSamePoints) {
  const TemporaryFolder folder;
  for (const char* text : {kPly, kPcd}) {
    writeText(folder / "cloud", text);
    const auto points = readPointCloud(folder / "cloud");
    ASSERT_EQ(points.size(), 2u);
    EXPECT_TRUE(points[0].isApprox(Eigen::Vector3d(0.5, 1, 2)));
    EXPECT_TRUE(points[1].isApprox(Eigen::Vector3d(-0.25, 0.1, 3)));
  }
}

TEST(PointCloud, WhatIsMalformedIsRefusedInOneLine) {
  EXPECT_THAT(cloudRefusal(""), HasSubstr("too early"));
  EXPECT_THAT(cloudRefusal("solid cube\n"), HasSubstr("neither as PLY nor as PCD"));
  EXPECT_THAT(cloudRefusal(replaced(kPly, "ascii 1.0", "binary 1.0")), HasSubstr("'binary' is no format"));
  EXPECT_THAT(cloudRefusal(replaced(kPly, "uchar red", "byte red")), HasSubstr("'byte' is no type"));
  EXPECT_THAT(cloudRefusal(replaced(kPly, "vertex 2", "vertex 3")), HasSubstr("too early"));
  EXPECT_THAT(cloudRefusal(replaced(kPly, "vertex 2", "vertex many")), HasSubstr("'many' is not a count"));
  EXPECT_THAT(cloudRefusal(replaced(kPly, "vertex 2", "vertex 0")), HasSubstr("no points"));
  EXPECT_THAT(cloudRefusal(replaced(kPly, "1e-1", "nan")), AllOf(HasSubstr("line 13"), HasSubstr("'nan'")));
  EXPECT_THAT(cloudRefusal(replaced(kPly, "1e-1", "1e9")), HasSubstr("within 1000 m"));
  EXPECT_THAT(cloudRefusal(replaced(kPly, "1e-1", "0,1")), HasSubstr("'0,1' is not a number"));
  EXPECT_THAT(cloudRefusal(replaced(kPly, "property float z\n", "")), HasSubstr("points have no z"));
  EXPECT_THAT(cloudRefusal(std::string(kPly).substr(0, std::string(kPly).find("end_header"))),
              HasSubstr("too early"));
  EXPECT_THAT(cloudRefusal(replaced(kPcd, "DATA ascii", "DATA binary_compressed")),
              AllOf(HasSubstr("line 11"), HasSubstr("binary_compressed is not supported")));
  EXPECT_THAT(cloudRefusal(replaced(kPcd, "DATA ascii", "DATA morse")), HasSubstr("'morse' is no DATA"));
  EXPECT_THAT(cloudRefusal(replaced(kPcd, "COUNT 1 1 1 1", "COUNT 1 1 1")),
              HasSubstr("3 values for 4 fields"));
  EXPECT_THAT(cloudRefusal(replaced(kPcd, "COUNT 1", "COUNT 2")), HasSubstr("several values of x"));
  EXPECT_THAT(cloudRefusal(replaced(kPcd, "POINTS 2\n", "")), HasSubstr("no POINTS"));
  EXPECT_THAT(cloudRefusal(replaced(kPcd, "0.1 3 7", "0.1 3")), HasSubstr("has 3 values, not 4"));
  EXPECT_THROW(readPointCloud("/nowhere/cloud.ply"), InputError);
}

template <class Number>
std::string bytesOf(Number value, bool big_endian) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  const std::uint16_t one = 1;
  unsigned char first = 0;
  std::memcpy(&first, &one, 1);
  if ((first == 0) != big_endian) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// x as float, a colour of three values, y as double, z as a signed whole number.
std::string binaryRow(float x, double y, std::int16_t z, bool big_endian = false) {
  return bytesOf(x, big_endian) + "\n\r\xff" + bytesOf(y, big_endian) + bytesOf(z, big_endian);
}

std::string binaryPly(bool big_endian, const std::string& rows) {
  return std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
         "_endian 1.0\nelement vertex 2\nproperty float x\nproperty uchar r\nproperty uchar g\nproperty "
         "uchar b\n"
         "property double y\nproperty short z\nelement face 0\nproperty list uchar int "
         "vertex_indices\nend_header\n" +
         rows;
}

std::string binaryPcd(const std::string& rows) {
  return "VERSION 0.7\nFIELDS x rgb y z\nSIZE 4 1 8 2\nTYPE F U F I\nCOUNT 1 3 1 1\nWIDTH 2\nHEIGHT "
         "1\nPOINTS 2\n"
         "DATA binary\n" +
         rows;
}

TEST(PointCloud, BinaryFilesOfEitherByteOrderAreRead) {
  const TemporaryFolder folder;
  const auto rows = [](bool big_endian) {
    return binaryRow(0.5F, 1.0, 2, big_endian) + binaryRow(-0.25F, 0.1, -3, big_endian);
  };
  for (const std::string& file :
       {binaryPly(false, rows(false)), binaryPly(true, rows(true)), binaryPcd(rows(false))}) {
    writeText(folder / "cloud", file);
    const auto points = readPointCloud(folder / "cloud");
    ASSERT_EQ(points.size(), 2u);
    EXPECT_EQ(points[0], Eigen::Vector3d(0.5, 1.0, 2.0));
    EXPECT_EQ(points[1], Eigen::Vector3d(-0.25, 0.1, -3.0));
  }
}

TEST(PointCloud, BinaryFilesThatAreMalformedAreRefusedInOneLine) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::string good = binaryRow(0.5F, 1.0, 2);
  for (const std::string& file : {binaryPly(false, good + good.substr(1)), binaryPcd(good + good.substr(1))})
    EXPECT_THAT(cloudRefusal(file), HasSubstr("ends after 1 of 2 points"));
  EXPECT_THAT(cloudRefusal(binaryPcd("")), HasSubstr("ends after 0 of 2 points"));
  EXPECT_THAT(cloudRefusal(binaryPcd(good + binaryRow(0.0F, 1e9, 0))),
              AllOf(HasSubstr("point 1"), HasSubstr("within 1000 m")));
  EXPECT_THAT(cloudRefusal(binaryPcd(good + binaryRow(nan, 1.0, 0))),
              AllOf(HasSubstr("point 1"), HasSubstr("nan")));
  EXPECT_THAT(cloudRefusal(replaced(binaryPcd(good + good), "SIZE 4 1 8 2\n", "")), HasSubstr("no SIZE"));
  EXPECT_THAT(
      cloudRefusal(
          "FIELDS x y z\nSIZE 99999999999999 4 4\nTYPE F F F\nCOUNT 1 1 1\nPOINTS 1\nDATA ascii\n0 0 0\n"),
      HasSubstr("field 'x' of TYPE F has SIZE 99999999999999"));
  EXPECT_THAT(cloudRefusal(replaced(binaryPcd(good + good), "SIZE 4 1 8", "SIZE 2 1 8")),
              HasSubstr("field 'x' of TYPE F has SIZE 2"));
  EXPECT_THAT(cloudRefusal(replaced(binaryPcd(good + good), "SIZE 4 1 8", "SIZE 4 3 8")),
              HasSubstr("field 'rgb' of TYPE U has SIZE 3"));
  EXPECT_THAT(cloudRefusal(replaced(binaryPcd(good + good), "COUNT 1 3", "COUNT 1 999999999999")),
              HasSubstr("is not a COUNT"));
}

TEST(PointCloud, MissingMeasurementsAreLeftOut) {
  const TemporaryFolder folder;
  writeText(folder / "cloud", replaced(kPcd, "0.5 1 2", "nan nan nan"));
  const auto points = readPointCloud(folder / "cloud");
  ASSERT_EQ(points.size(), 1u);
  EXPECT_TRUE(points[0].isApprox(Eigen::Vector3d(-0.25, 0.1, 3)));
  EXPECT_THAT(cloudRefusal(replaced(replaced(kPcd, "0.5 1 2", "nan nan nan"), "-0.25 0.1 3", "nan nan nan")),
              HasSubstr("no points but missing ones"));
}

}  // namespace
}  // namespace b4p::test
