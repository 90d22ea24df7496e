// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <locale>
#include <sstream>
#include <string>

namespace b4p {

/// A number as it appears in messages: six significant digits, whatever the locale.
inline std::string numberText(double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
}

}  // namespace b4p
