// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "experiments/commands/commands.h"
#include "experiments/commands/whole_number.h"
#include "experiments/output_file.h"
#include "experiments/scene_families/family.h"
#include "robots/input_error.h"
#include "robots/number_text.h"

namespace b4p {
namespace {

constexpr const char* kWhere = "b4p generate";

struct Options {
  bool list = false;
  std::string family;
  std::string seed = "0";
  std::string difficulty = "0.5";
  std::vector<std::string> set;
  std::string name;
  std::string out;
};

double finiteNumber(const std::string& text, const std::string& element) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    throw InputError(kWhere, element, "has to be a number (" + text + ")");
  return value;
}

/// A name that scene files may have, or "".
std::string sceneName(const std::string& name) {
  const auto good = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  if (!name.empty() && (std::isalpha(static_cast<unsigned char>(name[0])) == 0 ||
                        !std::all_of(name.begin(), name.end(), good)))
    throw InputError(kWhere, "--name", "has to be letters, digits and underscores (" + name + ")");
  return name;
}

FamilyRequest requestFrom(const Options& options) {
  FamilyRequest request;
  request.seed = wholeNumber(options.seed, 0, kLargestSeed, kWhere, "--seed");
  request.difficulty = finiteNumber(options.difficulty, "--difficulty");
  request.scene_name = sceneName(options.name);
  for (const std::string& word : options.set) {
    const auto equals = word.find('=');
    if (equals == std::string::npos || equals == 0)
      throw InputError(kWhere, "--set", "has to be KEY=VALUE (" + word + ")");
    const std::string key = word.substr(0, equals);
    if (!request.set.emplace(key, finiteNumber(word.substr(equals + 1), key)).second)
      throw InputError(kWhere, key, "is set twice");
  }
  return request;
}

/// A file's name as a scene beside it states it. In single quotes YAML takes all but these as they are.
std::string quotedName(const std::filesystem::path& file) {
  std::string quoted = "'";
  for (const char c : file.filename().string()) quoted += c == '\'' ? std::string("''") : std::string(1, c);
  return quoted + "'";
}

void listFamilies() {
  std::cout << "Families (parameters: standard value, range, values at difficulty 0 and 1; meaning)\n";
  for (const SceneFamily& family : sceneFamilies()) {
    std::cout << "  " << family.name << "\n";
    for (const FamilyParameter& p : family.parameters) {
      std::cout << "    " << p.name << ": " << numberText(p.standard) << ", " << numberText(p.low) << " ... "
                << numberText(p.high);
      if (p.easy != p.hard) std::cout << ", " << numberText(p.easy) << " to " << numberText(p.hard);
      std::cout << "; " << p.meaning << "\n";
    }
  }
}

int generate(const Options& options) {
  if (options.list) {
    listFamilies();
    return kSolved;
  }
  if (options.family.empty()) throw InputError(kWhere, "FAMILY", "is missing; see b4p generate --list");
  if (options.out.empty()) throw InputError(kWhere, "--out", "is missing");
  const SceneFamily& family = findFamily(options.family, kWhere);
  FamilyRequest request = requestFrom(options);
  if (family.grasps != nullptr) {
    const std::filesystem::path table = std::filesystem::path(options.out).replace_extension(".grasps.csv");
    request.grasp_file = quotedName(table);
    const std::string scene = generateScene(family, request, kWhere);
    writeFile(table.string(), generateGrasps(family, request, kWhere));
    std::cout << "grasps written to " << table.string() << "\n";
    writeFile(options.out, scene);
  } else {
    writeFile(options.out, generateScene(family, request, kWhere));
  }
  std::cout << "written to " << options.out << "\n";
  return kSolved;
}

}  // namespace

void addGenerateCommand(CLI::App& app, Run& run) {
  CLI::App* command =
      app.add_subcommand("generate", "Write an instance of a family of scenes as a scene file");
  auto options = std::make_shared<Options>();
  command->add_option("FAMILY", options->family, "maze, stick, grocery or confined");
  command->add_flag("--list", options->list, "Families with their parameters, units, ranges");
  command->add_option("--seed", options->seed, "Draws the instance; 0: the standard one")
      ->capture_default_str();
  command->add_option("--difficulty", options->difficulty, "0 (easy) to 1; sets what --set does not")
      ->capture_default_str();
  command->add_option("--set", options->set, "KEY=VALUE: a parameter, see --list; repeatable")
      ->allow_extra_args(false);
  command->add_option("--name", options->name, "Name of the scene [from family, seed and difficulty]");
  command->add_option("--out", options->out, "Scene file (YAML)");
  command->callback([&run, options] { run = [options] { return generate(*options); }; });
}

}  // namespace b4p
