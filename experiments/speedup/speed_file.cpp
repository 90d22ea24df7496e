// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/speedup/speed_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "experiments/output_file.h"
#include "experiments/runner/build_info.h"
#include "robots/input_error.h"

namespace b4p {

using Json = nlohmann::ordered_json;

namespace {

constexpr int kSchema = 1;
constexpr const char* kSimulated = "virtual time";
constexpr const char* kThreads = "threads";

Json toJson(const SpeedStudy& study) {
  Json parameters = Json::object();
  for (const auto& [name, value] : study.parameters) parameters[name] = value;
  return {{"schema", kSchema},
          {"scene", study.scene},
          {"planner", study.planner},
          {"parameters", parameters},
          {"time_limit_s", study.time_limit_s}};
}

Json toJson(const SpeedRun& run) {
  return {{"kind", run.which.real_threads ? kThreads : kSimulated},
          {"workers", run.which.workers},
          {"seed", run.which.seed},
          {"solved", run.solved},
          {"verified", run.verified},
          {"time_s", run.time_s},
          {"work_s", run.work_s},
          {"steps", run.steps}};
}

SpeedRun runFrom(const Json& json) {
  SpeedRun run;
  const auto kind = json.at("kind").get<std::string>();
  if (kind != kThreads && kind != kSimulated) throw std::invalid_argument("unknown kind '" + kind + "'");
  run.which.real_threads = kind == kThreads;
  json.at("workers").get_to(run.which.workers);
  json.at("seed").get_to(run.which.seed);
  json.at("solved").get_to(run.solved);
  json.at("verified").get_to(run.verified);
  json.at("time_s").get_to(run.time_s);
  json.at("work_s").get_to(run.work_s);
  json.at("steps").get_to(run.steps);
  return run;
}

/// The file's lines, but for a last one without its end.
std::vector<std::string> wholeLines(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(file, "", "cannot be read");
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  std::istringstream whole(text.substr(0, text.rfind('\n') + 1));
  std::vector<std::string> lines;
  for (std::string line; std::getline(whole, line);) lines.push_back(line);
  return lines;
}

/// What the header says of the build is for readers: a study may be continued by a later one.
void requireSameStudy(Json header, const SpeedStudy& study) {
  header.erase("build");
  const Json expected = toJson(study);
  for (const auto& item : expected.items())
    if (header.at(item.key()) != item.value())
      throw std::invalid_argument("holds runs of another study: " + item.key() + " is " +
                                  header.at(item.key()).dump() + ", not " + item.value().dump());
}

}  // namespace

SpeedFile::SpeedFile(std::string file, const SpeedStudy& study) : file_(std::move(file)) {
  requireWritableFile(file_);
  if (std::filesystem::is_regular_file(file_)) read(study);
  if (!text_.empty()) return;
  Json header = toJson(study);
  header["build"] = buildInfo();
  text_ = header.dump() + "\n";
}

void SpeedFile::read(const SpeedStudy& study) {
  std::size_t number = 0;
  for (const std::string& line : wholeLines(file_)) {
    ++number;
    try {
      const Json json = Json::parse(line);
      if (number == 1)
        requireSameStudy(json, study);
      else
        runs_.push_back(runFrom(json));
    } catch (const std::exception& e) {
      throw InputError(file_, "line " + std::to_string(number), e.what());
    }
    text_ += line + "\n";
  }
}

bool SpeedFile::has(const SpeedCase& which) const {
  return std::any_of(runs_.begin(), runs_.end(), [&](const SpeedRun& run) { return run.which == which; });
}

void SpeedFile::add(const SpeedRun& run) {
  runs_.push_back(run);
  text_ += toJson(run).dump() + "\n";
  writeFile(file_, text_);
}

}  // namespace b4p
