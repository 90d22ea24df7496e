// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/placement/point_file.h"

#include <charconv>
#include <sstream>

#include "robots/input_error.h"

namespace b4p {
namespace {

template <class Value>
bool parse(const std::string& word, Value& value) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

}  // namespace

PointFile::PointFile(const std::string& file) : file_(file), stream_(file, std::ios::binary) {
  if (!stream_) fail("", "cannot be read");
}

std::vector<std::string> PointFile::next() {
  std::string line;
  if (!std::getline(stream_, line)) fail("", "ends after line " + std::to_string(number_) + ", too early");
  ++number_;
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

bool PointFile::read(std::vector<unsigned char>& bytes) {
  const auto size = static_cast<std::streamsize>(bytes.size());
  return static_cast<bool>(stream_.read(reinterpret_cast<char*>(bytes.data()), size));
}

void PointFile::failHere(const std::string& problem) const {
  fail("line " + std::to_string(number_), problem);
}

void PointFile::fail(const std::string& element, const std::string& problem) const {
  throw InputError(file_, element, problem);
}

std::size_t PointFile::count(const std::string& word) const {
  std::size_t value = 0;
  if (!parse(word, value)) failHere("'" + word + "' is not a count");
  return value;
}

double PointFile::number(const std::string& word) const {
  double value = 0.0;
  if (!parse(word, value)) failHere("'" + word + "' is not a number");
  return value;
}

}  // namespace b4p
