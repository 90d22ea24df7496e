// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>
#include <sstream>
#include <string>

namespace b4p {

/// A number as OMPL's logs have it, with all its digits; "nan" where it is not finite.
inline std::string columnNumber(double value) {
  if (!std::isfinite(value)) return "nan";
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  text << value;
  return text.str();
}

}  // namespace b4p
