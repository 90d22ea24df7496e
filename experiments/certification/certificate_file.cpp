// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "experiments/certification/certificate.h"
#include "experiments/json_value.h"
#include "experiments/output_file.h"
#include "experiments/result_json.h"

namespace b4p {
namespace {

constexpr int kSchema = 1;

Json gridJson(const planar::GridSize& grid) { return {{"cell_m", grid.cell_m}, {"angles", grid.angles}}; }

Json settingsJson(const CertificateSettings& settings) {
  Json grids = Json::array();
  for (const planar::GridSize& grid : settings.grids) grids.push_back(gridJson(grid));
  return {{"seed", settings.seed},
          {"grasps", settings.grasps},
          {"placement_draws", settings.placement_draws},
          {"effort_s", settings.effort_s},
          {"grids", grids}};
}

Json numbersJson(const CertificateNumbers& numbers) {
  return {{"sampled", numbers.sampled},
          {"valid_at_pick", numbers.valid_at_pick},
          {"with_placement", numbers.with_placement},
          {"compatible", numbers.compatible},
          {"blocked", numbers.blocked},
          {"undecided", numbers.undecided},
          {"clearance_m", numbers.clearance_m}};
}

Json recordJson(const GraspRecord& record) {
  constexpr double kMilliseconds = 1000.0;
  if (!std::isfinite(record.clearance_m) || !std::isfinite(record.seconds))
    throw std::invalid_argument("certificate: a grasp's numbers are not finite");
  const bool blocked = record.status == GraspStatus::kBlocked;
  return {{"id", record.id},
          {"status", statusText(record.status)},
          {"placements_found", record.placements_found},
          {"grid", blocked ? gridJson(record.grid) : Json()},
          {"clearance_m", record.clearance_m},
          {"checks", record.checks},
          {"seconds", std::round(record.seconds * kMilliseconds) / kMilliseconds},
          {"failure", record.failure},
          {"grasp", graspJson(record.grasp)}};
}

Json binJson(const GraspBin& bin) {
  return {{"position", bin.position},
          {"approach", bin.approach},
          {"sampled", bin.sampled},
          {"valid_at_pick", bin.valid_at_pick},
          {"with_placement", bin.with_placement},
          {"compatible", bin.compatible}};
}

/// A list with one line for each item.
template <class Item, class ToJson>
std::string lines(const std::vector<Item>& items, ToJson toJson) {
  std::string text;
  for (const Item& item : items)
    text +=
        (text.empty() ? "\n  " : ",\n  ") + toJson(item).dump(-1, ' ', false, Json::error_handler_t::replace);
  return "[" + text + "]";
}

planar::GridSize readGrid(const JsonValue& value) {
  value.requireKeys({"cell_m", "angles"});
  return {value["cell_m"].number(), value["angles"].integer<int>()};
}

CertificateSettings readSettings(const JsonValue& value) {
  value.requireKeys({"seed", "grasps", "placement_draws", "effort_s", "grids"});
  CertificateSettings settings;
  settings.seed = value["seed"].integer<std::uint64_t>();
  settings.grasps = value["grasps"].integer<int>();
  settings.placement_draws = value["placement_draws"].integer<int>();
  settings.effort_s = value["effort_s"].number();
  for (const JsonValue& grid : value["grids"].items()) settings.grids.push_back(readGrid(grid));
  return settings;
}

CertificateNumbers readNumbers(const JsonValue& value) {
  value.requireKeys(
      {"sampled", "valid_at_pick", "with_placement", "compatible", "blocked", "undecided", "clearance_m"});
  CertificateNumbers numbers;
  numbers.sampled = value["sampled"].integer<int>();
  numbers.valid_at_pick = value["valid_at_pick"].integer<int>();
  numbers.with_placement = value["with_placement"].integer<int>();
  numbers.compatible = value["compatible"].integer<int>();
  numbers.blocked = value["blocked"].integer<int>();
  numbers.undecided = value["undecided"].integer<int>();
  numbers.clearance_m = value["clearance_m"].number();
  return numbers;
}

GraspStatus readStatus(const JsonValue& value) {
  const std::string text = value.text();
  for (const GraspStatus status : {GraspStatus::kInvalidAtPick, GraspStatus::kNoPlacement,
                                   GraspStatus::kCompatible, GraspStatus::kBlocked, GraspStatus::kUndecided})
    if (text == statusText(status)) return status;
  value.failWithValue("is not a status");
}

GraspRecord readRecord(const JsonValue& value) {
  value.requireKeys(
      {"id", "status", "placements_found", "grid", "clearance_m", "checks", "seconds", "failure", "grasp"});
  GraspRecord record;
  record.id = value["id"].integer<int>();
  record.status = readStatus(value["status"]);
  record.placements_found = value["placements_found"].integer<int>();
  if (!value["grid"].isNull()) record.grid = readGrid(value["grid"]);
  record.clearance_m = value["clearance_m"].number();
  record.checks = value["checks"].integer<std::uint64_t>();
  record.seconds = value["seconds"].number();
  record.failure = value["failure"].text();
  record.grasp = graspFrom(value["grasp"]);
  return record;
}

GraspBin readBin(const JsonValue& value) {
  value.requireKeys({"position", "approach", "sampled", "valid_at_pick", "with_placement", "compatible"});
  GraspBin bin;
  bin.position = value["position"].integer<int>();
  bin.approach = value["approach"].text();
  bin.sampled = value["sampled"].integer<int>();
  bin.valid_at_pick = value["valid_at_pick"].integer<int>();
  bin.with_placement = value["with_placement"].integer<int>();
  bin.compatible = value["compatible"].integer<int>();
  return bin;
}

}  // namespace

void writeCertificate(const std::string& file, const Certificate& certificate) {
  std::ostringstream text;
  text << "{\"schema\": " << kSchema << ",\n"
       << "\"scene\": " << Json(certificate.scene) << ",\n"
       << "\"digest\": " << Json(certificate.digest) << ",\n"
       << "\"settings\": " << settingsJson(certificate.settings) << ",\n"
       << "\"numbers\": " << numbersJson(certificate.numbers) << ",\n"
       << "\"pick_failures\": " << Json(certificate.pick_failures) << ",\n"
       << "\"placement_failures\": " << Json(certificate.placement_failures) << ",\n"
       << "\"bins\": " << lines(certificate.bins, binJson) << ",\n"
       << "\"grasps\": " << lines(certificate.grasps, recordJson) << ",\n"
       << "\"witness\": " << (certificate.witness ? resultJson(*certificate.witness) : Json()) << "}\n";
  writeFile(file, text.str());
}

Certificate readCertificate(const std::string& file) {
  const Json document = readJson(file);
  const JsonValue root(file, "", document);
  root.requireSchema(kSchema).requireKeys({"schema", "scene", "digest", "settings", "numbers",
                                           "pick_failures", "placement_failures", "bins", "grasps",
                                           "witness"});
  Certificate certificate;
  certificate.scene = root["scene"].text();
  certificate.digest = root["digest"].text();
  certificate.settings = readSettings(root["settings"]);
  certificate.numbers = readNumbers(root["numbers"]);
  certificate.pick_failures = root["pick_failures"].counts();
  certificate.placement_failures = root["placement_failures"].counts();
  for (const JsonValue& bin : root["bins"].items()) certificate.bins.push_back(readBin(bin));
  for (const JsonValue& record : root["grasps"].items()) certificate.grasps.push_back(readRecord(record));
  if (!root["witness"].isNull()) certificate.witness = resultFrom(root["witness"]);
  return certificate;
}

}  // namespace b4p
