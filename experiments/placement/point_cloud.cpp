// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/placement/point_cloud.h"

#include <cmath>
#include <cstdint>
#include <cstring>

#include "experiments/placement/point_cloud_header.h"
#include "experiments/scene_files/yaml_value.h"
#include "robots/number_text.h"

namespace b4p {
namespace {

template <class To, class From>
To sameBits(From bits) {
  static_assert(sizeof(To) == sizeof(From));
  To value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

double decoded(const unsigned char* bytes, const NumberFormat& format, PointEncoding encoding) {
  constexpr std::size_t kByte = 8, kLongest = 8;
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < format.bytes; ++i)
    bits = bits << kByte | bytes[encoding == PointEncoding::kBigEndian ? i : format.bytes - 1 - i];
  if (format.kind == 'U') return static_cast<double>(bits);
  if (format.kind == 'F' && format.bytes == sizeof(float))
    return static_cast<double>(sameBits<float>(static_cast<std::uint32_t>(bits)));
  if (format.kind == 'F') return sameBits<double>(bits);
  const std::uint64_t sign = std::uint64_t{1} << (kByte * format.bytes - 1);
  if (format.bytes < kLongest && (bits & sign) != 0) bits |= ~(sign - 1);
  return static_cast<double>(sameBits<std::int64_t>(bits));
}

/// Gives the points of a file one by one.
class PointRows {
 public:
  PointRows(PointFile& file, const PointCloudHeader& header) : file_(file), header_(header) {
    std::vector<std::size_t> value(1, 0), byte(1, 0);
    for (const PointColumn& column : header.columns) {
      value.push_back(value.back() + column.count);
      byte.push_back(byte.back() + column.count * column.format.bytes);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      value_.at(axis) = value.at(header.xyz.at(axis));
      byte_.at(axis) = byte.at(header.xyz.at(axis));
    }
    values_ = value.back();
    row_.resize(byte.back());
  }

  Eigen::Vector3d next() {
    Eigen::Vector3d p = header_.encoding == PointEncoding::kText ? nextLine() : nextBytes();
    ++read_;
    return p;
  }

  [[noreturn]] void fail(const std::string& problem) const {
    if (header_.encoding == PointEncoding::kText) file_.failHere(problem);
    file_.fail("point " + std::to_string(read_ - 1), problem);
  }

 private:
  Eigen::Vector3d nextLine() {
    const auto words = file_.next();
    if (words.size() != values_)
      file_.failHere("has " + std::to_string(words.size()) + " values, not " + std::to_string(values_));
    return {file_.number(words[value_[0]]), file_.number(words[value_[1]]), file_.number(words[value_[2]])};
  }

  Eigen::Vector3d nextBytes() {
    if (!file_.read(row_))
      file_.fail("", "ends after " + std::to_string(read_) + " of " + std::to_string(header_.points) +
                         " points, too early");
    Eigen::Vector3d p;
    for (std::size_t axis = 0; axis < 3; ++axis)
      p[static_cast<Eigen::Index>(axis)] = decoded(
          row_.data() + byte_.at(axis), header_.columns.at(header_.xyz.at(axis)).format, header_.encoding);
    return p;
  }

  PointFile& file_;
  const PointCloudHeader& header_;
  std::array<std::size_t, 3> value_{}, byte_{};  ///< where in a row the coordinates are
  std::size_t values_ = 0;                       ///< in a row
  std::vector<unsigned char> row_;
  std::size_t read_ = 0;
};

}  // namespace

std::vector<Eigen::Vector3d> readPointCloud(const std::string& name) {
  PointFile file(name);
  const PointCloudHeader header = readPointCloudHeader(file);
  PointRows rows(file, header);
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < header.points; ++i) {
    const Eigen::Vector3d p = rows.next();
    if (p.array().isNaN().all()) continue;
    for (const double coordinate : p)
      if (!(std::abs(coordinate) <= kFarthest_m))
        rows.fail("'" + numberText(coordinate) + "' is not a coordinate within 1000 m");
    points.push_back(p);
  }
  if (points.empty()) file.fail("", "holds no points but missing ones");
  return points;
}

}  // namespace b4p
