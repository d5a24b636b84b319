#include "client/cli/input/csv/csv_header.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/text/number.h"

namespace gonio::cli {
namespace {

constexpr std::array<Separator, 4> kSeparators{',', ';', '\t', ' '};

std::vector<std::string> names_in(std::string_view line, Separator separator) {
  std::vector<std::string> names;
  CsvFields fields(line, separator);
  for (std::string_view field; fields.next(field);) {
    std::string& name = names.emplace_back(field);
    for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return names;
}

// Where each name of `set` stands; none unless each stands there once.
std::optional<std::vector<std::size_t>> places_of(NameSet set,
                                                  const std::vector<std::string>& names) {
  std::vector<std::size_t> places;
  for (const std::string_view name : set) {
    if (std::count(names.begin(), names.end(), name) != 1) return std::nullopt;
    const auto found = std::find(names.begin(), names.end(), name);
    places.push_back(static_cast<std::size_t>(found - names.begin()));
  }
  return places;
}

// The names of `set` of which `names` has another number than one.
struct Misfit {
  std::size_t there = 0;
  std::string missing, twice;
};

Misfit misfit(NameSet set, const std::vector<std::string>& names) {
  Misfit found;
  for (const std::string_view name : set) {
    const auto count = std::count(names.begin(), names.end(), name);
    found.there += count > 0 ? 1 : 0;
    std::string& list = count == 0 ? found.missing : found.twice;
    if (count != 1) list += (list.empty() ? "" : ", ") + std::string(name);
  }
  return found;
}

bool is_numbers(std::string_view line) {
  return std::any_of(kSeparators.begin(), kSeparators.end(), [&](Separator separator) {
    const auto words = names_in(line, separator);
    return std::all_of(words.begin(), words.end(),
                       [](const auto& word) { return parse_number<double>(word).has_value(); });
  });
}

}  // namespace

std::optional<CsvHeader> find_header(std::string_view line, std::span<const NameSet> sets) {
  for (const Separator separator : kSeparators) {
    auto names = names_in(line, separator);
    for (std::size_t set = 0; set < sets.size(); ++set) {
      if (auto places = places_of(sets[set], names))
        return CsvHeader{std::move(names), separator, set, std::move(*places)};
    }
  }
  return std::nullopt;
}

std::string header_problem(std::string_view line, std::span<const NameSet> sets) {
  if (is_numbers(line)) return "there is no header";
  Misfit nearest;
  for (const Separator separator : kSeparators) {
    const auto names = names_in(line, separator);
    for (const NameSet& set : sets) {
      if (Misfit found = misfit(set, names); found.there > nearest.there)
        nearest = std::move(found);
    }
  }
  if (nearest.there == 0) return "the header has none of the columns";
  if (nearest.missing.empty()) return "the header has " + nearest.twice + " twice";
  return "the header lacks " + nearest.missing;
}

}  // namespace gonio::cli
