// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/scene_files/grasp_table.h"

#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>

#include "experiments/scene_files/yaml_value.h"
#include "robots/input_error.h"
#include "robots/number_text.h"

namespace b4p {
namespace {

constexpr std::size_t kPoseColumns = 16;
constexpr double kRotationError = 1e-4;

/// One row of the file, which its errors name.
class Row {
 public:
  Row(const std::string& file, std::size_t number, const std::string& line) : file_(file), number_(number) {
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) cells_.push_back(trimmed(cell));
    if (!line.empty() && line.back() == ',') cells_.emplace_back();
  }

  void requireColumns(std::size_t columns) const {
    if (cells_.size() != columns)
      fail("has " + std::to_string(cells_.size()) + " columns instead of " + std::to_string(columns));
  }

  Eigen::Isometry3d pose() const {
    Eigen::Matrix<double, 4, 4, Eigen::RowMajor> matrix;
    for (std::size_t column = 0; column < kPoseColumns; ++column) matrix.data()[column] = number(column);
    if (matrix.row(3) != Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0))
      fail("does not end in 0, 0, 0, 1 (" + numberText(matrix(3, 0)) + ", " + numberText(matrix(3, 1)) +
           ", " + numberText(matrix(3, 2)) + ", " + numberText(matrix(3, 3)) + ")");
    const Eigen::Matrix3d R = matrix.topLeftCorner<3, 3>();
    const double error = (R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    if (error > kRotationError)
      fail("has a rotation that is not orthonormal (off by " + numberText(error) + ")");
    if (R.determinant() < 0.0) fail("has a rotation that is a reflection (determinant -1)");
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    X.linear() = Eigen::Quaterniond(R).normalized().toRotationMatrix();
    X.translation() = matrix.topRightCorner<3, 1>();
    return X;
  }

  double opening_m(double max_opening_m) const {
    const double opening_m = number(kPoseColumns);
    if (opening_m < 0.0 || opening_m > max_opening_m)
      fail("has an opening outside 0 to " + numberText(max_opening_m) + " m (" + numberText(opening_m) + ")");
    return opening_m;
  }

 private:
  static std::string trimmed(const std::string& cell) {
    constexpr const char* kBlank = " \t\r";
    const auto first = cell.find_first_not_of(kBlank);
    return first == std::string::npos ? "" : cell.substr(first, cell.find_last_not_of(kBlank) - first + 1);
  }

  double number(std::size_t column) const {
    const std::string& cell = cells_[column];
    const std::string where = "column " + std::to_string(column + 1) + " ";
    double value = 0.0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc() || end != cell.data() + cell.size())
      fail(where + "is not a number (" + cell + ")");
    if (!std::isfinite(value)) fail(where + "is not finite (" + cell + ")");
    if (std::abs(value) > kFarthest_m)
      fail(where + "is more than " + numberText(kFarthest_m) + " away from 0 (" + cell + ")");
    return value;
  }

  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(file_, "row " + std::to_string(number_), problem);
  }

  const std::string& file_;
  std::size_t number_;
  std::vector<std::string> cells_;
};

/// Calls `add` with each row of `columns` numbers.
template <class Add>
void readRows(const std::string& file, std::size_t columns, const Add& add) {
  std::ifstream in(file);
  if (!in) throw InputError(file, "", "no such file, or it cannot be read");
  std::size_t rows = 0;
  for (std::string line; std::getline(in, line);) {
    const Row row(file, ++rows, line);
    row.requireColumns(columns);
    add(row);
  }
  if (in.bad()) throw InputError(file, "", "cannot be read");
  if (rows == 0) throw InputError(file, "", "holds no grasp");
}

}  // namespace

std::vector<Eigen::Isometry3d> readGraspTable(const std::string& file) {
  std::vector<Eigen::Isometry3d> poses;
  readRows(file, kPoseColumns, [&poses](const Row& row) { poses.push_back(row.pose()); });
  return poses;
}

std::vector<Grasp> readHoldingTable(const std::string& file, double max_opening_m) {
  std::vector<Grasp> grasps;
  readRows(file, kPoseColumns + 1, [&grasps, max_opening_m](const Row& row) {
    grasps.push_back({row.pose(), row.opening_m(max_opening_m)});
  });
  return grasps;
}

}  // namespace b4p
