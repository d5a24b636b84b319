#include "server/near_names.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <utility>
#include <vector>

namespace gonio {
namespace {

constexpr std::size_t kMaxCompared =
    64;  // the distance takes quadratic time, and names come from outside
constexpr std::size_t kMaxListed = 5;

std::string folded(std::string_view text) {
  std::string result(text.substr(0, kMaxCompared));
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

// Levenshtein's edit distance, one row at a time.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

// 0 is the same; anything above `limit` is not alike.
std::size_t unlikeness(const std::string& name, const std::string& candidate) {
  if (name.size() >= 3 &&
      (candidate.find(name) != std::string::npos || name.find(candidate) != std::string::npos)) {
    return 1;
  }
  return edit_distance(name, candidate);
}

std::string joined(std::span<const std::string> names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

std::string near_names(std::string_view name, std::span<const std::string> candidates) {
  if (candidates.empty()) return "none";
  const std::string wanted = folded(name);
  const std::size_t limit = std::max<std::size_t>(2, wanted.size() / 3);
  std::vector<std::pair<std::size_t, std::string>> alike;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = unlikeness(wanted, folded(candidate));
    if (distance <= limit) alike.emplace_back(distance, candidate);
  }
  std::sort(alike.begin(), alike.end());
  std::vector<std::string> listed;
  for (const auto& [distance, candidate] : alike) listed.push_back(candidate);
  if (!listed.empty()) return joined(std::span(listed).first(std::min(listed.size(), kMaxListed)));
  if (candidates.size() <= kMaxListed) return joined(candidates);
  return joined(candidates.first(kMaxListed)) + " and " +
         std::to_string(candidates.size() - kMaxListed) + " more";
}

}  // namespace gonio
