// What a server offers: its models, their parameters and what they are worth. Thread safety: plain
// values.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gonio/client/types.h"

namespace gonio::client {

enum class Role : std::uint8_t {
  unknown,   // of a newer server
  diffuse,   // may stand alone and as the diffuse base of a sum
  specular,  // may stand alone and as a specular lobe of a sum
  measured,  // stands alone: a table
};

// A word that may stand in the place of a parameter's numbers.
struct PresetInfo {
  std::string name;
  std::vector<double> values;  // one per channel: linear red, green, blue
  std::string source;          // publication, and what the channels stand for
};

struct ParameterInfo {
  std::string name;
  std::string meaning;
  std::string unit;  // "1" for a pure number, "rad" for an angle
  double lower = 0;  // what evaluation accepts, both ends included
  double upper = 0;
  double start = 0;          // taken when the parameter is not given
  bool logarithmic = false;  // vary it on a logarithmic scale
  bool colour = false;       // one number, or one per channel
  // For a word: those allowed, the default first; bounds do not apply.
  std::vector<std::string> words;
  // For a number that has a meaning only with some words of another parameter: which. A word that
  // is not given is the first one that all the given numbers can be used with.
  std::string used_with;
  std::vector<std::string> used_with_words;
  std::vector<PresetInfo> presets;
  bool file = false;           // the name of a file of measurements; bounds do not apply
  std::string preset_partner;  // what must be given too where this is a preset; empty: nothing
};

struct ModelInfo {
  std::string name;
  std::string summary;  // one line: what it is
  std::string source;   // paper and equation
  Role role = Role::unknown;
  std::vector<ParameterInfo> parameters;
  ErrorBound fast;
  ErrorBound reference;
  double albedo_limit = 1;  // the largest albedo over all directions, colours and scale at most 1
};

// A file of the server's materials folder that it cannot use.
struct SkippedMaterial {
  std::string name;    // of the material that it would be
  std::string reason;  // what is wrong, with the file's name
};

struct Catalogue {
  std::vector<ModelInfo> models;
  std::vector<std::string> materials;  // names of the materials that the server holds, sorted
  std::vector<SkippedMaterial> skipped_materials;
  std::vector<InstructionSet> instruction_sets;  // of the server's processor, the best last
  std::string server_version;
};

}  // namespace gonio::client
